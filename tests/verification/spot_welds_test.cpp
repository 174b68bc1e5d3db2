// SPDX-License-Identifier: BSD-3-Clause
//
// Spot weld beams (*MAT_SPOTWELD, ELFORM 9), alone and tied to sheets (*CONTACT_SPOTWELD).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/verified.hpp"

namespace crumple::spot_welds_test {
namespace {

using math::Vec3;
using test::Point;

constexpr double pi = std::numbers::pi;

model::BeamSection round_section(double diameter) {
  model::BeamSection section;
  section.id = 1;
  section.formulation = model::BeamFormulation::SpotWeld;
  section.area = pi * diameter * diameter / 4;
  section.inertia_s = section.inertia_t = section.area * diameter * diameter / 16;
  section.torsion = 2 * section.inertia_s;
  section.shear_area = section.area;
  return section;
}

model::Material weld_material(const model::SpotWeldLaw& law) {
  return {.id = 1, .title = "weld", .density = 7.85e-6, .law = law};
}

/// kN, mm, ms.
model::SpotWeldLaw steel() {
  return {.youngs_modulus = 210, .poissons_ratio = 0.3, .yield_stress = 1e3};
}

TEST(SpotWelds, CantileverBendsAndShearsAsTimoshenkoSays) {
  constexpr double length = 6;
  constexpr double force = 1e-3;
  const model::BeamSection section = round_section(5);
  model::Model model = test::one_beam_part(weld_material(steel()), section);
  test::add_line(model, 3, {0, 1, 0}, [](double u) { return Point{u * length, 0, 0}; });
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.curves.push_back({1, {0, 0.3, 1e9}, {0, 1, 1}});
  model.nodal_loads.push_back({.node = 3, .force = {0, force, 0}, .curve = 0});
  model.control.end_time = 2;
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 2e-2);
  const double bending = force * length * length * length / (3 * 210 * section.inertia_t);
  const double exact = bending + force * length / (210 / 2.6 * section.shear_area);
  test::verified("cantilever of three weld beams, slenderness 1.2: deflection over exact", "Timoshenko")
      .near(test::displacement(simulation.domain(), 3).y / exact, 1, 1e-5);
  EXPECT_GT(exact, 1.3 * bending) << "shear must matter for the test to show it";
}

/// A weld of length 2 with heavy ends that tumble and shake.
model::Model tumbling(const model::SpotWeldLaw& law) {
  model::Model model = test::one_beam_part(weld_material(law), round_section(5));
  test::add_line(model, 1, {0, 1, 0}, [](double u) { return Point{2 * u - 1, 0, 0}; });
  const Vec3 spin{0.2, 0.4, 0.3};
  for (Index i = 0; i < 2; ++i) {
    model.lumped_masses.push_back({.id = i + 1, .node = i, .mass = 0.1, .inertia = 0.1});
    const Vec3 v = cross(spin, Vec3{i == 0 ? -1.0 : 1.0, 0, 0});
    model.initial_velocities.push_back(
        {.node = i, .velocity = {v.x, v.y, v.z}, .angular_velocity = {spin.x, spin.y, spin.z + 0.05 * i}});
  }
  return model;
}

TEST(SpotWelds, TurningMakesNoForceAndKeepsEnergyAndMomenta) {
  model::Model model = tumbling(steel());
  for (model::InitialVelocity& given : model.initial_velocities) given.angular_velocity[2] = 0.3;
  model.control.end_time = 2 * pi / 0.5385;  // one turn
  timeloop::Simulation simulation(model, test::execution());
  double most = 0;
  double worst = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    most = test::larger_of(most, domain.energy.internal);
    worst = test::larger_of(worst, std::fabs(domain.energy.imbalance()));
  });
  const double kinetic = simulation.domain().energy.initial_total;
  // The pull of the ends on the bar, m v^2 / r, stretches it: F^2 l / 2 E A.
  const double pull = 0.1 * 0.25;
  EXPECT_LT(most, 8 * pull * pull * 2 / (2 * 210 * round_section(5).area));
  test::verified("weld beam turns once: energy over the kinetic one", "conservation")
      .below(worst / kinetic, 1e-5);
  EXPECT_LT(norm(test::momentum(simulation.domain())), 1e-12);
}

TEST(SpotWelds, PlasticWeldStopsAMassWhereItsWorkIsDone) {
  model::SpotWeldLaw law = steel();
  law.yield_stress = 0.3;
  law.hardening = 1;
  model::Model model = test::one_beam_part(weld_material(law), round_section(4));
  test::add_line(model, 1, {0, 1, 0}, [](double u) { return Point{10 * u, 0, 0}; });
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.lumped_masses.push_back({.id = 1, .node = 1, .mass = 1.0});
  model.initial_velocities.push_back({.node = 1, .velocity = {2, 0, 0}});
  model.control.end_time = 1.5;
  timeloop::Simulation simulation(model, test::execution());
  double stretch = 0;
  double strain = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    stretch = test::larger_of(stretch, test::displacement(domain, 1).x);
    const domain::BeamBlock& block = domain.beams[0];
    strain = block.state(0, block.find("plastic_strain")->first);
  });
  // 1/2 m v^2 = V (sy p + H p^2 / 2 + s^2 / 2 E), s = sy + H p.
  const double per_volume = 0.5 * 4 / (10 * pi * 4);
  double p = per_volume / 0.3;
  for (int i = 0; i < 50; ++i) {
    const double s = 0.3 + p;
    p -= (0.3 * p + 0.5 * p * p + s * s / 420 - per_volume) / (s + s / 210);
  }
  test::verified("elastic-plastic weld stops a mass: plastic strain over exact", "energy")
      .near(strain / p, 1, 2e-3);
  EXPECT_NEAR(stretch, 10 * (p + (0.3 + p) / 210), 2e-3 * stretch);
  EXPECT_LT(simulation.domain().energy.error(), 1e-3);
}

/// Two sheets of 40 x 20 x 1, 1 apart, that overlap by 20; a weld in the middle of the overlap; the far edge
/// of the second one moves along `axis`, that of the first one is held.
model::Model lap_joint(int axis, const model::SpotWeldLaw& law) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1, 2));
  model.parts.push_back({.id = 2, .title = "second", .section = 0, .material = 0});
  const Index first = test::add_grid(model, 0, 8, 4, [](double u, double v) {
    return Point{40 * u, 20 * v, 0};
  });
  const Index second = test::add_grid(model, 1, 8, 4, [](double u, double v) {
    return Point{20 + 40 * u, 20 * v, 1};
  });
  model.materials.push_back(weld_material(law));
  model.beam_sections.push_back(round_section(5));
  model.parts.push_back({.id = 3, .title = "weld", .beam_section = 0, .material = 1});
  const Index weld = model.nodes.count();
  for (const double z : {0.1, 0.9}) {
    model.nodes.id.push_back(model.nodes.count() + 1);
    model.nodes.position.push_back({31, 9, z});
  }
  model.beams.push_back({.id = 77, .part = 2, .node = {weld, weld + 1}});
  model::TiedContact& tied = model.tied_contacts.emplace_back();
  tied.id = 7;
  tied.ties_rotations = true;
  tied.side[0].nodes = {weld, weld + 1};
  tied.side[1].parts = {0, 1};
  model.curves.push_back({1, {0, 0.1, 1e9}, {0, 1, 1}});
  for (Index j = 0; j <= 4; ++j) {
    model.fixed_nodes.push_back(
        {.node = first + 9 * j, .translation = {true, true, true}, .rotation = {true, true, true}});
    const Index moved = second + 9 * j + 8;
    model.prescribed_motions.push_back({.node = moved, .axis = axis, .curve = 0, .scale = 1});
    model::FixedNode rest{.node = moved, .translation = {true, true, true}, .rotation = {true, true, true}};
    rest.translation[static_cast<std::size_t>(axis)] = false;
    model.fixed_nodes.push_back(rest);
  }
  model.control.end_time = 1.0;
  return model;
}

struct Joint {
  double largest_axial = 0;
  double largest_shear = 0;
  double failure_time = 0;
  double energy_error = 0;  ///< of the whole run, over the work done
};

Joint pull_apart(const model::Model& model) {
  timeloop::Simulation simulation(model, test::execution());
  Joint joint;
  test::run(simulation, [&](const domain::Domain& domain) {
    const domain::BeamBlock& block = domain.beams[0];
    const auto q = [&](Index i) { return block.state(0, block.find("resultant")->first + i); };
    joint.largest_axial = test::larger_of(joint.largest_axial, q(0));
    // The weld is one long from sheet to sheet once it is tied.
    joint.largest_shear = test::larger_of(joint.largest_shear, std::hypot(q(2) + q(4), q(3) + q(5)));
    joint.energy_error = test::larger_of(joint.energy_error, std::fabs(domain.energy.imbalance()));
  });
  const domain::Domain& domain = simulation.domain();
  EXPECT_EQ(domain.ties[0].nodes.size(), 2U);
  EXPECT_NEAR(domain.beams[0].state(0, domain.beams[0].find("reference_length")->first), 1, 1e-12);
  joint.failure_time = domain.beams[0].state(0, domain.beams[0].find("failure_time")->first);
  joint.energy_error /= domain.energy.external_work;
  EXPECT_EQ(domain.beams[0].eroded, 1);
  return joint;
}

TEST(SpotWelds, LapJointPulledAlongFailsByShear) {
  model::SpotWeldLaw law = steel();
  law.shear_strength_s = law.shear_strength_t = 3;
  law.tension_strength = 1e3;
  const Joint joint = pull_apart(lap_joint(0, law));
  std::printf("shear %.4f, fails at %.4f, energy %.2e\n", joint.largest_shear, joint.failure_time,
              joint.energy_error);
  test::verified("lap joint with one weld, pulled along: largest shear over its strength", "criterion")
      .near(joint.largest_shear / 3, 1, 0.02);
  EXPECT_LE(joint.largest_shear, 3);
  test::verified("lap joint with one weld, pulled along until after failure: energy error over the work",
                 "conservation")
      .below(joint.energy_error, 5e-3);
}

TEST(SpotWelds, LapJointPulledAcrossFailsByTension) {
  model::SpotWeldLaw law = steel();
  law.tension_strength = 0.01;
  const Joint joint = pull_apart(lap_joint(2, law));
  std::printf("tension %.4f, fails at %.4f, energy %.2e\n", joint.largest_axial, joint.failure_time,
              joint.energy_error);
  test::verified("lap joint with one weld, pulled across: largest tension over its strength", "criterion")
      .near(joint.largest_axial / 0.01, 1, 0.02);
  EXPECT_LE(joint.largest_axial, 0.01);
  EXPECT_LT(joint.energy_error, 5e-3);
}

TEST(SpotWelds, SameBitsForThreadsAndInstructionSets) {
  const auto hash = [](int threads, Isa isa) {
    model::SpotWeldLaw law = steel();
    law.yield_stress = 0.3;
    law.hardening = 1;
    law.tension_strength = 4;
    law.shear_strength_s = law.shear_strength_t = 2;
    law.torsion_strength = 3.5;
    law.bending_strength_s = law.bending_strength_t = 4;
    model::Model model = test::one_beam_part(weld_material(law), round_section(5));
    test::add_line(model, 200, {0, 1, 0}, [](double u) { return Point{1000 * u, 0, 0}; });
    for (Index i = 0; i <= 200; ++i) {
      const double size = i / 200.0;  // so that some fail, and some do not even yield
      model.initial_velocities.push_back(
          {.node = i,
           .velocity = {2 * size * std::sin(7.0 * i), 2 * size * std::cos(5.0 * i), 0.1},
           .angular_velocity = {size * std::cos(2.0 * i), size * std::sin(4.0 * i), size}});
    }
    model.control.end_cycle = 60;
    model.control.end_time = 1e9;
    timeloop::Simulation simulation(model, {Precision::Double, isa, threads});
    test::run(simulation);
    EXPECT_GT(simulation.domain().beams[0].eroded, 0);
    EXPECT_LT(simulation.domain().beams[0].eroded, 200);
    return simulation.state_hash();
  };
  const Isa best = default_isa();
  EXPECT_EQ(hash(1, best), hash(2, best));
  EXPECT_EQ(hash(1, best), hash(3, best));
  EXPECT_EQ(hash(1, Isa::Scalar), hash(1, Isa::Baseline));
  const std::vector<Isa> isas = available_isas();
  if (isas.size() == 4) {
    EXPECT_EQ(hash(1, isas[2]), hash(1, isas[3]));
  }
}

}  // namespace
}  // namespace crumple::spot_welds_test
