// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "domain/contact_node_force.hpp"
#include "domain/domain.hpp"
#include "domain/energy_residual.hpp"
#include "domain/section_report.hpp"
#include "math/vec3.hpp"
#include "model/model.hpp"

namespace crumple::output {

/// What an observer sees between two steps. Refers to a running simulation and owns nothing.
struct View {
  const model::Model& model;
  const domain::Domain& domain;
  double next_step = 0;  ///< from n to n+1 [time]
  /// Finds the element whose step is the smallest, which takes a look at all of them; may be absent.
  std::function<domain::ControllingElement()> controlling = {};
  /// Tells where energy goes wrong; absent if it is not traced.
  std::function<domain::EnergyTraceReport()> energy_trace = {};
  /// The forces of contacts on nodes; may be absent.
  std::function<std::vector<domain::ContactNodeForce>()> contact_node_forces = {};
  /// Forces in the cross-sections of the model, in its order; none if the deck does not ask for them.
  std::span<const domain::SectionReport> sections = {};
  /// Of every domain node at n - 1/2, those of the domain being at n + 1/2; none where they are not kept.
  std::span<const math::Vec3> earlier_velocity = {};
  std::span<const math::Vec3> earlier_angular_velocity = {};
};

}  // namespace crumple::output
