// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A small model and its domain, with a folder of its own to write to.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "domain/build.hpp"
#include "output/results/view.hpp"
#include "support/meshes.hpp"

namespace crumple::output {

/// A 2 x 1 plate of part 7 (two squares) and a triangle of part 3 beside it; ids are not in order, as decks
/// may have them.
inline model::Model sample_model() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.5, 3));
  model.parts[0].id = 7;
  model.parts.push_back({.id = 3, .title = "second", .section = 0, .material = 0});
  test::add_grid(model, 0, 2, 1, [](double u, double v) { return test::Point{2 * u, v, 0}; });
  model.nodes.id = {60, 50, 40, 30, 20, 10};
  model.shells.push_back({.id = 5, .part = 1, .node = {0, 1, 4, 4}});
  model.shells[0].id = 99;
  model.shells[1].id = 11;
  model.control.end_time = 1.0;
  return model;
}

/// Gives a block the state items that output looks for, without the element layer.
inline void add_state(domain::ShellBlock& block) {
  domain::add_item(block, "stress", "stress", 15);
  domain::add_item(block, "plastic_strain", "-", 3);
  domain::add_item(block, "active", "-", 1);
  const double outer = std::sqrt(0.6);  // Gauss
  block.point_place = {-outer, 0, outer};
  block.point_weight = {5.0 / 18, 4.0 / 9, 5.0 / 18};
  block.double_state.resize(static_cast<std::size_t>(block.groups()) * block.components * lanes);
  for (Index place = 0; place < block.elements; ++place)
    block.set_state(place, block.find("active")->first, 1);
}

class SampleTest : public ::testing::Test {
 public:
  ~SampleTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

 protected:
  SampleTest() : SampleTest(sample_model()) {}
  explicit SampleTest(model::Model model)
      : model_(std::move(model)), domain_(domain::build(model_, domain::Execution{})) {
    for (domain::ShellBlock& block : domain_.shells) add_state(block);
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        std::filesystem::path(::testing::TempDir()) / (std::string("crumple_") + test->test_suite_name() +
                                                       "_" + test->name() + "_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  View view() const { return {model_, domain_, 0.001}; }
  void go_to(double time, long cycle) {
    domain_.clock.time = time;
    domain_.clock.cycle = cycle;
  }

  static std::string read(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }
  static std::vector<std::string> lines(const std::filesystem::path& path) {
    std::vector<std::string> result;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) result.push_back(line);
    return result;
  }

  model::Model model_;
  domain::Domain domain_;
  std::filesystem::path folder_;
};

}  // namespace crumple::output
