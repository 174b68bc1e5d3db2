// SPDX-License-Identifier: BSD-3-Clause
#include "loads/part_selection.hpp"

#include <algorithm>

namespace crumple::loads {

NodeShares shares_of_parts(const domain::Domain& domain, const std::vector<Index>& parts) {
  std::vector<double> sum(static_cast<std::size_t>(domain.nodes.count()), 0.0);
  for (const Index part : parts) {
    const domain::PartShare& of = domain.part_shares[static_cast<std::size_t>(part)];
    for (std::size_t i = 0; i < of.nodes.size(); ++i)
      sum[static_cast<std::size_t>(of.nodes[i])] += of.share[i];
  }
  NodeShares found;
  for (std::size_t node = 0; node < sum.size(); ++node) {
    if (!(sum[node] > 0)) continue;
    found.nodes.push_back(static_cast<Index>(node));
    found.share.push_back(std::min(sum[node], 1.0));
  }
  return found;
}

bool has_part(const model::RigidBody& body, const std::vector<Index>& parts) {
  return std::any_of(body.parts.begin(), body.parts.end(),
                     [&](Index part) { return std::find(parts.begin(), parts.end(), part) != parts.end(); });
}

}  // namespace crumple::loads
