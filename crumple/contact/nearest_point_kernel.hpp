// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/isa.hpp"
#include "contact/segment_shape.hpp"

namespace crumple::contact {

/// nearest_point() with all sub-triangles at once, compiled once per instruction set. Every variant gives the
/// bits of nearest_point().
using NearestPointKernel = NearestPoint (*)(const SegmentShape& shape, const Vec3& p);

/// Defined in kernels/nearest_point.cpp, once per instruction set.
template <Isa Variant>
NearestPointKernel nearest_point_kernel();

/// The kernel for an instruction set chosen at run time.
NearestPointKernel nearest_point_kernel(Isa isa);

}  // namespace crumple::contact
