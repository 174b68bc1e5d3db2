// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace cellsearch {

/// How candidates are found. All methods give the same pairs in the same order; see docs/methods.md.
enum class Method {
  LinkedCell,    ///< "linked-cell": cells and linked lists as printed in the paper; O(N) for similar sizes
  BucketSort,    ///< "bucket-sort": buckets nested in x, y, z, the conventional method of DYNA3D
  PositionCode,  ///< "position-code": sorted cell numbers and binary search, O(N log N)
  Nbs,           ///< "nbs": no binary search, bodies of similar size only: else Error(UnsuitedMethod)
  BruteForce,    ///< "brute-force": every node against every segment, O(N^2); the oracle
  Production,    ///< "production": the one to use: linear for any layout, and the fastest
};

/// All methods, in the order of the enumeration.
std::span<const Method> methods();

/// The method's name, as users write it.
std::string_view name_of(Method method);

/// The method of that name, or nothing.
std::optional<Method> method_named(std::string_view name);

}  // namespace cellsearch
