// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The cases of the verification manual: each is an assertion that also notes what it found, among the
// properties of its test, from which tools/verification_manual makes docs/verification_results.md.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace crumple::test {

/// One comparison with something accepted.
class Verified {
 public:
  /// `what` is compared, in words; `source` is where the accepted value comes from. Neither holds a bar.
  Verified(std::string what, std::string source) : what_(std::move(what)), source_(std::move(source)) {}

  /// |found - accepted| <= allowed.
  void near(double found, double accepted, double allowed) const {
    EXPECT_NEAR(found, accepted, allowed) << what_;
    note("near", found, accepted, allowed);
  }
  /// |found - accepted| <= share |accepted|.
  void within(double found, double accepted, double share) const {
    EXPECT_NEAR(found, accepted, share * std::fabs(accepted)) << what_;
    note("within", found, accepted, share);
  }
  /// found < bound, of an error that should be zero.
  void below(double found, double bound) const {
    EXPECT_LT(found, bound) << what_;
    note("below", found, 0, bound);
  }

 private:
  void note(const char* kind, double found, double accepted, double allowed) const {
    // In full: what a limit of round-off allows is many digits behind the first.
    std::array<char, 160> numbers{};
    std::snprintf(numbers.data(), numbers.size(), " | %s | %.17g | %.17g | %.17g", kind, found, accepted,
                  allowed);
    // Properties of one name replace each other.
    const int count =
        ::testing::UnitTest::GetInstance()->current_test_info()->result()->test_property_count();
    ::testing::Test::RecordProperty("case_" + std::to_string(count),
                                    what_ + " | " + source_ + numbers.data());
  }

  std::string what_;
  std::string source_;
};

inline Verified verified(std::string what, std::string source) {
  return {std::move(what), std::move(source)};
}

}  // namespace crumple::test
