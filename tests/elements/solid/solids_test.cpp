// SPDX-License-Identifier: BSD-3-Clause
// What all formulations of solids must do: patch test, modes without energy, rotation, work, stable step.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "elements/solid_harness.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::solids_test {
namespace {

constexpr auto no_turn = [](const Vec3&) { return Vec3{}; };

Vec3 linear_field(const Vec3& x) {
  return 1e-7 * Vec3{x.x + 0.5 * x.y - 0.3 * x.z, 0.5 * x.x - 0.7 * x.y + 0.2 * x.z,
                     -0.3 * x.x + 0.2 * x.y + 0.4 * x.z};
}

/// Largest force on the inner nodes over that on the outer ones, and the error of the stress over itself.
struct PatchError {
  double force = 0;
  double stress = 0;
};
PatchError patch_error(const model::Model& model, double side, const domain::Execution& execution) {
  Driven body(model, execution);
  body.step(
      1e-7, [](const Vec3& x) { return x + linear_field(x); }, no_turn);
  double inner = 0;
  double outer = 0;
  for (Index i = 0; i < body.domain.nodes.count(); ++i) {
    const Vec3& x = body.domain.nodes.reference[i];
    const bool inside = x.x > 0 && x.x < side && x.y > 0 && x.y < side && x.z > 0 && x.z < side;
    (inside ? inner : outer) = test::larger_of(inside ? inner : outer, norm(body.force(i)));
  }
  const double shear = 0.5 * youngs_modulus / (1 + poissons_ratio);
  const double lame = youngs_modulus * poissons_ratio / (1 + poissons_ratio) / (1 - 2 * poissons_ratio);
  const std::array<double, 6> strain{1e-7, -0.7e-7, 0.4e-7, 1e-7, 0.4e-7, -0.6e-7};
  PatchError error{inner / outer, 0};
  const domain::SolidBlock& block = body.domain.solids[0];
  for (Index e = 0; e < block.elements; ++e)
    for (Index point = 0; point < block.points; ++point)
      for (Index c = 0; c < 6; ++c) {
        const auto at = static_cast<std::size_t>(c);
        const double expected = c < 3 ? lame * 0.7e-7 + 2 * shear * strain[at] : shear * strain[at];
        error.stress = test::larger_of(error.stress,
                                       std::fabs(block.state(e, 6 * point + c) - expected) / (shear * 1e-7));
      }
  return error;
}
void expect_exact_stress(const PatchError& error, const domain::Execution& execution,
                         const std::string& name) {
  // Strains are 1e-7, and so is the difference between the middle of the step and its start.
  if (execution.precision == Precision::Mixed) {
    EXPECT_LT(error.stress, 2e-5) << name;
  } else {
    test::verified(name + ", patch test: stresses over G e, error", "constant strain, exact")
        .below(error.stress, 1e-6);
  }
}
void expect_exact(const PatchError& error, const domain::Execution& execution, const std::string& name) {
  expect_exact_stress(error, execution, name);
  if (execution.precision == Precision::Mixed) {
    EXPECT_LT(error.force, 2e-5) << name;
  } else {
    test::verified(name + ", patch test: forces inside over those outside", "equilibrium")
        .below(error.force, 2e-7);
  }
}

/// Any linear field on a distorted mesh: the stress is uniform with every form. Forces balance where the
/// gradient operator is the mean over the volume, whose sum over the elements around a node vanishes: forms
/// 3, 5 and 6 of the hexahedron with one point, and the other formulations. One to the eighth of the Jacobian
/// at the centre leaves a resultant (L.E. Schwer and others, "An assessment of the LS-DYNA hourglass
/// formulations via the 3D patch test", 5th European LS-DYNA users conference, 2005: forms 1, 2 and 4 fail).
TEST(Solids, PassThePatchTestWhereTheVolumeIsExact) {
  using Form = model::SolidHourglassForm;
  for (const SolidCase& of : solid_cases)
    for (const auto& execution : all_executions()) {
      const PatchError error = patch_error(solid_cube(of, 3, 0.2), 6, execution);
      const bool fails = of.one_point_hexahedron() &&
                         (of.form == Form::StandardViscous || of.form == Form::FlanaganBelytschkoViscous ||
                          of.form == Form::FlanaganBelytschkoStiffness);
      if (!fails) {
        expect_exact(error, execution, of.name);
      } else {
        expect_exact_stress(error, execution, of.name);
        EXPECT_GT(error.force, 1e-3) << name_of(of, execution);
      }
    }
}

/// Wedges and tetrahedra that are hexahedra with equal nodes.
TEST(Solids, DegenerateHexahedraPassThePatchTest) {
  for (const SolidCase& of : solid_cases) {
    if (model::is_tetrahedral(of.formulation)) continue;
    if (of.one_point_hexahedron() && of.form != model::SolidHourglassForm::ExactVolumeStiffness &&
        of.form != model::SolidHourglassForm::ExactVolumeViscous)
      continue;
    for (const auto split : {test::split_into_wedges, test::split_into_tetrahedra}) {
      model::Model model = solid_cube(of, 3, 0.1);
      split(model);
      const domain::Execution execution{Precision::Double, available_isas().back(), 1};
      expect_exact(
          patch_error(model, 6, execution), execution,
          of.name + std::string(split == test::split_into_wedges ? ", wedges" : ", tetrahedra of hexahedra"));
    }
  }
}

/// Number of independent displacements that need no force: the size of the stiffness matrix of a free body,
/// found from forces, less its rank.
std::size_t modes_without_energy(const model::Model& model) {
  const std::size_t size = 3 * model.nodes.id.size();
  std::vector<std::vector<double>> k(size, std::vector<double>(size));
  const double step = 1e-7;
  for (std::size_t column = 0; column < size; ++column) {
    Driven body(model, {Precision::Double, available_isas().back(), 1});
    std::vector<Vec3> move(size / 3);
    move[column / 3][static_cast<int>(column % 3)] = step;
    body.step(1e-7, move, std::vector<Vec3>(size / 3));
    for (std::size_t row = 0; row < size; ++row)
      k[row][column] = -body.force(static_cast<Index>(row / 3))[static_cast<int>(row % 3)] / step;
  }
  // Gauss's elimination with complete pivoting: what is left when no pivot is above round-off.
  std::vector<bool> used_row(size);
  std::vector<bool> used_column(size);
  double first = 0;
  for (std::size_t rank = 0; rank < size; ++rank) {
    std::size_t row = 0;
    std::size_t column = 0;
    double pivot = 0;
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j)
        if (!used_row[i] && !used_column[j] && std::fabs(k[i][j]) > pivot) {
          pivot = std::fabs(k[i][j]);
          row = i;
          column = j;
        }
    if (rank == 0) first = pivot;
    if (pivot < 1e-5 * first) return size - rank;
    used_row[row] = used_column[column] = true;
    for (std::size_t i = 0; i < size; ++i) {
      if (used_row[i]) continue;
      const double factor = k[i][column] / k[row][column];
      for (std::size_t j = 0; j < size; ++j) k[i][j] -= factor * k[row][j];
    }
  }
  return 0;
}
model::Model distorted_element(const SolidCase& of, double coefficient) {
  model::Model model = solid_cube(of, 1, 0);
  model.control.hourglass.coefficient = coefficient;
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-0.25, 0.25);
  for (auto& x : model.nodes.position)
    for (double& coordinate : x) coordinate += uniform(generator);
  return model;
}

TEST(Solids, HaveNoOtherModesWithoutEnergyThanRigidMotions) {
  for (const SolidCase& of : solid_cases) {
    if (of.viscous()) continue;
    EXPECT_EQ(modes_without_energy(distorted_element(of, 0.1)), 6U) << of.name;
    if (of.one_point_hexahedron()) {
      EXPECT_EQ(modes_without_energy(distorted_element(of, 0)), 18U) << of.name;
    }
  }
  model::Model patch = solid_cube(solid_cases.back(), 2, 0.1);
  patch.control.bulk_linear = patch.control.bulk_quadratic = 0;
  EXPECT_EQ(modes_without_energy(patch), 6U);
}

/// Stretched, then turned through twenty turns: the stress turns with the body, hourglass forces as well.
TEST(Solids, StressTurnsWithTheBody) {
  for (const SolidCase& of : solid_cases) {
    test::Largest off(
        std::string(of.name) + ", stretched, twenty turns: stress, change over what rounding allows",
        "the stress at first, turned", 1);
    for (const auto& execution : all_executions()) {
      Driven body(solid_cube(of, 1, 0.0), execution);
      body.step(
          1e-6,
          [](const Vec3& x) {
            return Vec3{1.001 * x.x, x.y, x.z};
          },
          no_turn);
      const domain::SolidBlock& block = body.domain.solids[0];
      std::array<double, 6> before{};
      for (Index c = 0; c < 6; ++c) before[static_cast<std::size_t>(c)] = block.state(0, c);
      const Vec3 axis = (1 / std::sqrt(14.0)) * Vec3{1, 2, 3};
      const int steps = 40;
      const int turns = 20;
      for (int i = 0; i < turns * steps; ++i)
        body.step(
            1e-6, [&](const Vec3& x) { return rotated(x, axis, 2 * 3.14159265358979324 / steps); }, no_turn);
      // The velocity of a turn has no strain but its round-off, one unit in the last place per radian.
      const double round_off = execution.precision == Precision::Mixed ? 0x1p-24 : 0x1p-53;
      // The positions, in double, are rounded once a step by the test itself. Slender elements have more.
      const double slenderness = of.one_point_hexahedron() ? 1.5 : 4;
      const double tolerance = (round_off * 2 * 3.14159265358979324 * turns + 0x1p-53 * turns * steps) *
                               slenderness * youngs_modulus;
      for (Index c = 0; c < 6; ++c)
        off.compare(block.state(0, c), before[static_cast<std::size_t>(c)], tolerance,
                    name_of(of, execution));
    }
  }
}

/// An element that hourglasses and turns by a quarter: its nodal forces are the old ones, turned.
TEST(Solids, ForcesTurnWithTheBody) {
  for (const SolidCase& of : solid_cases) {
    if (of.viscous()) continue;
    Driven body(distorted_element(of, 0.1), {Precision::Double, available_isas().back(), 1});
    const Index count = body.domain.nodes.count();
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> uniform(-1e-4, 1e-4);
    std::vector<Vec3> move(count);
    for (Vec3& m : move) m = {uniform(generator), uniform(generator), uniform(generator)};
    body.step(1e-6, move, std::vector<Vec3>(count));
    std::vector<Vec3> before;
    double largest = 0;
    for (Index i = 0; i < count; ++i) {
      before.push_back(body.force(i));
      largest = test::larger_of(largest, norm(before.back()));
    }
    const Vec3 axis = (1 / std::sqrt(14.0)) * Vec3{1, 2, 3};
    const double quarter = 1.57079632679489662;
    const int steps = 20;
    for (int i = 0; i < steps; ++i)
      body.step(
          1e-6, [&](const Vec3& x) { return rotated(x, axis, quarter / steps); }, no_turn);
    test::Largest off(std::string(of.name) + ", quarter of a turn: forces over the largest, difference",
                      "forces at first, turned", 1e-9);
    for (Index i = 0; i < count; ++i)
      off.add(norm(body.force(i) - rotated(before[static_cast<std::size_t>(i)], axis, quarter)) / largest);
  }
}

/// A free body that shakes: the work of its forces is what it books.
TEST(Solids, BookTheWorkOfTheirForces) {
  for (const SolidCase& of : solid_cases) {
    Driven body(solid_cube(of, 2, 0.1, plastic()), {Precision::Double, available_isas().back(), 1});
    const Index count = body.domain.nodes.count();
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    double work = 0;
    std::vector<Vec3> velocity(count);
    std::vector<Vec3> before(count);
    for (int step = 0; step < 400; ++step) {
      // Slow waves with random phases: forces change little from step to step.
      for (Vec3& v : velocity)
        v = 0.98 * v + 2e-6 * Vec3{uniform(generator), uniform(generator), uniform(generator)};
      for (Index i = 0; i < count; ++i) before[i] = body.force(i);
      body.step(1e-7, velocity, std::vector<Vec3>(count));
      for (Index i = 0; i < count; ++i) work -= 0.5 * dot(before[i] + body.force(i), velocity[i]);
    }
    const domain::SolidBlock& block = body.domain.solids[0];
    EXPECT_EQ(block.hourglass_energy > 0, of.one_point_hexahedron());
    EXPECT_GT(work, 0);
    test::verified(std::string(of.name) + ", shaken and yielding: energy over the work",
                   "work of the nodal forces")
        .near((block.internal_energy + block.hourglass_energy) / work, 1, 1e-5);
  }
}

/// All numbers of a driven body that must be the same for every way to compute them.
std::vector<double> numbers_of(Driven& body, int steps) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-0.01, 0.01);
  std::vector<Vec3> move(static_cast<std::size_t>(body.domain.nodes.count()));
  for (int step = 0; step < steps; ++step) {
    for (Vec3& m : move) m = Vec3{uniform(generator), uniform(generator), uniform(generator)};
    body.step(1e-7, move, std::vector<Vec3>(move.size()));
  }
  std::vector<double> all{body.domain.solids[0].internal_energy, body.domain.solids[0].hourglass_energy,
                          body.domain.clock.element_limit};
  for (Index i = 0; i < body.domain.nodes.count(); ++i)
    for (int axis = 0; axis < 3; ++axis) all.push_back(body.force(i)[axis]);
  return all;
}

/// Thousands of random elements and steps: the vectors give the bits of one element at a time.
TEST(Solids, HaveTheSameBitsForEveryWidth) {
  const std::vector<Isa> isas = available_isas();
  for (const Precision precision : {Precision::Double, Precision::Mixed})
    for (const SolidCase& of : solid_cases) {
      // Two families: scalar and baseline, AVX2 and AVX-512.
      std::array<std::vector<double>, 2> first;
      for (const Isa isa : isas) {
        Driven body(solid_cube(of, 4, 0.15, plastic()), {precision, isa, 1});
        const std::vector<double> all = numbers_of(body, 20);
        std::vector<double>& expected = first[isa == Isa::Avx2 || isa == Isa::Avx512 ? 1 : 0];
        if (expected.empty()) expected = all;
        EXPECT_EQ(all, expected) << of.name << isa_name(isa);
      }
    }
}

/// Shares that have nodes in common: their forces are added in one order for any number of threads.
TEST(Solids, HaveTheSameBitsForEveryNumberOfThreads) {
  for (const Precision precision : {Precision::Double, Precision::Mixed})
    for (const SolidCase& of : solid_cases) {
      if (of.one_point_hexahedron() && of.form < model::SolidHourglassForm::ExactVolumeStiffness) continue;
      const Index side = model::is_tetrahedral(of.formulation) ? 7 : 12;
      std::vector<double> alone;
      for (const int threads : {1, 2, 3, 4}) {
        Driven body(solid_cube(of, side, 0.15, plastic()), {precision, available_isas().back(), threads});
        ASSERT_EQ(body.domain.assembly.shares().size(), static_cast<std::size_t>(threads));
        const std::vector<double> all = numbers_of(body, 3);
        if (threads == 1) alone = all;
        EXPECT_EQ(all, alone) << of.name << threads;
      }
    }
}

TEST(Solids, StableStepIsSafeWithinAMesh) {
  for (const SolidCase& of : solid_cases) {
    if (of.viscous()) continue;
    const double regular = courant_number(solid_cube(of, 4, 0));
    const double distorted = courant_number(solid_cube(of, 4, 0.2));
    std::printf("%s: half omega dt %.3f, distorted mesh %.3f", of.name, regular, distorted);
    if (!model::is_tetrahedral(of.formulation))
      for (const auto split : {test::split_into_wedges, test::split_into_tetrahedra}) {
        model::Model model = solid_cube(of, 3, 0.1);
        split(model);
        const double number = courant_number(model);
        std::printf(", degenerate %.3f", number);
        EXPECT_LT(number, 1 / 0.9) << of.name;
      }
    std::printf("\n");
    EXPECT_LT(regular, 1 / 0.9) << of.name;
    test::verified(std::string(of.name) + ", distorted mesh: half of 0.9 omega dt", "stable below 1")
        .below(0.9 * distorted, 1);
  }
}

/// Free boxes of nx x ny x nz elements with sides 2, 2 and `height`, turned to no axis.
double courant_number_of_block(const SolidCase& of, Index nx, Index ny, Index nz, double height) {
  model::Model model = solid_model(of, elastic());
  test::add_box(model, 0, nx, ny, nz, [&](double u, double v, double w) {
    const double x = 2.0 * u * static_cast<double>(nx);
    const double y = 2.0 * v * static_cast<double>(ny);
    const double z = height * w * static_cast<double>(nz);
    return test::Point{0.6 * x - 0.8 * y, 0.8 * (0.8 * x + 0.6 * y) - 0.6 * z,
                       0.6 * (0.8 * x + 0.6 * y) + 0.8 * z};
  });
  return courant_number(model);
}

TEST(Solids, StableStepIsSafeForFreeBlocks) {
  for (const SolidCase& of : solid_cases) {
    if (of.viscous() || model::is_tetrahedral(of.formulation)) continue;
    for (const double height : {2.0, 0.4})
      for (const Index n : {1, 2, 3, 4})
        for (const Index m : {1, 2, 4}) {
          if (m > n) continue;
          const double number = courant_number_of_block(of, n, m, 1, height);
          EXPECT_LT(number, 1 + 1e-6) << of.name << n << m << height;
          if (n == 1 && height == 2)
            test::verified(std::string(of.name) + ", lone cube: half omega dt", "2 / omega of uniform strain")
                .near(number, 1, 1e-3);
        }
  }
}

/// A lone parallelepiped with the edges `edge`, of a material with that Poisson's ratio.
double courant_number_of_parallelepiped(const SolidCase& of, const std::array<Vec3, 3>& edge, double nu) {
  model::Material material = elastic();
  material.law = model::Elastic{youngs_modulus, nu};
  model::Model model = solid_model(of, material);
  test::add_box(model, 0, 1, 1, 1, [&](double u, double v, double w) {
    const Vec3 x = u * edge[0] + v * edge[1] + w * edge[2];
    return test::Point{x.x, x.y, x.z};
  });
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  Driven body(model, {Precision::Double, available_isas().back(), 1});
  const double step = stable_step(body.domain, body.domain.solids[0]);
  body.update(0);
  EXPECT_NEAR(body.domain.clock.element_limit, step, 1e-12 * step) << of.name;
  return courant_number(model);
}

TEST(Solids, StableStepIsSafeForLoneShearedElements) {
  for (const SolidCase& of : solid_cases) {
    if (!model::is_selective(of.formulation)) continue;
    double largest = 0;
    const auto add = [&](const std::array<Vec3, 3>& edge, double nu, const std::string& shape) {
      const double number = courant_number_of_parallelepiped(of, edge, nu);
      std::printf("%s, lone, %s, nu %.1f: half omega dt %.3f\n", of.name, shape.c_str(), nu, number);
      largest = std::max(largest, number);
    };
    for (const double nu : {0.0, 0.3}) {
      for (const double shear : {1.0, 1.25, 2.0, 3.0, 4.0})
        for (const double height : {0.2, 1.0, 5.0})
          add({Vec3{1, 0, 0}, Vec3{0, 1, 0}, height * Vec3{0, shear, 1}}, nu,
              "sheared by " + std::to_string(shear));
      add({Vec3{1, 0, 0}, Vec3{2, 1, 0}, Vec3{2, 2, 1}}, nu, "axes leaning by 2");
      add({Vec3{1, 2, 0}, Vec3{0, 1, 2}, Vec3{2, 0, 1}}, nu, "axes leaning by 2 in turn");
    }
    test::verified(std::string(of.name) + ", lone sheared elements: half of omega dt", "stable up to 1")
        .below(largest, 1 + 1e-6);
  }
}

TEST(Solids, HaveTheMassOfTheirVolumeAndGrowHeavierForTheStepAskedFor) {
  for (const SolidCase& of : solid_cases) {
    model::Model model = solid_cube(of, 2, 0.1);
    model.control.bulk_linear = model.control.bulk_quadratic = 0;
    const auto mass_of = [](const Driven& body) {
      double sum = 0;
      for (Index i = 0; i < body.domain.nodes.count(); ++i) sum += body.domain.nodes.mass[i];
      return sum;
    };
    Driven body(model, {Precision::Double, available_isas().back(), 1});
    // At the centre the volume is not quite that of the trilinear map.
    const bool exact = !of.one_point_hexahedron() || of.form == model::SolidHourglassForm::AssumedStrain;
    test::verified(std::string(of.name) + ", distorted mesh of a cube: mass over exact",
                   "density times volume")
        .near(mass_of(body) / (64 * density), 1, exact ? 1e-12 : 1e-6);
    const double step = stable_step(body.domain, body.domain.solids[0]);
    body.update(0);
    EXPECT_NEAR(body.domain.clock.element_limit, step, 1e-12 * step) << of.name;
    model.control.mass_scaling_step = -2 * step;
    Driven heavier(model, {Precision::Double, available_isas().back(), 1});
    EXPECT_GT(heavier.domain.added_mass, 0);
    EXPECT_NEAR(mass_of(heavier), mass_of(body) + heavier.domain.added_mass, 1e-12 * mass_of(body))
        << of.name;
    heavier.update(0);
    EXPECT_NEAR(heavier.domain.clock.element_limit, 2 * step, 1e-12 * step) << of.name;
  }
}

/// A body that is compressed evenly at the rate d: rho l (Q1 l d^2 + Q2 c d), l the third root of the volume;
/// nothing when it expands. The step is 1 / (Q + sqrt(Q^2 + c^2)) of what it is without, Q = Q2 c + Q1 l d,
/// and has Q2 c also in expansion; Q grows with l over sqrt(3) times what a wave must cross in a step.
TEST(Solids, BulkViscosityResistsCompressionAlone) {
  test::Largest off("all solids, compressed evenly: pressure of bulk viscosity, relative error",
                    "rho l (Q1 l d^2 + Q2 c d)", 1e-4);
  const double nu = poissons_ratio;
  const double speed = std::sqrt(youngs_modulus * (1 - nu) / (density * (1 + nu) * (1 - 2 * nu)));
  for (const SolidCase& of : solid_cases)
    for (const double rate : {3000.0, -3000.0}) {
      Driven body(solid_cube(of, 2, 0), {Precision::Double, available_isas().back(), 1});
      body.update(0);
      const double limit = body.domain.clock.element_limit;
      const double step = 1e-9;
      body.step(
          step, [&](const Vec3& x) { return (1 - rate / 3 * step) * x; }, no_turn);
      const domain::SolidBlock& block = body.domain.solids[0];
      const double volume = block.state(0, block.find("reference_volume")->first);
      const double length = std::cbrt(volume);
      const double expected = rate < 0 ? 0 : density * length * rate * (1.5 * length * rate + 0.06 * speed);
      const double found = block.state(0, block.find("bulk_viscosity")->first);
      EXPECT_NEAR(found, expected, 1e-4 * expected) << of.name;
      if (rate > 0) off.compare(found, expected, expected, of.name);
      model::Model without = solid_cube(of, 2, 0);
      without.control.bulk_linear = without.control.bulk_quadratic = 0;
      Driven bare(without, {Precision::Double, available_isas().back(), 1});
      bare.update(0);
      const double crossed = speed * bare.domain.clock.element_limit;
      const double flatness = std::max(1.0, length / (std::sqrt(3.0) * crossed));
      const auto share = [&](double q) { return 1 / (flatness * q + std::hypot(flatness * q, speed)); };
      const double linear = 0.06 * speed;
      const double shorter = share(linear + 1.5 * length * std::max(rate, 0.0)) / share(linear);
      EXPECT_NEAR(body.domain.clock.element_limit, shorter * limit, 1e-5 * limit) << of.name;
    }
}

}  // namespace
}  // namespace crumple::elements::testing::solids_test
