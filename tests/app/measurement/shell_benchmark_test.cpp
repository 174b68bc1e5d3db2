// SPDX-License-Identifier: BSD-3-Clause
#include "app/measurement/shell_benchmark.hpp"

#include <gtest/gtest.h>

#include "model/model.hpp"

namespace crumple::app::shell_benchmark_test {
namespace {

/// Each formulation gets shells that it computes, and as many as its figures are divided by.
TEST(ShellBenchmark, ModelsOfAllFormulationsCanBeRun) {
  const NamedLaw elastic = benchmark_laws().at(0);
  ASSERT_GE(benchmark_formulations().size(), 6U);
  for (const NamedFormulation& formulation : benchmark_formulations()) {
    const ShellBenchmark benchmark{4, formulation.formulation, elastic.law, 3, {}};
    EXPECT_EQ(model::faults(shell_benchmark_model(benchmark)), std::vector<std::string>{})
        << formulation.name;
    EXPECT_EQ(shell_benchmark_model(benchmark).shells.size(), 16U) << formulation.name;
    EXPECT_GT(measure_shells(benchmark, 0).wall, 0) << formulation.name;
  }
}

}  // namespace
}  // namespace crumple::app::shell_benchmark_test
