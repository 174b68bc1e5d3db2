// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unordered_map>

#include "base/index.hpp"

namespace crumple::deck {

/// From user ids to places in an array. Only looked up in, never walked through, so that the order of its
/// buckets cannot get into results.
class IdTable {
 public:
  void reserve(std::size_t count) { index_.reserve(count); }

  /// Enters an id. Returns no_index, or the index that already has this id.
  Index insert(UserId id, Index index) {
    const auto [entry, is_new] = index_.try_emplace(id, index);
    return is_new ? no_index : entry->second;
  }

  /// The index of an id, or no_index.
  Index find(UserId id) const {
    const auto entry = index_.find(id);
    return entry == index_.end() ? no_index : entry->second;
  }

 private:
  std::unordered_map<UserId, Index> index_;
};

}  // namespace crumple::deck
