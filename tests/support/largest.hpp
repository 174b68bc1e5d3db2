// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One case of the verification manual made of many points: each is asserted, the largest error is noted.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "support/larger.hpp"
#include "support/verified.hpp"

namespace crumple::test {

/// Errors that should be zero and are below a bound. Notes the largest where it goes out of scope.
class Largest {
 public:
  /// `what` and `source` as in verified().
  Largest(std::string what, std::string source, double bound)
      : what_(std::move(what)), source_(std::move(source)), bound_(bound) {}
  Largest(const Largest&) = delete;
  Largest& operator=(const Largest&) = delete;
  ~Largest() {
    EXPECT_TRUE(any_) << what_ << ": nothing was compared";
    verified(what_, source_).below(largest_, bound_);
  }

  /// The size of an error, which has no sign: a sum with one would hide behind the bound. `place` helps to
  /// find it.
  void add(double error, const std::string& place = "") {
    EXPECT_LT(error, bound_) << what_ << " " << place;
    EXPECT_GE(error, 0) << what_ << " " << place;
    largest_ = larger_of(largest_, error);
    any_ = true;
  }
  /// |found - accepted| over the size of what is compared.
  void compare(double found, double accepted, double size = 1, const std::string& place = "") {
    add(std::fabs(found - accepted) / std::fabs(size), place);
  }

 private:
  std::string what_;
  std::string source_;
  double bound_;
  double largest_ = 0;
  bool any_ = false;
};

}  // namespace crumple::test
