// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
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
  /// Gives the array another number of bytes and tells where they are; empty if its length never changes.
  std::function<std::span<std::byte>(std::size_t)> resize;
  bool in_hash = true;  ///< false: a count or a by-product, which a restart needs all the same
};

/// Every array that changes, each declared once by its owner. Made anew on request: the spans hold until
/// the next step.
class StateList {
 public:
  template <class T>
  void add(const std::string& name, const std::string& unit, Entity entity, int components,
           std::span<T> values) {
    arrays_.push_back({name, unit, entity, components, std::as_writable_bytes(values), {}, true});
  }

  /// The same for a list whose length changes during the run.
  template <class List>
  void add_list(const std::string& name, const std::string& unit, Entity entity, int components,
                List& values) {
    add(name, unit, entity, components, std::span(values));
    arrays_.back().resize = [&values](std::size_t bytes) {
      values.resize(bytes / sizeof(values[0]));
      return std::as_writable_bytes(std::span(values));
    };
  }

  /// One number or struct that a run can be taken up from, but that tells nothing new about the state: it is
  /// no part of the fingerprint.
  template <class T>
  void keep(const std::string& name, const std::string& unit, Entity entity, T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(name, unit, entity, 1, std::span(&value, 1));
    arrays_.back().in_hash = false;
  }

  /// The same for a list, whose length may change.
  template <class List>
  void keep_list(const std::string& name, const std::string& unit, Entity entity, int components,
                 List& values) {
    add_list(name, unit, entity, components, values);
    arrays_.back().in_hash = false;
  }

  const std::vector<StateArray>& arrays() const { return arrays_; }

  /// Fingerprint of all arrays in the order of their declaration, but of those that are only kept.
  std::uint64_t hash() const;

 private:
  std::vector<StateArray> arrays_;
};

}  // namespace crumple::domain
