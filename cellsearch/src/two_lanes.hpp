// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace cellsearch {

/// Two double precision numbers side by side; one vector instruction where the processor has it.
#if defined(__SSE2__)
struct TwoLanes {
  __m128d value;

  static TwoLanes both(double a) { return {_mm_set1_pd(a)}; }
  static TwoLanes load(const double* at) { return {_mm_loadu_pd(at)}; }
  void store(double* at) const { _mm_storeu_pd(at, value); }

  friend TwoLanes operator+(TwoLanes a, TwoLanes b) { return {_mm_add_pd(a.value, b.value)}; }
  friend TwoLanes operator-(TwoLanes a, TwoLanes b) { return {_mm_sub_pd(a.value, b.value)}; }
  friend TwoLanes operator*(TwoLanes a, TwoLanes b) { return {_mm_mul_pd(a.value, b.value)}; }
  /// The second where one is not a number, as the instruction does.
  friend TwoLanes min(TwoLanes a, TwoLanes b) { return {_mm_min_pd(a.value, b.value)}; }
  friend TwoLanes max(TwoLanes a, TwoLanes b) { return {_mm_max_pd(a.value, b.value)}; }
};
#else
struct TwoLanes {
  double value[2];

  static TwoLanes both(double a) { return {{a, a}}; }
  static TwoLanes load(const double* at) { return {{at[0], at[1]}}; }
  void store(double* at) const {
    at[0] = value[0];
    at[1] = value[1];
  }

  friend TwoLanes operator+(TwoLanes a, TwoLanes b) {
    return {{a.value[0] + b.value[0], a.value[1] + b.value[1]}};
  }
  friend TwoLanes operator-(TwoLanes a, TwoLanes b) {
    return {{a.value[0] - b.value[0], a.value[1] - b.value[1]}};
  }
  friend TwoLanes operator*(TwoLanes a, TwoLanes b) {
    return {{a.value[0] * b.value[0], a.value[1] * b.value[1]}};
  }
  friend TwoLanes min(TwoLanes a, TwoLanes b) {
    return {{a.value[0] < b.value[0] ? a.value[0] : b.value[0],
             a.value[1] < b.value[1] ? a.value[1] : b.value[1]}};
  }
  friend TwoLanes max(TwoLanes a, TwoLanes b) {
    return {{a.value[0] > b.value[0] ? a.value[0] : b.value[0],
             a.value[1] > b.value[1] ? a.value[1] : b.value[1]}};
  }
};
#endif

}  // namespace cellsearch
