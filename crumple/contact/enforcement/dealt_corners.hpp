// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "contact/enforcement/touch.hpp"

namespace crumple::contact {

/// Deals the corners of touches (a touch and one of its nodes) out to threads, so that these can add what
/// touches do to nodes without meeting. Each share has a range of places of its own, with about as many
/// corners as the others, and gets its corners in the order of the touches: the sum at a place has the same
/// bits for any number of shares. It is a counting sort by ranges of places in which each thread counts and
/// sorts a stretch of the touches.
class DealtCorners {
 public:
  /// Deals out the corners of the touches for which acts(touch) is true. `places`: of the surface.
  template <class Acts>
  void deal(std::span<const Touch> touches, Index places, int threads, const Acts& acts) {
    begin(touches, places, threads);
    if (shares_ == 1) return;
    parallel_for(shares_, shares_, [&](Index part) {
      std::uint32_t* const counts = counts_of(part);
      for_each_of(part, [&](std::size_t t) {
        if (!acts(touches[t])) return;
        for (int k = 0; k < touches[t].nodes; ++k) ++counts[bin_of(touches[t].place[k])];
      });
    });
    place_bins();
    parallel_for(shares_, shares_, [&](Index part) {
      std::uint32_t* const next = counts_of(part);
      for_each_of(part, [&](std::size_t t) {
        if (!acts(touches[t])) return;
        for (int k = 0; k < touches[t].nodes; ++k)
          corners_[next[bin_of(touches[t].place[k])]++] =
              static_cast<std::uint32_t>(t) * Touch::most_nodes + static_cast<std::uint32_t>(k);
      });
    });
  }

  /// Shares of the last call, and the first place of one; that of `shares()` is the number of places.
  Index shares() const { return shares_; }
  Index first_place(Index share) const { return first_place_[share]; }

  /// Calls fetch(place) for what is soon needed, and add(touch, corner) for all corners of a share in the
  /// order of the touches. One share alone has all touches, those that do not act as well.
  template <class Prefetch, class Add>
  void for_each(Index share, std::span<const Touch> touches, const Prefetch& fetch, const Add& add) const {
    constexpr std::size_t ahead = 8;
    if (shares_ == 1) {
      for (std::size_t t = 0; t < touches.size(); ++t) {
        if (t + ahead < touches.size())
          for (int k = 0; k < touches[t + ahead].nodes; ++k) fetch(touches[t + ahead].place[k]);
        for (int k = 0; k < touches[t].nodes; ++k) add(touches[t], k);
      }
      return;
    }
    constexpr std::size_t corners_ahead = 4 * ahead;
    const auto own =
        std::span(corners_).subspan(first_corner_[share], first_corner_[share + 1] - first_corner_[share]);
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (i + 2 * corners_ahead < own.size())
        prefetch<false>(&touches[own[i + 2 * corners_ahead] / Touch::most_nodes], 1);
      if (i + corners_ahead < own.size()) {
        const std::uint32_t later = own[i + corners_ahead];
        fetch(touches[later / Touch::most_nodes].place[later % Touch::most_nodes]);
      }
      add(touches[own[i] / Touch::most_nodes], static_cast<int>(own[i] % Touch::most_nodes));
    }
  }

 private:
  static constexpr Index bins = 256;

  void begin(std::span<const Touch> touches, Index places, int threads);
  void place_bins();
  template <class Visit>
  void for_each_of(Index part, const Visit& visit) const {
    const std::size_t size = touches_ / static_cast<std::size_t>(shares_) + 1;
    const std::size_t first = size * static_cast<std::size_t>(part);
    for (std::size_t t = first; t < std::min(first + size, touches_); ++t) visit(t);
  }
  Index bin_of(Index place) const { return place / places_in_bin_; }
  std::uint32_t* counts_of(Index part) { return &counts_[static_cast<std::size_t>(part) * bins]; }

  std::size_t touches_ = 0;
  Index shares_ = 1;  ///< as many as parts of the touches
  Index places_in_bin_ = 1;
  std::vector<std::uint32_t> counts_;        ///< by part and bin; then where the next corner goes
  std::vector<std::uint32_t> corners_;       ///< touch times most_nodes, plus corner
  std::vector<std::uint32_t> first_corner_;  ///< by share
  std::vector<Index> first_place_;           ///< by share
};

}  // namespace crumple::contact
