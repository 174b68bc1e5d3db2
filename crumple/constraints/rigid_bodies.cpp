// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/rigid_bodies.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "constraints/body_share.hpp"
#include "constraints/rigid_motion.hpp"
#include "math/to_vec3.hpp"

namespace crumple::constraints {

using domain::Domain;
using domain::NodeFields;
using domain::RigidBody;
using math::Matrix3;
using math::to_vec3;
using math::Vec3;

namespace {

constexpr Index piece = 1024;

bool any(const std::array<bool, 3>& axes) {
  return axes[0] || axes[1] || axes[2];
}

/// Adds m (r.r 1 - r r) + I 1 to a tensor.
void add_mass(Matrix3& tensor, double mass, double own, const Vec3& r) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3& column = tensor.column[static_cast<std::size_t>(axis)];
    column -= mass * r[axis] * r;
    column[axis] += mass * dot(r, r) + own;
  }
}

/// Axes, principal moments and arms from the tensor about the centre.
void set_inertia(RigidBody& body, const Matrix3& tensor, const NodeFields& nodes) {
  const math::PrincipalAxes principal = math::principal_axes(tensor);
  body.turn = body.next_turn = principal.axes;
  body.principal_inertia = principal.moment;
  const double largest = std::max({principal.moment.x, principal.moment.y, principal.moment.z});
  constexpr double none = 1e-12;  // of nodes on a line
  for (int axis = 0; axis < 3; ++axis)
    if (body.principal_inertia[axis] < none * largest) body.principal_inertia[axis] = 0;
  const Matrix3 axes = math::matrix_of(body.turn);
  body.arm.clear();
  body.arm.reserve(body.nodes.size());
  for (const Index node : body.nodes)
    body.arm.push_back(math::transposed_product(axes, nodes.position[node] - body.centre));
}

struct MassSum {
  double mass = 0;
  Vec3 first;     ///< sum of m x
  Vec3 momentum;  ///< sum of m v
};

MassSum sum_masses(const NodeFields& nodes, const std::vector<Index>& some) {
  MassSum sum;
  for (const Index node : some) {
    sum.mass += nodes.mass[node];
    sum.first += nodes.mass[node] * nodes.position[node];
    sum.momentum += nodes.mass[node] * nodes.velocity[node];
  }
  return sum;
}

Vec3 angular_momentum(const NodeFields& nodes, const RigidBody& body) {
  Vec3 sum;
  for (const Index node : body.nodes)
    sum +=
        nodes.mass[node] * cross(nodes.position[node] - body.centre, nodes.velocity[node] - body.velocity) +
        nodes.inertia[node] * nodes.angular_velocity[node];
  return sum;
}

/// What is fixed stays so from the first moment on.
void hold_fixed(RigidBody& body) {
  body.held_translation = body.fixed_translation;
  body.held_rotation = body.fixed_rotation;
  body.prescribed_velocity = body.prescribed_spin = Vec3{};
  for (int axis = 0; axis < 3; ++axis)
    if (body.fixed_translation[static_cast<std::size_t>(axis)]) hold_translation(body, axis, 0);
}

void take_given_inertia(const model::RigidInertia& given, const std::vector<Index>& added, Domain& domain,
                        RigidBody& body) {
  NodeFields& nodes = domain.nodes;
  const MassSum extra = sum_masses(nodes, added);
  const Vec3 spin = given.velocity_from_nodes ? spin_of(body, body.turn, body.angular_momentum)
                                              : to_vec3(given.angular_velocity);
  const Vec3 centre = to_vec3(given.centre);
  const double nodal = sum_masses(nodes, body.nodes).mass;
  const Vec3 former_centre = body.centre;
  body.mass = given.mass + extra.mass;
  body.centre = (1 / body.mass) * (given.mass * centre + extra.first);
  const auto& t = given.tensor;
  Matrix3 tensor{{Vec3{t[0], t[1], t[2]}, Vec3{t[1], t[3], t[4]}, Vec3{t[2], t[4], t[5]}}};
  add_mass(tensor, given.mass, 0, centre - body.centre);
  for (const Index node : added)
    add_mass(tensor, nodes.mass[node], nodes.inertia[node], nodes.position[node] - body.centre);
  set_inertia(body, tensor, nodes);
  // What the nodes have together is what contact and walls see of the body.
  if (nodal > 0)
    for (const Index node : body.nodes) nodes.mass[node] *= body.mass / nodal;
  // The motion of the nodes is kept, not their momenta.
  body.velocity = given.velocity_from_nodes ? body.velocity + cross(spin, body.centre - former_centre)
                                            : to_vec3(given.velocity);
  body.angular_momentum = inertia_tensor(body, body.turn) * spin;
}

/// Sums of nodal forces about the centre.
struct ForceSum {
  Vec3 force;
  Vec3 moment;
};

ForceSum sum_piece(const NodeFields& nodes, const RigidBody& body, Index p) {
  ForceSum sum;
  const auto count = static_cast<Index>(body.nodes.size());
  for (Index i = p * piece; i < std::min((p + 1) * piece, count); ++i) {
    const Index node = body.nodes[i];
    const domain::NodeForce& at = nodes.force[node];
    const Vec3 force{at.force[0], at.force[1], at.force[2]};
    sum.force += force;
    sum.moment +=
        cross(nodes.position[node] - body.centre, force) + Vec3{at.moment[0], at.moment[1], at.moment[2]};
  }
  return sum;
}

ForceSum sum_forces(const NodeFields& nodes, const RigidBody& body, int threads) {
  ForceSum total{body.force, body.moment};
  const auto add = [&](const ForceSum& sum) {
    total.force += sum.force;
    total.moment += sum.moment;
  };
  const Index parts = pieces(static_cast<Index>(body.nodes.size()), piece);
  // Most bodies are small (welds): no room for sums has to be found for them.
  if (parts == 1) {
    add(sum_piece(nodes, body, 0));
    return total;
  }
  std::vector<ForceSum> sums(static_cast<std::size_t>(parts));
  parallel_for(parts, threads, [&](Index p) { sums[p] = sum_piece(nodes, body, p); });
  for (const ForceSum& sum : sums) add(sum);
  return total;
}

/// Axes that were held in the last step are free again or fixed; what held them may have done work while the
/// body turned.
void begin_step(Domain& domain, RigidBody& body) {
  body.previous_velocity = body.velocity;
  const Vec3 spin = spin_of(body, body.turn, body.angular_momentum);
  if (any(body.held_rotation)) {
    const Vec3 momentum = inertia_tensor(body, body.turn) * spin;
    // Axes that only are fixed do no work.
    if (norm(body.prescribed_spin) > 0)
      domain.energy.external_work += 0.5 * (dot(spin, momentum) - dot(body.spin, body.angular_momentum));
    body.angular_momentum = momentum;
  }
  body.previous_spin = body.spin = spin;
  body.previous_momentum = body.angular_momentum;
  hold_fixed(body);
}

void kick_body(Domain& domain, RigidBody& body, double interval) {
  begin_step(domain, body);
  const ForceSum sum = sum_forces(domain.nodes, body, domain.execution.threads);
  body.force = body.moment = Vec3{};
  body.impulse = body.angular_impulse = Vec3{};
  give_impulse(body, Vec3{}, interval * sum.force);
  body.angular_impulse = interval * sum.moment;
  body.angular_momentum += body.angular_impulse;
  body.spin = spin_of(body, body.turn, body.angular_momentum);
}

/// Kinetic energy of time n, and the work of what is prescribed: the impulses of the reactions act on the
/// mean of the velocities before and after.
void book_energy(Domain& domain, RigidBody& body, double interval) {
  if (any(body.held_rotation)) body.angular_momentum = inertia_tensor(body, body.turn) * body.spin;
  body.kinetic_energy = 0.5 * (body.mass * dot(body.previous_velocity, body.velocity) +
                               dot(body.previous_spin, body.angular_momentum));
  body.acceleration = (1 / interval) * (body.velocity - body.previous_velocity);
  domain.energy.external_work += body.deferred_work;
  body.deferred_work = 0;
  body.reaction = body.reaction_moment = Vec3{};
  if (!any(body.held_translation) && !any(body.held_rotation)) return;
  const Vec3 impulse = body.mass * (body.velocity - body.previous_velocity) - body.impulse;
  const Vec3 angular = body.angular_momentum - body.previous_momentum - body.angular_impulse;
  domain.energy.external_work +=
      0.5 * (dot(impulse, body.previous_velocity) + dot(angular, body.previous_spin));
  body.deferred_work = 0.5 * (dot(impulse, body.velocity) + dot(angular, body.spin));
  body.reaction = (1 / interval) * impulse;
  body.reaction_moment = (1 / interval) * angular;
}

}  // namespace

RigidBody body_of_nodes(const Domain& domain, UserId id, std::vector<Index> nodes) {
  const NodeFields& fields = domain.nodes;
  RigidBody body;
  body.id = id;
  body.nodes = std::move(nodes);
  const MassSum sum = sum_masses(fields, body.nodes);
  if (!(sum.mass > 0)) throw Error("Rigid body " + std::to_string(id) + " has no mass.");
  body.mass = sum.mass;
  body.centre = (1 / sum.mass) * sum.first;
  body.velocity = (1 / sum.mass) * sum.momentum;
  body.angular_momentum = angular_momentum(fields, body);
  Matrix3 tensor;
  for (const Index node : body.nodes)
    add_mass(tensor, fields.mass[node], fields.inertia[node], fields.position[node] - body.centre);
  set_inertia(body, tensor, fields);
  return body;
}

Index add_body(Domain& domain, RigidBody body) {
  NodeFields& nodes = domain.nodes;
  const auto place = static_cast<Index>(domain.rigid_bodies.size());
  domain.body_of_node.resize(static_cast<std::size_t>(nodes.count()), no_index);
  hold_fixed(body);
  body.spin = body.angular_velocity = spin_of(body, body.turn, body.angular_momentum);
  if (any(body.held_rotation)) body.angular_momentum = inertia_tensor(body, body.turn) * body.spin;
  body.kinetic_energy =
      0.5 * (body.mass * dot(body.velocity, body.velocity) + dot(body.spin, body.angular_momentum));
  for (const Index node : body.nodes) {
    domain.body_of_node[node] = place;
    nodes.fixed[node] |= domain::moved_by_body;
    nodes.velocity[node] = velocity_at(body, nodes.position[node] - body.centre);
    nodes.angular_velocity[node] = body.spin;
    nodes.publish(node);
  }
  domain.rigid_bodies.push_back(std::move(body));
  return place;
}

void release_body(Domain& domain, Index body) {
  RigidBody& released = domain.rigid_bodies[body];
  released.active = false;
  released.kinetic_energy = 0;
  for (const Index node : released.nodes) {
    domain.nodes.fixed[node] &= static_cast<std::uint8_t>(~domain::moved_by_body);
    domain.body_of_node[node] = no_index;
  }
}

RigidBodies::RigidBodies(const model::Model& model, Domain& domain) {
  const auto in_domain = [&](const std::vector<Index>& nodes) {
    std::vector<Index> found;
    found.reserve(nodes.size());
    for (const Index node : nodes) found.push_back(domain.nodes.domain_node[node]);
    std::sort(found.begin(), found.end());
    return found;
  };
  for (const model::RigidBody& given : model.rigid_bodies) {
    std::vector<Index> nodes = in_domain(given.nodes);
    RigidBody body;
    if (given.inertia && !given.inertia->velocity_from_nodes) {
      body.id = given.id;
      body.nodes = std::move(nodes);
    } else {
      body = body_of_nodes(domain, given.id, std::move(nodes));
    }
    if (!given.parts.empty()) body.part = given.parts.front();
    body.fixed_translation = given.fixed_translation;
    body.fixed_rotation = given.fixed_rotation;
    for (std::size_t axis = 0; axis < 3; ++axis) body.held_axes.column[axis] = to_vec3(given.held_axes[axis]);
    body.has_given_inertia = given.inertia.has_value();
    if (given.inertia) {
      take_given_inertia(*given.inertia, in_domain(given.added_nodes), domain, body);
      share_of_masses_.resize(domain.rigid_bodies.size() + 1, 1.0);
      share_of_masses_.back() = share_of_masses(body, domain.nodes);
    }
    if (given.initial_motion) {
      body.velocity = to_vec3(given.initial_motion->velocity);
      body.angular_momentum =
          inertia_tensor(body, body.turn) * to_vec3(given.initial_motion->angular_velocity);
    }
    add_body(domain, std::move(body));
  }
}

void RigidBodies::weigh(Domain& domain) const {
  for (std::size_t i = 0; i < share_of_masses_.size(); ++i) {
    const RigidBody& body = domain.rigid_bodies[i];
    if (!body.active || share_of_masses_[i] >= 1) continue;
    for (const Index node : body.nodes) domain.contact_weight[node] /= share_of_masses_[i];
  }
}

void RigidBodies::kick(Domain& domain, double interval) const {
  for (RigidBody& body : domain.rigid_bodies)
    if (body.active) kick_body(domain, body, interval);
}

void RigidBodies::carry_nodes(Domain& domain, double interval, double next_step) const {
  NodeFields& nodes = domain.nodes;
  for (RigidBody& body : domain.rigid_bodies) {
    if (!body.active) continue;
    book_energy(domain, body, interval);
    turn_over_step(body, next_step);
    const Matrix3 axes = math::matrix_of(body.next_turn);
    const auto count = static_cast<Index>(body.nodes.size());
    parallel_for(pieces(count, piece), domain.execution.threads, [&](Index p) {
      for (Index i = p * piece; i < std::min((p + 1) * piece, count); ++i) {
        const Index node = body.nodes[i];
        const Vec3 mean_arm = 0.5 * ((nodes.position[node] - body.centre) + axes * body.arm[i]);
        const Vec3 velocity = body.velocity + cross(body.angular_velocity, mean_arm);
        if (keep_acceleration_) nodes.acceleration[node] = (1 / interval) * (velocity - nodes.velocity[node]);
        nodes.velocity[node] = velocity;
        nodes.angular_velocity[node] = body.angular_velocity;
      }
    });
  }
}

double RigidBodies::place_nodes(Domain& domain) const {
  NodeFields& nodes = domain.nodes;
  double largest = 0;
  std::vector<double> moved;
  for (RigidBody& body : domain.rigid_bodies) {
    if (!body.active) continue;
    body.centre += domain.clock.step * body.velocity;
    body.turn = body.next_turn;
    const Matrix3 axes = math::matrix_of(body.turn);
    const auto count = static_cast<Index>(body.nodes.size());
    moved.assign(pieces(count, piece), 0);
    parallel_for(pieces(count, piece), domain.execution.threads, [&](Index p) {
      for (Index i = p * piece; i < std::min((p + 1) * piece, count); ++i) {
        const Index node = body.nodes[i];
        const Vec3 drifted = nodes.position[node];
        nodes.position[node] = body.centre + axes * body.arm[i];
        moved[p] = std::max(moved[p], norm(nodes.position[node] - drifted));
        nodes.publish(node);
      }
    });
    for (const double way : moved) largest = std::max(largest, way);
  }
  return largest;
}

double RigidBodies::kinetic_energy(const Domain& domain) {
  double sum = 0;
  for (const RigidBody& body : domain.rigid_bodies)
    if (body.active) sum += body.kinetic_energy;
  return sum;
}

}  // namespace crumple::constraints
