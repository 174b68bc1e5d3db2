// SPDX-License-Identifier: BSD-3-Clause
// The hexahedron with one point: geometry, patch test, spurious modes, rotation, energy, bits.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "elements/solid_geometry.hpp"
#include "elements/solid_setup.hpp"
#include "shell_harness.hpp"

namespace crumple::elements::testing {
namespace {

using Form = model::SolidHourglassForm;
constexpr std::array forms{Form::StandardViscous, Form::FlanaganBelytschkoViscous, Form::ExactVolumeViscous,
                           Form::FlanaganBelytschkoStiffness, Form::ExactVolumeStiffness};
bool has_exact_volume(Form form) {
  return form == Form::ExactVolumeViscous || form == Form::ExactVolumeStiffness;
}

/// A cube of side 2 n of n x n x n elements; every node but those on its surface is moved by up to
/// `distortion` of an element's side, those on the surface within it.
model::Model cube(Index n, double distortion, Form form, const model::Material& material = elastic()) {
  model::Model model = test::one_solid_part(material);
  model.control.hourglass.solid_form = form;
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double side = 2.0 * static_cast<double>(n);
  test::add_box(model, 0, n, n, n, [&](double u, double v, double w) {
    test::Point x{u * side, v * side, w * side};
    for (double& coordinate : x) {
      const double move = 2 * distortion * uniform(generator);
      if (coordinate > 0 && coordinate < side) coordinate += move;
    }
    return x;
  });
  return model;
}

std::array<Vec3, 8> distorted_corners(int seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.25, 0.25);
  std::array<Vec3, 8> corner{Vec3{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                             {-1, -1, 1},      {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  for (Vec3& x : corner) x += Vec3{uniform(generator), uniform(generator), uniform(generator)};
  return corner;
}

/// Volume by Gauss's rule of 2 x 2 x 2 points, exact for the trilinear map, from shape functions.
double volume_by_points(const std::array<Vec3, 8>& corner) {
  constexpr double signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                  {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  double sum = 0;
  for (const auto& place : signs) {
    Vec3 tangent[3];
    for (std::size_t k = 0; k < 8; ++k) {
      double factor[3];
      for (int a = 0; a < 3; ++a) factor[a] = 1 + signs[k][a] * place[a] / std::sqrt(3.0);
      tangent[0] += 0.125 * signs[k][0] * factor[1] * factor[2] * corner[k];
      tangent[1] += 0.125 * signs[k][1] * factor[2] * factor[0] * corner[k];
      tangent[2] += 0.125 * signs[k][2] * factor[0] * factor[1] * corner[k];
    }
    sum += dot(tangent[0], cross(tangent[1], tangent[2]));
  }
  return sum;
}

TEST(SolidGeometry, VolumeIsThatOfTheTrilinearMap) {
  for (int seed = 0; seed < 50; ++seed) {
    const auto corner = distorted_corners(seed);
    const double exact = volume_by_points(corner);
    EXPECT_NEAR(solid_geometry(patterns_of(corner), true).volume, exact, 1e-14 * exact);
  }
}

TEST(SolidGeometry, GradientsAreDerivativesOfTheVolume) {
  for (int seed = 0; seed < 20; ++seed)
    for (const bool exact : {false, true}) {
      const SolidPatterns<double> x = patterns_of(distorted_corners(seed));
      const auto g = solid_geometry(x, exact);
      for (int p = 0; p < 6; ++p) {
        const auto derivative = [&](double math::PackVec3<double>::*axis) {
          // The volume is of the third degree: the central difference's error is that of step squared.
          const double step = 1e-4;
          SolidPatterns<double> up = x;
          SolidPatterns<double> down = x;
          up.of[p].*axis += step;
          down.of[p].*axis -= step;
          return (solid_geometry(up, exact).volume - solid_geometry(down, exact).volume) / (2 * step);
        };
        using Vec = math::PackVec3<double>;
        EXPECT_NEAR(derivative(&Vec::x), g.gradient[p].x, 1e-7);
        EXPECT_NEAR(derivative(&Vec::y), g.gradient[p].y, 1e-7);
        EXPECT_NEAR(derivative(&Vec::z), g.gradient[p].z, 1e-7);
      }
    }
}

Vec3 linear_field(const Vec3& x) {
  return 1e-7 * Vec3{x.x + 0.5 * x.y - 0.3 * x.z, 0.5 * x.x - 0.7 * x.y + 0.2 * x.z,
                     -0.3 * x.x + 0.2 * x.y + 0.4 * x.z};
}

/// Largest force on the inner nodes over that on the outer ones, and the error of the stress over itself.
struct PatchError {
  double force = 0;
  double stress = 0;
};
PatchError patch_error(Form form, const domain::Execution& execution) {
  const model::Model model = cube(3, 0.2, form);
  Driven body(model, execution);
  body.step(
      1e-7, [](const Vec3& x) { return x + linear_field(x); }, [](const Vec3&) { return Vec3{}; });
  double inner = 0;
  double outer = 0;
  for (Index i = 0; i < body.domain.nodes.count(); ++i) {
    const Vec3& x = body.domain.nodes.reference[i];
    const bool inside = x.x > 0 && x.x < 6 && x.y > 0 && x.y < 6 && x.z > 0 && x.z < 6;
    (inside ? inner : outer) = std::max(inside ? inner : outer, norm(body.force(i)));
  }
  const double shear = 0.5 * youngs_modulus / (1 + poissons_ratio);
  const double lame = youngs_modulus * poissons_ratio / (1 + poissons_ratio) / (1 - 2 * poissons_ratio);
  const std::array<double, 6> strain{1e-7, -0.7e-7, 0.4e-7, 1e-7, 0.4e-7, -0.6e-7};
  PatchError error{inner / outer, 0};
  const domain::SolidBlock& block = body.domain.solids[0];
  for (Index e = 0; e < block.elements; ++e)
    for (Index c = 0; c < 6; ++c) {
      const auto at = static_cast<std::size_t>(c);
      const double expected = c < 3 ? lame * 0.7e-7 + 2 * shear * strain[at] : shear * strain[at];
      error.stress = std::max(error.stress, std::fabs(block.state(e, c) - expected) / (shear * 1e-7));
    }
  return error;
}

/// Any linear field on a distorted mesh: the stress is uniform with every form. Forces balance where the
/// gradient operator is the mean over the volume, whose sum over the elements around a node vanishes: forms 3
/// and 5. One to the eighth of the Jacobian at the centre leaves a resultant (L.E. Schwer and others, "An
/// assessment of the LS-DYNA hourglass formulations via the 3D patch test", 5th European LS-DYNA users
/// conference, 2005: forms 1, 2 and 4 fail).
TEST(OnePointHexahedron, PassesThePatchTestWithTheExactVolume) {
  for (const Form form : forms)
    for (const auto& execution : all_executions()) {
      const PatchError error = patch_error(form, execution);
      const std::string name = name_of(execution) + " form " + std::to_string(int(form) + 1);
      // Strains are 1e-7, and so is the difference between the middle of the step and its start.
      const bool mixed = execution.precision == Precision::Mixed;
      EXPECT_LT(error.stress, mixed ? 2e-5 : 1e-6) << name;
      if (has_exact_volume(form))
        EXPECT_LT(error.force, mixed ? 2e-5 : 1e-7) << name;
      else
        EXPECT_GT(error.force, 1e-3) << name;
    }
}

/// Stiffness matrix of one element from forces, and the number of its zero eigenvalues.
int modes_without_energy(Form form, double coefficient) {
  model::Model model = cube(1, 0, form);
  model.control.hourglass.coefficient = coefficient;
  for (std::size_t k = 0; k < 8; ++k) {
    const Vec3 corner = distorted_corners(3)[k];
    model.nodes.position[model.solids[0].node[k]] = {corner.x, corner.y, corner.z};
  }
  constexpr int size = 24;
  std::vector<std::array<double, size>> k(size);
  const double step = 1e-7;
  for (int column = 0; column < size; ++column) {
    Driven body(model, {Precision::Double, available_isas().back(), 1});
    std::vector<Vec3> move(8);
    move[static_cast<std::size_t>(column / 3)][column % 3] = step;
    body.step(1e-7, move, std::vector<Vec3>(8));
    for (int row = 0; row < size; ++row)
      k[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          -body.force(row / 3)[row % 3] / step;
  }
  // Gauss's elimination with complete pivoting: what is left when no pivot is above round-off.
  int rank = 0;
  double first = 0;
  std::vector<bool> used_row(size);
  std::vector<bool> used_column(size);
  for (; rank < size; ++rank) {
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
    if (pivot < 1e-5 * first) break;
    used_row[row] = used_column[column] = true;
    for (std::size_t i = 0; i < size; ++i) {
      if (used_row[i]) continue;
      const double factor = k[i][column] / k[row][column];
      for (std::size_t j = 0; j < size; ++j) k[i][j] -= factor * k[row][j];
    }
  }
  return size - rank;
}

TEST(OnePointHexahedron, HasTwelveModesThatHourglassControlTakes) {
  for (const Form form : {Form::FlanaganBelytschkoStiffness, Form::ExactVolumeStiffness}) {
    EXPECT_EQ(modes_without_energy(form, 0), 18);
    EXPECT_EQ(modes_without_energy(form, 0.1), 6);
  }
}

/// Stretched, then turned through a hundred turns: the stress turns with the body, forces keep their size.
TEST(OnePointHexahedron, StressTurnsWithTheBody) {
  for (const Form form : forms)
    for (const auto& execution : all_executions()) {
      Driven body(cube(1, 0.0, form), execution);
      const auto no_turn = [](const Vec3&) { return Vec3{}; };
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
      // The positions, in double, are rounded once a step by the test itself.
      const double tolerance =
          (round_off * 2 * 3.14159265358979324 * turns + 0x1p-53 * turns * steps) * 1.5 * youngs_modulus;
      for (Index c = 0; c < 6; ++c)
        EXPECT_NEAR(block.state(0, c), before[static_cast<std::size_t>(c)], tolerance)
            << name_of(execution) << " form " << int(form) + 1 << " component " << c;
    }
}

/// A free element that shakes: the work of its forces is what it books.
TEST(OnePointHexahedron, BooksTheWorkOfItsForces) {
  for (const Form form : forms) {
    model::Model model = cube(2, 0.1, form, plastic());
    Driven body(model, {Precision::Double, available_isas().back(), 1});
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
    EXPECT_GT(block.hourglass_energy, 0);
    EXPECT_NEAR(block.internal_energy + block.hourglass_energy, work, 1e-3 * work) << int(form) + 1;
  }
}

/// Thousands of random elements and steps: the vectors give the bits of one element at a time.
TEST(OnePointHexahedron, HasTheSameBitsForEveryWidth) {
  for (const Precision precision : {Precision::Double, Precision::Mixed})
    for (const Form form : {Form::StandardViscous, Form::ExactVolumeStiffness}) {
      std::vector<std::vector<double>> forces;
      std::vector<Isa> isas = available_isas();
      for (const Isa isa : isas) {
        Driven body(cube(4, 0.2, form, plastic()), {precision, isa, 1});
        std::mt19937 generator(5);
        std::uniform_real_distribution<double> uniform(-1, 1);
        std::vector<Vec3> move(static_cast<std::size_t>(body.domain.nodes.count()));
        for (int step = 0; step < 20; ++step) {
          for (Vec3& m : move) m = 0.01 * Vec3{uniform(generator), uniform(generator), uniform(generator)};
          body.step(1e-7, move, std::vector<Vec3>(move.size()));
        }
        std::vector<double> all;
        for (Index i = 0; i < body.domain.nodes.count(); ++i)
          for (int axis = 0; axis < 3; ++axis) all.push_back(body.force(i)[axis]);
        forces.push_back(all);
      }
      for (std::size_t k = 1; k < forces.size(); ++k) {
        const bool same_family = (isas[k] == Isa::Baseline || isas[k] == Isa::Avx512);
        if (same_family) {
          EXPECT_EQ(forces[k], forces[k - 1]) << isa_name(isas[k]);
        }
      }
    }
}

/// Four chunks that share nodes: their forces are added in one order whoever computes them.
TEST(OnePointHexahedron, HasTheSameBitsForEveryNumberOfThreads) {
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    std::vector<double> alone;
    for (const int threads : {1, 2, 3, 4}) {
      Driven body(cube(12, 0.2, Form::ExactVolumeStiffness, plastic()),
                  {precision, available_isas().back(), threads});
      ASSERT_GE(body.domain.assembly.chunks().size(), 4U);
      std::mt19937 generator(5);
      std::uniform_real_distribution<double> uniform(-0.01, 0.01);
      std::vector<Vec3> move(static_cast<std::size_t>(body.domain.nodes.count()));
      for (int step = 0; step < 3; ++step) {
        for (Vec3& m : move) m = Vec3{uniform(generator), uniform(generator), uniform(generator)};
        body.step(1e-7, move, std::vector<Vec3>(move.size()));
      }
      std::vector<double> all{body.domain.solids[0].internal_energy, body.domain.solids[0].hourglass_energy};
      for (Index i = 0; i < body.domain.nodes.count(); ++i)
        for (int axis = 0; axis < 3; ++axis) all.push_back(body.force(i)[axis]);
      if (threads == 1) alone = all;
      EXPECT_EQ(all, alone) << threads;
    }
  }
}

TEST(OnePointHexahedron, StepIsThatOfAWaveAcrossTheThinnestWay) {
  model::Model model = cube(1, 0, Form::ExactVolumeViscous);
  for (auto& x : model.nodes.position) x[2] *= 0.25;
  Driven body(model, {Precision::Double, available_isas().back(), 1});
  const double nu = poissons_ratio;
  const double speed = std::sqrt(youngs_modulus * (1 - nu) / (density * (1 + nu) * (1 - 2 * nu)));
  EXPECT_NEAR(stable_step(body.domain, body.domain.solids[0]), 0.5 / speed, 1e-12 / speed);
  body.update(0);
  EXPECT_NEAR(body.domain.clock.element_limit, 0.5 / speed, 1e-12 / speed);
}

TEST(OnePointHexahedron, OfNegativeVolumeIsRefusedByName) {
  model::Model model = cube(1, 0, Form::StandardViscous);
  std::swap(model.solids[0].node[0], model.solids[0].node[4]);
  std::swap(model.solids[0].node[1], model.solids[0].node[5]);
  std::swap(model.solids[0].node[2], model.solids[0].node[6]);
  std::swap(model.solids[0].node[3], model.solids[0].node[7]);
  try {
    Driven body(model, {Precision::Double, available_isas().back(), 1});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("Solid 1 has no positive volume"), std::string::npos);
  }
}

}  // namespace
}  // namespace crumple::elements::testing
