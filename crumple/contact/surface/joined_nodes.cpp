// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/joined_nodes.hpp"

#include <algorithm>
#include <utility>

#include "contact/surface/surface.hpp"

namespace crumple::contact {
namespace {

Index ended_ties(const domain::Domain& domain) {
  Index ended = 0;
  for (const domain::Tie& tie : domain.ties) ended += tie.released;
  return ended;
}

/// Places in Surface::nodes of joined nodes, each pair both ways round, once.
std::vector<std::pair<Index, Index>> joined_pairs(const domain::Domain& domain, UserId contact,
                                                  const Surface& surface) {
  std::vector<std::pair<Index, Index>> pairs;
  for (const domain::Tie& tie : domain.ties) {
    if (tie.id == contact) continue;
    for (std::size_t i = 0; i < tie.nodes.size(); ++i) {
      const Index own = surface.place[tie.nodes[i].node];
      if (tie.holds[i] == 0 || own == no_index) continue;
      for (const Index corner : tie.nodes[i].corner) {
        const Index other = surface.place[corner];
        if (other == no_index) continue;
        pairs.emplace_back(own, other);
        pairs.emplace_back(other, own);
      }
    }
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

void join_nodes(const domain::Domain& domain, UserId contact, Surface& surface) {
  JoinedNodes& joined = surface.joined;
  joined = {};
  joined.ended = ended_ties(domain);
  const std::vector<std::pair<Index, Index>> pairs = joined_pairs(domain, contact, surface);
  if (pairs.empty()) return;
  joined.first.assign(surface.nodes.size() + 1, 0);
  joined.node.reserve(pairs.size());
  for (const auto& [place, other] : pairs) {
    ++joined.first[place + 1];
    joined.node.push_back(surface.nodes[other]);
  }
  for (std::size_t i = 1; i < joined.first.size(); ++i) joined.first[i] += joined.first[i - 1];
}

bool follow_ended_ties(const domain::Domain& domain, UserId contact, Surface& surface) {
  JoinedNodes& joined = surface.joined;
  joined.freed.clear();
  if (ended_ties(domain) == joined.ended) return false;
  const JoinedNodes before = joined;
  join_nodes(domain, contact, surface);
  if (before.empty()) return false;
  joined.freed.resize(surface.nodes.size());
  for (Index place = 0; place < surface.node_count(); ++place) {
    const std::size_t left = joined.empty() ? 0 : joined.of(place).size();
    joined.freed[place] = left < before.of(place).size() ? 1 : 0;
  }
  return true;
}

}  // namespace crumple::contact
