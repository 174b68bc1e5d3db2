// SPDX-License-Identifier: BSD-3-Clause
#include "app/preparation/part_tables.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace crumple::app::part_tables_test {
namespace {

TEST(RateWords, SayWhichEffectActsAndHow) {
  EXPECT_EQ(rate_words(model::Elastic{}), "none");
  EXPECT_EQ(rate_words(model::PlasticKinematic{}), "none");
  model::PlasticKinematic kinematic;
  kinematic.cowper_symonds_rate = 40;
  EXPECT_EQ(rate_words(kinematic), "Cowper-Symonds, VP 0");
  model::PiecewiseLinearPlasticity piecewise;
  EXPECT_EQ(rate_words(piecewise), "none");
  piecewise.cowper_symonds_rate = 40;
  piecewise.viscoplastic = true;
  EXPECT_EQ(rate_words(piecewise), "Cowper-Symonds, VP 1");
  piecewise.factor_rate = {0, 1};
  EXPECT_EQ(rate_words(piecewise), "factors by rate, VP 1");
  piecewise.by_rate.resize(3);
  EXPECT_EQ(rate_words(piecewise), "3 curves by rate, VP 1");
}

TEST(HourglassWords, AreNoneWhereThereIsNoControl) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1, 3));
  const auto words = [&](model::ShellFormulation formulation) {
    model.shell_sections[0].formulation = formulation;
    return hourglass_words(model, model.parts[0]);
  };
  EXPECT_EQ(words(model::ShellFormulation::BelytschkoTsay), "viscous QM 0.1");
  EXPECT_EQ(words(model::ShellFormulation::HughesLiuSelectiveReduced), "viscous QW 0.1");
  EXPECT_EQ(words(model::ShellFormulation::FullyIntegrated), "none");
  EXPECT_EQ(words(model::ShellFormulation::Triangle), "none");
  model.materials[0].law = model::NullMaterial{200, 0.3};
  EXPECT_EQ(words(model::ShellFormulation::BelytschkoTsay), "none");
}

}  // namespace
}  // namespace crumple::app::part_tables_test
