// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "domain/state_list.hpp"

namespace crumple::domain {

/// A copy of everything in a state list, to go back to, or to give to another simulation of the same model.
class StateSnapshot {
 public:
  /// An array of the list, by name, with its bytes.
  struct Array {
    std::string name;
    std::vector<std::byte> bytes;
  };

  StateSnapshot() = default;
  explicit StateSnapshot(const StateList& list) { take(list); }
  explicit StateSnapshot(std::vector<Array> arrays) : arrays_(std::move(arrays)) {}

  /// Copies all arrays; re-uses memory.
  void take(const StateList& list);
  /// Fills the arrays of `list` with the copies. Throws Error, and changes nothing, if the list has other
  /// arrays: it is of another model, or of another version of the program.
  void put_back(const StateList& list) const;
  /// Fills those arrays of `list` that are known by name and have the same length; the others stay as they
  /// are.
  void put_back_known(const StateList& list) const;

  const std::vector<Array>& arrays() const { return arrays_; }
  bool empty() const { return arrays_.empty(); }

 private:
  std::vector<Array> arrays_;
};

}  // namespace crumple::domain
