// SPDX-License-Identifier: BSD-3-Clause
#include "domain/tie.hpp"

#include "domain/domain.hpp"

namespace crumple::domain {

bool has_failed(const Domain& domain, Index block, Index element) {
  const auto shells = static_cast<Index>(domain.shells.size());
  const ElementBlock& of_element =
      block < shells ? static_cast<const ElementBlock&>(domain.shells[block]) : domain.solids[block - shells];
  const StateItem* active = of_element.find("active");
  return active != nullptr && of_element.state(element, active->first) == 0;
}

Index eroded_elements(const Domain& domain) {
  Index eroded = 0;
  for (const ShellBlock& block : domain.shells) eroded += block.eroded;
  for (const SolidBlock& block : domain.solids) eroded += block.eroded;
  return eroded;
}

}  // namespace crumple::domain
