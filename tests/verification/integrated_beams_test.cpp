// SPDX-License-Identifier: BSD-3-Clause
//
// Beams integrated over their cross section against closed forms: statics, plastic bending, collapse. Static
// solutions are reached by loads that rise slowly while the velocities are damped.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/verified.hpp"

namespace crumple::integrated_beams_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double young = 1e4;
constexpr double yield = 10;
using model::SectionRule;
using test::Point;

model::Material elastic() {
  return {.id = 1, .title = "m", .density = 1.0, .law = model::Elastic{young, 0.25}};
}
/// Perfectly plastic.
model::Material plastic(double density = 1.0) {
  return {
      .id = 1,
      .title = "m",
      .density = density,
      .law = model::PlasticKinematic{.youngs_modulus = young, .poissons_ratio = 0.25, .yield_stress = yield}};
}

/// Beams along x, fixed at the first node; s is y, t is z.
model::Model cantilever(const model::Material& material, const model::BeamSection& section, double length,
                        Index count) {
  model::Model model = test::one_beam_part(material, section);
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

TEST(IntegratedBeams, CantileverDeflectsAsTimoshenkoSays) {
  // With one point along each of n beams the bending part is 1 - 1 / 4 n^2 of the exact one: the curvature is
  // that of the middle of each beam.
  constexpr double length = 3;
  constexpr Index count = 8;
  constexpr double force = 1e-4;
  const auto section = test::integrated(model::rectangle_points(1.0, 0.6, SectionRule::Gauss2), 5.0 / 6);
  EXPECT_NEAR(section.area, 0.6, 1e-12);
  EXPECT_NEAR(section.inertia_s, 0.216 / 12, 1e-12);
  EXPECT_NEAR(section.inertia_t, 0.6 / 12, 1e-12);
  model::Model model = cantilever(elastic(), section, length, count);
  model.control.end_time = 120;
  load_slowly(model, {.node = count, .force = {force, force, 2 * force}});
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 2e-3);
  const math::Vec3 u = test::displacement(simulation.domain(), count);
  const double shear = force * length / (4e3 * 0.6 * 5 / 6);
  const double bending = force * length * length * length / (3 * young);
  const double share = 1 - 1 / (4.0 * count * count);
  const double y = bending / section.inertia_t + shear;
  const double z = 2 * (bending / section.inertia_s + shear);
  test::verified("thick cantilever of 8 integrated beams: deflection over exact", "Timoshenko")
      .near(u.y / y, 1, 5e-3);
  EXPECT_NEAR(u.y, share * bending / section.inertia_t + shear, 2e-5 * y);
  EXPECT_NEAR(u.z, 2 * (share * bending / section.inertia_s + shear), 2e-5 * z);
  EXPECT_NEAR(u.x, force * length / (young * 0.6), 1e-3 * force * length / (young * 0.6));
}

TEST(IntegratedBeams, RoundBarTwistsAsSaintVenantSays) {
  constexpr double length = 5;
  const double polar = pi / 32 * (1 - std::pow(0.6, 4));
  for (const SectionRule rule :
       {SectionRule::Gauss2, SectionRule::Gauss3, SectionRule::Lobatto3, SectionRule::Gauss4}) {
    const auto section = test::integrated(model::tube_points(1, 0.6, rule));
    EXPECT_NEAR(section.area, pi / 4 * 0.64, 1e-12);
    EXPECT_NEAR(section.torsion, polar, 1e-12);
    EXPECT_NEAR(section.inertia_s, polar / 2, 1e-12);
    model::Model model = cantilever(elastic(), section, length, 5);
    model.control.end_time = 40;
    load_slowly(model, {.node = 5, .force = {}, .moment = {1e-3, 0, 0}});
    timeloop::Simulation simulation(model, test::execution());
    test::run_damped(simulation, 5e-3);
    const domain::BeamBlock& block = simulation.domain().beams[0];
    double twist = 0;
    for (Index place = 0; place < block.elements; ++place)
      twist += block.state(place, block.find("deformation")->first + 1);
    test::verified("twist of a tube of integrated beams over exact", "Saint-Venant")
        .near(twist / (1e-3 * length / (4e3 * polar)), 1, 1e-4);
  }
}

/// The bending moment about t of a beam of length 1 whose ends turn slowly against each other by `turn`.
double moment_at(const model::BeamSection& section, double turn, int axis = 2) {
  model::Model model = test::one_beam_part(plastic(), section);
  test::add_line(model, 1, {0, 1, 0}, [](double u) { return Point{u, 0, 0}; });
  model.control.end_time = 40;
  model.curves.push_back({1, {0, 40, 1e9}, {0, 0.5 * turn, 0.5 * turn}});
  using Kind = model::PrescribedMotion::Kind;
  for (const Index node : {0, 1})
    model.prescribed_motions.push_back({.node = node,
                                        .axis = axis,
                                        .rotation = true,
                                        .kind = Kind::Displacement,
                                        .curve = 0,
                                        .scale = node == 0 ? -1.0 : 1.0});
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::BeamBlock& block = simulation.domain().beams[0];
  return block.state(0, block.find("resultant")->first + (axis == 2 ? 5 : 4));
}

/// Sum of the moments of elastic, perfectly plastic fibres.
double moment_of_fibres(const model::BeamSection& section, double curvature) {
  double moment = 0;
  for (const model::SectionPoint& point : section.points)
    moment += point.area * point.s * std::clamp(young * curvature * point.s, -yield, yield);
  return moment;
}

TEST(IntegratedBeams, MomentFollowsTheCurvatureAsTheFibresSay) {
  // Half width 0.2: first yield at the curvature 10 / (1e4 * 0.2) = 0.005.
  for (const SectionRule rule :
       {SectionRule::Gauss2, SectionRule::Gauss3, SectionRule::Lobatto3, SectionRule::Gauss4}) {
    const auto section = test::integrated(model::rectangle_points(0.4, 0.2, rule));
    for (const double turn : {0.004, 0.008, 0.02, 0.06})
      EXPECT_NEAR(moment_at(section, turn), moment_of_fibres(section, turn),
                  1e-4 * moment_of_fibres(section, turn))
          << static_cast<int>(rule) << " " << turn;
  }
}

TEST(IntegratedBeams, ManyFibresHaveTheExactMomentCurvatureLine) {
  const auto section = test::integrated(model::plate_points({{0, 0, 0.4, 0.2}}, 8));
  const double first = yield * 0.2 * 0.16 / 6;
  double worst = 0;
  for (const double ratio : {1.0, 1.5, 2.0, 4.0, 10.0}) {
    const double exact = 1.5 * first * (1 - 1 / (3 * ratio * ratio));
    worst = test::larger_of(worst, std::fabs(moment_at(section, 0.005 * ratio) / exact - 1));
  }
  test::verified("moment of a rectangle over its curvature, error over exact", "elastic, perfectly plastic")
      .below(worst, 4e-3);
  test::verified("shape factor of a rectangle", "3/2").near(moment_at(section, 0.2) / first, 1.5, 1e-3);
}

TEST(IntegratedBeams, TubesHaveTheirShapeFactors) {
  const auto factor = [](double inner) {
    const auto section = test::integrated(model::tube_points(0.4, inner, SectionRule::Gauss4));
    const double first = yield * section.inertia_t / 0.2;
    return moment_at(section, 0.4) / first;
  };
  // Plastic over elastic modulus: (D^3 - d^3) / 6 and pi (D^4 - d^4) / 32 D.
  const auto exact = [](double ratio) {
    return 16 / (3 * pi) * (1 - std::pow(ratio, 3)) / (1 - std::pow(ratio, 4));
  };
  test::verified("shape factor of a solid round bar over exact, 32 points", "16 / 3 pi")
      .near(factor(0) / exact(0), 1, 0.02);
  test::verified("shape factor of a thin tube over exact, 32 points", "closed form")
      .near(factor(0.38) / exact(0.95), 1, 0.01);
}

TEST(IntegratedBeams, ShapesOfPlatesHaveTheirPlasticMoments) {
  // I: width 0.3, flange 0.02, depth 0.4, web 0.01; about the strong axis s.
  const auto section = test::integrated(model::plate_points(model::i_plates(0.3, 0.02, 0.4, 0.01), 4));
  const double modulus = 0.3 * 0.02 * 0.38 + 0.01 * 0.36 * 0.36 / 4;
  test::verified("plastic moment of an I of integrated beams over exact", "closed form")
      .near(moment_at(section, 0.2, 1) / (yield * modulus), 1, 3e-3);
  const auto box = test::integrated(model::plate_points(model::box_plates(0.3, 0.02, 0.4, 0.01), 4));
  const double box_modulus = 0.3 * 0.02 * 0.38 + 2 * 0.01 * 0.36 * 0.36 / 4;
  EXPECT_NEAR(moment_at(box, 0.2, 1), yield * box_modulus, 2e-3 * yield * box_modulus);
}

TEST(IntegratedBeams, ShapesAreCentredAndHaveTheirMoments) {
  const auto check = [](const std::vector<model::SectionPlate>& plates) {
    auto section = test::integrated(model::plate_points(plates, 0));
    double area = 0;
    double s = 0;
    double t = 0;
    double inertia = 0;
    for (const model::SectionPlate& plate : plates) {
      const double own = plate.width_s * plate.width_t;
      area += own;
      s += own * plate.s;
      t += own * plate.t;
      inertia += own * (plate.t * plate.t + plate.width_t * plate.width_t / 12);
    }
    EXPECT_NEAR(section.area, area, 1e-12);
    EXPECT_NEAR(section.inertia_s, inertia, 1e-12);
    EXPECT_NEAR(s, 0, 1e-15);
    EXPECT_NEAR(t, 0, 1e-15);
    return section;
  };
  EXPECT_NEAR(check(model::channel_plates(0.2, 0.02, 0.3, 0.01)).area, 2 * 0.2 * 0.02 + 0.26 * 0.01, 1e-12);
  EXPECT_NEAR(check(model::angle_plates(0.2, 0.02, 0.3, 0.01)).area, 0.2 * 0.02 + 0.28 * 0.01, 1e-12);
  EXPECT_NEAR(check(model::tee_plates(0.2, 0.02, 0.3, 0.01)).area, 0.2 * 0.02 + 0.28 * 0.01, 1e-12);
  check(model::i_plates(0.2, 0.02, 0.3, 0.01));
  check(model::box_plates(0.2, 0.02, 0.3, 0.01));
}

TEST(IntegratedBeams, NodesOnTheSideBendUnderAnAxialForce) {
  // Nodes at s = +half the width: the force acts with an arm of 0.2 on the middle of the section.
  auto points = model::rectangle_points(0.4, 0.2, SectionRule::Gauss2);
  model::move_nodes(points, 0.2, 0);
  const auto section = test::integrated(points);
  model::Model model = cantilever(elastic(), section, 4, 8);
  model.control.end_time = 200;
  constexpr double force = 1e-4;
  load_slowly(model, {.node = 8, .force = {force, 0, 0}});
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 2e-3);
  const double curvature = force * 0.2 / (young * 0.2 * 0.064 / 12);
  const math::Vec3 u = test::displacement(simulation.domain(), 8);
  // The middle is drawn towards the line of the force.
  test::verified("beam with its nodes on a side under an axial force: deflection over exact", "beam theory")
      .near(u.y / (-0.5 * curvature * 16), 1, 1e-3);
  const double stretched = force * 4 / (young * 0.08) + 0.2 * curvature * 4;
  EXPECT_NEAR(u.x, stretched, 2e-3 * stretched);
}

/// Largest tip displacement of a fixed and free column under a load along it, over its length.
double bow_of_column(double share) {
  constexpr double length = 10;
  constexpr Index count = 16;
  const auto section = test::integrated(model::rectangle_points(0.2, 0.4, SectionRule::Gauss2));
  model::Model model = cantilever(elastic(), section, length, count);
  model.control.end_time = 700;
  const double euler = pi * pi * young * section.inertia_t / (4 * length * length);
  load_slowly(model, {.node = count, .force = {-share * euler, 0, 0}});
  load_slowly(model, {.node = count, .force = {0, 1e-4 * euler, 0}});
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 1e-3);
  return std::fabs(test::displacement(simulation.domain(), count).y) / length;
}

TEST(IntegratedBeams, ColumnBucklesAtEulersLoad) {
  const double below = bow_of_column(0.9);
  const double above = bow_of_column(1.1);
  // Below, with k L = pi / 2 sqrt(share): deflection over length H / P (tan(k L) / k L - 1). Above it bows as
  // the elastica does: 0.422 at 1.063, 0.593 at 1.152 of Euler's load (S.P. Timoshenko & J.M. Gere, Theory of
  // Elastic Stability, 1961, table 2-4).
  const double angle = 0.5 * pi * std::sqrt(0.9);
  const double exact = 1e-4 / 0.9 * (std::tan(angle) / angle - 1);
  RecordProperty("bow_above", std::to_string(above));
  test::verified("column at 0.9 of Euler's load with a side force: deflection over exact", "beam column")
      .near(below / exact, 1, 0.03);
  EXPECT_GT(above, 0.422);
  EXPECT_LT(above, 0.593);
}

TEST(IntegratedBeams, PortalFrameCollapsesAtItsPlasticLoad) {
  // Fixed feet, height 4, width 4; the corners are pushed sideways. With hinges in the middle of the last
  // beams of the columns, h less one beam apart: load = 4 Mp / (h - l).
  constexpr Index count = 20;
  constexpr double height = 4;
  const auto section = test::integrated(model::plate_points({{0, 0, 0.2, 0.1}}, 4));
  model::Model model = test::one_beam_part(plastic(), section);
  test::add_line(model, count, {1, 0, 0}, [](double u) { return Point{0, 0, height * u}; });
  // The beam is stiff and strong: three times as wide.
  model.beam_sections.push_back(test::integrated(model::plate_points({{0, 0, 0.6, 0.1}}, 4)));
  model.parts.push_back({.id = 2, .title = "beam", .beam_section = 1, .material = 0});
  const Index other = test::add_line(model, count, {1, 0, 0}, [](double u) {
    return Point{4, 0, height * u};
  });
  for (Index i = 0; i < 10; ++i) {
    const Index last = model.nodes.count() - 1;
    const Index from = i == 0 ? count : last;
    Index to = other + count;
    if (i < 9) {
      model.nodes.id.push_back(model.nodes.count() + 1);
      model.nodes.position.push_back({4 * (i + 1) / 10.0, 0, height});
      to = last + 1;
    }
    model.beams.push_back({.id = 1000 + i, .part = 1, .node = {from, to}, .orientation = {0, 0, 1}});
  }
  for (const Index foot : {Index{0}, other})
    model.fixed_nodes.push_back(
        {.node = foot, .translation = {true, true, true}, .rotation = {true, true, true}});
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.fixed_nodes.push_back(
        {.node = i, .translation = {false, true, false}, .rotation = {true, false, true}});
  model.control.end_time = 80;
  model.curves.push_back({1, {0, 80, 1e9}, {0, 0.5, 0.5}});
  using Kind = model::PrescribedMotion::Kind;
  for (const Index corner : {count, other + count})
    model.prescribed_motions.push_back({.node = corner, .axis = 0, .kind = Kind::Displacement, .curve = 0});
  timeloop::Simulation simulation(model, test::execution());
  test::run_damped(simulation, 2e-3);
  const domain::BeamBlock& block = simulation.domain().beams[0];
  double force = 0;
  for (Index place = 0; place < block.elements; ++place) {
    const Index element = block.element[place];
    if (element != 0 && element != count) continue;
    const Index resultant = block.find("resultant")->first;
    const double length = block.state(place, 2) + block.state(place, block.find("deformation")->first);
    force += (block.state(place, resultant + 3) + block.state(place, resultant + 5)) / length;
  }
  const double moment = yield * 0.1 * 0.04 / 4;
  RecordProperty("over_four_moments_over_height", std::to_string(std::fabs(force) * height / (4 * moment)));
  test::verified("portal frame of integrated beams: collapse load over exact", "plastic hinges")
      .near(std::fabs(force) / (4 * moment / (height - height / count)), 1, 0.02);
}

}  // namespace
}  // namespace crumple::integrated_beams_test
