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
// The build has the variants whose CRUMPLE_HAS_<name> is defined, which it is for isa.cpp and the sources
// that include this header: see CRUMPLE_KERNELS in CMakeLists.txt.

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

/// Returns visit.operator()<isa>(). A variant that the build lacks falls back to the scalar one, which it
/// always has.
template <class Visit>
auto visit_isa(Isa isa, const Visit& visit) {
  switch (isa) {
#if defined(CRUMPLE_HAS_avx512)
    case Isa::Avx512:
      return visit.template operator()<Isa::Avx512>();
#endif
#if defined(CRUMPLE_HAS_avx2)
    case Isa::Avx2:
      return visit.template operator()<Isa::Avx2>();
#endif
#if defined(CRUMPLE_HAS_baseline)
    case Isa::Baseline:
      return visit.template operator()<Isa::Baseline>();
#endif
    default:
      return visit.template operator()<Isa::Scalar>();
  }
}

}  // namespace crumple
