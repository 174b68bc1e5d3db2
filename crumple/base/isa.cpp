// SPDX-License-Identifier: BSD-3-Clause
#include "base/isa.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/error.hpp"

namespace crumple {
namespace {

constexpr std::array<std::string_view, 4> names{"scalar", "baseline", "avx2", "avx512"};

#if defined(CRUMPLE_HAS_avx2) || defined(CRUMPLE_HAS_avx512)
bool has_avx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
#endif

}  // namespace

std::string_view isa_name(Isa isa) {
  return names[static_cast<std::size_t>(isa)];
}

std::vector<Isa> available_isas() {
  std::vector<Isa> found{Isa::Scalar};
#if defined(CRUMPLE_HAS_baseline)
  found.push_back(Isa::Baseline);
#endif
#if defined(CRUMPLE_HAS_avx2)
  if (has_avx2()) found.push_back(Isa::Avx2);
#endif
#if defined(CRUMPLE_HAS_avx512)
  if (has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    found.push_back(Isa::Avx512);
#endif
  return found;
}

Isa parse_isa(std::string_view name) {
  std::string choices;
  for (const Isa isa : available_isas()) {
    if (isa_name(isa) == name) return isa;
    choices += (choices.empty() ? "" : ", ") + std::string(isa_name(isa));
  }
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  throw Error("The instruction set \"" + std::string(name) + "\" " +
              (known ? "is not in this program, or cannot run on this processor" : "is unknown") +
              "; the choices here are " + choices + ".");
}

Isa default_isa() {
  const char* forced = std::getenv("CRUMPLE_ISA");
  return forced != nullptr && *forced != '\0' ? parse_isa(forced) : available_isas().back();
}

}  // namespace crumple
