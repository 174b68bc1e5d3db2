// SPDX-License-Identifier: BSD-3-Clause
// Shells that LS-DYNA would have deleted or stopped at (NFAIL1, NFAIL4 of *CONTROL_SHELL).
#include <fmt/core.h>

#include "base/counted.hpp"
#include "math/vec3.hpp"
#include "output/checks.hpp"

namespace crumple::output {

namespace {

/// Whether a corner of a quadrilateral is turned inside out: the bilinear map from the reference square has a
/// negative Jacobian there.
bool has_negative_corner(const domain::Domain& domain, const std::array<Index, 4>& nodes) {
  const auto at = [&](std::size_t corner) { return domain.nodes.position[nodes[corner % 4]]; };
  const math::Vec3 normal = cross(at(2) - at(0), at(3) - at(1));
  for (std::size_t corner = 0; corner < 4; ++corner)
    if (dot(cross(at(corner + 1) - at(corner), at(corner + 3) - at(corner)), normal) < 0) return true;
  return false;
}

}  // namespace

std::vector<std::string> distortion_warnings(const View& view) {
  std::vector<std::string> sentences;
  if (!view.model.control.report_distorted_shells) return sentences;
  for (const domain::ShellBlock& block : view.domain.shells) {
    const model::Part& part = view.model.parts[block.part];
    if (model::is_rigid(view.model, part)) continue;
    Index count = 0;
    Index first = no_index;
    for (Index place = 0; place < block.elements; ++place) {
      const bool active = block.state(place, block.find("active")->first) != 0;
      if (!active || !has_negative_corner(view.domain, block.nodes_of(place))) continue;
      if (count++ == 0) first = block.element[place];
    }
    if (count > 0)
      sentences.push_back(fmt::format(
          "{} of part {} {} a negative Jacobian, the first is {}: LS-DYNA would have deleted them, or "
          "stopped "
          "(NFAIL1, NFAIL4).",
          counted(count, "shell"), part.id, count == 1 ? "has" : "have", view.model.shells[first].id));
  }
  return sentences;
}

}  // namespace crumple::output
