// SPDX-License-Identifier: BSD-3-Clause
// Forces in cross-sections: what lies ahead of a cut has no other forces than its loads and the section's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/larger.hpp"
#include "support/lines.hpp"

namespace crumple::section_forces_test {
namespace {

using math::Vec3;

/// Elements with nodes on both sides of x = at, and their nodes on the lower side.
template <class Elements>
void cut_elements(const model::Model& model, const Elements& elements, double at, std::vector<Index>& cut,
                  std::vector<Index>& nodes) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto ahead = [&](Index node) { return model.nodes.position[node][0] > at; };
    const auto& node = elements[i].node;
    if (std::all_of(node.begin(), node.end(), ahead) || std::none_of(node.begin(), node.end(), ahead))
      continue;
    cut.push_back(static_cast<Index>(i));
    for (const Index n : node)
      if (!ahead(n) && std::find(nodes.begin(), nodes.end(), n) == nodes.end()) nodes.push_back(n);
  }
}

void cut(model::Model& model, double at) {
  model::CrossSection section;
  section.id = 17;
  cut_elements(model, model.shells, at, section.shells, section.nodes);
  cut_elements(model, model.solids, at, section.solids, section.nodes);
  cut_elements(model, model.beams, at, section.beams, section.nodes);
  cut_elements(model, model.discretes, at, section.discretes, section.nodes);
  model.output.cross_sections.push_back(section);
  model.output.of(model::HistoryFile::Secforc).asked = true;
}

constexpr double length = 40;

/// Holds the nodes at x = 0, pulls and bends those at the end.
void load(model::Model& model, const Vec3& force) {
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const double x = model.nodes.position[node][0];
    if (x < 1e-9)
      model.fixed_nodes.push_back(
          {.node = node, .translation = {true, true, true}, .rotation = {true, true, true}});
    else if (x > length - 1e-9)
      model.nodal_loads.push_back({.node = node, .force = {force.x, force.y, force.z}});
  }
}

Vec3 momentum_ahead(const domain::Domain& domain, double at) {
  Vec3 sum;
  for (Index i = 0; i < domain.nodes.count(); ++i)
    if (domain.nodes.reference[i].x > at) sum += domain.nodes.mass[i] * domain.nodes.velocity[i];
  return sum;
}

/// Largest deviation from load - section = change of momentum ahead, over the largest force in the section.
double worst_balance(model::Model model, Precision precision, double end_time = 0.1,
                     double at = 0.55 * length) {
  cut(model, at);
  model.control.end_time = end_time;
  Vec3 applied;
  for (const model::NodalLoad& one : model.nodal_loads)
    applied += Vec3{one.force[0], one.force[1], one.force[2]};
  timeloop::Simulation simulation(model, {precision, default_isa(), 2});
  simulation.start();
  double worst = 0;
  double largest = 0;
  while (!simulation.finished()) {
    const Vec3 before = momentum_ahead(simulation.domain(), at);
    const double step = simulation.next_step();
    simulation.step();
    const double interval = 0.5 * (step + simulation.next_step());
    const Vec3 rate = (1 / interval) * (momentum_ahead(simulation.domain(), at) - before);
    const domain::SectionReport& section = simulation.sections()[0];
    worst = test::larger_of(worst, norm(rate - applied + section.force));
    largest = test::larger_of(largest, norm(section.force));
  }
  EXPECT_GT(largest, 0.5 * norm(applied)) << "the wave has reached the section";
  return worst / largest;
}

model::Material yielding_steel() {
  model::PlasticKinematic law;
  law.youngs_modulus = 210;
  law.poissons_ratio = 0.3;
  law.yield_stress = 0.2;
  law.tangent_modulus = 2;
  return {.id = 1, .title = "steel", .density = 7.85e-6, .law = law};
}

model::Model plate(model::ShellFormulation formulation) {
  model::Model model = test::one_part(yielding_steel(), test::shell_section(1.5, 5, formulation));
  test::add_grid(model, 0, 12, 5, [](double u, double v) {
    return test::Point{length * u, 20 * v, 2 * u * v};
  });
  load(model, {1, 0.1, 0.05});
  return model;
}

model::Model bar(model::SolidFormulation formulation) {
  model::Model model = test::one_solid_part(yielding_steel());
  model.solid_sections[0].formulation = formulation;
  test::add_box(model, 0, 12, 3, 3, [](double u, double v, double w) {
    return test::Point{length * u, 10 * v + 2 * u, 10 * w};
  });
  if (model::is_tetrahedral(formulation)) test::split_into_tetrahedra(model);
  load(model, {0.8, 0.1, 0.05});
  return model;
}

TEST(SectionForces, OfShellsAreTheRateOfMomentumAhead) {
  for (const auto formulation :
       {model::ShellFormulation::BelytschkoTsay, model::ShellFormulation::BelytschkoWongChiang,
        model::ShellFormulation::HughesLiu, model::ShellFormulation::HughesLiuSelectiveReduced,
        model::ShellFormulation::FullyIntegrated}) {
    EXPECT_LT(worst_balance(plate(formulation), Precision::Double), 5e-14);
    EXPECT_LT(worst_balance(plate(formulation), Precision::Mixed), 6e-7);
  }
}

TEST(SectionForces, OfSolidsAreTheRateOfMomentumAhead) {
  for (const auto formulation :
       {model::SolidFormulation::OnePointHexahedron, model::SolidFormulation::SelectiveHexahedron,
        model::SolidFormulation::Tetrahedron, model::SolidFormulation::NodalPressureTetrahedron}) {
    EXPECT_LT(worst_balance(bar(formulation), Precision::Double), 5e-14);
    EXPECT_LT(worst_balance(bar(formulation), Precision::Mixed), 2e-7);
  }
}

TEST(SectionForces, EndWithTheElementsThatFail) {
  model::Model model = plate(model::ShellFormulation::BelytschkoTsay);
  std::get<model::PlasticKinematic>(model.materials[0].law).failure_strain = 0.002;
  // Next to the loads, which then throw the last nodes away.
  const double at = 0.95 * length;
  EXPECT_LT(worst_balance(model, Precision::Double, 0.1, at), 4e-13);
  cut(model, at);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  EXPECT_EQ(simulation.domain().shells[0].eroded, 5) << "the row that is cut is gone, and no other";
  EXPECT_EQ(norm(simulation.sections()[0].force), 0);
}

TEST(SectionForces, OfBeamsAndSpringsAreTheRateOfMomentumAhead) {
  model::Model beams = test::one_beam_part(test::elastic_steel(), test::rectangle(5, 8, 500));
  test::add_line(beams, 12, {0, 1, 0}, [](double u) { return test::Point{length * u, 0, 0}; });
  load(beams, {5, 1, 0.5});
  EXPECT_LT(worst_balance(beams, Precision::Double), 5e-14);
  EXPECT_LT(worst_balance(beams, Precision::Mixed), 5e-14) << "beams are in double always";

  model::Model springs = test::one_spring_part(model::LinearSpring{5});
  const Index first = test::add_mass(springs, {0, 0, 0}, 0.001);
  for (Index i = 1; i <= 8; ++i) {
    test::add_mass(springs, {length * i / 8.0, 0, 0}, 0.001);
    springs.discretes.push_back({.id = i, .part = 0, .node = {first + i - 1, first + i}});
  }
  load(springs, {0.5, 0.02, 0});
  EXPECT_LT(worst_balance(springs, Precision::Double, 1.0), 5e-15);
}

TEST(SectionForces, OfACantileverBearTheMomentOfItsLoad) {
  const double force = 0.01;
  model::Model model = test::one_beam_part(test::elastic_steel(), test::rectangle(5, 8, 500));
  test::add_line(model, 10, {0, 1, 0}, [](double u) { return test::Point{length * u, 0, 0}; });
  load(model, {0, 0, force});
  model.control.end_time = 5;
  cut(model, 0.35 * length);
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 0.01);
  const domain::SectionReport& section = simulation.sections()[0];
  const Vec3 arm =
      simulation.domain().nodes.position[simulation.domain().nodes.domain_node[10]] - section.centroid;
  EXPECT_NEAR(section.centroid.x, 0.3 * length, 1e-7) << "the node on the lower side";
  EXPECT_NEAR(section.force.z, force, 8e-12 * force);
  EXPECT_NEAR(section.moment.y, -arm.x * force, 3e-13 * force * length);
}

TEST(SectionForces, LeaveTheRunAsItIs) {
  model::Model model = plate(model::ShellFormulation::BelytschkoTsay);
  model.control.end_time = 0.05;
  timeloop::Simulation without(model, test::execution());
  test::run(without);
  cut(model, 0.55 * length);
  timeloop::Simulation with(model, test::execution());
  test::run(with);
  EXPECT_EQ(without.state_hash(), with.state_hash());
  EXPECT_TRUE(without.sections().empty());
}

}  // namespace
}  // namespace crumple::section_forces_test
