// SPDX-License-Identifier: BSD-3-Clause
#include "loads/pressure_loads.hpp"

namespace crumple::loads {
namespace {

/// Nodes that share the force: three or four.
std::size_t corners(const std::array<Index, 4>& node) {
  return node[2] == node[3] ? 3 : 4;
}

}  // namespace

PressureLoads::PressureLoads(const model::Model& model, const domain::Domain& domain) : model_(&model) {
  for (const model::PressureLoad& load : model.pressure_loads) {
    Load own;
    own.pressure = load.pressure;
    own.curve = load.curve;
    own.arrival = load.arrival;
    own.shell = load.shell;
    for (std::size_t k = 0; k < 4; ++k) own.node[k] = domain.nodes.domain_node[load.node[k]];
    loads_.push_back(own);
  }
}

math::Vec3 PressureLoads::force_on_nodes(const domain::Domain& domain, const Load& load) const {
  const double time = domain.clock.time;
  if (time < load.arrival || load.ended) return {};
  // The curve's time begins when the load arrives.
  const double factor = load.curve == no_index ? 1.0 : model_->curves[load.curve].at(time - load.arrival);
  const auto& x = domain.nodes.position;
  const math::Vec3 area = 0.5 * cross(x[load.node[2]] - x[load.node[0]], x[load.node[3]] - x[load.node[1]]);
  return (-load.pressure * factor / static_cast<double>(corners(load.node))) * area;
}

void PressureLoads::end_with_shells(const domain::Domain& domain) {
  Index eroded = 0;
  for (const domain::ShellBlock& block : domain.shells) eroded += block.eroded;
  if (eroded == eroded_) return;
  eroded_ = eroded;
  std::vector<char> gone(model_->shells.size(), 0);
  for (const domain::ShellBlock& block : domain.shells) {
    const domain::StateItem* const active = block.find("active");
    for (Index place = 0; place < block.elements; ++place)
      gone[block.element[place]] = block.state(place, active->first) == 0 ? 1 : 0;
  }
  for (Load& load : loads_) load.ended = load.shell != no_index && gone[load.shell] != 0;
}

void PressureLoads::add_forces(domain::Domain& domain) {
  if (!loads_.empty()) end_with_shells(domain);
  for (Load& load : loads_) {
    const math::Vec3 force = force_on_nodes(domain, load);
    math::Vec3 velocity;
    for (std::size_t k = 0; k < corners(load.node); ++k) {
      domain::NodeForce& sum = domain.nodes.force[load.node[k]];
      for (int axis = 0; axis < 3; ++axis) sum.force[axis] += force[axis];
      velocity += domain.nodes.velocity[load.node[k]];
    }
    domain.energy.external_work += 0.5 * domain.clock.step * dot(load.previous + force, velocity);
    load.previous = force;
  }
}

void PressureLoads::declare(domain::StateList& list) {
  for (Load& load : loads_) {
    list.keep("pressure_load", "force", domain::Entity::Node, load.previous);
    list.keep("pressure_load_ended", "-", domain::Entity::Run, load.ended);
  }
  list.keep("pressure_loads_eroded", "-", domain::Entity::Run, eroded_);
}

}  // namespace crumple::loads
