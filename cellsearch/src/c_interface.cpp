// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/cellsearch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "c_handle.hpp"
#include "cellsearch/search_interval.hpp"
#include "cellsearch/verify.hpp"

#ifndef CELLSEARCH_VERSION
#error "The build system defines CELLSEARCH_VERSION."
#endif

using cellsearch::Index;
using cellsearch::c_interface::demand;
using cellsearch::c_interface::guarded;
using cellsearch::c_interface::Handle;
using cellsearch::c_interface::largest_count;

namespace {

/// Ends a walk over the candidates.
struct Stop {};

/// The same for a call that changes what the next build looks at.
template <class Call>
int32_t changed(cellsearch_handle* handle, const Call& call) noexcept {
  return guarded(handle, [&](Handle& own) {
    call(own);
    own.built = false;
  });
}

/// `count` numbers in the caller's memory, or none at all.
template <class Number>
std::span<const Number> view(const Number* numbers, std::size_t count) {
  if (numbers == nullptr) return {};
  return {numbers, count};
}

cellsearch::Positions positions_of(int64_t nodes, const double* xyz, int64_t stride) {
  demand(nodes >= 0 && (xyz != nullptr || nodes == 0), CELLSEARCH_BAD_ARGUMENT,
         "The array of x, y, z is null or the number of nodes is negative.");
  demand(nodes <= largest_count, CELLSEARCH_BAD_LAYOUT, "There are more than 2147483647 nodes.");
  demand(stride >= 3 && stride <= largest_count, CELLSEARCH_BAD_LAYOUT,
         "The stride must be from 3 to 2147483647.");
  const int64_t values = nodes == 0 ? 0 : (nodes - 1) * stride + 3;
  return {view(xyz, static_cast<std::size_t>(values)), static_cast<std::size_t>(stride)};
}

}  // namespace

extern "C" {

cellsearch_handle* cellsearch_create(void) {
  try {
    return new cellsearch_handle;
  } catch (...) {
    return nullptr;
  }
}

void cellsearch_destroy(cellsearch_handle* handle) {
  delete handle;
}

const char* cellsearch_version(void) {
  return CELLSEARCH_VERSION;
}

int32_t cellsearch_error_code(const cellsearch_handle* handle) {
  return handle == nullptr ? CELLSEARCH_BAD_ARGUMENT : handle->status;
}

const char* cellsearch_error_message(const cellsearch_handle* handle) {
  return handle == nullptr ? "The handle is null." : handle->message.data();
}

int64_t cellsearch_error_index(const cellsearch_handle* handle) {
  return handle == nullptr ? -1 : handle->error_index;
}

int32_t cellsearch_set_index_base(cellsearch_handle* handle, int32_t base) {
  return changed(handle, [&](Handle& own) {
    demand(base == 0 || base == 1, CELLSEARCH_BAD_SETTING, "The index base must be 0 or 1.");
    own.base = base;
  });
}

int32_t cellsearch_set_method(cellsearch_handle* handle, const char* name) {
  return changed(handle, [&](Handle& own) {
    demand(name != nullptr, CELLSEARCH_BAD_ARGUMENT, "The name of the method is null.");
    const std::optional<cellsearch::Method> method = cellsearch::method_named(name);
    if (!method) {
      std::string message = "There is no such search method; there are";
      for (const cellsearch::Method known : cellsearch::methods()) {
        message.append(" ").append(cellsearch::name_of(known));
      }
      throw cellsearch::Error(cellsearch::ErrorKind::BadSetting, -1, message + ".");
    }
    cellsearch::Settings wanted = own.settings;
    wanted.method = *method;
    own.apply(wanted);
  });
}

int32_t cellsearch_method_count(void) {
  return static_cast<int32_t>(cellsearch::methods().size());
}

const char* cellsearch_method_name(int32_t number) {
  if (number < 0 || number >= cellsearch_method_count()) return nullptr;
  // The names are literals, so a null follows.
  return cellsearch::name_of(cellsearch::methods()[static_cast<std::size_t>(number)]).data();
}

int32_t cellsearch_set_threads(cellsearch_handle* handle, int32_t threads) {
  return changed(handle, [&](Handle& own) {
    cellsearch::Settings wanted = own.settings;
    wanted.threads = threads;
    own.apply(wanted);
  });
}

int32_t cellsearch_set_cell_edge(cellsearch_handle* handle, double edge) {
  return changed(handle, [&](Handle& own) {
    cellsearch::Settings wanted = own.settings;
    wanted.cell_edge = edge == 0.0 ? std::nullopt : std::optional<double>(edge);
    own.apply(wanted);
  });
}

int32_t cellsearch_set_instruction_set(cellsearch_handle* handle, const char* name) {
  return changed(handle, [&](Handle& own) {
    demand(name != nullptr, CELLSEARCH_BAD_ARGUMENT, "The name of the instruction set is null.");
    cellsearch::Settings wanted = own.settings;
    wanted.instruction_set = cellsearch::instruction_set_named(name);
    if (!wanted.instruction_set && *name != '\0') {
      throw cellsearch::Error(cellsearch::ErrorKind::BadSetting, -1,
                              "There is no such instruction set; there are portable, avx2 and avx512.");
    }
    own.apply(wanted);
  });
}

int32_t cellsearch_set_cell_factor(cellsearch_handle* handle, double factor) {
  return changed(handle, [&](Handle& own) {
    cellsearch::Settings wanted = own.settings;
    wanted.cell_factor = factor;
    own.apply(wanted);
  });
}

int32_t cellsearch_set_cells_per_node(cellsearch_handle* handle, double cells) {
  return changed(handle, [&](Handle& own) {
    cellsearch::Settings wanted = own.settings;
    wanted.cells_per_node = cells;
    own.apply(wanted);
  });
}

int32_t cellsearch_set_domain(cellsearch_handle* handle, const double* minimum, const double* maximum,
                              const int32_t* cells) {
  return changed(handle, [&](Handle& own) {
    const bool all = minimum != nullptr && maximum != nullptr && cells != nullptr;
    const bool none = minimum == nullptr && maximum == nullptr && cells == nullptr;
    demand(all || none, CELLSEARCH_BAD_ARGUMENT, "Either all three arrays of a domain or none must be null.");
    cellsearch::Settings wanted = own.settings;
    wanted.domain.reset();
    if (all) {
      wanted.domain.emplace();
      std::copy_n(minimum, 3, wanted.domain->box.lo.begin());
      std::copy_n(maximum, 3, wanted.domain->box.hi.begin());
      std::copy_n(cells, 3, wanted.domain->cells.begin());
    }
    own.apply(wanted);
  });
}

int32_t cellsearch_set_positions(cellsearch_handle* handle, int64_t nodes, const double* xyz,
                                 int64_t stride) {
  return changed(handle, [&](Handle& own) { own.scene.positions = positions_of(nodes, xyz, stride); });
}

int32_t cellsearch_set_segments(cellsearch_handle* handle, int64_t segments, const int32_t* nodes) {
  return changed(handle, [&](Handle& own) {
    demand(segments >= 0 && (nodes != nullptr || segments == 0), CELLSEARCH_BAD_ARGUMENT,
           "The connectivity is null or the number of segments is negative.");
    demand(segments <= largest_count, CELLSEARCH_BAD_LAYOUT, "There are more than 2147483647 segments.");
    own.scene.segments = cellsearch::Segments(view(nodes, 4 * static_cast<std::size_t>(segments)));
  });
}

int32_t cellsearch_set_expansion(cellsearch_handle* handle, double expansion) {
  return changed(handle, [&](Handle& own) { own.scene.expansion = expansion; });
}

int32_t cellsearch_set_segment_expansion(cellsearch_handle* handle, const double* expansion) {
  return changed(handle, [&](Handle& own) {
    own.scene.segment_expansion = view(expansion, own.scene.segments.count());
  });
}

int32_t cellsearch_set_nodes(cellsearch_handle* handle, int64_t count, const int32_t* nodes) {
  return changed(handle, [&](Handle& own) {
    demand(count >= 0 && count <= largest_count, CELLSEARCH_BAD_ARGUMENT,
           "The length of the list of nodes is wrong.");
    own.scene.nodes.reset();
    if (nodes != nullptr) own.scene.nodes = view(nodes, static_cast<std::size_t>(count));
  });
}

int32_t cellsearch_set_node_radius(cellsearch_handle* handle, const double* radius) {
  return changed(handle,
                 [&](Handle& own) { own.scene.node_radius = view(radius, own.scene.positions.count()); });
}

int32_t cellsearch_set_active(cellsearch_handle* handle, const uint8_t* active) {
  return changed(handle,
                 [&](Handle& own) { own.scene.segment_active = view(active, own.scene.segments.count()); });
}

int32_t cellsearch_set_exclude_neighbours(cellsearch_handle* handle, int32_t exclude) {
  return changed(handle, [&](Handle& own) { own.scene.exclude_neighbours = exclude != 0; });
}

int32_t cellsearch_set_groups(cellsearch_handle* handle, int32_t groups, const int32_t* node_group,
                              const int32_t* segment_group, const uint8_t* allow) {
  return changed(handle, [&](Handle& own) {
    demand(groups >= 0, CELLSEARCH_BAD_ARGUMENT, "The number of groups is negative.");
    demand(groups == 0 || (node_group != nullptr && segment_group != nullptr && allow != nullptr),
           CELLSEARCH_BAD_ARGUMENT, "An array of the groups is null.");
    own.scene.groups = cellsearch::Groups{};
    if (groups == 0) return;
    const std::size_t count = static_cast<std::size_t>(groups);
    own.scene.groups.count = groups;
    own.scene.groups.node_group = view(node_group, own.scene.positions.count());
    own.scene.groups.segment_group = view(segment_group, own.scene.segments.count());
    own.scene.groups.allow = view(allow, count * count);
  });
}

int32_t cellsearch_build(cellsearch_handle* handle) {
  return guarded(handle, [](Handle& own) { own.build(); });
}

int32_t cellsearch_query(cellsearch_handle* handle, const int64_t** first, const int32_t** node,
                         int64_t* pairs) {
  return guarded(handle, [&](Handle& own) { own.query(first, node, pairs); });
}

int32_t cellsearch_find(cellsearch_handle* handle, const int64_t** first, const int32_t** node,
                        int64_t* pairs) {
  return guarded(handle, [&](Handle& own) {
    own.build();
    own.query(first, node, pairs);
  });
}

int32_t cellsearch_visit(cellsearch_handle* handle, cellsearch_visitor* visitor, void* data) {
  return guarded(handle, [&](Handle& own) {
    demand(visitor != nullptr, CELLSEARCH_BAD_ARGUMENT, "The visitor is null.");
    own.demand_build();
    try {
      own.search.visit([&](Index segment, Index node) {
        if (visitor(segment + own.base, node + own.base, data) != 0) throw Stop{};
      });
    } catch (const Stop&) {
      return;  // the caller has seen enough
    }
  });
}

int32_t cellsearch_statistics(cellsearch_handle* handle, cellsearch_counts* counts) {
  return guarded(handle, [&](Handle& own) {
    demand(counts != nullptr, CELLSEARCH_BAD_ARGUMENT, "The place for the counts is null.");
    own.demand_build();
    const cellsearch::Statistics& done = own.search.statistics();
    *counts = {done.segments, done.participants, done.nodes_in_domain, done.cells,
               done.bytes,    done.cell_visits,  done.raw_visits,      done.candidates};
  });
}

int32_t cellsearch_verify(cellsearch_handle* handle, int64_t* segment, int64_t* node) {
  return guarded(handle, [&](Handle& own) {
    demand(segment != nullptr && node != nullptr, CELLSEARCH_BAD_ARGUMENT, "A place for the pair is null.");
    own.demand_build();
    const auto difference = cellsearch::verify(own.search.query(), own.search.scene(), own.settings);
    *segment = own.base + int64_t{difference ? difference->segment : -1};
    *node = own.base + int64_t{difference ? difference->node : -1};
  });
}

int32_t cellsearch_motion_start(cellsearch_handle* handle, double expansion, double contact_distance) {
  return guarded(handle, [&](Handle& own) { own.start_tracker(expansion, contact_distance); });
}

int32_t cellsearch_motion_update(cellsearch_handle* handle, double* used, double* left, int32_t* due) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (used != nullptr) *used = infinity;
  if (left != nullptr) *left = -infinity;
  if (due != nullptr) *due = 1;
  return guarded(handle, [&](Handle& own) {
    if (!own.tracker) return;
    own.tracker->update(own.scene.positions);
    if (used != nullptr) *used = own.tracker->used();
    if (left != nullptr) *left = own.tracker->left();
    if (due != nullptr) *due = own.tracker->due() ? 1 : 0;
  });
}

int32_t cellsearch_motion_steps(cellsearch_handle* handle, const double* velocities, int64_t stride,
                                double largest_step, int32_t cap, int32_t* steps) {
  if (steps != nullptr) *steps = 1;
  return guarded(handle, [&](Handle& own) {
    demand(steps != nullptr && velocities != nullptr, CELLSEARCH_BAD_ARGUMENT,
           "The velocities or the place for the steps are null.");
    if (!own.tracker) return;
    const auto nodes = static_cast<int64_t>(own.scene.positions.count());
    *steps = own.tracker->predicted_steps(positions_of(nodes, velocities, stride), largest_step, cap);
  });
}

int32_t cellsearch_interval(double expansion, double contact_distance, double largest_speed,
                            double largest_step, int32_t cap) {
  return cellsearch::search_interval(expansion, contact_distance, largest_speed, largest_step, cap);
}

}  // extern "C"
