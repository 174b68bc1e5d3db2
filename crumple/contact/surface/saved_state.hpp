// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/error.hpp"
#include "base/index.hpp"

namespace crumple::contact {

/// Throws Error unless `fits`. What a restart file says of a contact is checked once when it has been read,
/// as a wrong index would be used without further question: a checksum shows damage, not intent.
inline void require_saved(bool fits, const std::string& what) {
  if (!fits) throw Error("The state of a contact is damaged: " + what + " do not fit the model.");
}

/// The same of all items of a list.
template <class List, class Fits>
void require_all_saved(const List& list, const Fits& fits, const std::string& what) {
  require_saved(std::all_of(list.begin(), list.end(), fits), what);
}

/// Whether an index is one of so many items.
inline bool is_one_of(Index index, std::size_t items) {
  return index >= 0 && static_cast<std::size_t>(index) < items;
}

}  // namespace crumple::contact
