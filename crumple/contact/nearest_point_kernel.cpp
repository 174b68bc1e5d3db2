// SPDX-License-Identifier: BSD-3-Clause
#include "contact/nearest_point_kernel.hpp"

namespace crumple::contact {

NearestPointKernel nearest_point_kernel(Isa isa) {
  switch (isa) {
#if defined(CRUMPLE_FAST_KERNELS)
    case Isa::Avx512:
      return nearest_point_kernel<Isa::Avx512>();
    case Isa::Avx2:
      return nearest_point_kernel<Isa::Avx2>();
#endif
    case Isa::Scalar:
      return &nearest_point;
    default:
      return nearest_point_kernel<Isa::Baseline>();
  }
}

}  // namespace crumple::contact
