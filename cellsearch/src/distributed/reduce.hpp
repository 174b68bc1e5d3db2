// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "cellsearch/distributed/transport.hpp"

namespace cellsearch {

/// True if `one` comes before `other`: by value, -0 before +0.
inline bool is_before(double one, double other) {
  return one < other || (one == other && std::signbit(one) && !std::signbit(other));
}
inline bool is_before(std::int64_t one, std::int64_t other) {
  return one < other;
}

/// All NaNs become the same one: the bits must not depend on whose it was.
inline double joined_minimum(double one, double other) {
  if (std::isnan(one) || std::isnan(other)) return std::nan("");
  return is_before(other, one) ? other : one;
}
inline double joined_maximum(double one, double other) {
  if (std::isnan(one) || std::isnan(other)) return std::nan("");
  return is_before(one, other) ? other : one;
}
inline std::int64_t joined_minimum(std::int64_t one, std::int64_t other) {
  return other < one ? other : one;
}
inline std::int64_t joined_maximum(std::int64_t one, std::int64_t other) {
  return one < other ? other : one;
}
inline double joined_sum(double one, double other) {
  return one + other;
}
inline std::int64_t joined_sum(std::int64_t one, std::int64_t other) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(one) + static_cast<std::uint64_t>(other));
}

/// Joins `count` values of one more rank to those joined so far.
template <class Number>
void join(Reduction how, const Number* more, Number* joined, std::size_t count) {
  for (std::size_t place = 0; place < count; ++place) {
    Number& value = joined[place];
    switch (how) {
      case Reduction::Min:
        value = joined_minimum(value, more[place]);
        break;
      case Reduction::Max:
        value = joined_maximum(value, more[place]);
        break;
      case Reduction::Sum:
        value = joined_sum(value, more[place]);
        break;
    }
  }
}

}  // namespace cellsearch
