// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "base/isa.hpp"

namespace crumple::bench {

/// What the machine can do at most, for one instruction set.
struct MachineKernels {
  /// `rounds` times 12 independent multiply-adds of a pack; returns something that depends on all of them.
  double (*float_peak)(long rounds);
  double (*double_peak)(long rounds);
  int float_width;
  int double_width;
  /// Sum of `count` doubles; `count` is a multiple of 64, the address that of a cache line.
  double (*read)(const double* from, std::size_t count);
  /// Multiplies them by a factor in place.
  void (*update)(double* at, std::size_t count, double factor);
};

inline constexpr int independent_chains = 12;

template <Isa Variant>
MachineKernels machine_kernels();

}  // namespace crumple::bench
