// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "cellsearch/cellsearch.h"
#include "cellsearch/types.hpp"
#include "scenes.hpp"

namespace cellsearch {

/// Ends a handle that goes out of scope.
struct Destroy {
  void operator()(cellsearch_handle* handle) const { cellsearch_destroy(handle); }
};
using Handle = std::unique_ptr<cellsearch_handle, Destroy>;

/// The numbers in another way of counting.
inline std::vector<Index> shifted(std::span<const Index> numbers, Index base) {
  std::vector<Index> result(numbers.begin(), numbers.end());
  for (Index& number : result) number += base;
  return result;
}

/// A scene in the numbering of a C or Fortran program, with the handle that views it.
struct Program {
  Index base;
  std::vector<double> positions;
  std::size_t stride;
  std::vector<Index> segments;
  std::vector<Index> nodes;
  Handle handle{cellsearch_create()};

  Program(const scenes::Mesh& mesh, Index index_base)
      : base(index_base),
        positions(mesh.positions),
        stride(mesh.stride),
        segments(shifted(mesh.segments, base)) {
    cellsearch_handle* own = handle.get();
    EXPECT_EQ(cellsearch_set_index_base(own, base), CELLSEARCH_OK);
    const auto count = static_cast<int64_t>(mesh.node_count());
    EXPECT_EQ(cellsearch_set_positions(own, count, positions.data(), static_cast<int64_t>(stride)),
              CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_segments(own, static_cast<int64_t>(mesh.segment_count()), segments.data()),
              CELLSEARCH_OK);
    EXPECT_EQ(cellsearch_set_expansion(own, mesh.expansion), CELLSEARCH_OK);
    if (!mesh.segment_expansion.empty()) {
      EXPECT_EQ(cellsearch_set_segment_expansion(own, mesh.segment_expansion.data()), CELLSEARCH_OK);
    }
    if (mesh.nodes) {
      nodes = shifted(*mesh.nodes, base);
      nodes.reserve(1);  // an empty list still has an address
      EXPECT_EQ(cellsearch_set_nodes(own, static_cast<int64_t>(nodes.size()), nodes.data()), CELLSEARCH_OK);
    }
    if (mesh.domain) {
      EXPECT_EQ(cellsearch_set_domain(own, mesh.domain->box.lo.data(), mesh.domain->box.hi.data(),
                                      mesh.domain->cells.data()),
                CELLSEARCH_OK);
    }
  }
};

/// Two unit squares, one a quarter above the other, and c just that.
inline scenes::Mesh two_plates() {
  scenes::Mesh mesh;
  for (const double z : {0.0, 0.25}) {
    const Index first = mesh.add_node(0, 0, z);
    mesh.add_node(1, 0, z);
    mesh.add_node(1, 1, z);
    mesh.add_node(0, 1, z);
    mesh.add_segment(first, first + 1, first + 2, first + 3);
  }
  mesh.expansion = 0.25;
  return mesh;
}

}  // namespace cellsearch
