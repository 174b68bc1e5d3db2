// SPDX-License-Identifier: BSD-3-Clause
#include "loads/segment_pressure.hpp"

namespace crumple::loads {

SegmentNodes domain_nodes(const domain::Domain& domain, const std::array<Index, 4>& node) {
  SegmentNodes own{};
  for (std::size_t k = 0; k < 4; ++k) own[k] = domain.nodes.domain_node[node[k]];
  return own;
}

std::size_t corners(const SegmentNodes& node) {
  return node[2] == node[3] ? 3 : 4;
}

math::Vec3 centre(const domain::Domain& domain, const SegmentNodes& node) {
  math::Vec3 sum;
  for (std::size_t k = 0; k < corners(node); ++k) sum += domain.nodes.position[node[k]];
  return (1.0 / static_cast<double>(corners(node))) * sum;
}

math::Vec3 vector_area(const domain::Domain& domain, const SegmentNodes& node) {
  const auto& x = domain.nodes.position;
  return 0.5 * cross(x[node[2]] - x[node[0]], x[node[3]] - x[node[1]]);
}

void add_equal_forces(domain::Domain& domain, const SegmentNodes& node, const math::Vec3& force,
                      math::Vec3& previous) {
  math::Vec3 velocity;
  for (std::size_t k = 0; k < corners(node); ++k) {
    domain::NodeForce& sum = domain.nodes.force[node[k]];
    for (int axis = 0; axis < 3; ++axis) sum.force[axis] += force[axis];
    velocity += domain.nodes.velocity[node[k]];
  }
  domain.energy.external_work += 0.5 * domain.clock.step * dot(previous + force, velocity);
  previous = force;
}

bool ErodedShells::have_changed(const domain::Domain& domain, const model::Model& model) {
  Index eroded = 0;
  for (const domain::ShellBlock& block : domain.shells) eroded += block.eroded;
  if (eroded == count_) return false;
  count_ = eroded;
  gone_.assign(model.shells.size(), 0);
  for (const domain::ShellBlock& block : domain.shells) {
    const domain::StateItem* const active = block.find("active");
    for (Index place = 0; place < block.elements; ++place)
      gone_[block.element[place]] = block.state(place, active->first) == 0 ? 1 : 0;
  }
  return true;
}

}  // namespace crumple::loads
