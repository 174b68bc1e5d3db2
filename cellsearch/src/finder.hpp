// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "candidate_test.hpp"
#include "cellsearch/array.hpp"
#include "cellsearch/box.hpp"
#include "cellsearch/cell_grid.hpp"
#include "cellsearch/instruction_set.hpp"
#include "cellsearch/method.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// What a method builds from: a checked scene and the cells to use. Kept by value, so that a Search can move.
struct FinderInput {
  Scene scene;
  CandidateTest test;
  CellGrid grid;
  std::optional<Box> limit{};  ///< the user's domain: only nodes inside count; not set: all of them
  int threads = 1;
  double asked_cell_edge = 0.0;  ///< by the settings, 0 if not [length]
  double cell_edge = 0.0;  ///< wanted by the settings [length]; `grid` may have larger cells; 0: no segment
};

/// Rows found for a run of consecutive segments. Belongs to one thread while it is filled.
struct FoundRows {
  Offset* ends = nullptr;         ///< per segment of the run: nodes.size() after its row
  Array<Index>* nodes = nullptr;  ///< the rows, one after another; empty at the start
  Offset raw_visits = 0;          ///< nodes looked at, candidates or not
  Offset cell_visits = 0;         ///< cells looked into; 0 for methods without cells
  Array<Index>* spare = nullptr;  ///< for the method to use as it likes
};

/// One method of finding candidates. The virtual calls happen once per build and per block of segments.
class Finder {
 public:
  Finder() = default;
  virtual ~Finder() = default;
  Finder(const Finder&) = delete;
  Finder& operator=(const Finder&) = delete;

  /// Sorts the nodes; re-uses memory of earlier builds. Throws Error(UnsuitedMethod) for a scene outside the
  /// method's domain of use; the next build must work all the same.
  virtual void build(const FinderInput& input) = 0;

  /// Finds the rows of segments begin..end-1, each ascending. May run in several threads at once.
  virtual void query(Index begin, Index end, FoundRows& rows) const = 0;

  /// Number of cells, 0 for a method without cells.
  virtual Offset cells() const = 0;

  /// Working memory after build [bytes].
  virtual Offset bytes() const = 0;

  /// Participating nodes inside the domain.
  virtual Offset nodes_in_domain() const = 0;
};

/// A new finder for `method`; `set` is for the production method.
std::unique_ptr<Finder> make_finder(Method method, InstructionSet set);

}  // namespace cellsearch
