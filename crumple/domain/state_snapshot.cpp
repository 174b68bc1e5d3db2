// SPDX-License-Identifier: BSD-3-Clause
#include "domain/state_snapshot.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace crumple::domain {

namespace {

void fill(const StateArray& to, const std::vector<std::byte>& bytes) {
  const std::span<std::byte> place = to.resize ? to.resize(bytes.size()) : to.bytes;
  std::copy_n(bytes.begin(), std::min(place.size(), bytes.size()), place.begin());
}

/// A list that has its length by the model keeps it.
bool may_take(const StateArray& to, std::size_t bytes) {
  return to.bytes.size() == bytes || (to.resize && to.bytes.empty());
}

}  // namespace

void StateSnapshot::take(const StateList& list) {
  arrays_.resize(list.arrays().size());
  for (std::size_t i = 0; i < arrays_.size(); ++i) {
    const StateArray& from = list.arrays()[i];
    arrays_[i].name = from.name;
    arrays_[i].bytes.assign(from.bytes.begin(), from.bytes.end());
  }
}

void StateSnapshot::put_back(const StateList& list) const {
  if (list.arrays().size() != arrays_.size())
    throw Error("A state of " + std::to_string(arrays_.size()) +
                " arrays does not fit this model, which has " + std::to_string(list.arrays().size()) + ".");
  for (std::size_t i = 0; i < arrays_.size(); ++i) {
    const StateArray& to = list.arrays()[i];
    if (to.name != arrays_[i].name || (!to.resize && to.bytes.size() != arrays_[i].bytes.size()))
      throw Error("A state does not fit this model: " + arrays_[i].name + " of " +
                  std::to_string(arrays_[i].bytes.size()) + " bytes where " + to.name + " of " +
                  std::to_string(to.bytes.size()) + " is expected.");
  }
  for (std::size_t i = 0; i < arrays_.size(); ++i) fill(list.arrays()[i], arrays_[i].bytes);
}

void StateSnapshot::put_back_known(const StateList& list) const {
  for (const StateArray& to : list.arrays())
    for (const Array& from : arrays_)
      if (from.name == to.name && may_take(to, from.bytes.size())) fill(to, from.bytes);
}

}  // namespace crumple::domain
