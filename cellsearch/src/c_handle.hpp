// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <string>

#include "cellsearch/array.hpp"
#include "cellsearch/cellsearch.h"
#include "cellsearch/edge_pairs.hpp"
#include "cellsearch/error.hpp"
#include "cellsearch/motion_tracker.hpp"
#include "cellsearch/nearest_nodes.hpp"
#include "cellsearch/search.hpp"
#include "cellsearch/segment_pairs.hpp"
#include "parallel.hpp"

namespace cellsearch::c_interface {

inline constexpr std::int64_t largest_count = std::numeric_limits<Index>::max();

/// What this interface refuses by itself.
struct Refusal {
  std::int32_t status;
  const char* message;
};

inline void demand(bool fulfilled, std::int32_t status, const char* message) {
  if (!fulfilled) throw Refusal{status, message};
}

/// Adds `shift` to every number. Bad input must not become good by running over.
template <class Number>
void copy_shifted(std::span<const Number> from, Number shift, int threads, Array<Number>& to) {
  to.resize(from.size());
  constexpr int blocks = 64;
  const auto size = static_cast<std::size_t>(blocks);
  for_blocks(threads, blocks, [&](int block) {
    const std::size_t begin = from.size() * static_cast<std::size_t>(block) / size;
    const std::size_t end = from.size() * (static_cast<std::size_t>(block) + 1) / size;
    for (std::size_t place = begin; place < end; ++place) {
      const Number number = from[place];
      to[place] = number == std::numeric_limits<Number>::min() ? number : number + shift;
    }
  });
}

inline std::int32_t status_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::BadLayout:
      return CELLSEARCH_BAD_LAYOUT;
    case ErrorKind::EmptyInput:
      return CELLSEARCH_EMPTY_INPUT;
    case ErrorKind::NonFiniteCoordinate:
      return CELLSEARCH_NON_FINITE_COORDINATE;
    case ErrorKind::BadConnectivity:
      return CELLSEARCH_BAD_CONNECTIVITY;
    case ErrorKind::BadExpansion:
      return CELLSEARCH_BAD_EXPANSION;
    case ErrorKind::BadRadius:
      return CELLSEARCH_BAD_RADIUS;
    case ErrorKind::BadNodeGroup:
      return CELLSEARCH_BAD_NODE_GROUP;
    case ErrorKind::BadSegmentGroup:
      return CELLSEARCH_BAD_SEGMENT_GROUP;
    case ErrorKind::BadNodeList:
      return CELLSEARCH_BAD_NODE_LIST;
    case ErrorKind::BadDomain:
      return CELLSEARCH_BAD_DOMAIN;
    case ErrorKind::BadSetting:
      return CELLSEARCH_BAD_SETTING;
    case ErrorKind::UnsuitedMethod:
      return CELLSEARCH_UNSUITED_METHOD;
    case ErrorKind::BadNodeId:
      return CELLSEARCH_BAD_NODE_ID;
    case ErrorKind::BadSegmentId:
      return CELLSEARCH_BAD_SEGMENT_ID;
  }
  return CELLSEARCH_INTERNAL_ERROR;
}

/// The library counts from 0; the same sentence for callers who count from 1. Empty where no number is said.
inline std::string message_from_one(std::int32_t status, const std::string& number) {
  switch (status) {
    case CELLSEARCH_NON_FINITE_COORDINATE:
      return "Node " + number + " has a coordinate that is not finite.";
    case CELLSEARCH_BAD_CONNECTIVITY:
      return "Segment " + number + " names a node that does not exist; nodes are numbered from 1.";
    case CELLSEARCH_BAD_EXPANSION:
      return "The expansion of segment " + number + " is negative or not finite.";
    case CELLSEARCH_BAD_NODE_LIST:
      return "Entry " + number + " of the list of nodes is out of range or not above the one before.";
    case CELLSEARCH_BAD_RADIUS:
      return "The radius of node " + number + " is negative or not finite.";
    case CELLSEARCH_BAD_NODE_GROUP:
      return "The group of node " + number + " is out of range.";
    case CELLSEARCH_BAD_SEGMENT_GROUP:
      return "The group of segment " + number + " is out of range.";
    case CELLSEARCH_UNSUITED_METHOD:
      return "The method is not made for scenes like this: segment " + number + " is too large or too small.";
    case CELLSEARCH_BAD_NODE_ID:
      return "The global number of node " + number +
             " is negative or given twice, or its coordinates differ by rank.";
    case CELLSEARCH_BAD_SEGMENT_ID:
      return "The global number of segment " + number + " is negative or given twice.";
    default:
      return "";
  }
}

/// Rows as they are given out.
struct RowsView {
  const std::int64_t* first;
  const std::int32_t* entries;
  std::int64_t count;

  /// Each of the three places may be null.
  void give(const std::int64_t** rows, const std::int32_t** row_entries, std::int64_t* entry_count) const {
    if (rows != nullptr) *rows = first;
    if (row_entries != nullptr) *row_entries = entries;
    if (entry_count != nullptr) *entry_count = count;
  }
};

/// Rows that were given out in the caller's numbering; not used if that is from 0.
struct LentRows {
  Array<Offset> first;
  Array<Index> entries;

  RowsView lend(const Array<Offset>& found_first, const Array<Index>& found, Index base, int threads) {
    const auto count = static_cast<std::int64_t>(found.size());
    if (base == 0) return {found_first.data(), found.data(), count};
    copy_shifted<Offset>(found_first, base, threads, first);
    copy_shifted<Index>(found, base, threads, entries);
    return {first.data(), entries.data(), count};
  }
};

/// A search object of a further query, kept for its memory as long as its settings are the same.
template <class Kind>
struct Kept {
  std::optional<Kind> search;
  std::array<double, 4> key{};

  template <class Settings>
  Kind& with(const std::array<double, 4>& wanted, const Settings& settings) {
    if (!search || key != wanted) {
      search.emplace(settings);
      key = wanted;
    }
    return *search;
  }
};

/// What the queries beside the one of nodes and segments keep.
struct FurtherQueries {
  Kept<SegmentPairSearch> segment_search;
  LentRows segment_pairs;
  Array<Index> edges;       // from 0
  Array<Index> lent_edges;  // as the caller counts
  Kept<EdgePairSearch> edge_search;
  LentRows edge_pairs;
  Kept<NearestSearch> nearest_search;
  LentRows nearest;
};

/// A search with what the caller has set. The views are the caller's arrays in the caller's numbering.
struct Handle {
  Settings settings;
  Search search;
  std::optional<MotionTracker> tracker;
  double tracked_expansion = 0.0;
  double tracked_distance = 0.0;
  Scene scene;
  Index base = 0;
  bool built = false;

  // Node numbers from 0; not used if the caller counts from 0 as well.
  Array<Index> connectivity;
  Array<Index> nodes;
  Array<Index> node_group;
  Array<Index> segment_group;
  LentRows candidates;
  FurtherQueries further;

  std::int32_t status = CELLSEARCH_OK;
  std::int64_t error_index = -1;
  std::array<char, 512> message{};

  void set_error(std::int32_t code, std::int64_t index, const char* text) noexcept {
    status = code;
    error_index = index;
    const std::size_t length = std::min(std::strlen(text), message.size() - 1);
    std::memcpy(message.data(), text, length);
    message[length] = '\0';
  }

  void set_error(const Error& error) {
    const std::int32_t code = status_of(error.kind());
    const bool shifted = base != 0 && error.index() >= 0 && code != CELLSEARCH_BAD_DOMAIN;
    const std::int64_t index = std::int64_t{error.index()} + (shifted ? base : 0);
    const std::string own = shifted ? message_from_one(code, std::to_string(index)) : "";
    set_error(code, index, own.empty() ? error.what() : own.c_str());
  }

  /// A search with other settings. Those that cannot be followed throw, and the old ones stay.
  void apply(const Settings& wanted) {
    search = Search(wanted);
    settings = wanted;
    built = false;
  }

  std::span<const Index> from_zero(std::span<const Index> numbers, Array<Index>& copy) const {
    if (base == 0) return numbers;
    copy_shifted(numbers, -base, settings.threads, copy);
    return copy;
  }

  /// The scene with all numbers from 0.
  Scene scene_from_zero() {
    Scene from_0 = scene;
    from_0.segments = Segments(from_zero(scene.segments.nodes(), connectivity));
    if (scene.nodes) from_0.nodes = from_zero(*scene.nodes, nodes);
    from_0.groups.node_group = from_zero(scene.groups.node_group, node_group);
    from_0.groups.segment_group = from_zero(scene.groups.segment_group, segment_group);
    return from_0;
  }

  void build() {
    built = false;
    search.build(scene_from_zero());
    built = true;
  }

  void demand_build() const {
    demand(built, CELLSEARCH_NOT_BUILT, "There was no successful build since the last change.");
  }

  /// Keeps the memory of the tracker where it can.
  void start_tracker(double expansion, double contact_distance) {
    demand_build();
    if (!tracker || tracked_expansion != expansion || tracked_distance != contact_distance) {
      tracker.emplace(expansion, contact_distance, settings.threads);
      tracked_expansion = expansion;
      tracked_distance = contact_distance;
    }
    tracker->start(search.scene());
  }

  void query(const std::int64_t** rows, const std::int32_t** found_nodes, std::int64_t* pairs) {
    demand_build();
    const Candidates& found = search.query();
    candidates.lend(found.first, found.node, base, settings.threads).give(rows, found_nodes, pairs);
  }
};

}  // namespace cellsearch::c_interface

/// Behind the opaque pointer.
struct cellsearch_handle : cellsearch::c_interface::Handle {};

namespace cellsearch::c_interface {

/// Runs `call` and turns whatever it throws into the status of the handle: nothing gets out.
template <class Call>
std::int32_t guarded(cellsearch_handle* handle, const Call& call) noexcept {
  if (handle == nullptr) return CELLSEARCH_BAD_ARGUMENT;
  handle->set_error(CELLSEARCH_OK, -1, "");
  try {
    try {
      call(*handle);
    } catch (const Error& error) {
      handle->set_error(error);
    } catch (const Refusal& refusal) {
      handle->set_error(refusal.status, -1, refusal.message);
    }
  } catch (const std::bad_alloc&) {
    handle->set_error(CELLSEARCH_OUT_OF_MEMORY, -1, "Memory ran out.");
  } catch (const std::exception& error) {
    handle->set_error(CELLSEARCH_INTERNAL_ERROR, -1, error.what());
  } catch (...) {
    handle->set_error(CELLSEARCH_INTERNAL_ERROR, -1, "Something unknown was thrown.");
  }
  return handle->status;
}

}  // namespace cellsearch::c_interface
