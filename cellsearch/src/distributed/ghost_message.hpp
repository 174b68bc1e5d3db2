// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>

#include "cellsearch/array.hpp"
#include "cellsearch/distributed/distributed.hpp"

namespace cellsearch {

/// What stands at the beginning of a message of ghosts.
struct GhostHeader {
  std::int64_t segments = 0;
  std::int64_t nodes = 0;
};

/// Segments and their nodes on the way to another rank. In the message: the header, then per segment its
/// global number, and, where they differ, its expansion; per node its global number and position; per segment
/// its number at the owner, four places in the list of nodes and, where there are groups, its group. 8-byte
/// numbers come first, so that all stay aligned.
struct GhostMessage {
  Array<GlobalId> segment_id;
  Array<double> expansion;
  Array<Index> number;
  Array<Index> corner;
  Array<Index> group;
  Array<Index> node;  ///< own numbers of the nodes; stay here
  Array<GlobalId> node_id;
  Array<double> position;
  Array<std::byte> bytes;

  void clear() {
    for (Array<Index>* numbers : {&number, &corner, &group, &node}) numbers->clear();
    segment_id.clear();
    node_id.clear();
    expansion.clear();
    position.clear();
  }

  /// Writes all into `bytes`.
  void pack() {
    bytes.clear();
    const GhostHeader header{static_cast<std::int64_t>(segment_id.size()),
                             static_cast<std::int64_t>(node_id.size())};
    append(std::span(&header, 1));
    append(std::span<const GlobalId>(segment_id));
    append(std::span<const double>(expansion));
    append(std::span<const GlobalId>(node_id));
    append(std::span<const double>(position));
    append(std::span<const Index>(number));
    append(std::span<const Index>(corner));
    append(std::span<const Index>(group));
  }

 private:
  template <class Number>
  void append(std::span<const Number> numbers) {
    const std::span<const std::byte> more = std::as_bytes(numbers);
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
};

/// The same at its destination: views of the bytes.
struct GhostView {
  std::span<const GlobalId> segment_id;
  std::span<const double> expansion;
  std::span<const Index> number;
  std::span<const Index> corner;
  std::span<const Index> group;
  std::span<const GlobalId> node_id;
  std::span<const double> position;

  /// `bytes`: aligned to 8. Throws std::length_error if they are not what pack() writes.
  void read(std::span<const std::byte> bytes, bool expansions_differ, bool grouped) {
    GhostHeader header;
    if (bytes.size() < sizeof header) throw std::length_error("A message of ghosts has no header.");
    std::memcpy(&header, bytes.data(), sizeof header);
    const auto segments = static_cast<std::size_t>(header.segments);
    const auto nodes = static_cast<std::size_t>(header.nodes);
    std::size_t at = sizeof header;
    take(bytes, at, segments, segment_id);
    take(bytes, at, expansions_differ ? segments : 0, expansion);
    take(bytes, at, nodes, node_id);
    take(bytes, at, 3 * nodes, position);
    take(bytes, at, segments, number);
    take(bytes, at, 4 * segments, corner);
    take(bytes, at, grouped ? segments : 0, group);
    if (at != bytes.size()) throw std::length_error("A message of ghosts has another length than it says.");
  }

 private:
  template <class Number>
  static void take(std::span<const std::byte> bytes, std::size_t& at, std::size_t count,
                   std::span<const Number>& numbers) {
    if (count > (bytes.size() - at) / sizeof(Number))
      throw std::length_error("A message of ghosts is too short.");
    numbers = {reinterpret_cast<const Number*>(bytes.data() + at), count};
    at += count * sizeof(Number);
  }
};

}  // namespace cellsearch
