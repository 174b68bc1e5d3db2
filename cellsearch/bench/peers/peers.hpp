// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contestant.hpp"

/// The peers: other libraries that can answer the same question. Each has a file of its own, which is
/// compiled only where the library's package is installed.
namespace cellsearch::bench {

ContestantKind embree_contestant();
ContestantKind nanoflann_contestant();
ContestantKind fcl_contestant();
ContestantKind cgal_contestant();
ContestantKind bullet_contestant();

}  // namespace cellsearch::bench
