// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The pictures of the verification manual: curves that a test notes beside its cases (verified.hpp), from
// which tools/verification_manual draws docs/pictures/verified_*.svg.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace crumple::test {

/// Points of a curve.
using Points = std::vector<std::array<double, 2>>;

/// One picture: what was accepted and what was found, over the same axis.
class Drawn {
 public:
  /// Title and names of the axes, with units. None of the texts holds a bar or a colon.
  Drawn(const std::string& title, const std::string& across, const std::string& up)
      : text_(title + " | " + across + " | " + up) {}

  /// What is accepted; drawn in grey.
  Drawn& accepted(const std::string& name, const Points& points) { return add("accepted", name, points); }
  /// What the test found.
  Drawn& found(const std::string& name, const Points& points) { return add("found", name, points); }

  /// Puts the picture among the properties of the test.
  void note() const {
    const int count =
        ::testing::UnitTest::GetInstance()->current_test_info()->result()->test_property_count();
    ::testing::Test::RecordProperty("curves_" + std::to_string(count), text_);
  }

 private:
  /// More would not be seen.
  static constexpr std::size_t most_points = 200;

  Drawn& add(const char* kind, const std::string& name, const Points& points) {
    text_ += std::string(" | ") + kind + " : " + name + " :";
    const std::size_t stride = 1 + points.size() / most_points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i % stride != 0 && i + 1 != points.size()) continue;
      std::array<char, 64> pair{};
      std::snprintf(pair.data(), pair.size(), " %.5g %.5g", points[i][0], points[i][1]);
      text_ += pair.data();
    }
    return *this;
  }

  std::string text_;
};

inline Drawn drawn(const std::string& title, const std::string& across, const std::string& up) {
  return {title, across, up};
}

}  // namespace crumple::test
