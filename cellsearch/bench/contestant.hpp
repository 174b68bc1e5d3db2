// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cellsearch/candidates.hpp"
#include "cellsearch/scene.hpp"

namespace cellsearch::bench {

/// One way to answer the question of all benchmarks: which nodes lie in the closed territory of each segment
/// (Scene, no options but the expansions), without the segment's own nodes, as sorted compressed rows.
class Contestant {
 public:
  Contestant() = default;
  virtual ~Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;

  /// All that is done before the first question. Called again and again; memory may be kept. The scene stays
  /// alive until the next build.
  virtual void build(const Scene& scene) = 0;

  /// The answer, kept by the contestant until the next build or query.
  virtual const Candidates& query() = 0;

  /// Called after each measurement, not timed: for those that keep nothing.
  virtual void forget() {}
};

/// What is known of a contestant before it runs.
struct ContestantKind {
  std::string name;
  std::string setup;        ///< how it is used, one line
  bool peer = false;        ///< not of this library
  bool threaded = false;    ///< uses more than one thread if told to
  double most_nodes = 1e9;  ///< "all" leaves it out above this number: it would take too long
  std::function<std::unique_ptr<Contestant>(int threads)> make{};
};

/// A peer that this program was built without.
struct AbsentPeer {
  std::string name;
  std::string package;  ///< the Debian package to install before CMake runs
};

/// All that this program was built with: the methods of this library in their order, then the peers.
std::vector<ContestantKind> contestants();

/// The methods of this library, as contestants.
std::vector<ContestantKind> own_contestants();

/// The peers that were not found when this program was built.
std::vector<AbsentPeer> absent_peers();

}  // namespace cellsearch::bench
