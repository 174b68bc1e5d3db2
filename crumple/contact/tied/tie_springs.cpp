// SPDX-License-Identifier: BSD-3-Clause
#include "contact/tied/tie_springs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "contact/enforcement/penalty.hpp"
#include "contact/surface/segment_shape.hpp"
#include "contact/tied/cohesive_law.hpp"
#include "contact/tied/node_rotation.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 64;

double largest_coordinate(const Vec3& x) {
  return std::max({std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
}

double power(double ratio, double exponent) {
  return exponent == 2 ? ratio * ratio : exponent == 1 ? ratio : std::pow(ratio, exponent);
}

SegmentShape shape_of(const domain::NodeFields& nodes, const domain::TiedNode& tied) {
  SegmentShape shape;
  for (std::size_t k = 0; k < 4; ++k) shape.corner[k] = nodes.position[tied.corner[k]];
  return shape;
}

Vec3 spin_of(const domain::NodeFields& nodes, const domain::TiedNode& tied) {
  Vec3 spin;
  for (std::size_t k = 0; k < 4; ++k) spin += tied.weight[k] * nodes.angular_velocity[tied.corner[k]];
  return spin;
}

/// By how much a corner that moves moves the end of the spring at most: its weight plus the height times the
/// opposite diagonal over twice the segment's area [-].
std::array<double, 4> gains(const domain::NodeFields& nodes, const domain::TiedNode& tied) {
  const SegmentShape shape = shape_of(nodes, tied);
  const Vec3 first = shape.corner[2] - shape.corner[0];
  const Vec3 second = shape.corner[3] - shape.corner[1];
  const double lever = std::fabs(tied.height) / norm(cross(first, second));
  std::array<double, 4> found{};
  for (std::size_t k = 0; k < 4; ++k)
    found[k] = std::fabs(tied.weight[k]) + lever * norm(k % 2 == 0 ? second : first);
  return found;
}

/// Over the springs by penalty.
SpringSums sum_springs(const domain::Domain& domain) {
  SpringSums sums{std::vector<double>(static_cast<std::size_t>(domain.nodes.count()), 0.0),
                  std::vector<Index>(domain.rigid_bodies.size(), 0)};
  for (const domain::Tie& tie : domain.ties) {
    for (const domain::TiedNode& tied : tie.nodes) {
      if (tied.follows) continue;
      const std::array<double, 4> gain = gains(domain.nodes, tied);
      sums.at_node[tied.node] += 1;
      for (std::size_t k = 0; k < 4; ++k) sums.at_node[tied.corner[k]] += gain[k];
      if (const Index body = body_of(domain, tied.corner[0]); body != no_index) ++sums.at_body[body];
    }
  }
  return sums;
}

/// Inertia that a moment on a corner meets: of the node the part that it lends to a spring with that gain, or
/// that of the rigid body about its weakest axis over the number of springs there [mass * length^2].
double lent_inertia(const domain::Domain& domain, const SpringSums& sums, Index corner, double gain) {
  const Index body = body_of(domain, corner);
  if (body == no_index) return domain.nodes.inertia[corner] * gain / sums.at_node[corner];
  const Vec3& principal = domain.rigid_bodies[body].principal_inertia;
  return std::min({principal.x, principal.y, principal.z}) / sums.at_body[body];
}

/// True if one rigid body has all nodes.
bool in_one_body(const domain::Domain& domain, const domain::TiedNode& tied) {
  const Index body = body_of(domain, tied.node);
  return body != no_index && std::all_of(tied.corner.begin(), tied.corner.end(),
                                         [&](Index node) { return body_of(domain, node) == body; });
}

}  // namespace

TieSprings::TieSprings(const model::Model& model, const domain::Domain& domain, Index tie)
    : contact_(model.tied_contacts[tie]),
      tie_(tie),
      step_scale_(model.control.step_scale),
      budget_(tolerances::tie_budget * stability_budget(model.control.step_scale)) {
  const SpringSums sums = sum_springs(domain);
  const std::vector<domain::TiedNode>& nodes = domain.ties[tie].nodes;
  springs_.reserve(nodes.size());
  active_.reserve(nodes.size());
  for (std::size_t at = 0; at < nodes.size(); ++at) {
    const domain::TiedNode& tied = nodes[at];
    if (tied.follows) continue;
    Spring spring{.tied = tied, .at = at};
    spring.tied.stiffness *= tolerances::tie_over_contact_stiffness;
    set_limits(domain, sums, spring);
    springs_.push_back(spring);
    active_.push_back(in_one_body(domain, tied) ? 0 : 1);
  }
  loads_.resize(springs_.size());
  previous_.resize(springs_.size());
  turn_.resize(springs_.size());
  if (!contact_.softening) return;
  bedding_.resize(springs_.size());
  damage_.resize(springs_.size());
}

std::array<Index, TieSprings::ends> TieSprings::nodes_of(const Spring& spring) const {
  const auto& corner = spring.tied.corner;
  return {spring.tied.node, corner[0], corner[1], corner[2], corner[3]};
}

/// Bounds for stability. Each node lends its mass to its springs in proportion to their gains, as for contact
/// (docs/theory/contact.md): those that share no corner with weight take nothing from each other. Rotations
/// have the frequency of the spring.
void TieSprings::set_limits(const domain::Domain& domain, const SpringSums& sums, Spring& spring) const {
  const domain::NodeFields& nodes = domain.nodes;
  const domain::TiedNode& tied = spring.tied;
  const std::array<double, 4> gain = gains(nodes, tied);
  spring.inverse_mass = sums.at_node[tied.node] / nodes.mass[tied.node];
  bool turns = contact_.ties_rotations && nodes.inertia[tied.node] > 0;
  for (std::size_t k = 0; k < 4; ++k) {
    spring.inverse_mass += gain[k] * sums.at_node[tied.corner[k]] / nodes.mass[tied.corner[k]];
    if (tied.weight[k] != 0 && !has_rotation(domain, tied.corner[k])) turns = false;
  }
  if (!turns) return;
  spring.turning_stiffness = tied.stiffness * nodes.inertia[tied.node] / nodes.mass[tied.node];
  spring.inverse_inertia = sums.at_node[tied.node] / nodes.inertia[tied.node];
  for (std::size_t k = 0; k < 4; ++k)
    if (tied.weight[k] != 0)
      spring.inverse_inertia +=
          tied.weight[k] * tied.weight[k] / lent_inertia(domain, sums, tied.corner[k], gain[k]);
}

double TieSprings::share_of_strength(const Spring& spring, double tension, double shear) const {
  if (!contact_.failure) return 0;
  const model::TieFailure& failure = *contact_.failure;
  const double area = failure.by_stress ? spring.tied.area : 1.0;
  double share = 0;
  if (failure.normal_strength > 0)
    share += power(std::max(tension, 0.0) / (failure.normal_strength * area), failure.normal_exponent);
  if (failure.shear_strength > 0)
    share += power(shear / (failure.shear_strength * area), failure.shear_exponent);
  return share;
}

TieSprings::Place TieSprings::place_of(const domain::NodeFields& nodes, const domain::TiedNode& tied) {
  const SegmentShape shape = shape_of(nodes, tied);
  Place place;
  place.first = shape.corner[2] - shape.corner[0];
  place.second = shape.corner[3] - shape.corner[1];
  const Vec3 product = cross(place.first, place.second);
  place.size = norm(product);
  if (!(place.size > 0)) return place;
  place.normal = (1 / place.size) * product;
  place.away = nodes.position[tied.node] - tied.height * place.normal;
  for (std::size_t k = 0; k < 4; ++k) place.away -= tied.weight[k] * shape.corner[k];
  if (norm(place.away) <= tolerances::no_stretch * largest_coordinate(nodes.position[tied.node]))
    place.away = Vec3{};
  return place;
}

/// The stiffness of ties that soften is chosen once, as the energy that they take depends on it. Throws Error
/// where they could not soften with it.
void TieSprings::settle_stiffness(double step) {
  const model::TieSoftening& given = *contact_.softening;
  const CohesiveLaw law(*contact_.failure, given);
  for (std::size_t at = 0; at < springs_.size(); ++at) {
    const Spring& spring = springs_[at];
    const double area = spring.tied.area;
    const double wanted = given.stiffness > 0 ? given.stiffness * area : spring.tied.stiffness;
    const double largest = budget_ / (step * step * spring.inverse_mass * std::max(1.0, given.shear_ratio));
    bedding_[at] = std::min(wanted, largest);
    if (active_[at] == 0 || !(area > 0)) continue;
    const double bedding = bedding_[at] / area;
    const std::string mode = law.brittle_mode({bedding, given.shear_ratio * bedding});
    if (mode.empty()) continue;
    throw Error("Tied contact " + std::to_string(contact_.id) + " cannot soften in " + mode +
                ": its stiffness is " + std::to_string(bedding) + " (stress over length)" +
                (wanted > largest ? ", which is what the time step allows," : "") +
                " and with that it takes more up to its strength than its energy says, or opens further than "
                "PARAM. Raise " +
                (wanted > largest ? std::string("the energy or PARAM, lower the strength, or make the step "
                                                "shorter by TSSFAC.")
                                  : std::string("CN or the energy or PARAM, or lower the strength.")));
  }
}

double TieSprings::longest_step() const {
  double stiffest = 0;
  if (contact_.softening)
    for (std::size_t at = 0; at < springs_.size(); ++at)
      if (active_[at] != 0) stiffest = std::max(stiffest, bedding_[at] * springs_[at].inverse_mass);
  if (!(stiffest > 0)) return std::numeric_limits<double>::max();
  return std::sqrt(budget_ / (stiffest * std::max(1.0, contact_.softening->shear_ratio)));
}

TieSprings::Secant TieSprings::secant_of(std::size_t at, const Place& place, double limit) {
  const Spring& spring = springs_[at];
  if (!contact_.softening || bedding_[at] == 0) {
    const double stiffness = std::min(spring.tied.stiffness, limit / spring.inverse_mass);
    return {stiffness, stiffness};
  }
  const double normal = bedding_[at];
  const double shear = contact_.softening->shear_ratio * normal;
  const double opening = spring.tied.side * dot(place.away, place.normal);
  const double sliding = norm(place.away - dot(place.away, place.normal) * place.normal);
  const double area = spring.tied.area;
  damage_[at] = CohesiveLaw(*contact_.failure, *contact_.softening)
                    .damage(opening, sliding, {normal / area, shear / area}, damage_[at]);
  const double left = 1 - damage_[at];
  return {opening > 0 ? left * normal : normal, left * shear};
}

/// Of ties that hold rotations.
void TieSprings::add_moment(const domain::Domain& domain, std::size_t at, double limit, Load& load) {
  const Spring& spring = springs_[at];
  if (!(spring.turning_stiffness > 0)) return;
  const domain::NodeFields& nodes = domain.nodes;
  const Frame frame = frame_of(shape_of(nodes, spring.tied));
  const Vec3 spin = nodes.angular_velocity[spring.tied.node] - spin_of(nodes, spring.tied);
  turn_[at] += domain.clock.step * frame.to_local(spin);
  const double turning = std::min(spring.turning_stiffness, limit / spring.inverse_inertia);
  load.moment = -turning * frame.to_global(turn_[at]);
}

TieSprings::Load TieSprings::evaluate(const domain::Domain& domain, std::size_t at, double step) {
  const domain::TiedNode& tied = springs_[at].tied;
  const Place place = place_of(domain.nodes, tied);
  Load load;
  if (!(place.size > 0)) return load;
  const double limit = step > 0 ? budget_ / (step * step) : std::numeric_limits<double>::max();
  const Secant secant = secant_of(at, place, limit);
  const Vec3& normal = place.normal;
  const double more = (secant.normal - secant.shear) * dot(place.away, normal);
  Vec3 force = -secant.shear * place.away;
  if (more != 0) force -= more * normal;
  load.force[0] = force;
  for (std::size_t k = 0; k < 4; ++k) load.force[1 + k] = -tied.weight[k] * force;
  // The normal turns with the diagonals.
  const Vec3 tangential = force - dot(force, normal) * normal;
  Vec3 couple = (tied.height / place.size) * tangential;
  if (more != 0) couple += (more / place.size) * (place.away - dot(place.away, normal) * normal);
  const Vec3 on_first = cross(place.second, couple);
  const Vec3 on_second = cross(couple, place.first);
  load.force[3] -= on_first;
  load.force[1] += on_first;
  load.force[4] -= on_second;
  load.force[2] += on_second;
  load.opening = norm(place.away);
  load.share = contact_.softening
                   ? damage_[at]
                   : share_of_strength(springs_[at], -tied.side * dot(force, normal), norm(tangential));
  add_moment(domain, at, limit, load);
  return load;
}

bool TieSprings::ends_now(const domain::Domain& domain, const Spring& spring, bool look) const {
  return domain.clock.time >= contact_.death_time ||
         (look && domain::has_failed(domain, spring.tied.block, spring.tied.element));
}

/// Hands a load over to the nodes; returns the work on them since the last call.
double TieSprings::add(domain::Domain& domain, std::size_t at, const Load& load) {
  domain::NodeFields& nodes = domain.nodes;
  const Spring& spring = springs_[at];
  const domain::TiedNode& tied = spring.tied;
  const std::array<Index, ends> node = nodes_of(spring);
  double work = 0;
  for (std::size_t k = 0; k < ends; ++k) {
    work += dot(previous_[at].force[k] + load.force[k], nodes.velocity[node[k]]);
    for (int axis = 0; axis < 3; ++axis) nodes.force[node[k]].force[axis] += load.force[k][axis];
  }
  if (spring.turning_stiffness > 0) {
    const Vec3 spin = nodes.angular_velocity[tied.node] - spin_of(nodes, tied);
    work += dot(previous_[at].moment + load.moment, spin);
    for (int axis = 0; axis < 3; ++axis) {
      nodes.force[tied.node].moment[axis] += load.moment[axis];
      for (std::size_t k = 0; k < 4; ++k)
        nodes.force[tied.corner[k]].moment[axis] -= tied.weight[k] * load.moment[axis];
    }
  }
  previous_[at] = load;
  return 0.5 * domain.clock.step * work;
}

void TieSprings::add_forces(domain::Domain& domain) {
  const StageTimer timer(domain.times.contact_forces);
  domain::Tie& tie = domain.ties[tie_];
  const Index eroded = domain::eroded_elements(domain);
  const bool look = eroded != eroded_;
  eroded_ = eroded;
  const double step = std::max(domain.clock.step, step_scale_ * domain.clock.element_limit);
  const auto count = static_cast<Index>(springs_.size());
  // Springs without an area stay at zero.
  if (contact_.softening && step > 0 && std::ranges::none_of(bedding_, [](double k) { return k > 0; }))
    settle_stiffness(step);
  parallel_for(pieces(count, piece), domain.execution.threads, [&](Index part) {
    for (Index i = part * piece; i < std::min((part + 1) * piece, count); ++i)
      loads_[i] = active_[i] != 0 ? evaluate(domain, static_cast<std::size_t>(i), step) : Load{};
  });
  tie.opening = 0;
  double held = 0;
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    Load& load = loads_[i];
    if (active_[i] == 0 && previous_[i].opening == 0) continue;
    const bool breaks = load.share >= 1;
    if (active_[i] != 0 && (breaks || ends_now(domain, springs_[i], look))) {
      active_[i] = tie.holds[springs_[i].at] = 0;
      load = Load{};
      ++tie.released;
      if (breaks) ++tie.broken;
    }
    tie.energy -= add(domain, i, load);
    tie.force += load.force[0];
    tie.opening = std::max(tie.opening, load.opening);
    held += 0.5 * (norm(load.force[0]) * load.opening + norm(load.moment) * norm(turn_[i]));
  }
  if (contact_.softening || tie.released > 0) tie.dissipated = std::max(0.0, tie.energy - held);
}

void TieSprings::declare(domain::StateList& list) {
  list.add("tie_springs", "-", domain::Entity::Contact, 1, std::span(active_));
  list.add("tie_spring_loads", "by item", domain::Entity::Contact, 20, std::span(previous_));
  if (contact_.softening) {
    list.add("tie_spring_stiffness", "force/length", domain::Entity::Contact, 1, std::span(bedding_));
    list.add("tie_spring_damage", "-", domain::Entity::Contact, 1, std::span(damage_));
  }
  list.add("tie_spring_turns", "rad", domain::Entity::Contact, 3, std::span(turn_));
  list.keep("tie_spring_eroded", "-", domain::Entity::Contact, eroded_);
}

}  // namespace crumple::contact
