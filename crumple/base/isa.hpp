// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crumple {

/// Variants in which every kernel is compiled. Scalar is the reference the others are tested against.
enum class Isa {
  Scalar,    ///< one element at a time, plain float or double
  Baseline,  ///< x86-64-v2 (or whatever the target's default is)
  Avx2,      ///< AVX2 with FMA; not in sanitizer builds
  Avx512,    ///< AVX-512 F, BW, CD, DQ, VL
};

/// Lower-case name, as the command line and run.json spell it: scalar, baseline, avx2, avx512.
std::string_view isa_name(Isa isa);

/// The variants that this processor can run, slowest first.
std::vector<Isa> available_isas();

/// The fastest variant of this processor, or the one that the environment variable CRUMPLE_ISA names.
/// Throws Error if that name is unknown or the processor lacks it.
Isa default_isa();

/// The variant of that name. Throws Error naming the choices if it is unknown or cannot run here.
Isa parse_isa(std::string_view name);

}  // namespace crumple
