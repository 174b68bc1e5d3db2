// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/trouble.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "elements/elements.hpp"

namespace crumple::timeloop {
namespace {

bool finite(const math::Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Index first_bad_node(const domain::NodeFields& nodes) {
  for (Index i = 0; i < nodes.count(); ++i)
    if (!finite(nodes.position[i]) || !finite(nodes.velocity[i]) || !finite(nodes.angular_velocity[i]))
      return i;
  return no_index;
}

Index fastest_node(const domain::NodeFields& nodes) {
  const auto slower = [](const math::Vec3& a, const math::Vec3& b) { return dot(a, a) < dot(b, b); };
  return static_cast<Index>(std::max_element(nodes.velocity.begin(), nodes.velocity.end(), slower) -
                            nodes.velocity.begin());
}

/// " of shell 12, part 3" for the first element that has the node; empty if there is none.
std::string owner_of(const model::Model& model, const domain::Domain& domain, Index node) {
  std::string found;
  const auto look = [&](const auto& blocks, const char* kind, const auto& elements) {
    for (const auto& block : blocks)
      for (Index place = 0; place < block.elements && found.empty(); ++place) {
        bool has_node = false;
        for (Index corner = 0; corner < block.corners; ++corner)
          has_node = has_node || block.node_of(place, corner) == node;
        if (has_node)
          found = std::string(" of ") + kind + " " + std::to_string(elements[block.element[place]].id) +
                  ", part " + std::to_string(model.parts[block.part].id);
      }
  };
  look(domain.shells, "shell", model.shells);
  look(domain.solids, "solid", model.solids);
  look(domain.beams, "beam", model.beams);
  look(domain.discretes, "discrete element", model.discretes);
  return found;
}

/// The first active solid that has turned inside out, in words; empty if there is none.
std::string inside_out(const model::Model& model, const domain::Domain& domain) {
  for (const domain::SolidBlock& block : domain.solids)
    for (Index place = 0; place < block.elements; ++place) {
      const bool active = block.state(place, block.find("active")->first) != 0;
      if (!active || !(elements::solid_volume(domain, block, place) <= 0)) continue;
      return "negative volume in brick element " + std::to_string(model.solids[block.element[place]].id) +
             ", part " + std::to_string(model.parts[block.part].id);
    }
  return "";
}

}  // namespace

void throw_trouble(const model::Model& model, const domain::Domain& domain, const std::string& otherwise) {
  const std::string where =
      " at cycle " + std::to_string(domain.clock.cycle) + ", time " + std::to_string(domain.clock.time) + ".";
  if (const std::string solid = inside_out(model, domain); !solid.empty())
    throw NumericalError(solid + "," + where);
  const Index node = first_bad_node(domain.nodes);
  if (node == no_index) {
    const Index fastest = fastest_node(domain.nodes);
    throw NumericalError(otherwise + "; out-of-range velocities: the fastest node is " +
                         std::to_string(model.nodes.id[domain.nodes.model_node[fastest]]) +
                         owner_of(model, domain, fastest) + "," + where);
  }
  throw NumericalError("out-of-range velocities: the motion of node " +
                       std::to_string(model.nodes.id[domain.nodes.model_node[node]]) +
                       owner_of(model, domain, node) + " is no longer a finite number," + where);
}

}  // namespace crumple::timeloop
