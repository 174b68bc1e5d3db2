// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/dealt_corners.hpp"

namespace crumple::contact {

void DealtCorners::begin(std::span<const Touch> touches, Index places, int threads) {
  // Fewer are faster added than dealt out.
  constexpr std::size_t least_touches = 256;
  touches_ = touches.size();
  shares_ = touches_ < least_touches ? 1 : std::max(1, threads);
  first_place_.assign(static_cast<std::size_t>(shares_) + 1, places);
  first_place_.front() = 0;
  if (shares_ == 1) return;
  places_in_bin_ = pieces(places, bins);
  counts_.assign(static_cast<std::size_t>(shares_) * bins, 0);
}

/// Bins follow one another, in each the corners of the parts; shares begin with the bin that fills the one
/// before.
void DealtCorners::place_bins() {
  std::uint32_t total = 0;
  for (const std::uint32_t count : counts_) total += count;
  corners_.resize(total);
  first_corner_.assign(first_place_.size(), total);
  std::uint32_t next = 0;
  Index share = 0;
  for (Index bin = 0; bin < bins; ++bin) {
    while (share < shares_ && next >= std::uint64_t{total} * static_cast<std::uint64_t>(share) /
                                          static_cast<std::uint64_t>(shares_)) {
      first_corner_[share] = next;
      first_place_[share] = std::min(bin * places_in_bin_, first_place_.back());
      ++share;
    }
    for (Index part = 0; part < shares_; ++part) {
      std::uint32_t& count = counts_of(part)[bin];
      const std::uint32_t first = next;
      next += count;
      count = first;
    }
  }
}

}  // namespace crumple::contact
