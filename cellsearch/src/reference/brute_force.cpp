// SPDX-License-Identifier: BSD-3-Clause
#include "reference/brute_force.hpp"

#include "cellsearch/territory.hpp"

namespace cellsearch {

bool BruteForce::counts(Index node) const {
  return !input_.limit || input_.limit->contains(input_.scene.positions[node]);
}

void BruteForce::build(const FinderInput& input) {
  input_ = input;
  nodes_in_domain_ = 0;
  const Index nodes = static_cast<Index>(input.scene.participants());
  for (Index place = 0; place < nodes; ++place) {
    if (counts(input.scene.participant(place))) ++nodes_in_domain_;
  }
}

void BruteForce::query(Index begin, Index end, FoundRows& rows) const {
  const Scene& scene = input_.scene;
  const Index nodes = static_cast<Index>(scene.participants());
  for (Index segment = begin; segment < end; ++segment) {
    if (input_.test.active(segment)) {
      const Box box = territory(scene, segment);
      for (Index place = 0; place < nodes; ++place) {
        const Index node = scene.participant(place);
        if (input_.test(segment, box, node) && counts(node)) rows.nodes->push_back(node);
      }
      rows.raw_visits += nodes;
    }
    rows.ends[segment - begin] = static_cast<Offset>(rows.nodes->size());
  }
}

}  // namespace cellsearch
