// SPDX-License-Identifier: BSD-3-Clause
#include "domain/shell_side.hpp"

namespace crumple::domain {

Vec3 first_side(const NodeFields& nodes, const model::ShellElement& shell) {
  std::size_t next = 1;
  while (next < 3 && shell.node[next] == shell.node[0]) ++next;
  const auto at = [&](std::size_t k) {
    return nodes.position[nodes.domain_node[static_cast<std::size_t>(shell.node[k])]];
  };
  return at(next) - at(0);
}

}  // namespace crumple::domain
