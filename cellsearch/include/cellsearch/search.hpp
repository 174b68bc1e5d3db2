// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cellsearch/array.hpp"
#include "cellsearch/candidates.hpp"
#include "cellsearch/cell_grid.hpp"
#include "cellsearch/error.hpp"
#include "cellsearch/instruction_set.hpp"
#include "cellsearch/method.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

class Finder;
class NeighbourLists;

/// How to search. The defaults suit any scene.
struct Settings {
  Method method = Method::Production;

  /// The cells, possibly over part of the model only (then nodes outside are never candidates, whatever the
  /// method). Not set: the bounding box of the participating nodes at each build, so that none is missed.
  std::optional<CellDomain> domain{};

  /// Edge of the cells [length], > 0. Not set: chosen by the method. Larger ones are taken where these would
  /// be too many.
  std::optional<double> cell_edge{};

  /// The paper's methods, automatic cells: cell edge over mean segment edge, > 0. The paper advises 1 or a
  /// little more.
  double cell_factor = 1.0;

  /// The paper's methods, automatic cells: at most this many cells per participating node, > 0, so that
  /// memory does not grow with the empty volume of a sparse scene.
  double cells_per_node = 4.0;

  /// Instruction set of the production method. Not set: the best that this processor has. The results are
  /// bitwise the same for any.
  std::optional<InstructionSet> instruction_set{};

  /// Number of threads, >= 1. The results are bitwise the same for any number.
  int threads = 1;
};

/// What the last search did, counted. Independent of the number of threads, but for the memory.
struct Statistics {
  Offset segments = 0;         ///< rows of the result
  Offset participants = 0;     ///< nodes that took part
  Offset nodes_in_domain = 0;  ///< of these, inside the given domain
  Offset cells = 0;            ///< Ncell; 0 for methods without cells
  Offset bytes = 0;            ///< working memory; linked-cell: 4 (Ncell + N), eq. (12), N the participants
  Offset cell_visits = 0;      ///< cells looked into, over all segments, by the queries since the build
  Offset raw_visits = 0;       ///< nodes looked at, over all segments, by the queries since the build
  Offset candidates = 0;       ///< pairs reported by the queries since the build
};

/// The global contact search. Keep one object over many searches: it re-uses its memory.
///
///     cellsearch::Search search;
///     const cellsearch::Candidates& found = search.find(scene);
///     for (cellsearch::Index node : found.of(segment)) ...
///
/// An object may be used by one thread at a time; different objects are independent. Time and memory are O(N)
/// for any layout with the production method, which also keeps its cells from one build to the next where it
/// can (docs/production.md), and for elements of similar size in a compact domain with the printed one (eq.
/// 11, 12).
class Search {
 public:
  /// Throws Error(BadSetting) or Error(BadDomain).
  explicit Search(const Settings& settings = {});
  ~Search();
  Search(Search&&) noexcept;
  Search& operator=(Search&&) noexcept;
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  /// Checks the scene and sorts its nodes into cells. Keeps the views of `scene` for the queries that follow,
  /// until the next build. Throws Error (see ErrorKind); there is nothing to query then. A scene without
  /// segments, or with an empty list of nodes, is no error: it has no candidates.
  void build(const Scene& scene);

  /// All candidates of the last build, as compressed rows in the order of segments. The result belongs to
  /// this object and is overwritten by the next query; `take` it to keep it.
  const Candidates& query();

  /// build() and query() at once.
  const Candidates& find(const Scene& scene) {
    build(scene);
    return query();
  }

  /// Moves the last result of query() out of the object.
  Candidates take() { return std::move(candidates_); }

  /// Calls visitor(segment, node) for all candidates of the last build: segments ascending, for each of them
  /// nodes ascending, one after another on the calling thread. Nothing is stored. What the visitor throws
  /// reaches the caller.
  template <class Visitor>
  void visit(Visitor&& visitor) {
    for (Index begin = 0; begin < segments(); begin += batch_size) {
      const Index end = query_batch(begin);
      Offset place = 0;
      for (Index segment = begin; segment < end; ++segment) {
        for (; place < batch_ends_[segment - begin]; ++place) visitor(segment, batch_nodes_[place]);
      }
    }
  }

  /// How far nodes may move relative to segments along any axis, from the last build on, before a pair nearer
  /// than `contact_distance` h may be missing among its candidates: c - h, at least 0 [length]. A pair is
  /// near by the box of the segment. MotionTracker watches it.
  double allowed_motion(double contact_distance) const {
    const double left = scene_.expansion - contact_distance;
    return left > 0.0 ? left : 0.0;
  }

  /// The scene of the last build.
  const Scene& scene() const { return scene_; }

  /// The settings given at construction.
  const Settings& settings() const { return settings_; }

  /// The cells of the last build (given or automatic); not meaningful for BruteForce and Production.
  const CellGrid& grid() const { return grid_; }

  /// Counts of the last build and the queries since.
  const Statistics& statistics() const { return statistics_; }

 private:
  static constexpr Index batch_size = 256;

  struct BlockRows {
    Offset start;
    Offset raw_visits;
    Offset cell_visits;
  };

  Index segments() const { return static_cast<Index>(scene_.segments.count()); }
  InstructionSet instruction_set() const;
  Index query_batch(Index begin);

  Settings settings_;
  InstructionSet instruction_set_ = InstructionSet::Portable;
  Scene scene_;
  CellGrid grid_;
  Statistics statistics_;
  Candidates candidates_;
  std::unique_ptr<Finder> finder_;
  std::unique_ptr<NeighbourLists> neighbours_;
  std::vector<BlockRows> block_rows_;
  std::vector<Array<Index>> block_spare_;
  std::vector<Array<Index>> block_nodes_;  // what each block of segments found, before it is joined
  std::array<Offset, batch_size> batch_ends_{};
  Array<Index> batch_nodes_;
};

}  // namespace cellsearch
