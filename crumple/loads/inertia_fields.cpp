// SPDX-License-Identifier: BSD-3-Clause
#include "loads/inertia_fields.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "math/to_vec3.hpp"

namespace crumple::loads {

using math::to_vec3;
using math::Vec3;

namespace {

constexpr Index field_piece = 1024;

/// The acceleration of the frame at a place, for a factor.
Vec3 acceleration_at(const model::InertiaField& field, double factor, const Vec3& place) {
  const Vec3 spin = factor * to_vec3(field.spin);
  return factor * to_vec3(field.acceleration) + cross(spin, cross(spin, place - to_vec3(field.centre)));
}

/// w x (J w) for a body's tensor of inertia J.
Vec3 gyration(const domain::RigidBody& body, const Vec3& spin) {
  const math::Matrix3 axes = math::matrix_of(body.turn);
  Vec3 own = math::transposed_product(axes, spin);
  for (int axis = 0; axis < 3; ++axis) own[axis] *= body.principal_inertia[axis];
  return cross(spin, axes * own);
}

}  // namespace

InertiaFields::InertiaFields(const model::Model& model, const domain::Domain& domain) : model_(&model) {
  if (model.inertia_fields.empty()) return;
  in_given_body_.assign(static_cast<std::size_t>(domain.nodes.count()), 0);
  for (const domain::RigidBody& body : domain.rigid_bodies)
    if (body.has_given_inertia)
      for (const Index node : body.nodes) in_given_body_[static_cast<std::size_t>(node)] = 1;
  for (const model::InertiaField& given : model.inertia_fields) {
    Field field;
    field.given = &given;
    if (!given.parts.empty()) field.selection = shares_of_parts(domain, given.parts);
    if (!given.nodes.empty()) {
      for (const Index node : given.nodes) field.selection.nodes.push_back(domain.nodes.domain_node[node]);
      std::sort(field.selection.nodes.begin(), field.selection.nodes.end());
      field.selection.share.assign(field.selection.nodes.size(), 1.0);
    }
    field.first_body = previous_moment_.size();
    for (std::size_t body = 0; body < model.rigid_bodies.size(); ++body)
      if (domain.rigid_bodies[body].has_given_inertia &&
          (given.of_all || has_part(model.rigid_bodies[body], given.parts)))
        field.bodies.push_back(static_cast<Index>(body));
    previous_moment_.resize(previous_moment_.size() + field.bodies.size());
    fields_.push_back(std::move(field));
  }
  previous_.assign(fields_.size(), 0.0);
}

/// Returns the work of the forces since time n-1 [energy]; `factors` are those of times n-1 and n.
double InertiaFields::push_nodes(const Field& field, const Vec3& factors, domain::Domain& domain) {
  domain::NodeFields& nodes = domain.nodes;
  const bool all = field.given->of_all;
  const Index count = all ? nodes.count() : static_cast<Index>(field.selection.nodes.size());
  const double step = domain.clock.step;
  work_.assign(static_cast<std::size_t>(pieces(count, field_piece)), 0.0);
  parallel_for(pieces(count, field_piece), domain.execution.threads, [&](Index p) {
    double work = 0;
    for (Index k = p * field_piece; k < std::min((p + 1) * field_piece, count); ++k) {
      const Index i = all ? k : field.selection.nodes[static_cast<std::size_t>(k)];
      if (in_given_body_[static_cast<std::size_t>(i)] != 0) continue;
      const double mass =
          all ? nodes.mass[i] : field.selection.share[static_cast<std::size_t>(k)] * nodes.mass[i];
      const Vec3& velocity = nodes.velocity[i];
      const Vec3 now = acceleration_at(*field.given, factors.y, nodes.position[i]);
      const Vec3 last = acceleration_at(*field.given, factors.x, nodes.position[i] - step * velocity);
      for (int axis = 0; axis < 3; ++axis) nodes.force[i].force[axis] -= mass * now[axis];
      work -= 0.5 * step * mass * dot(last + now, velocity);
    }
    work_[static_cast<std::size_t>(p)] = work;
  });
  double sum = 0;
  for (const double part : work_) sum += part;
  return sum;
}

/// The same of rigid bodies whose inertia is given.
double InertiaFields::push_bodies(const Field& field, const Vec3& factors, domain::Domain& domain) {
  const double step = domain.clock.step;
  double sum = 0;
  for (std::size_t i = 0; i < field.bodies.size(); ++i) {
    domain::RigidBody& body = domain.rigid_bodies[field.bodies[i]];
    const Vec3 now = acceleration_at(*field.given, factors.y, body.centre);
    const Vec3 last = acceleration_at(*field.given, factors.x, body.centre - step * body.velocity);
    const Vec3 moment = -gyration(body, factors.y * to_vec3(field.given->spin));
    Vec3& last_moment = previous_moment_[field.first_body + i];
    body.force -= body.mass * now;
    body.moment += moment;
    sum -= 0.5 * step * body.mass * dot(last + now, body.velocity);
    sum += 0.5 * step * dot(last_moment + moment, body.angular_velocity);
    last_moment = moment;
  }
  return sum;
}

void InertiaFields::add_forces(domain::Domain& domain) {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = fields_[i];
    const double factor = model_->curves[field.given->curve].at(domain.clock.time);
    const Vec3 factors{previous_[i], factor, 0};
    domain.energy.external_work += push_nodes(field, factors, domain);
    domain.energy.external_work += push_bodies(field, factors, domain);
    previous_[i] = factor;
  }
}

void InertiaFields::declare(domain::StateList& list) {
  if (fields_.empty()) return;
  list.keep_list("inertia_fields", "-", domain::Entity::Run, 1, previous_);
  list.keep_list("inertia_field_moments", "force * length", domain::Entity::RigidBody, 3, previous_moment_);
}

}  // namespace crumple::loads
