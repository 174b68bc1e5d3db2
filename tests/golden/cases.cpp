// SPDX-License-Identifier: BSD-3-Clause
#include "golden/cases.hpp"

#include <cmath>
#include <numbers>

#include "support/bags.hpp"
#include "support/meshes.hpp"

namespace crumple::golden {
namespace {

using model::ShellFormulation;

constexpr double pi = std::numbers::pi;

/// A square tube that runs onto a wall and folds onto itself.
model::Model crushed_tube(ShellFormulation formulation, const model::ConstitutiveLaw& law) {
  model::Model model = test::one_part({.id = 1, .title = "steel", .density = 7.85e-6, .law = law},
                                      test::shell_section(1.0, 3, formulation));
  constexpr Index sides = 4;
  constexpr Index columns = 6;
  constexpr Index rows = 24;
  constexpr double width = 30;
  for (Index side = 0; side < sides; ++side) {
    const double angle = side * pi / 2;
    // Four free panels in a square, a contact distance apart at the corners: many surfaces, no sewing needed.
    test::add_grid(model, 0, columns, rows, [&](double u, double v) {
      const double bow = 0.3 * std::sin(6 * pi * v) * std::sin(pi * u);
      const double across = (width - 1.5) * (u - 0.5);
      const double out = 0.5 * width + bow;
      return test::Point{across * std::cos(angle) - out * std::sin(angle),
                         across * std::sin(angle) + out * std::cos(angle), 120.0 * v};
    });
  }
  model::RigidWall wall;
  wall.normal = {0, 0, 1};
  wall.friction = 0.2;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    model.initial_velocities.push_back({.node = i, .velocity = {0, 0, -40}, .angular_velocity = {}});
    wall.nodes.push_back(i);
    if (model.nodes.position[i][2] > 119)
      model.lumped_masses.push_back({.id = i + 1, .node = i, .mass = 0.5});
  }
  model.rigid_walls.push_back(wall);
  model.contacts.push_back(model::self_contact(1, "self", {0}));
  model.contacts.back().static_friction = 0.2;
  model.contacts.back().dynamic_friction = 0.1;
  model.control.end_time = 1.0;
  model.control.end_cycle = 400;
  return model;
}

model::Model tube_of_belytschko_tsay() {
  return crushed_tube(ShellFormulation::BelytschkoTsay, kinematic_steel());
}
model::Model tube_of_hughes_liu() {
  return crushed_tube(ShellFormulation::HughesLiu, kinematic_steel());
}

/// Fully integrated shells of a law with rate, heating and changing thickness.
model::Model tube_fully_integrated() {
  model::JohnsonCook steel;
  steel.youngs_modulus = 210;
  steel.poissons_ratio = 0.3;
  steel.yield_stress = 0.25;
  steel.hardening = 0.5;
  steel.exponent = 0.3;
  steel.rate_coefficient = 0.02;
  steel.reference_rate = 1e-3;
  steel.thermal_exponent = 1.0;
  steel.melting_rise = 1500;
  steel.heat_capacity = 450;
  model::Model model = crushed_tube(ShellFormulation::FullyIntegrated, steel);
  model.control.thickness_change = true;
  model.control.end_cycle = 200;
  return model;
}

/// Fails at a plastic strain of 0.05.
model::PiecewiseLinearPlasticity torn_steel() {
  model::PiecewiseLinearPlasticity steel;
  steel.youngs_modulus = 210;
  steel.poissons_ratio = 0.3;
  steel.plastic_strain = {0, 0.02, 0.1};
  steel.yield_stress = {0.3, 0.36, 0.4};
  steel.cowper_symonds_rate = 0.04;
  steel.cowper_symonds_exponent = 5;
  steel.failure_strain = 0.05;
  return steel;
}

/// Two strips of triangles and quadrilaterals, one on the other, pulled apart until they tear.
model::Model strips_of(const model::PiecewiseLinearPlasticity& steel) {
  model::Model model = test::one_part({.id = 1, .title = "steel", .density = 7.85e-6, .law = steel},
                                      test::shell_section(1.0, 2));
  for (int layer = 0; layer < 2; ++layer)
    test::add_grid(model, 0, 20, 4, [&](double u, double v) {
      return test::Point{60 * u, 12 * v, 0.9 * layer + 0.2 * std::sin(pi * u) * std::sin(7 * u + 3 * v)};
    });
  std::vector<model::ShellElement> halves;
  for (model::ShellElement& shell : model.shells) {
    if (shell.id % 3 != 0) continue;
    model::ShellElement half = shell;
    half.id += 1000;
    half.node = {shell.node[0], shell.node[2], shell.node[3], shell.node[3]};
    shell.node[3] = shell.node[2];
    halves.push_back(half);
  }
  model.shells.insert(model.shells.end(), halves.begin(), halves.end());
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i,
                                        .velocity = {8.0 * (model.nodes.position[i][0] - 30), 0,
                                                     model.nodes.position[i][2] > 0.45 ? -2.0 : 2.0},
                                        .angular_velocity = {}});
  model.contacts.push_back(model::self_contact(1, "self", {0}));
  model.control.end_time = 1.0;
  model.control.end_cycle = 400;
  return model;
}

model::Model torn_strips() {
  return strips_of(torn_steel());
}

/// Their stress fades before.
model::Model fading_strips() {
  model::PiecewiseLinearPlasticity steel = torn_steel();
  steel.damage_strain = {0, 0.02, 0.05};
  steel.damage = {0, 0, 1};
  steel.failed_points = 1;
  return strips_of(steel);
}

/// A warped panel under a pressure that follows it, nodes on its surface, many points, viscous hourglass
/// control.
model::Model pressed_panel() {
  model::PowerLawPlasticity steel;
  steel.youngs_modulus = 210;
  steel.poissons_ratio = 0.3;
  steel.strength = 0.6;
  steel.exponent = 0.2;
  steel.yield_strain = 1.2e-3;
  model::ShellSection section = test::shell_section(1.2, 9, ShellFormulation::BelytschkoWongChiang);
  section.thickness_rule = model::ThicknessRule::Trapezoid;
  section.node_place = 1;
  model::Model model = test::one_part({.id = 1, .title = "steel", .density = 7.85e-6, .law = steel}, section);
  test::add_grid(model, 0, 12, 10, [](double u, double v) {
    return test::Point{60 * u, 50 * v, 8 * (u - 0.5) * (v - 0.5)};
  });
  model::Curve curve;
  curve.abscissa = {0, 0.05, 0.1};
  curve.ordinate = {0, 1, 0};
  model.curves.push_back(curve);
  for (const model::ShellElement& shell : model.shells)
    model.pressure_loads.push_back({.node = shell.node, .pressure = 0.02, .curve = 0, .arrival = 0});
  for (Index i = 0; i < 13; ++i)
    model.fixed_nodes.push_back(
        {.node = i, .translation = {true, true, true}, .rotation = {true, true, true}});
  model.control.end_time = 1.0;
  model.control.end_cycle = 400;
  return model;
}

/// An orthotropic plate of selectively reduced shells under a skin without stiffness, hit at its free end.
model::Model bent_laminate() {
  model::OrthotropicElastic plies;
  plies.modulus_a = 60;
  plies.modulus_b = plies.modulus_c = 10;
  plies.poisson_ba = plies.poisson_ca = 0.05;
  plies.poisson_cb = 0.3;
  plies.shear_ab = plies.shear_ca = 5;
  plies.shear_bc = 4;
  plies.angle = 0.4;
  model::set_stand_in(plies);
  model::ShellSection section = test::shell_section(2.0, 4, ShellFormulation::HughesLiuSelectiveReduced);
  section.thickness_rule = model::ThicknessRule::Lobatto;
  model::Model model = test::one_part({.id = 1, .title = "plies", .density = 1.6e-6, .law = plies}, section);
  model.materials.push_back({.id = 2, .title = "skin", .density = 1e-6, .law = model::NullMaterial{10, 0.3}});
  model.shell_sections.push_back(test::shell_section(0.1, 2));
  model.parts.push_back({.id = 2, .title = "skin", .section = 1, .material = 1});
  test::add_grid(model, 0, 14, 6, [](double u, double v) { return test::Point{70 * u, 30 * v, 3 * u * v}; });
  const std::vector<model::ShellElement> plate = model.shells;
  for (model::ShellElement shell : plate) {
    shell.id += 1000;
    shell.part = 1;
    model.shells.push_back(shell);
  }
  for (Index j = 0; j <= 6; ++j) {
    model.fixed_nodes.push_back(
        {.node = j * 15, .translation = {true, true, true}, .rotation = {true, true, true}});
    model.initial_velocities.push_back(
        {.node = j * 15 + 14, .velocity = {0, 0, 5.0 + j}, .angular_velocity = {}});
  }
  model.control.end_time = 1.0;
  model.control.end_cycle = 300;
  return model;
}

/// Layers of elastic, plastic and orthotropic materials, of the part and of some elements of their own, one
/// of which fails; hit at a free end.
model::Model layered_strip(model::ShellFormulation formulation) {
  model::Model model = bent_laminate();
  model.shell_sections[0].formulation = formulation;
  model::PlasticKinematic metal = kinematic_steel();
  metal.yield_stress = 0.02;
  metal.failure_strain = 1e-4;
  model.materials.push_back({.id = 3, .title = "foil", .density = 7.85e-6, .law = metal});
  const auto add = [&](const std::vector<model::ShellLayer>& layers) {
    model::Layup layup;
    layup.layers = layers;
    layup.unfailing_layers_hold = model.layups.empty();
    layup.material = static_cast<Index>(model.materials.size());
    model.materials.push_back(layup_material(model, layup));
    model.layups.push_back(layup);
  };
  add({{0, -0.75, 0.25, 0}, {0, -0.25, 0.25, 1.2}, {2, 0.1, 0.1, 0}, {0, 0.6, 0.4, -0.5}});
  add({{2, -0.5, 0.5, 0}, {2, 0.4, 0.4, 0}, {0, 0.9, 0.1, 0}});
  model.parts[0].layup = 0;
  model.parts[0].material = model.layups[0].material;
  for (std::size_t shell = 30; shell < 40; ++shell) {
    model.shells[shell].layup = 1;
    model.shells[shell].layer_angles = static_cast<Index>(model.layer_angles.size());
    for (const double angle : {0.0, 0.0, 0.1 * static_cast<double>(shell)})
      model.layer_angles.push_back(angle);
  }
  return model;
}
model::Model layers_of_belytschko_tsay() {
  return layered_strip(ShellFormulation::BelytschkoTsay);
}
model::Model layers_fully_integrated() {
  return layered_strip(ShellFormulation::FullyIntegrated);
}

/// Two layers that fail by modes and go, by Chang & Chang and by Tsai & Wu, torn.
model::Model failing_plies() {
  model::Model model = bent_laminate();
  model.shell_sections[0].formulation = ShellFormulation::BelytschkoTsay;
  for (const auto matrix : {model::CompositeDamage::Matrix::Chang, model::CompositeDamage::Matrix::TsaiWu}) {
    model::CompositeDamage law;
    static_cast<model::OrthotropicElastic&>(law) =
        std::get<model::OrthotropicElastic>(model.materials[0].law);
    law.matrix = matrix;
    law.tension_a = 0.3;
    law.compression_a = 0.2;
    law.tension_b = 0.05;
    law.compression_b = 0.12;
    law.shear_strength = 0.06;
    law.shear_softening = 100;
    law.shear_in_fibre_mode = 0.5;
    law.failure_tension = matrix == model::CompositeDamage::Matrix::Chang ? 0.01 : 0;
    law.failure_matrix = law.failure_tension;
    law.failure_shear = law.failure_tension;
    law.goes_by_fibre_tension = law.failure_tension == 0;
    model.materials.push_back({.id = 3, .title = "ply", .density = 1.6e-6, .law = law});
  }
  model::Layup layup;
  layup.layers = {{2, -0.5, 0.5, 0.3}, {3, 0.5, 0.5, -0.9}};
  layup.material = static_cast<Index>(model.materials.size());
  model.materials.push_back(layup_material(model, layup));
  model.layups.push_back(layup);
  model.parts[0].layup = 0;
  model.parts[0].material = layup.material;
  for (model::InitialVelocity& initial : model.initial_velocities)
    initial.velocity = {30, 4 * initial.velocity[2], initial.velocity[2]};
  return model;
}

/// A cushion of fabric and foil, of all membranes, full of gas that leaks, on a wall.
model::Model thrown_cushion() {
  model::Fabric cloth;
  cloth.sheet.modulus_a = 0.5;
  cloth.sheet.modulus_b = 0.3;
  cloth.sheet.poisson_ba = 0.1;
  cloth.sheet.shear_ab = 0.05;
  cloth.sheet.angle = 0.4;
  cloth.wrinkles = true;
  cloth.liner_modulus = 0.1;
  cloth.liner_ratio = 0.3;
  cloth.liner_share = 0.1;
  cloth.damping = 0.05;
  model::set_stand_in(cloth);
  model::Model model = test::one_part({.id = 1, .title = "cloth", .density = 9e-7, .law = cloth},
                                      test::shell_section(0.3, 1, ShellFormulation::FullyIntegratedMembrane));
  model.materials.push_back({.id = 2, .title = "foil", .density = 9e-7, .law = model::Elastic{0.4, 0.4}});
  model.shell_sections.push_back(test::shell_section(0.3, 1, ShellFormulation::Membrane));
  model.parts.push_back({.id = 2, .title = "foil", .section = 1, .material = 1});
  test::add_closed_box(model, 0, 6, [](double x, double y, double z) {
    return test::Point{100 * x, 80 * y * (1 - 0.2 * x), 40 * z};
  });
  model::ControlVolume bag = test::bag_of_shells(model, model::InflatedGas{.heat_at_volume = 717.5,
                                                                           .heat_at_pressure = 1004.5,
                                                                           .temperature = 600,
                                                                           .ambient = 1e-4,
                                                                           .density = 1.2e-9,
                                                                           .inflow = 0});
  model::Curve inflow;
  inflow.abscissa = {0, 100};
  inflow.ordinate = {1e-4, 1e-4};
  model.curves.push_back(inflow);
  model::PorousFabric porous;
  porous.coefficient = 0.5;
  porous.area = 0.02;
  std::vector<model::ShellElement> halves;
  for (model::ShellElement& shell : model.shells) {
    if (shell.id % 3 == 0) shell.part = 1;
    if (shell.part == 0) porous.segments.push_back(shell.node);
    if (shell.id % 5 != 0) continue;
    model::ShellElement half = shell;
    half.id += 1000;
    half.node = {shell.node[0], shell.node[2], shell.node[3], shell.node[3]};
    shell.node[3] = shell.node[2];
    halves.push_back(half);
  }
  model.shells.insert(model.shells.end(), halves.begin(), halves.end());
  bag.porous.push_back(porous);
  model.control_volumes.push_back(bag);
  model::RigidWall wall;
  wall.point = {0, 0, -41};
  wall.normal = {0, 0, 1};
  for (Index i = 0; i < model.nodes.count(); ++i) {
    model.initial_velocities.push_back({.node = i, .velocity = {1, 0, -10}, .angular_velocity = {}});
    wall.nodes.push_back(i);
  }
  model.rigid_walls.push_back(wall);
  model.control.end_time = 100;
  model.control.end_cycle = 400;
  return model;
}

}  // namespace

model::PlasticKinematic kinematic_steel() {
  model::PlasticKinematic steel;
  steel.youngs_modulus = 210;
  steel.poissons_ratio = 0.3;
  steel.yield_stress = 0.25;
  steel.tangent_modulus = 1.0;
  steel.isotropic_fraction = 0.5;
  return steel;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> shells{{"crushed_tube_BelytschkoTsay", tube_of_belytschko_tsay},
                                        {"crushed_tube_HughesLiu", tube_of_hughes_liu},
                                        {"crushed_tube_FullyIntegrated", tube_fully_integrated},
                                        {"torn_strips", torn_strips, true},
                                        {"fading_strips", fading_strips, true},
                                        {"pressed_panel", pressed_panel},
                                        {"bent_laminate", bent_laminate},
                                        {"layers_BelytschkoTsay", layers_of_belytschko_tsay, true},
                                        {"layers_FullyIntegrated", layers_fully_integrated, true},
                                        {"failing_plies", failing_plies},
                                        {"thrown_cushion", thrown_cushion}};
  static const std::vector<Case> all = [] {
    std::vector<Case> both = shells;
    both.insert(both.end(), solid_cases().begin(), solid_cases().end());
    return both;
  }();
  return all;
}

}  // namespace crumple::golden
