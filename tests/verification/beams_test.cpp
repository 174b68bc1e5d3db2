// SPDX-License-Identifier: BSD-3-Clause
//
// Beams and trusses against closed forms. Static solutions are reached by loads that rise slowly while the
// velocities are damped.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/verified.hpp"

namespace crumple::beams_test {
namespace {

constexpr double pi = std::numbers::pi;
using test::Point;

/// A cantilever of 10 beams along x, orientation towards y: s is y, t is z.
model::Model cantilever(const model::BeamSection& section, double length, Index count = 10) {
  model::Model model =
      test::one_beam_part({.id = 1, .title = "m", .density = 1.0, .law = model::Elastic{1e4, 0.25}}, section);
  test::add_line(model, count, {0, 1, 0}, [&](double u) { return Point{u * length, 0, 0}; });
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  return model;
}

/// A load that is full at three tenths of the end time.
void load_slowly(model::Model& model, const model::NodalLoad& load) {
  const auto curve = static_cast<Index>(model.curves.size());
  model.curves.push_back({curve + 1, {0, 0.3 * model.control.end_time, 1e9}, {0, 1, 1}});
  model.nodal_loads.push_back(load);
  model.nodal_loads.back().curve = curve;
}

math::Vec3 tip_position(const timeloop::Simulation& simulation, Index node) {
  const domain::NodeFields& nodes = simulation.domain().nodes;
  return nodes.position[nodes.domain_node[node]];
}

TEST(Beams, CantileverBendsStretchesAndTwistsAsItsSectionSays) {
  constexpr double length = 10;
  const model::BeamSection section = test::rectangle(0.4, 0.2, 1e-3);
  model::Model model = cantilever(section, length);
  model.control.end_time = 400;
  const math::Vec3 force{1e-6, 2e-7, 1e-7};
  load_slowly(model, {.node = 10, .force = {force.x, force.y, force.z}, .moment = {1e-6, 0, 0}});
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 2e-3);
  const math::Vec3 u = test::displacement(simulation.domain(), 10);
  const double cube = length * length * length / 3;
  const double y = force.y * cube / (1e4 * section.inertia_t);
  const double z = force.z * cube / (1e4 * section.inertia_s);
  RecordProperty("deflection_over_exact", std::to_string(u.y / y));
  EXPECT_NEAR(u.y, y, 1e-3 * y);
  EXPECT_NEAR(u.z, z, 1e-3 * z);
  EXPECT_NEAR(u.x, force.x * length / (1e4 * section.area), 0.01 * force.x * length / (1e4 * section.area));
  const domain::BeamBlock& block = simulation.domain().beams[0];
  const Index resultant = block.find("resultant")->first;
  EXPECT_NEAR(block.state(0, resultant), force.x, 1e-3 * force.x);
  EXPECT_NEAR(block.state(0, resultant + 1), 1e-6, 1e-9);
  EXPECT_NEAR(block.state(0, resultant + 3), -force.y * length, 1e-3 * force.y * length);
}

/// Static deflection under a small force at the tip.
double deflection(const model::BeamSection& section, double length, double force) {
  model::Model model = cantilever(section, length);
  model.control.end_time = 40 * length;
  load_slowly(model, {.node = 10, .force = {0, force, 0}});
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 2e-3);
  return test::displacement(simulation.domain(), 10).y;
}

TEST(Beams, SlenderCantileverDeflectsAsEulerAndBernoulliSay) {
  const model::BeamSection section = test::rectangle(0.2, 0.2, 2e-4);
  constexpr double force = 1e-6;
  const double exact = force * 1000 / (3 * 1e4 * section.inertia_t);
  const double found = deflection(section, 10, force);
  test::verified("slender cantilever, ten beams: deflection over exact", "Euler and Bernoulli")
      .near(found / exact, 1, 1e-5);
}

TEST(Beams, ThickCantileverShearsAsTimoshenkoSays) {
  model::BeamSection section = test::rectangle(1.0, 1.0, 0.14);
  section.shear_area = 5.0 / 6;
  constexpr double force = 1e-4;
  const double bending = force * 27 / (3 * 1e4 * section.inertia_t);
  const double exact = bending + force * 3 / (4e3 * section.shear_area);
  const double found = deflection(section, 3, force);
  test::verified("thick cantilever of beams: deflection over exact", "Timoshenko")
      .near(found / exact, 1, 1e-5);
  EXPECT_GT(exact, 1.05 * bending);
}

/// Frequency of the first bending mode by the mean of crossings of the tip.
double frequency(Index count) {
  constexpr double length = 10;
  const model::BeamSection section = test::rectangle(0.2, 0.2, 2e-4);
  model::Model model = cantilever(section, length, count);
  const double omega = 3.5160152685 / (length * length) * std::sqrt(1e4 * section.inertia_t / section.area);
  for (Index i = 1; i <= count; ++i) {
    // The first mode, about: the polynomial of a uniform load.
    const double x = static_cast<double>(i) / count;
    model.initial_velocities.push_back(
        {.node = i, .velocity = {0, 1e-4 * x * x * (6 - 4 * x + x * x) / 3, 0}});
  }
  model.control.end_time = 2.2 * 2 * pi / omega;
  timeloop::Simulation simulation(model, test::execution());
  double before = 0;
  double time_before = 0;
  double crossing = 0;
  int crossings = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double y = test::displacement(domain, count).y;
    if (before < 0 && y >= 0) {
      crossing = time_before + (domain.clock.time - time_before) * before / (before - y);
      ++crossings;
    }
    before = y;
    time_before = domain.clock.time;
  });
  EXPECT_EQ(crossings, 2);
  return 2 * pi * crossings / crossing / omega;
}

TEST(Beams, FirstFrequencyOfACantileverConvergesToEulerAndBernoulli) {
  const double coarse = frequency(6);
  const double fine = frequency(12);
  RecordProperty("first_frequency_6", std::to_string(coarse));
  test::verified("cantilever, 12 beams: first frequency over exact", "Euler and Bernoulli")
      .near(fine, 1, 6e-3);
  EXPECT_LT(std::fabs(fine - 1), 0.4 * std::fabs(coarse - 1));
}

TEST(Beams, EndMomentRollsACantileverIntoACircle) {
  constexpr double length = 10;
  const model::BeamSection section = test::rectangle(0.2, 0.2, 2e-4);
  model::Model model = cantilever(section, length);
  model.control.end_time = 400;
  load_slowly(model, {.node = 10, .force = {}, .moment = {0, 0, 2 * pi * 1e4 * section.inertia_t / length}});
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 1e-3);
  const math::Vec3 tip = tip_position(simulation, 10);
  const math::Vec3 opposite = tip_position(simulation, 5);
  test::verified("end moment rolls ten beams into a circle: gap over the length", "exact")
      .below(math::norm(tip) / length, 2e-3);
  // A regular polygon of ten sides.
  const double radius = 0.5 * (length / 10) / std::sin(pi / 10);
  EXPECT_NEAR(math::norm(opposite - tip), 2 * radius, 2e-3 * length);
  EXPECT_LT(std::fabs(tip.z), 1e-9);
}

TEST(Beams, BendOf45DegreesGoesWhereOthersFoundIt) {
  // K.J. Bathe and S. Bolourchi, IJNME 14 (1979) 961-986: radius 100, section 1 x 1, E 1e7, eight straight
  // beams, 600 at the tip across the plane: they find the tip at 15.9, 47.2, 53.4. Here against J.C. Simo and
  // L. Vu-Quoc, CMAME 58 (1986) 79-116: 15.79, 47.23, 53.37, a beam with shear.
  model::BeamSection section = test::rectangle(1, 1, 1.0 / 6);
  section.shear_area = 1;
  model::Model model =
      test::one_beam_part({.id = 1, .title = "m", .density = 1.0, .law = model::Elastic{1e7, 0.0}}, section);
  test::add_line(model, 8, {0, 0, 1}, [](double u) {
    const double angle = u * pi / 4;
    return Point{100 * (1 - std::cos(angle)), 100 * std::sin(angle), 0};
  });
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.control.end_time = 200;
  load_slowly(model, {.node = 8, .force = {0, 0, 600}});
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 1e-3);
  const math::Vec3 tip = tip_position(simulation, 8);
  const char* const source = "Simo and Vu-Quoc 1986";
  test::verified("bend of 45 degrees, eight beams: tip, x", source).near(tip.x, 15.79, 0.2);
  test::verified("bend of 45 degrees, eight beams: tip, y", source).near(tip.y, 47.23, 0.2);
  test::verified("bend of 45 degrees, eight beams: tip, z", source).near(tip.z, 53.37, 0.2);
}

math::Vec3 angular_momentum(const domain::Domain& domain) {
  const domain::NodeFields& nodes = domain.nodes;
  math::Vec3 sum;
  for (Index i = 0; i < nodes.count(); ++i)
    sum += nodes.mass[i] * cross(nodes.position[i], nodes.velocity[i]) +
           nodes.inertia[i] * nodes.angular_velocity[i];
  return sum;
}

TEST(Beams, TumblingBeamKeepsEnergyAndAngularMomentum) {
  const model::BeamSection section = test::rectangle(0.4, 0.2, 1e-3);
  model::Model model =
      test::one_beam_part({.id = 1, .title = "m", .density = 1.0, .law = model::Elastic{1e4, 0.25}}, section);
  test::add_line(model, 6, {0, 1, 0}, [](double u) { return Point{4 * u - 2, 0, 0}; });
  const math::Vec3 spin{0.5, 0.3, 1.0};
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const Point& p = model.nodes.position[i];
    const math::Vec3 v = cross(spin, math::Vec3{p[0], p[1], p[2]});
    model.initial_velocities.push_back(
        {.node = i, .velocity = {v.x, v.y, v.z}, .angular_velocity = {spin.x, spin.y, spin.z}});
  }
  model.control.end_time = 20 * 2 * pi;  // about twenty turns
  timeloop::Simulation simulation(model, test::execution());
  math::Vec3 initial;
  double worst = 0;
  double stretched = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.clock.cycle == 0) initial = angular_momentum(domain);
    worst = test::larger_of(worst, std::fabs(domain.energy.imbalance()));
    stretched = test::larger_of(stretched, domain.energy.internal);
  });
  const double kinetic = simulation.domain().energy.initial_total;
  RecordProperty("internal_over_kinetic", std::to_string(stretched / kinetic));
  test::verified("beam tumbles twenty turns: energy over the kinetic one", "conservation")
      .below(worst / kinetic, 1e-3);
  const math::Vec3 end = angular_momentum(simulation.domain());
  EXPECT_LT(math::norm(end - initial), 5e-3 * math::norm(initial));
  EXPECT_LT(math::norm(test::momentum(simulation.domain())), 1e-10);
}

/// A light cantilever with a heavy mass at its tip that moves across it; yield stress 10.
model::Model struck_cantilever(const math::Vec3& velocity) {
  model::Model model = cantilever(test::rectangle(0.4, 0.2, 1e-3), 2, 4);
  model.materials[0] = {
      .id = 1, .title = "", .density = 1e-3, .law = model::ResultantPlasticity{1e4, 0.25, 10}};
  model.lumped_masses.push_back({.id = 1, .node = 4, .mass = 1.0});
  model.initial_velocities.push_back({.node = 4, .velocity = {velocity.x, velocity.y, velocity.z}});
  return model;
}

TEST(Beams, HingeAtTheFootTakesTheEnergyThatTheBeamCannot) {
  // Plastic moment about t of the rectangle: 10 * 0.2 * 0.4^2 / 4.
  constexpr double plastic_moment = 0.08;
  model::Model model = struck_cantilever({0, 0.2, 0});
  model.control.end_time = 12;
  timeloop::Simulation simulation(model, test::execution());
  double most = 0;
  double turn = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const domain::BeamBlock& block = domain.beams[0];
    for (Index place = 0; place < block.elements; ++place)
      if (block.element[place] == 0) {
        most = test::larger_of(most, std::fabs(block.state(place, block.find("resultant")->first + 3)));
        turn = block.state(place, block.find("plastic_deformation")->first + 2);
      }
  });
  EXPECT_LT(most, plastic_moment * (1 + 1e-6));
  EXPECT_GT(most, plastic_moment * 0.999);
  // The mass stops when moment times turn and the elastic energy M^2 L / 6 E I are its kinetic energy.
  const double elastic = plastic_moment * plastic_moment * 2 / (6 * 1e4 * 0.2 * 0.064 / 12);
  const double expected = (0.5 * 0.04 - elastic) / plastic_moment;
  test::verified("hinge at the foot of a cantilever stops a mass: turn over exact",
                 "rigid-plastic, with elastic energy")
      .near(std::fabs(turn) / expected, 1, 0.02);
  EXPECT_LT(simulation.domain().energy.error(), 0.01);
}

TEST(Beams, PlasticBarYieldsAtItsWholeSection) {
  model::Model model = struck_cantilever({2.0, 0, 0});
  model.control.end_time = 3;
  timeloop::Simulation simulation(model, test::execution());
  double most = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const domain::BeamBlock& block = domain.beams[0];
    most = test::larger_of(most, block.state(0, block.find("resultant")->first));
  });
  EXPECT_NEAR(most, 10 * 0.08, 1e-9);
  // 1/2 m v^2 = Np (stretch) less the elastic Np^2 L / 2 E A
  const double stretch = (2.0 + 0.5 * 0.8 * 0.8 * 2 / 800) / 0.8;
  EXPECT_GT(test::displacement(simulation.domain(), 4).x, 0.97 * stretch);
}

TEST(Beams, ShakenBeamsOfAnyProportionsStayStable) {
  for (const double slenderness : {0.2, 1.0, 5.0, 50.0})
    for (const double shear_area : {0.0, 0.8}) {
      model::BeamSection section = test::rectangle(1.0, 0.7, 0.1);
      section.shear_area = shear_area;
      model::Model model = test::one_beam_part(
          {.id = 1, .title = "m", .density = 1.0, .law = model::Elastic{1e4, 0.3}}, section);
      const double length = 5 * slenderness;
      test::add_line(model, 5, {0, 1, 0}, [&](double u) { return Point{length * u, 0, 0}; });
      for (Index i = 0; i < 6; ++i)
        model.initial_velocities.push_back(
            {.node = i,
             .velocity = {1e-3 * std::sin(7.0 * i), 1e-3 * std::cos(5.0 * i), 1e-3 * std::sin(3.0 * i + 1)},
             .angular_velocity = {1e-3 * std::cos(2.0 * i), 1e-3 * std::sin(4.0 * i), 1e-3}});
      model.control.end_cycle = 20000;
      model.control.end_time = 1e9;
      timeloop::Simulation simulation(model, test::execution());
      double worst = 0;
      test::run(simulation, [&](const domain::Domain& domain) {
        worst = test::larger_of(worst, std::fabs(domain.energy.imbalance()));
      });
      // The first half step from rest of the forces is the largest part.
      EXPECT_LT(worst, 0.02 * simulation.domain().energy.initial_total) << slenderness << " " << shear_area;
    }
}

TEST(Beams, SameBitsForThreadsAndInstructionSets) {
  const auto hash = [](int threads, Isa isa, Precision precision) {
    const model::BeamSection section = test::rectangle(0.4, 0.2, 1e-3);
    model::Model model = cantilever(section, 20, 1200);
    model.parts.push_back(model.parts[0]);
    model.parts[1].beam_section = 1;
    model.beam_sections.push_back(section);
    model.beam_sections[1].formulation = model::BeamFormulation::Truss;
    for (std::size_t i = 0; i < model.beams.size(); i += 3) model.beams[i].part = 1;
    load_slowly(model, {.node = 1200, .force = {0.1, 0.2, 0.3}});
    for (Index i = 1; i < 1200; ++i)
      model.initial_velocities.push_back({.node = i,
                                          .velocity = {std::sin(7.0 * i), std::cos(5.0 * i), 0.1},
                                          .angular_velocity = {std::cos(2.0 * i), std::sin(4.0 * i), 1}});
    model.control.end_cycle = 50;
    timeloop::Simulation simulation(model, {precision, isa, threads});
    test::run(simulation);
    return simulation.state_hash();
  };
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    const Isa best = default_isa();
    EXPECT_EQ(hash(1, best, precision), hash(2, best, precision));
    EXPECT_EQ(hash(1, best, precision), hash(3, best, precision));
    EXPECT_EQ(hash(1, Isa::Scalar, precision), hash(1, Isa::Baseline, precision));
    const std::vector<Isa> isas = available_isas();
    if (isas.size() == 4) {
      EXPECT_EQ(hash(1, isas[2], precision), hash(1, isas[3], precision));
    }
  }
}

}  // namespace
}  // namespace crumple::beams_test
