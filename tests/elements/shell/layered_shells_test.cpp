// SPDX-License-Identifier: BSD-3-Clause
// Layered shells against classical laminate theory, and against shells of one material each.
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "elements/shell_harness.hpp"
#include "support/alike.hpp"
#include "support/largest.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::layered_shells_test {
namespace {

constexpr double side = 5;
constexpr double degree = std::numbers::pi / 180;
const domain::Execution doubles{Precision::Double, available_isas().back(), 1};

/// Graphite-epoxy, E1 / E2 = 25, G12 / E2 = 0.5, G23 / E2 = 0.2, nu12 = 0.25: the material of the examples in
/// J.N. Reddy, Mechanics of Laminated Composite Plates and Shells, 2nd ed. 2004, chapter 7.
model::OrthotropicElastic graphite() {
  model::OrthotropicElastic law;
  law.modulus_a = 250000;
  law.modulus_b = law.modulus_c = 10000;
  law.poisson_ba = law.poisson_ca = 0.25 / 25;
  law.poisson_cb = 0.25;
  law.shear_ab = law.shear_ca = 5000;
  law.shear_bc = 2000;
  law.axes = model::OrthotropicElastic::Axes::Vector;
  law.direction = {1, 0, 0};
  set_stand_in(law);
  return law;
}

struct Ply {
  double thickness;
  double angle;  ///< [degree]
};
using Three = std::array<std::array<double, 3>, 3>;

/// Reduced stiffness of a ply in the axes of the laminate: Jones, Mechanics of Composite Materials, 2nd ed.
/// 1999, eq. (2.80) by tensor algebra.
Three turned_stiffness(double degrees) {
  const model::OrthotropicElastic law = graphite();
  const double ratio = 1 - law.poisson_ba * law.poisson_ba * law.modulus_a / law.modulus_b;
  const Three own{{{law.modulus_a / ratio, law.poisson_ba * law.modulus_a / ratio, 0},
                   {law.poisson_ba * law.modulus_a / ratio, law.modulus_b / ratio, 0},
                   {0, 0, law.shear_ab}}};
  const double c = std::cos(degrees * degree);
  const double s = std::sin(degrees * degree);
  // Strains (engineering shears) in the axes of the ply from those of the laminate; energy is the same.
  const Three turn{{{c * c, s * s, c * s}, {s * s, c * c, -c * s}, {-2 * c * s, 2 * c * s, c * c - s * s}}};
  Three q{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l) q[i][j] += turn[k][i] * own[k][l] * turn[l][j];
  return q;
}

/// A, B and D as one matrix: forces and moments per length over strains and curvatures of the mid-surface.
using Six = std::array<std::array<double, 6>, 6>;
double total_of(const std::vector<Ply>& plies) {
  return std::accumulate(plies.begin(), plies.end(), 0.0,
                         [](double sum, const Ply& ply) { return sum + ply.thickness; });
}
/// Jones, eqs. (4.22) to (4.24); `own_bending` is false where each ply has one point in its middle.
Six laminate(const std::vector<Ply>& plies, bool own_bending) {
  Six abd{};
  double z = -0.5 * total_of(plies);
  for (const Ply& ply : plies) {
    const Three q = turned_stiffness(ply.angle);
    const double middle = z + 0.5 * ply.thickness;
    const double second = ply.thickness * middle * middle +
                          (own_bending ? ply.thickness * ply.thickness * ply.thickness / 12 : 0);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        abd[i][j] += q[i][j] * ply.thickness;
        abd[i][j + 3] += q[i][j] * ply.thickness * middle;
        abd[i + 3][j] += q[i][j] * ply.thickness * middle;
        abd[i + 3][j + 3] += q[i][j] * second;
      }
    z += ply.thickness;
  }
  return abd;
}

model::Model with_layup(model::Model model, model::Layup layup) {
  model::Material mean = layup_material(model, layup);
  mean.id = 100;
  layup.material = static_cast<Index>(model.materials.size());
  model.materials.push_back(mean);
  model.parts[0].material = layup.material;
  model.parts[0].layup = static_cast<Index>(model.layups.size());
  model.layups.push_back(std::move(layup));
  model.control.hourglass = no_hourglass_control();
  return model;
}

/// Plies with one point in the middle, or with two at the places of Gauss.
model::Layup layup_of(const std::vector<Ply>& plies, bool gauss) {
  model::Layup layup;
  const double total = total_of(plies);
  double below = 0;
  for (const Ply& ply : plies) {
    const double middle = (2 * below + ply.thickness) / total - 1;
    const double apart = ply.thickness / total / std::sqrt(3.0);
    if (gauss)
      for (const double off : {-apart, apart})
        layup.layers.push_back({0, middle + off, 0.5 * ply.thickness / total, ply.angle * degree});
    else
      layup.layers.push_back({0, middle, ply.thickness / total, ply.angle * degree});
    below += ply.thickness;
  }
  return layup;
}

/// Motion of the nodes under one strain or curvature, without transverse shear.
struct Mode {
  std::vector<Vec3> u, turn;
};
Mode mode_of(const domain::Domain& domain, std::size_t which, double size) {
  Mode mode;
  for (const Vec3& at : domain.nodes.position) {
    const double x = at.x - 0.5 * side;
    const double y = at.y - 0.5 * side;
    const Vec3 u[] = {
        {x, 0, 0},           {0, y, 0}, {0.5 * y, 0.5 * x, 0}, {0, 0, -0.5 * x * x}, {0, 0, -0.5 * y * y},
        {0, 0, -0.5 * x * y}};
    const Vec3 turn[] = {{}, {}, {}, {0, x, 0}, {-y, 0, 0}, {-0.5 * x, 0.5 * y, 0}};
    mode.u.push_back(size * u[which]);
    mode.turn.push_back(size * turn[which]);
  }
  return mode;
}

/// The same matrix from the work of the nodal forces on each mode.
Six measured(const model::Model& model) {
  constexpr double size = 1e-7;
  Six found{};
  for (std::size_t column = 0; column < 6; ++column) {
    Driven loaded(model, doubles);
    const Mode motion = mode_of(loaded.domain, column, size);
    std::array<Mode, 6> tests;
    for (std::size_t row = 0; row < 6; ++row) tests[row] = mode_of(loaded.domain, row, 1);
    loaded.step(1e-6, motion.u, motion.turn);
    for (std::size_t row = 0; row < 6; ++row) {
      double work = 0;
      for (Index i = 0; i < loaded.domain.nodes.count(); ++i)
        work += dot(loaded.force(i), tests[row].u[static_cast<std::size_t>(i)]) +
                dot(loaded.moment(i), tests[row].turn[static_cast<std::size_t>(i)]);
      found[row][column] = -work / (size * side * side);
    }
  }
  return found;
}

model::Model square(model::ShellFormulation formulation, double total) {
  model::Model model =
      plate(formulation, 1, 0, 2, {.id = 1, .title = "", .density = density, .law = graphite()});
  model.shell_sections[0].thickness = {total, total, total, total};
  return model;
}

/// Largest difference, each block of the matrix over the largest number that it could have.
double difference(const Six& found, const Six& expected, double total) {
  const double largest = turned_stiffness(0)[0][0];
  double off = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const int power = 1 + (i > 2 ? 1 : 0) + (j > 2 ? 1 : 0);
      const double scale = largest * std::pow(total, power) / (power == 3 ? 12 : power == 2 ? 4 : 1);
      off = test::larger_of(off, std::fabs(found[i][j] - expected[i][j]) / scale);
    }
  return off;
}

const std::vector<std::pair<const char*, std::vector<Ply>>> laminates{
    {"one ply at 30", {{1.5, 30}}},
    {"antisymmetric cross-ply 0/90", {{0.75, 0}, {0.75, 90}}},
    {"antisymmetric angle-ply -45/45", {{0.75, -45}, {0.75, 45}}},
    {"symmetric 0/45/-45/90/90/-45/45/0",
     {{0.1, 0}, {0.1, 45}, {0.1, -45}, {0.1, 90}, {0.1, 90}, {0.1, -45}, {0.1, 45}, {0.1, 0}}},
    {"plies of different thickness 20/-70/5", {{0.2, 20}, {0.7, -70}, {0.6, 5}}}};

TEST(LayeredShells, StiffnessesAreThoseOfLaminateTheory) {
  for (const Kind& kind : kinds)
    for (const auto& [name, plies] : laminates) {
      const double total = total_of(plies);
      const model::Model model = square(kind.formulation, total);
      const Six by_gauss = measured(with_layup(model, layup_of(plies, true)));
      test::verified(std::string(kind.name) + ", " + name + ": A, B and D, two points a ply, largest error",
                     "Jones 1999, (4.22) to (4.24)")
          .below(difference(by_gauss, laminate(plies, true), total), 1e-6);
      const Six by_middle = measured(with_layup(model, layup_of(plies, false)));
      test::verified(std::string(kind.name) + ", " + name + ": A, B and D, one point a ply, largest error",
                     "the same without each ply's own t^3/12")
          .below(difference(by_middle, laminate(plies, false), total), 1e-6);
    }
}

/// One point a ply lacks its own t^3/12: the bending stiffness of a stack of n like plies lacks 1/n^2.
TEST(LayeredShells, BendingStiffnessOfOnePointAPlyComesNearerWithTheSquareOfThePlies) {
  const model::Model model = square(model::ShellFormulation::BelytschkoTsay, 1.5);
  for (const int count : {1, 2, 4, 8}) {
    const std::vector<Ply> plies(static_cast<std::size_t>(count), Ply{1.5 / count, 0});
    const Six found = measured(with_layup(model, layup_of(plies, false)));
    test::verified(std::to_string(count) + " plies with one point each: D11 over that of the sheet",
                   "1 - 1 / n^2")
        .near(found[3][3] / laminate(plies, true)[3][3], 1 - 1.0 / (count * count), 1e-6);
  }
}

/// Coupling of stretch and bending of two plies in closed form (Jones, sections 4.4.3 and 4.4.4): cross-ply
/// B11 = -B22 = t^2 (Q22 - Q11) / 8 with the fibres of the lower ply along x, angle-ply B16 = t^2 Q16 / 4.
TEST(LayeredShells, CouplingOfAntisymmetricLaminates) {
  constexpr double t = 1.5;
  for (const Kind& kind : kinds) {
    const model::Model model = square(kind.formulation, t);
    const Six cross = measured(with_layup(model, layup_of(laminates[1].second, false)));
    const Three q = turned_stiffness(0);
    const double b11 = t * t * (q[1][1] - q[0][0]) / 8;
    const std::string of = std::string(kind.name) + ", ";
    test::verified(of + "0/90: B11", "Jones 1999, cross-ply").within(cross[0][3], b11, 1e-6);
    test::verified(of + "0/90: B22", "Jones 1999, cross-ply").within(cross[1][4], -b11, 1e-6);
    const Six angle = measured(with_layup(model, layup_of(laminates[2].second, false)));
    const double q16 = turned_stiffness(45)[0][2];
    test::verified(of + "-45/45: B16", "Jones 1999, angle-ply").within(angle[0][5], t * t * q16 / 4, 1e-6);
    test::verified(of + "-45/45: A16 over A11", "Jones 1999, angle-ply")
        .near(angle[0][2] / angle[0][0], 0, 1e-6);
  }
}

model::Material weak(double failure_strain) {
  model::Material material = plastic(1, 0);
  auto& law = std::get<model::PlasticKinematic>(material.law);
  law.yield_stress = 100;
  law.failure_strain = failure_strain;
  return material;
}

/// Layers of an elastic, two plastic and an orthotropic law.
model::Model mixed(model::ShellFormulation formulation) {
  model::Model model = plate(formulation, 2, 0.1, 2, elastic());
  model.materials.push_back(plastic());
  model.materials.push_back(weak(0));
  model.materials.push_back({.id = 4, .title = "", .density = 1.6e-9, .law = graphite()});
  model::Layup layup;
  const double shares[] = {0.1, 0.25, 0.15, 0.3, 0.2};
  const Index materials[] = {0, 1, 1, 3, 2};
  double below = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    layup.layers.push_back({materials[i], 2 * below + shares[i] - 1, shares[i], i == 3 ? 0.4 : 0});
    below += shares[i];
  }
  return with_layup(std::move(model), std::move(layup));
}

/// A sheet of the material of one of these layers alone under the same motion.
model::Model sheet_of(const model::Model& layered, std::size_t layer) {
  model::Model model = layered;
  const model::ShellLayer& its = layered.layups[0].layers[layer];
  model.parts[0].layup = no_index;
  model.parts[0].material = its.material;
  if (auto* law = std::get_if<model::OrthotropicElastic>(&model.materials[its.material].law))
    law->angle = its.angle;
  return model;
}

/// Stretched beyond yield in several steps the forces are the sum of those of sheets of each material, which
/// have their share of the thickness: an independent way through the code.
TEST(LayeredShells, LayersOfDifferentLawsActSideBySide) {
  for (const Kind& kind : all_kinds) {
    test::Largest forces(std::string(kind.name) + ", layers of four laws: force, relative error",
                         "sum over sheets of one law", 1e-11);
    test::Largest energies(std::string(kind.name) + ", layers of four laws: energy, relative error",
                           "sum over sheets of one law", 1e-11);
    const model::Model model = mixed(kind.formulation);
    const auto stretch = [](Driven& body) {
      for (int i = 0; i < 20; ++i)
        body.step(
            1e-6,
            [](const Vec3& x) {
              return Vec3{(1 + 2e-4) * x.x + 1e-4 * x.y, (1 - 1e-4) * x.y, x.z};
            },
            [](const Vec3&) { return Vec3{}; });
    };
    Driven layered(model, doubles);
    stretch(layered);
    std::vector<Vec3> sum(static_cast<std::size_t>(layered.domain.nodes.count()));
    double energy = 0;
    for (std::size_t layer = 0; layer < 5; ++layer) {
      Driven sheet(sheet_of(model, layer), doubles);
      stretch(sheet);
      const double share = model.layups[0].layers[layer].share;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * sheet.force(static_cast<Index>(i));
      for (const domain::ShellBlock& block : sheet.domain.shells) energy += share * block.internal_energy;
    }
    double largest = 0;
    for (const Vec3& force : sum) largest = std::max(largest, norm(force));
    for (std::size_t i = 0; i < sum.size(); ++i)
      forces.compare(norm(layered.force(static_cast<Index>(i)) - sum[i]), 0, largest);
    double found = 0;
    for (const domain::ShellBlock& block : layered.domain.shells) found += block.internal_energy;
    energies.compare(found, energy, energy);
  }
}

/// The same motion gives the same bits with instruction sets of the same rounding.
TEST(LayeredShells, InstructionSetsOfTheSameRoundingAgree) {
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    std::vector<double> forces;
    for (const Isa isa : available_isas()) {
      Driven body(mixed(model::ShellFormulation::FullyIntegrated), {precision, isa, 1});
      for (int i = 0; i < 10; ++i)
        body.step(
            1e-6,
            [](const Vec3& x) {
              return Vec3{(1 + 2e-4) * x.x + 1e-4 * x.y, x.y, 1e-4 * x.x * x.y + x.z};
            },
            [](const Vec3& x) {
              return Vec3{1e-4 * x.y, 1e-4, 0};
            });
      forces.push_back(body.force(3).x);
    }
    test::expect_alike(forces, std::equal_to<>());
  }
}

/// A sheet that is divided into layers of its own material is the sheet.
TEST(LayeredShells, LayersOfOneMaterialByTheSectionsRuleAreTheSheet) {
  for (const Kind& kind : kinds) {
    model::Model sheet = plate(kind.formulation, 2, 0.1, 3, plastic());
    sheet.control.hourglass = no_hourglass_control();
    model::Layup layup;
    layup.follows_rule = true;
    layup.layers.assign(3, {.material = 0, .share = 1.0 / 3, .angle = 0.3});
    const model::Model layered = with_layup(sheet, layup);
    EXPECT_NEAR(std::get<model::Elastic>(layered.materials.back().law).youngs_modulus, youngs_modulus, 1e-6);
    EXPECT_NEAR(std::get<model::Elastic>(layered.materials.back().law).poissons_ratio, poissons_ratio, 1e-12);
    Driven a(sheet, doubles);
    Driven b(layered, doubles);
    ASSERT_EQ(b.block().runs.size(), 1U);
    for (Driven* body : {&a, &b})
      for (int i = 0; i < 10; ++i)
        body->step(
            1e-6,
            [](const Vec3& x) {
              return Vec3{(1 + 2e-4) * x.x, x.y, 1e-3 * x.x + x.z};
            },
            [](const Vec3& x) {
              return Vec3{0, 1e-4 * x.x, 0};
            });
    for (Index i = 0; i < a.domain.nodes.count(); ++i)
      EXPECT_LT(norm(a.force(i) - b.force(i)), 1e-9 * (1 + norm(a.force(i)))) << kind.name;
  }
}

/// Layers that fail take their shells along, unless there are layers that cannot and FAILOPT says that these
/// hold them.
TEST(LayeredShells, GoWhenAllLayersHaveFailedThatCan) {
  for (const Kind& kind : kinds)
    for (const bool hold : {false, true}) {
      model::Model model = plate(kind.formulation, 1, 0, 2, elastic());
      model.materials.push_back(weak(0.002));
      model.materials.push_back(weak(0.006));
      model::Layup layup;
      layup.unfailing_layers_hold = hold;
      layup.layers = {{0, -2.0 / 3, 1.0 / 3, 0}, {1, 0, 1.0 / 3, 0}, {2, 2.0 / 3, 1.0 / 3, 0}};
      model = with_layup(std::move(model), layup);
      Driven body(model, doubles);
      std::vector<Index> eroded;
      for (int i = 0; i < 10; ++i) {
        body.step(
            1e-6,
            [](const Vec3& x) {
              return Vec3{(1 + 1e-3) * x.x, x.y, x.z};
            },
            [](const Vec3&) { return Vec3{}; });
        eroded.push_back(body.block().eroded);
        if (i == 4) {
          EXPECT_EQ(body.stress(0, 1, 0), 0) << "the weaker layer has failed";
          EXPECT_GT(body.stress(0, 2, 0), 50);
          EXPECT_EQ(eroded.back(), 0);
        }
      }
      EXPECT_EQ(eroded.back(), hold ? 0 : 1) << kind.name;
      EXPECT_NEAR(body.item("active", 0), hold ? 1 : 0, 0);
      for (Index point = 0; point < body.block().points && !hold; ++point)
        EXPECT_EQ(body.stress(0, point, 0), 0) << "the elastic layer goes with the shell";
    }
}

/// Shells with layups of their own, each with its angles, are those of a part with that layup.
TEST(LayeredShells, ElementsWithTheirOwnLayups) {
  const std::vector<Ply> plies{{0.6, 20}, {0.9, -50}};
  const model::Model one =
      with_layup(square(model::ShellFormulation::BelytschkoTsay, 1.5), layup_of(plies, false));
  model::Model own = one;
  own.parts[0].layup = no_index;
  own.layups[0].layers[0].angle = own.layups[0].layers[1].angle = 0;
  own.layer_angles = {9, 20 * degree, -50 * degree};
  own.shells[0].layup = 0;
  own.shells[0].layer_angles = 1;
  const Six a = measured(one);
  const Six b = measured(own);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) EXPECT_EQ(a[i][j], b[i][j]) << i << " " << j;
}

/// Mass and step: the mean density; the bound of the step is that of stretching and bending together.
TEST(LayeredShells, MeanDensityAndASafeStep) {
  model::Model model = plate(model::ShellFormulation::BelytschkoTsay, 1, 0, 2, elastic());
  model::Material core = elastic();
  core.density = 1e-10;
  core.law = model::Elastic{70, 0.3};
  model.materials.push_back(core);
  model::Layup sandwich;
  sandwich.layers = {{0, -0.95, 0.05, 0}, {1, 0, 0.9, 0}, {0, 0.95, 0.05, 0}};
  model = with_layup(std::move(model), sandwich);
  const Driven body(model, doubles);
  const double mass = std::accumulate(body.domain.nodes.mass.begin(), body.domain.nodes.mass.end(), 0.0);
  const double mean = 0.1 * density + 0.9 * 1e-10;
  EXPECT_NEAR(mass / (mean * side * side * thickness), 1, 1e-12);
  const auto& law = std::get<model::Elastic>(model.materials.back().law);
  const double plate_modulus = law.youngs_modulus / (1 - law.poissons_ratio * law.poissons_ratio);
  const double skin = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
  const double bending = 3 * 2 * 0.05 * (0.95 * 0.95 + 0.05 * 0.05 / 3) * skin;
  EXPECT_GT(plate_modulus, bending) << "bending is stiffer than stretching";
  EXPECT_LT(plate_modulus, 1.01 * bending);
}

}  // namespace
}  // namespace crumple::elements::testing::layered_shells_test
