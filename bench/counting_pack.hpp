// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A pack of one number that counts its floating-point operations: sums, products, divisions and square roots,
// a multiply-add as two. Comparisons, selections, loads and stores are free. For counting only: the kernels
// are compiled with it as with any other pack.

#include <cmath>

#include "base/pack.hpp"
#include "math/power.hpp"

namespace crumple {

template <class Real>
struct CountingPack {
  Real value = 0;
  static inline long operations = 0;

  CountingPack() = default;
  CountingPack(Real number) : value(number) {}  // implicit, as of any pack

  static CountingPack counted(Real result) {
    ++operations;
    return result;
  }
  friend CountingPack operator+(CountingPack a, CountingPack b) { return counted(a.value + b.value); }
  friend CountingPack operator-(CountingPack a, CountingPack b) { return counted(a.value - b.value); }
  friend CountingPack operator*(CountingPack a, CountingPack b) { return counted(a.value * b.value); }
  friend CountingPack operator/(CountingPack a, CountingPack b) { return counted(a.value / b.value); }
  friend CountingPack operator-(CountingPack a) { return -a.value; }
  friend bool operator<(CountingPack a, CountingPack b) { return a.value < b.value; }
  friend bool operator>(CountingPack a, CountingPack b) { return a.value > b.value; }
  friend bool operator<=(CountingPack a, CountingPack b) { return a.value <= b.value; }
  friend bool operator>=(CountingPack a, CountingPack b) { return a.value >= b.value; }
  friend bool operator==(CountingPack a, CountingPack b) { return a.value == b.value; }
};

template <class Number>
struct PackTraits<CountingPack<Number>> {
  using Real = Number;
  using Mask = bool;
  static constexpr int width = 1;
};

template <>
inline void store<CountingPack<float>>(float* to, const CountingPack<float>& from) {
  *to = from.value;
}
template <>
inline CountingPack<float> square_root(const CountingPack<float>& a) {
  return CountingPack<float>::counted(std::sqrt(a.value));
}
template <>
inline CountingPack<float> absolute(const CountingPack<float>& a) {
  return std::fabs(a.value);
}

/// Works on the bits of a number: not counted. The materials that are counted have no rate effect.
template <>
inline CountingPack<float> math::power(const CountingPack<float>& x, const CountingPack<float>& y) {
  return std::pow(x.value, y.value);
}

}  // namespace crumple
