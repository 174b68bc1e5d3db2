// SPDX-License-Identifier: BSD-3-Clause
#include "app/measurement/solid_benchmark.hpp"

#include <gtest/gtest.h>

namespace crumple::app::solid_benchmark_test {
namespace {

TEST(SolidBenchmark, ModelsOfAllFormulationsCanBeRun) {
  for (const NamedSolid& solid : benchmark_solids()) {
    const SolidBenchmark benchmark{2, solid, {}};
    const model::Model model = solid_benchmark_model(benchmark);
    EXPECT_EQ(model::faults(model), std::vector<std::string>{}) << solid.name;
    EXPECT_EQ(model.solids.size(), model::is_tetrahedral(solid.formulation) ? 48U : 8U) << solid.name;
    EXPECT_GT(measure_solids(benchmark, 0).wall, 0) << solid.name;
  }
}

}  // namespace
}  // namespace crumple::app::solid_benchmark_test
