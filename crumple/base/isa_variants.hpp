// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One text of a kernel, one machine code per instruction set. CMake compiles <layer>/kernels/*.cpp once per
// variant (crumple_add_isa_variants in cmake/layers.cmake); there `compiled_isa` names the variant, and the
// text specialises a function template for it:
//
//     template <Isa Variant>
//     Kernel kernel();                                     // declared in a header, for all variants
//
//     template <>
//     Kernel kernel<compiled_isa>() { return &work; }      // defined in kernels/work.cpp
//
// Everything else picks a variant at run time, once per call of a kernel and never within its loops:
//
//     Kernel kernel(Isa isa) {
//       return visit_isa(isa, []<Isa Variant>() { return kernel<Variant>(); });
//     }
//
// CRUMPLE_FAST_KERNELS says whether the build has AVX2 and AVX-512: builds with sanitizers, with
// CRUMPLE_PLAIN_KERNELS and for other processors have not. Targets that include this header define it.

#include "base/isa.hpp"

namespace crumple {

#if defined(CRUMPLE_ISA)
namespace isa_as_built {
// As the build spells them.
[[maybe_unused]] constexpr Isa scalar = Isa::Scalar;
[[maybe_unused]] constexpr Isa baseline = Isa::Baseline;
[[maybe_unused]] constexpr Isa avx2 = Isa::Avx2;
[[maybe_unused]] constexpr Isa avx512 = Isa::Avx512;
}  // namespace isa_as_built

/// The variant for which this file is being compiled. Not inline: it differs from object to object.
[[maybe_unused]] constexpr Isa compiled_isa = isa_as_built::CRUMPLE_ISA;
#endif

/// Returns visit.operator()<isa>(). A variant that the build lacks falls back to the baseline, which every
/// processor of the target runs.
template <class Visit>
auto visit_isa(Isa isa, const Visit& visit) {
  switch (isa) {
#if defined(CRUMPLE_FAST_KERNELS)
    case Isa::Avx512:
      return visit.template operator()<Isa::Avx512>();
    case Isa::Avx2:
      return visit.template operator()<Isa::Avx2>();
#endif
    case Isa::Scalar:
      return visit.template operator()<Isa::Scalar>();
    default:
      return visit.template operator()<Isa::Baseline>();
  }
}

}  // namespace crumple
