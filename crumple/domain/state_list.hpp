// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/index.hpp"

namespace crumple::domain {

enum class Entity { Node, Shell, Solid, Beam, Discrete, Contact, Wall, RigidBody, Run };

/// One array that changes during a run: what hash, restart, output and transfer to other memories go by.
struct StateArray {
  std::string name;
  std::string unit;  ///< dimension, in words
  Entity entity = Entity::Node;
  int components = 1;          ///< numbers per item
  std::span<std::byte> bytes;  ///< owned by whoever declared it
};

/// Every array that changes, each declared once by its owner. Made anew on request: the spans hold until
/// the next step.
class StateList {
 public:
  template <class T>
  void add(const std::string& name, const std::string& unit, Entity entity, int components,
           std::span<T> values) {
    arrays_.push_back({name, unit, entity, components, std::as_writable_bytes(values)});
  }
  const std::vector<StateArray>& arrays() const { return arrays_; }

  /// Fingerprint of all arrays in the order of their declaration.
  std::uint64_t hash() const;

 private:
  std::vector<StateArray> arrays_;
};

}  // namespace crumple::domain
