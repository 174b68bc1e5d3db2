// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/run_limits.hpp"

#include <gtest/gtest.h>

namespace crumple::app::run_limits_test {
namespace {

class RunLimits : public ::testing::Test {
 protected:
  RunLimits() {
    domain_.energy.initial_total = 100;
    domain_.energy.kinetic = 97;
    domain_.added_mass = 3;
  }
  std::optional<std::string> passed(double next_step) const {
    return passed_limit(control_, domain_, next_step, {1e-6, 50});
  }
  model::Control control_;
  domain::Domain domain_;
};

TEST_F(RunLimits, NothingHoldsUnlessTheDeckSetsIt) {
  EXPECT_FALSE(passed(1e-30).has_value());
}

TEST_F(RunLimits, StepBelowAShareOfTheFirst) {
  control_.minimum_step_factor = 0.1;
  EXPECT_FALSE(passed(1.01e-7).has_value());
  EXPECT_NE(passed(0.99e-7).value().find("DTMIN"), std::string::npos);
}

TEST_F(RunLimits, TheEndIsThatOfTheTimeOrOfTheCycles) {
  control_.end_time = 2;
  domain_.clock.cycle = 10;
  domain_.clock.time = 0.5;
  EXPECT_EQ(end_reached(control_, domain_.clock), "termination time reached");
  control_.end_cycle = 11;
  EXPECT_EQ(end_reached(control_, domain_.clock), "termination time reached");
  control_.end_cycle = 10;
  EXPECT_EQ(end_reached(control_, domain_.clock), "cycle limit reached: ENDCYC = 10, at the time 0.5 of 2");
}

TEST_F(RunLimits, SolidsThatGoDoNotEndTheRun) {
  control_.minimum_step_factor = 0.1;
  control_.erodes_short_solids = true;
  EXPECT_FALSE(passed(0.5e-7).has_value());
}

TEST_F(RunLimits, EnergyRatioInEitherDirection) {
  control_.end_energy_ratio = 2.9;
  EXPECT_NE(passed(1e-6).value().find("ENDENG"), std::string::npos);
  domain_.energy.kinetic = 103;
  EXPECT_TRUE(passed(1e-6).has_value());
  control_.end_energy_ratio = 3.1;
  EXPECT_FALSE(passed(1e-6).has_value());
}

TEST_F(RunLimits, MassIncreaseUsesTheWordsUsersSearchFor) {
  control_.end_mass_increase = 5.9;
  EXPECT_NE(passed(1e-6).value().find("termination due to mass increase"), std::string::npos);
  control_.end_mass_increase = 6.1;
  EXPECT_FALSE(passed(1e-6).has_value());
}

}  // namespace
}  // namespace crumple::app::run_limits_test
