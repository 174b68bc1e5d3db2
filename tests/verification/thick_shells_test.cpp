// SPDX-License-Identifier: BSD-3-Clause
//
// Shells much thicker than long, shaken at random: hourglass control must not damp faster than the step
// allows.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/largest.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"

namespace crumple::thick_shells_test {
namespace {

const char* name_of(model::ShellFormulation formulation) {
  using enum model::ShellFormulation;
  switch (formulation) {
    case BelytschkoTsay:
      return "Belytschko-Tsay";
    case BelytschkoWongChiang:
      return "Belytschko-Wong-Chiang";
    case HughesLiu:
      return "Hughes-Liu";
    case HughesLiuSelectiveReduced:
      return "Hughes-Liu, selectively reduced";
    default:
      return "fully integrated";
  }
}

TEST(ThickShells, StayStableWithEitherHourglassControl) {
  using enum model::ShellFormulation;
  for (const auto formulation :
       {BelytschkoTsay, BelytschkoWongChiang, HughesLiu, HughesLiuSelectiveReduced, FullyIntegrated})
    for (const auto form : {model::HourglassForm::Viscous, model::HourglassForm::Stiffness}) {
      test::Largest off(std::string("shells up to eight times as thick as long, ") + name_of(formulation) +
                            (form == model::HourglassForm::Viscous ? ", viscous" : ", stiffness") +
                            " control: imbalance over the energy at first",
                        "conservation", form == model::HourglassForm::Viscous ? 0.01 : 1e-4);
      for (const double thickness : {0.1, 1.0, 2.0, 8.0}) {
        model::Model model =
            test::one_part(test::elastic_steel(), test::shell_section(thickness, 3, formulation));
        test::add_grid(model, 0, 4, 4, [](double u, double v) { return test::Point{4 * u, 4 * v, 0}; });
        model.control.hourglass = {form, 0.1, 0.1, 0.1};
        model.control.end_time = 0.1;  // some 600 steps
        std::mt19937 generator(1);
        std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
        const auto random = [&] {
          return test::Point{uniform(generator), uniform(generator), uniform(generator)};
        };
        for (Index node = 0; node < model.nodes.count(); ++node)
          model.initial_velocities.push_back(
              {.node = node, .velocity = random(), .angular_velocity = random()});
        timeloop::Simulation simulation(model, test::execution());
        test::run(simulation);
        const domain::EnergyLedger& energy = simulation.domain().energy;
        off.add(std::fabs(energy.imbalance()) / energy.initial_total, std::to_string(thickness));
      }
    }
}

}  // namespace
}  // namespace crumple::thick_shells_test
