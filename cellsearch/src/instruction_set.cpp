// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/instruction_set.hpp"

#include <array>
#include <cstddef>

namespace cellsearch {
namespace {

constexpr std::array<std::string_view, 3> names{"portable", "avx2", "avx512"};

}  // namespace

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> found{InstructionSet::Portable};
#ifdef CELLSEARCH_X86
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
      __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("popcnt")) {
    found.push_back(InstructionSet::Avx2);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
      found.push_back(InstructionSet::Avx512);
    }
  }
#endif
  return found;
}

std::string_view name_of(InstructionSet set) {
  return names[static_cast<std::size_t>(set)];
}

std::optional<InstructionSet> instruction_set_named(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<InstructionSet>(i);
  }
  return std::nullopt;
}

}  // namespace cellsearch
