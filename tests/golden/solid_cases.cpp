// SPDX-License-Identifier: BSD-3-Clause
// Golden cases of solids, beams, springs, rigid bodies and connections.
#include <cmath>

#include "golden/cases.hpp"
#include "support/copper.hpp"
#include "support/lines.hpp"
#include "support/rigid.hpp"

namespace crumple::golden {
namespace {

using model::SolidFormulation;
using model::SolidHourglassForm;

void throw_all(model::Model& model, const test::Point& velocity) {
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = velocity, .angular_velocity = {}});
}

/// Parts of solids side by side along x.
class Row {
 public:
  model::Model model;

  /// Makes a part with its own section, material and hourglass control.
  Index add_part(SolidFormulation formulation, SolidHourglassForm form, double density,
                 const model::ConstitutiveLaw& law) {
    const Index part = static_cast<Index>(model.parts.size());
    const UserId id = part + 1;
    model.materials.push_back({.id = id, .title = "law", .density = density, .law = law});
    model.solid_sections.push_back({.id = id, .title = "section", .formulation = formulation});
    model.hourglass_controls.push_back({.coefficient = 0.05, .solid_form = form});
    model.parts.push_back(
        {.id = id, .title = "part", .solid_section = part, .material = part, .hourglass = part});
    return part;
  }

  /// A block of warped elements, split in some way or not, for the part.
  void add_block(Index part, void (*split)(model::Model&) = nullptr) {
    std::vector<model::SolidElement> before = std::move(model.solids);
    model.solids.clear();
    test::add_box(model, part, 4, 4, 3, [&](double u, double v, double w) {
      const double bulge = 0.3 * std::sin(3 * u + 5 * v + 4 * w);
      return test::Point{14.0 * part + 10 * u + bulge, 10 * v - 5 - bulge, 8 * w + 0.2 + 0.3 * bulge * w};
    });
    if (split != nullptr) split(model);
    for (model::SolidElement& solid : model.solids) before.push_back(solid);
    for (std::size_t i = 0; i < before.size(); ++i) before[i].id = static_cast<UserId>(i) + 1;
    model.solids = std::move(before);
  }
};

/// Blocks of all formulations and of most laws fall on a cylinder; one of them breaks.
model::Model blocks_on_cylinder() {
  Row row;
  const model::PlasticKinematic soft_steel{.youngs_modulus = 210,
                                           .poissons_ratio = 0.3,
                                           .yield_stress = 0.25,
                                           .tangent_modulus = 1.0,
                                           .isotropic_fraction = 0.5,
                                           .cowper_symonds_rate = 0.04,
                                           .cowper_symonds_exponent = 5};
  model::PiecewiseLinearPlasticity brittle;
  brittle.youngs_modulus = 210;
  brittle.poissons_ratio = 0.3;
  brittle.plastic_strain = {0, 0.02, 0.1};
  brittle.yield_stress = {0.3, 0.36, 0.4};
  brittle.failure_strain = 0.06;
  const model::CrushableFoam foam{.youngs_modulus = 0.5,
                                  .poissons_ratio = 0.1,
                                  .crush = {0, 0.2, 0.6},
                                  .yield_stress = {0.005, 0.006, 0.03},
                                  .tensile_stress = 0.002,
                                  .damping = 0.1};
  const model::MooneyRivlin rubber{
      .youngs_modulus = 4 * 0.03 * 1.49, .poissons_ratio = 0.49, .first = 0.02, .second = 0.01};
  const model::BlatzKo sponge{.youngs_modulus = 0.06 * 2 * 1.463, .poissons_ratio = 0.463};
  const auto hexahedron = SolidFormulation::OnePointHexahedron;
  const auto viscous = SolidHourglassForm::FlanaganBelytschkoViscous;
  row.add_block(row.add_part(hexahedron, SolidHourglassForm::ExactVolumeViscous, 7.85e-6, soft_steel));
  row.add_block(row.add_part(hexahedron, SolidHourglassForm::ExactVolumeStiffness, 7.85e-6, brittle));
  row.add_block(
      row.add_part(hexahedron, SolidHourglassForm::AssumedStrain, 7.85e-6, model::Elastic{210, 0.3}));
  row.add_block(row.add_part(hexahedron, viscous, 1.1e-6, rubber), test::split_into_wedges);
  row.add_block(row.add_part(hexahedron, SolidHourglassForm::StandardViscous, 1e-7, foam));
  row.add_block(row.add_part(SolidFormulation::SelectiveHexahedron, viscous, 7.85e-6, soft_steel));
  row.add_block(row.add_part(SolidFormulation::Tetrahedron, viscous, 1e-6, sponge),
                test::split_into_tetrahedra);
  row.add_block(row.add_part(SolidFormulation::NodalPressureTetrahedron, viscous, 7.85e-6, soft_steel),
                test::split_into_tetrahedra);
  model::Model model = std::move(row.model);
  throw_all(model, {1, 0, -60});
  model::RigidWall wall;
  wall.point = {-20, 0, -6};
  wall.normal = {1, 0, 0};
  wall.friction = 0.3;
  wall.shape = model::WallShape::Cylinder;
  wall.radius = 6;
  for (Index i = 0; i < model.nodes.count(); ++i) wall.nodes.push_back(i);
  model.rigid_walls.push_back(wall);
  model.control.step_scale = 0.6;
  model.control.end_time = 1.0;
  model.control.end_cycle = 400;
  return model;
}

/// A copper bar runs into water: equations of state, spall, viscosity of a fluid.
model::Model bar_into_water() {
  Row row;
  model::JohnsonCook copper = test::ofhc_copper();
  copper.reference_rate = 1e-3;  // in ms
  copper.thermal_exponent = 1.09;
  copper.melting_rise = 1063;
  copper.heat_capacity = 383;
  copper.shear_modulus = 46;
  copper.least_pressure = -0.5;
  copper.spall = model::Spall::Pressure;
  const model::NullMaterial water{.least_pressure = -1e-4, .viscosity = 1e-6};
  const auto hexahedron = SolidFormulation::OnePointHexahedron;
  row.add_part(hexahedron, SolidHourglassForm::FlanaganBelytschkoStiffness, 8.96e-6, copper);
  row.add_part(hexahedron, SolidHourglassForm::FlanaganBelytschkoViscous, 1e-6, water);
  model::Model model = std::move(row.model);
  model.equations_of_state.push_back(
      {.id = 1,
       .title = "copper",
       .law = model::Gruneisen{
           .sound_speed = 3940, .slopes = {1.489, 0, 0}, .gamma = 1.99, .volume_correction = 0.47}});
  model.equations_of_state.push_back({.id = 2,
                                      .title = "water",
                                      .initial_energy = 0,
                                      .law = model::LinearPolynomial{{0, 2.2, 9.5, 14.6, 0.28, 0.28, 0}}});
  for (Index part = 0; part < 2; ++part) model.parts[part].equation_of_state = part;
  test::add_box(model, 0, 4, 4, 20, [](double u, double v, double w) {
    return test::Point{4 * u + 0.2 * w * v, 4 * v, 20 * w};
  });
  for (model::SolidElement& solid : model.solids)
    if (model.nodes.position[solid.node[0]][2] < 10) solid.part = 1;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const double height = model.nodes.position[i][2];
    if (height > 9.5) model.initial_velocities.push_back({.node = i, .velocity = {0, 0, -300}});
    if (height == 0) model.fixed_nodes.push_back({.node = i, .translation = {true, true, true}});
  }
  model.control.end_time = 1.0;
  model.control.end_cycle = 300;
  return model;
}

Index add_node(model::Model& model, const test::Point& at) {
  model.nodes.id.push_back(model.nodes.count() + 1);
  model.nodes.position.push_back(at);
  return model.nodes.count() - 1;
}

/// Beams with hinges, a truss, springs and dampers between them.
model::Model frame() {
  model::Model model = test::one_beam_part(
      {.id = 1, .title = "steel", .density = 7.85e-6, .law = model::ResultantPlasticity{210, 0.3, 0.3}},
      test::rectangle(4, 3, 50));
  for (const double y : {0.0, 20.0})
    test::add_line(model, 8, {0, 0, 1}, [&](double u) {
      return test::Point{120 * u, y, 2 * std::sin(3 * u)};
    });
  model.materials.push_back(
      {.id = 2,
       .title = "bar",
       .density = 7.85e-6,
       .law = model::PlasticKinematic{
           .youngs_modulus = 210, .poissons_ratio = 0.3, .yield_stress = 0.2, .tangent_modulus = 2}});
  model.beam_sections.push_back(
      {.id = 2, .title = "rod", .formulation = model::BeamFormulation::Truss, .area = 4});
  model.parts.push_back({.id = 2, .title = "truss", .beam_section = 1, .material = 1});
  for (Index i = 2; i <= 6; ++i)
    model.beams.push_back({.id = static_cast<UserId>(100 + i), .part = 1, .node = {i, 9 + i + 1}});
  const Index curve = 0;
  model.curves.push_back({1, {-5, 0, 5}, {-0.8, 0, 1.2}});
  const model::SpringLaw laws[] = {model::LinearSpring{0.3}, model::LinearDamper{0.02},
                                   model::ElastoplasticSpring{0.5, 0.05, 0.1}, model::NonlinearSpring{curve},
                                   model::NonlinearDamper{curve}};
  model.discrete_sections.push_back({.id = 3, .title = "springs"});
  for (const model::SpringLaw& law : laws) {
    const auto spring = static_cast<Index>(model.spring_materials.size());
    const auto part = static_cast<Index>(model.parts.size());
    model.spring_materials.push_back({.id = spring + 1, .title = "law", .law = law});
    model.parts.push_back(
        {.id = part + 1, .title = "spring", .discrete_section = 0, .spring_material = spring});
    model.discretes.push_back({.id = spring + 1, .part = part, .node = {1 + spring, 9 + 2 + spring}});
  }
  return model;
}

/// The frame carries rigid bodies, is held by welds, links and prescribed motions, and meets a moving ball.
model::Model frame_with_bodies() {
  model::Model model = frame();
  for (Index end : {Index{0}, Index{9}})
    model.fixed_nodes.push_back(
        {.node = end, .translation = {true, true, true}, .rotation = {true, true, true}});
  model::RigidBody tip;
  tip.id = 1;
  tip.nodes = {8, 17, add_node(model, {130, 5, 3}), add_node(model, {130, 15, -2})};
  for (const Index node : {tip.nodes[2], tip.nodes[3]})
    model.lumped_masses.push_back({.id = node + 1, .node = node, .mass = 2e-3});
  model.rigid_bodies.push_back(tip);
  // A second body hangs on the first frame by a weld that breaks and a link.
  model::RigidBody swing;
  swing.id = 2;
  swing.held_axes = {{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}}};
  swing.fixed_translation = {true, false, false};
  for (const test::Point& at :
       {test::Point{60, 40, 0}, test::Point{70, 40, 5}, test::Point{65, 50, 0}, test::Point{62, 45, 9}}) {
    const Index node = add_node(model, at);
    model.lumped_masses.push_back({.id = node + 1, .node = node, .mass = 1e-3});
    swing.nodes.push_back(node);
  }
  model.rigid_bodies.push_back(swing);
  const Index free = add_node(model, {30, -5, 1});
  const Index linked = add_node(model, {90, -5, 1});
  for (const Index node : {free, linked})
    model.lumped_masses.push_back({.id = node + 1, .node = node, .mass = 5e-4});
  model.spot_welds.push_back({.id = 1,
                              .nodes = {2, free},
                              .normal_strength = 0.05,
                              .shear_strength = 0.04,
                              .normal_exponent = 2,
                              .shear_exponent = 2});
  model.rivets.push_back({.id = 1, .node = {6, linked}});
  model.constrained_node_sets.push_back({.nodes = {4, 13}, .direction = {false, true, true}});
  const Index curve = test::add_constant_curve(model, 1.0);
  model.body_loads.push_back({.axis = 2, .curve = curve, .scale = 0.5});
  model.rigid_body_loads.push_back({.body = 0, .force = {0.1, 0.2, -3}, .moment = {2, 0, 1}, .curve = curve});
  model.rigid_body_loads.push_back(
      {.body = 1, .force = {0.1, 0.2, 0.3}, .moment = {0.2, 0.4, 0.1}, .curve = curve});
  model.prescribed_motions.push_back(
      {.node = 3, .axis = 2, .kind = model::PrescribedMotion::Kind::Displacement, .curve = 0, .scale = 2});
  model.prescribed_motions.push_back({.body = 0, .axis = 0, .rotation = true, .curve = curve, .scale = 0.3});
  model::RigidWall ball;
  ball.point = {130, 10, -16};
  ball.normal = {0, 0, 1};
  ball.friction = 0.2;
  ball.shape = model::WallShape::Sphere;
  ball.radius = 10;
  ball.motion = {.curve = curve, .is_displacement = false, .direction = {0, 0, 3}};
  for (Index i = 0; i < model.nodes.count(); ++i) ball.nodes.push_back(i);
  model.rigid_walls.push_back(ball);
  model.control.end_time = 100.0;
  model.control.end_cycle = 800;
  return model;
}

/// Beams integrated over their cross sections, round and of plates, bent and twisted far beyond yield.
model::Model integrated_frame() {
  model::PiecewiseLinearPlasticity steel;
  steel.youngs_modulus = 210;
  steel.poissons_ratio = 0.3;
  steel.plastic_strain = {0, 0.05, 1};
  steel.yield_stress = {0.3, 0.4, 0.5};
  steel.cowper_symonds_rate = 0.04;
  steel.cowper_symonds_exponent = 5;
  steel.failure_strain = 0.02;
  model::Model model =
      test::one_beam_part({.id = 1, .title = "steel", .density = 7.85e-6, .law = steel},
                          test::integrated(model::tube_points(6, 4, model::SectionRule::Gauss3), 5.0 / 6));
  for (const double y : {0.0, 20.0})
    test::add_line(model, 8, {0, 0, 1}, [&](double u) {
      return test::Point{120 * u, y, 2 * std::sin(3 * u)};
    });
  model.materials.push_back({.id = 2,
                             .title = "bar",
                             .density = 7.85e-6,
                             .law = model::PlasticKinematic{.youngs_modulus = 210,
                                                            .poissons_ratio = 0.3,
                                                            .yield_stress = 0.2,
                                                            .tangent_modulus = 2,
                                                            .isotropic_fraction = 0.3}});
  model.beam_sections.push_back(test::integrated(model::plate_points(model::tee_plates(6, 1, 5, 1), 0)));
  model.parts.push_back({.id = 2, .title = "cross", .beam_section = 1, .material = 1});
  for (Index i = 2; i <= 6; ++i)
    model.beams.push_back(
        {.id = static_cast<UserId>(100 + i), .part = 1, .node = {i, 9 + i + 1}, .orientation = {0, 0, 1}});
  for (Index end : {Index{0}, Index{9}})
    model.fixed_nodes.push_back(
        {.node = end, .translation = {true, true, true}, .rotation = {true, true, true}});
  for (const Index node : {8, 17, 4})
    model.initial_velocities.push_back(
        {.node = node, .velocity = {2, node == 8 ? 8.0 : -3.0, 30}, .angular_velocity = {0.5, 0.2, -0.1}});
  model.lumped_masses.push_back({.id = 1, .node = 8, .mass = 2e-2});
  model.control.end_time = 100.0;
  model.control.end_cycle = 800;
  return model;
}

}  // namespace

const std::vector<Case>& solid_cases() {
  static const std::vector<Case> all{{"blocks_on_cylinder", blocks_on_cylinder, true},
                                     {"bar_into_water", bar_into_water},
                                     {"frame_with_bodies", frame_with_bodies},
                                     {"integrated_frame", integrated_frame}};
  return all;
}

}  // namespace crumple::golden
