// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "finder.hpp"

namespace cellsearch {

/// A small scene written down in a test, with the memory that a FinderInput views, for tests that look inside
/// a method. Every segment may be a point: its four nodes are then the same.
struct FinderScene {
  std::vector<double> positions;
  std::vector<Index> connectivity;
  double expansion = 0.0;

  /// What a method builds from, with cells of `edge` [length] wanted.
  FinderInput input(double edge) const {
    Scene scene;
    scene.positions = Positions(positions);
    scene.segments = Segments(connectivity);
    scene.expansion = expansion;
    FinderInput result{scene, CandidateTest(scene, nullptr, 0.0), CellGrid(), std::nullopt, 1};
    result.cell_edge = edge;
    return result;
  }
};

/// The rows of all segments, one after another, and the visits that they took.
struct FinderRows {
  std::vector<Index> nodes;
  std::vector<Offset> ends;
  Offset raw_visits = 0;
  Offset cell_visits = 0;

  FinderRows(const Finder& finder, const FinderScene& scene) {
    const Index segments = static_cast<Index>(scene.connectivity.size() / 4);
    ends.resize(static_cast<std::size_t>(segments));
    Array<Index> found;
    FoundRows rows{ends.data(), &found};
    finder.query(0, segments, rows);
    nodes.assign(found.begin(), found.end());
    raw_visits = rows.raw_visits;
    cell_visits = rows.cell_visits;
  }
};

}  // namespace cellsearch
