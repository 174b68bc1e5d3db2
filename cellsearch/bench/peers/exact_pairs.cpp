// SPDX-License-Identifier: BSD-3-Clause
#include "peers/exact_pairs.hpp"

#include <algorithm>

#include "cellsearch/territory.hpp"

namespace cellsearch::bench {

void ExactPairs::reset(const Scene& scene) {
  scene_ = scene;
  pairs_.clear();
  const std::size_t count = scene.segments.count();
  territories_.resize(count);
  for (std::size_t segment = 0; segment < count; ++segment) {
    territories_[segment] = territory(scene, static_cast<Index>(segment));
  }
}

const Candidates& ExactPairs::rows() {
  const std::size_t count = territories_.size();
  candidates_.first.assign(count + 1, 0);
  for (const Pair& pair : pairs_) ++candidates_.first[static_cast<std::size_t>(pair.segment) + 1];
  for (std::size_t segment = 0; segment < count; ++segment) {
    candidates_.first[segment + 1] += candidates_.first[segment];
  }
  place_.assign(candidates_.first.begin(), candidates_.first.end() - 1);
  candidates_.node.resize(pairs_.size());
  for (const Pair& pair : pairs_) {
    candidates_.node[static_cast<std::size_t>(place_[static_cast<std::size_t>(pair.segment)]++)] = pair.node;
  }
  for (std::size_t segment = 0; segment < count; ++segment) {
    std::sort(candidates_.node.begin() + candidates_.first[segment],
              candidates_.node.begin() + candidates_.first[segment + 1]);
  }
  return candidates_;
}

void ExactPairs::start_rows() {
  candidates_.first.clear();
  candidates_.first.reserve(territories_.size() + 1);
  candidates_.first.push_back(0);
  candidates_.node.clear();
}

void ExactPairs::end_row() {
  std::sort(candidates_.node.begin() + candidates_.first.back(), candidates_.node.end());
  candidates_.first.push_back(static_cast<Offset>(candidates_.node.size()));
}

}  // namespace cellsearch::bench
