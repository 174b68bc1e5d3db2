// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shell/shell_setup.hpp"

namespace crumple::elements {

ShellCorners corners_of(const domain::Domain& domain, const std::array<Index, 4>& node) {
  ShellCorners corner;
  for (std::size_t k = 0; k < 4; ++k) corner[k] = domain.nodes.position[node[k]];
  return corner;
}

}  // namespace crumple::elements
