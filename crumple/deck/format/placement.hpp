// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/format/affine.hpp"
#include "deck/format/id_kind.hpp"

namespace crumple::deck {

/// What the ids and the coordinates of a file become in the deck: those of all *INCLUDE_TRANSFORM around it.
struct Placement {
  IdOffsets offsets{};
  Affine map;
  bool moves = false;  ///< `map` is not the identity

  /// Zero is no id; the sign of a negative one is a mark that stays.
  std::int64_t id(IdKind kind, std::int64_t written) const {
    constexpr std::int64_t largest = 4'000'000'000'000'000'000;
    const std::int64_t offset = offsets[static_cast<std::size_t>(kind)];
    if (written > largest || written < -largest) return written;  // the sum would have no room
    return written == 0 ? 0 : written < 0 ? written - offset : written + offset;
  }
};

}  // namespace crumple::deck
