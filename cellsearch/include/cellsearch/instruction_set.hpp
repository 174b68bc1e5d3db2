// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace cellsearch {

/// Instruction sets for which the production method has loops of its own. The results are the same.
enum class InstructionSet {
  Portable,  ///< "portable": standard C++, any processor
  Avx2,      ///< "avx2": x86 with AVX2, FMA and BMI
  Avx512,    ///< "avx512": x86 with AVX-512 F, BW, DQ and VL
};

/// Those that the library has been compiled with and this processor has, the fastest last.
std::vector<InstructionSet> instruction_sets();

/// The name, as users write it.
std::string_view name_of(InstructionSet set);

/// The instruction set of that name, whether or not this processor has it, or nothing.
std::optional<InstructionSet> instruction_set_named(std::string_view name);

}  // namespace cellsearch
