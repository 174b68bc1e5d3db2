// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace crumple::compare {

/// Pairs of samples (of the first and of the second curve) on the cheapest way through dynamic time warping:
/// each step goes on by one sample in the first curve, in the second, or in both, a pair costs the square of
/// its difference, and samples of a pair are less than `band` apart. Of equally cheap ways the one that
/// prefers, seen from the end, steps of the first curve, then of the second. Both curves have as many
/// samples, at least one.
std::vector<std::pair<std::size_t, std::size_t>> warping_path(std::span<const double> first,
                                                              std::span<const double> second,
                                                              std::size_t band);

}  // namespace crumple::compare
