// SPDX-License-Identifier: BSD-3-Clause
#include "app/preparation/preparation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/preparation/bounding_box.hpp"
#include "app/preparation/perturbation.hpp"
#include "base/error.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"

namespace crumple::app::preparation_test {
namespace {

model::Model plate() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1, 3));
  test::add_grid(model, 0, 10, 10, [](double u, double v) { return test::Point{30 * u, 40 * v, 0}; });
  return model;
}

TEST(Preparation, TheCommandLineComesBeforeTheDeckBeforeTheDefault) {
  model::Model model = plate();
  Options options;
  EXPECT_EQ(choose_execution(options, model).precision, Precision::Double);
  EXPECT_EQ(choose_execution(options, model).threads, 1);
  model.run.precision = "mixed";
  EXPECT_EQ(choose_execution(options, model).precision, Precision::Mixed);
  options.precision = "double";
  options.isa = "scalar";
  options.threads = 5;
  EXPECT_EQ(choose_execution(options, model).precision, Precision::Double);
  EXPECT_EQ(choose_execution(options, model).isa, Isa::Scalar);
  EXPECT_EQ(choose_execution(options, model).threads, 5);
  options.precision.reset();
  model.run.precision = "quarter";
  EXPECT_THROW(choose_execution(options, model), Error);
}

TEST(Perturbation, IsSmallDifferentForEveryCoordinateAndRepeatable) {
  const model::Model before = plate();
  EXPECT_DOUBLE_EQ(bounding_box(before).diagonal(), 50);
  model::Model moved = before;
  perturb_coordinates(moved, 1e-3, 1);
  double largest = 0;
  double sum = 0;
  for (std::size_t i = 0; i < before.nodes.position.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double change = moved.nodes.position[i][axis] - before.nodes.position[i][axis];
      EXPECT_NE(change, 0);
      largest = test::larger_of(largest, std::fabs(change));
      sum += change;
    }
  EXPECT_LE(largest, 0.05 * (1 + 1e-9)) << "a thousandth of the diagonal";
  EXPECT_GT(largest, 0.04);
  // 363 numbers, uniform within 0.05: their sum has a standard deviation of 0.05 sqrt(363/3) = 0.55.
  EXPECT_LT(std::fabs(sum), 4 * 0.55);
  model::Model again = before;
  perturb_coordinates(again, 1e-3, 1);
  EXPECT_EQ(again.nodes.position, moved.nodes.position);
  perturb_coordinates(again, 0, 1);
  EXPECT_EQ(again.nodes.position, moved.nodes.position);
  model::Model other = before;
  perturb_coordinates(other, 1e-3, 2);
  EXPECT_NE(other.nodes.position, moved.nodes.position);
}

TEST(Perturbation, MovesNodesAtOnePlaceAlike) {
  model::Model model = plate();
  model.nodes.position[7] = model.nodes.position[3];
  const auto before = model.nodes.position[3];
  perturb_coordinates(model, 1e-3, 5);
  EXPECT_EQ(model.nodes.position[7], model.nodes.position[3]);
  EXPECT_NE(model.nodes.position[3], before);
}

}  // namespace
}  // namespace crumple::app::preparation_test
