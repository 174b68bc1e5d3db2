// SPDX-License-Identifier: BSD-3-Clause
#include "loads/pressure_loads.hpp"

namespace crumple::loads {

PressureLoads::PressureLoads(const model::Model& model, const domain::Domain& domain) : model_(&model) {
  for (const model::PressureLoad& load : model.pressure_loads) {
    Load own;
    own.pressure = load.pressure;
    own.curve = load.curve;
    own.arrival = load.arrival;
    own.shell = load.shell;
    own.node = domain_nodes(domain, load.node);
    loads_.push_back(own);
  }
}

math::Vec3 PressureLoads::force_on_nodes(const domain::Domain& domain, const Load& load) const {
  const double time = domain.clock.time;
  if (time < load.arrival || load.ended) return {};
  // The curve's time begins when the load arrives.
  const double factor = load.curve == no_index ? 1.0 : model_->curves[load.curve].at(time - load.arrival);
  return (-load.pressure * factor / static_cast<double>(corners(load.node))) * vector_area(domain, load.node);
}

void PressureLoads::end_with_shells(const domain::Domain& domain) {
  if (!eroded_.have_changed(domain, *model_)) return;
  for (Load& load : loads_) load.ended = load.shell != no_index && eroded_.gone(load.shell);
}

void PressureLoads::add_forces(domain::Domain& domain) {
  if (!loads_.empty()) end_with_shells(domain);
  for (Load& load : loads_) add_equal_forces(domain, load.node, force_on_nodes(domain, load), load.previous);
}

void PressureLoads::declare(domain::StateList& list) {
  for (Load& load : loads_) {
    list.keep("pressure_load", "force", domain::Entity::Node, load.previous);
    list.keep("pressure_load_ended", "-", domain::Entity::Run, load.ended);
  }
  list.keep("pressure_loads_eroded", "-", domain::Entity::Run, eroded_.count());
}

}  // namespace crumple::loads
