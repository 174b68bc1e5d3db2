// SPDX-License-Identifier: BSD-3-Clause
//
// Pinched cylinder and hemisphere of R.H. MacNeal & R.L. Harder, Finite Elements in Analysis and Design 1
// (1985) 3-20, brought to rest under their loads by the explicit solver: the loads act from time zero, and
// the test takes speed from all nodes in proportion to it, so much as is critical for a low frequency, until
// they have come to rest. Accepted displacements: 1.8248e-5 and 0.094. The hemisphere carries a tenth of its
// load, to stay linear. The names of the tests say the mesh.

#include <gtest/gtest.h>

#include <string>

#include "support/run.hpp"
#include "support/shell_benchmarks.hpp"
#include "support/verified.hpp"

namespace crumple::curved_shells_test {
namespace {

using model::ShellFormulation;

/// Displacement of the first loaded node along its load, over the accepted one, after `duration` [time];
/// speeds decay with `rate` [1/time].
double over_accepted(test::ShellBenchmark benchmark, double rate, double duration) {
  model::Model& model = benchmark.model;
  model.control.end_time = duration;
  model.control.hourglass = {model::HourglassForm::Stiffness, 0.1, 0.1, 0.1};
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  while (!simulation.finished()) {
    simulation.step();
    const double keep = 1 - rate * simulation.next_step();
    domain::NodeFields& nodes = simulation.domain().nodes;
    for (Index i = 0; i < nodes.count(); ++i) {
      nodes.velocity[i] = keep * nodes.velocity[i];
      nodes.angular_velocity[i] = keep * nodes.angular_velocity[i];
    }
  }
  const model::NodalLoad& load = model.nodal_loads.front();
  const math::Vec3 along = math::normalised(math::Vec3{load.force[0], load.force[1], load.force[2]});
  const double ratio = dot(test::displacement(simulation.domain(), load.node), along) / benchmark.accepted;
  return ratio;
}

/// About critical for the lowest frequencies, and long enough to agree with the static solutions.
constexpr double cylinder_rate = 40;
constexpr double cylinder_duration = 0.6;
constexpr double hemisphere_rate = 7;
constexpr double hemisphere_duration = 5;

struct Case {
  ShellFormulation formulation;
  const char* name;
  double cylinder, hemisphere;  ///< of the static solutions with the same stiffness, tests/elements
};
const Case cases[] = {{ShellFormulation::FullyIntegrated, "FullyIntegrated", 0.7590, 0.9910},
                      {ShellFormulation::HughesLiuSelectiveReduced, "HughesLiuSelective", 0.7679, 1.0483}};

class CurvedShell : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Shells, CurvedShell, ::testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

/// The explicit solver comes to rest where the static solution is.
TEST_P(CurvedShell, PinchedCylinder8x8) {
  const double ratio =
      over_accepted(test::pinched_cylinder(GetParam().formulation, 8), cylinder_rate, cylinder_duration);
  test::verified("pinched cylinder 8 x 8, brought to rest: displacement over accepted",
                 "static solution of this mesh")
      .near(ratio, GetParam().cylinder, 0.005);
}
TEST_P(CurvedShell, Hemisphere8x8) {
  const double ratio =
      over_accepted(test::hemisphere(GetParam().formulation, 8, 0.1), hemisphere_rate, hemisphere_duration);
  test::verified("hemisphere 8 x 8, brought to rest: displacement over accepted",
                 "static solution of this mesh")
      .near(ratio, GetParam().hemisphere, 0.005);
}

/// What is left of the mesh's error: 1 is the accepted displacement.
TEST_P(CurvedShell, PinchedCylinderNightly32x32) {
  const double ratio =
      over_accepted(test::pinched_cylinder(GetParam().formulation, 32), cylinder_rate, cylinder_duration);
  test::verified("pinched cylinder 32 x 32, brought to rest: displacement over accepted",
                 "MacNeal and Harder 1985")
      .near(ratio, 1, 0.02);
}
TEST_P(CurvedShell, HemisphereNightly16x16) {
  const double ratio =
      over_accepted(test::hemisphere(GetParam().formulation, 16, 0.1), hemisphere_rate, hemisphere_duration);
  test::verified("hemisphere 16 x 16, brought to rest: displacement over accepted", "MacNeal and Harder 1985")
      .near(ratio, 1, 0.02);
}

}  // namespace
}  // namespace crumple::curved_shells_test
