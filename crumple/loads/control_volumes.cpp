// SPDX-License-Identifier: BSD-3-Clause
#include "loads/control_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace crumple::loads {

using math::Vec3;

namespace {

constexpr Index airbag_piece = 1024;

std::vector<std::array<Index, 4>> domain_segments(std::vector<std::array<Index, 4>> segments,
                                                  const domain::Domain& domain) {
  for (std::array<Index, 4>& segment : segments)
    for (Index& node : segment) node = domain.nodes.domain_node[static_cast<std::size_t>(node)];
  return segments;
}

/// Of a rigid body under the force and the moment of a unit of pressure: the work of a unit of time at the
/// acceleration that they make, in the directions in which it is free.
double flexibility_of(const domain::RigidBody& body, const Vec3& force, const Vec3& moment) {
  if (!body.active || !(body.mass > 0)) return 0;
  double sum = 0;
  double smallest = std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3; ++axis) smallest = std::min(smallest, body.principal_inertia[axis]);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 along = body.held_axes.column[axis];
    const double push = dot(force, along);
    const double turn = dot(moment, along);
    if (!body.fixed_translation[axis]) sum += push * push / body.mass;
    if (!body.fixed_rotation[axis] && smallest > 0) sum += turn * turn / smallest;
  }
  return sum;
}

}  // namespace

ControlVolumes::ControlVolumes(const model::Model& model, domain::Domain& domain) {
  for (const model::ControlVolume& description : model.control_volumes) {
    Volume volume{&description, ClosedSurface(domain_segments(description.segments, domain)),
                  Filling(description.filling, model.curves)};
    volume.surface.measure(domain.nodes, domain.execution.threads);
    volume.state = volume.filling.initial(description.volume_scale * volume.surface.volume());
    volume.force.resize(volume.surface.nodes().size());
    for (const model::PorousFabric& fabric : description.porous) {
      volume.porous.push_back(domain_segments(fabric.segments, domain));
      volume.porous_area.push_back({&fabric, 0});
    }
    volumes_.push_back(std::move(volume));
    domain.control_volumes.push_back({.id = description.id});
  }
}

void ControlVolumes::add_forces(domain::Domain& domain) {
  frequency_squared_ = 0;
  for (std::size_t i = 0; i < volumes_.size(); ++i) {
    Volume& volume = volumes_[i];
    const model::ControlVolume& description = *volume.description;
    volume.surface.measure(domain.nodes, domain.execution.threads);
    if (!(volume.surface.volume() > 0))
      throw NumericalError("The surface of airbag " + std::to_string(description.id) +
                           " has turned inside out: the volume in it is not above zero.");
    for (std::size_t k = 0; k < volume.porous.size(); ++k)
      volume.porous_area[k].area = present_area(volume.porous[k], domain.nodes, domain.execution.threads);
    volume.filling.advance(volume.state,
                           {domain.clock.time, domain.clock.step,
                            description.volume_scale * volume.surface.volume(), volume.porous_area});
    push_nodes(domain, volume, description.pressure_scale * volume.state.pressure);
    report(volume, domain.control_volumes[i]);
  }
}

void ControlVolumes::push_nodes(domain::Domain& domain, Volume& volume, double pressure) {
  domain::NodeFields& nodes = domain.nodes;
  const std::vector<Index>& pushed = volume.surface.nodes();
  const auto count = static_cast<Index>(pushed.size());
  const double half_step = 0.5 * domain.clock.step;
  sums_.assign(static_cast<std::size_t>(pieces(count, airbag_piece)), {});
  parallel_for(pieces(count, airbag_piece), domain.execution.threads, [&](Index p) {
    std::array<double, 2> sum{};
    for (Index i = p * airbag_piece; i < std::min((p + 1) * airbag_piece, count); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Index node = pushed[at];
      const Vec3& gradient = volume.surface.gradients()[at];
      const Vec3 force = pressure * gradient;
      for (int axis = 0; axis < 3; ++axis) nodes.force[node].force[axis] += force[axis];
      sum[0] += half_step * dot(volume.force[at] + force, nodes.velocity[node]);
      if (nodes.is_free(node) && nodes.mass[node] > 0) sum[1] += dot(gradient, gradient) / nodes.mass[node];
      volume.force[at] = force;
    }
    sums_[static_cast<std::size_t>(p)] = sum;
  });
  double flexibility = flexibility_of_bodies(domain, volume);
  for (const std::array<double, 2>& sum : sums_) {
    domain.energy.external_work += sum[0];
    flexibility += sum[1];
  }
  const model::ControlVolume& description = *volume.description;
  frequency_squared_ +=
      description.pressure_scale * description.volume_scale * volume.state.stiffness * flexibility;
}

/// What a unit of pressure accelerates the volume by through the rigid bodies in its surface
/// [volume/(time^2 pressure)].
double ControlVolumes::flexibility_of_bodies(const domain::Domain& domain, const Volume& volume) {
  if (domain.rigid_bodies.empty()) return 0;
  on_body_.assign(domain.rigid_bodies.size(), {});
  turning_body_.assign(domain.rigid_bodies.size(), {});
  for (std::size_t i = 0; i < volume.surface.nodes().size(); ++i) {
    const Index node = volume.surface.nodes()[i];
    const Index at = domain.body_of_node[node];
    if (at == no_index) continue;
    const Vec3& gradient = volume.surface.gradients()[i];
    on_body_[at] += gradient;
    turning_body_[at] += cross(domain.nodes.position[node] - domain.rigid_bodies[at].centre, gradient);
  }
  double sum = 0;
  for (std::size_t at = 0; at < domain.rigid_bodies.size(); ++at)
    sum += flexibility_of(domain.rigid_bodies[at], on_body_[at], turning_body_[at]);
  return sum;
}

double ControlVolumes::stable_share(double step) const {
  return 1 / std::sqrt(1 + 0.25 * frequency_squared_ * step * step);
}

void ControlVolumes::report(const Volume& volume, domain::ControlVolumeReport& into) {
  const FillingState& state = volume.state;
  into.volume = volume.surface.volume();
  into.pressure = volume.description->pressure_scale * state.pressure;
  into.energy = state.energy;
  into.inflow = state.inflow;
  into.outflow = state.outflow;
  into.mass = state.mass;
  into.temperature = state.temperature;
  into.area = volume.surface.area();
}

void ControlVolumes::declare(domain::StateList& list) {
  for (Volume& volume : volumes_) {
    static_assert(sizeof(FillingState) == 10 * sizeof(double));
    list.add("control_volume", "-", domain::Entity::Run, 10, std::span(&volume.state, 1));
    list.keep_list("control_volume_force", "force", domain::Entity::Node, 3, volume.force);
  }
}

}  // namespace crumple::loads
