// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "contact/enforcement/penalty.hpp"
#include "contact/enforcement/raised_point.hpp"
#include "contact/surface/height_now.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 64;

/// By how many touches or places data are asked for before they are needed. In a large model they come from
/// memory.
constexpr std::size_t ahead = 8;

/// Calls ask(place) for the nodes of a touch soon after `i`.
template <class Ask>
void ask_after(std::size_t i, std::span<const Touch> touches, const Ask& ask) {
  if (i + ahead >= touches.size()) return;
  const Touch& touch = touches[i + ahead];
  for (int k = 0; k < touch.nodes; ++k) ask(touch.place[k]);
}

/// Factor on the force because contact begins and ends within steps. `square`: omega^2 that the touch is
/// expected to have where it begins; where it goes on, its acceleration in the last step tells.
double factor_in_step(const PenaltyMemory& before, const PenaltyMemory& now, const Steps& steps,
                      double square) {
  const double step = steps.last;
  const double travel = std::fabs(now.speed) * step;
  if (travel <= 0) return 1;
  if (before.slope_limit <= 0)
    return now.speed < 0 ? landing_factor(now.depth / travel, square * step * step, steps.next / step) : 1;
  if (now.speed < 0 || before.depth <= 0) return 1;
  return leaving_factor(now.depth / travel,
                        std::clamp((now.speed - before.speed) * step / before.depth, 0.0, 1.0));
}

/// SLSFAC times SFS, the larger of SFS and SFM where there are two sides.
double stiffness_scale(const model::Contact& contact, const model::Control& control) {
  double scale = contact.side[0].stiffness_scale;
  if (contact.kind != model::ContactKind::SingleSurface)
    scale = std::max(scale, contact.side[1].stiffness_scale);
  return control.contact_stiffness_scale * scale;
}

/// True for a touch of two edges, or of two segments, with as many nodes each.
bool has_equal_halves(const Touch& touch) {
  const int half = touch.nodes / 2;
  return half > 1 && touch.nodes == 2 * half && touch.weight[half - 1] > tolerances::no_weight &&
         touch.weight[half] < 0;
}

/// What the normal force does to the nodes beyond the weights where its points are above their segments: it
/// turns them.
void add_turning(std::span<const Vec3> x, Touch& touch) {
  const auto first = static_cast<std::size_t>(std::count_if(
      touch.weight.begin(), touch.weight.begin() + touch.nodes, [](double w) { return w > 0; }));
  const auto add = [&](std::size_t begin, std::size_t end, double height, const Vec3& force) {
    if (height == 0) return;
    const std::array<Vec3, 4> forces = turning_forces(x.subspan(begin, end - begin), height, force);
    for (std::size_t i = begin; i < end; ++i) touch.couple[i] += forces[i - begin];
  };
  add(0, first, touch.height[0], touch.normal_force);
  add(first, x.size(), touch.height[1], -touch.normal_force);
}

}  // namespace

Forces::Forces(const Surface& surface, const model::Contact& contact, const model::Control& control)
    : surface_(&surface),
      sums_(surface, contact.viscous_damping > 0),
      contact_(contact),
      stiffness_scale_(stiffness_scale(contact, control)),
      step_scale_(control.step_scale) {
  share_step(step_scale_);
}

/// Where the motion of the surfaces bounds the step more than the elements do, these use less of what is
/// stable, and contact may have more: as if the deck had asked for that step. `share`: of what the elements
/// allow.
void Forces::share_step(double share) {
  step_share_ = share;
  const double damping = damping_factor(contact_.viscous_damping);
  budget_ = stability_budget(share, stiffness_scale_) * damping;
  largest_budget_ = stability_budget(share) * damping;
}

void Forces::bound_step(const domain::Domain& domain, double bound) {
  const double allowed = step_scale_ * domain.clock.element_limit;
  const double share = bound < allowed ? bound / allowed * step_scale_ : step_scale_;
  if (share != step_share_) share_step(share);
}

/// Stability is judged by the larger of the last step and of what is allowed now, where it is not known that
/// the next one is shorter.
void Forces::set_steps(const domain::Clock& clock, double next) {
  steps_.last_kick = last_kick_ > 0 ? last_kick_ : clock.step;
  steps_.last = clock.step;
  const bool known = next < clock.step;
  steps_.next = known ? next : clock.step;
  steps_.kick = 0.5 * (steps_.last + steps_.next);
  steps_.judged = known ? steps_.kick : std::max(clock.step, step_share_ * clock.element_limit);
  next_kick_ = known ? steps_.kick : 0;
}

void Forces::evaluate(const domain::Domain& domain, std::span<Touch> touches, double next_step) {
  set_steps(domain.clock, next_step);
  const auto count = static_cast<Index>(touches.size());
  outcomes_.assign(static_cast<std::size_t>(pieces(count, piece)), {});
  parallel_for(pieces(count, piece), domain.execution.threads, [&](Index part) {
    for (Index i = part * piece; i < std::min((part + 1) * piece, count); ++i) {
      ask_after(i, touches, [&](Index place) {
        const Index node = surface_->nodes[place];
        prefetch<false>(&domain.nodes.mass[node], 1);
        prefetch<false>(&domain.nodes.position[node], 1);
        prefetch<false>(&domain.nodes.velocity[node], 1);
        prefetch<false>(&domain.contact_weight[node], 1);
      });
      evaluate_touch(domain, touches[i], outcomes_[part]);
    }
  });
  limited_ = 0;
  longest_step_ = std::numeric_limits<double>::infinity();
  for (const Outcome& outcome : outcomes_) {
    limited_ += outcome.limited;
    longest_step_ = std::min(longest_step_, outcome.step);
  }
}

/// 1/m* of the touch, each node lending its mass in proportion to the weights of the touches that act on it:
/// a spring of stiffness k then has omega^2 <= k / m* in the assembled system (docs/theory/contact.md)
/// [1/mass].
double Forces::inverse_mass(const domain::Domain& domain, const Touch& touch) const {
  double sum = 0;
  for (int i = 0; i < touch.nodes; ++i) {
    const double weight = touch.weight[i];
    const Index node = surface_->nodes[touch.place[i]];
    sum += weight * weight * domain.contact_weight[node] / (lent_weight(weight) * domain.nodes.mass[node]);
  }
  return sum;
}

/// 1/m* of the touch with the whole masses of the nodes [1/mass].
double Forces::whole_inverse_mass(const domain::NodeFields& nodes, const Touch& touch) const {
  double sum = 0;
  for (int i = 0; i < touch.nodes; ++i)
    sum += touch.weight[i] * touch.weight[i] / nodes.mass[surface_->nodes[touch.place[i]]];
  return sum;
}

/// Of SOFT = 1: 1/2 SOFSCL m* / dt^2 with the whole masses of the nodes. Of SOFT = 2: 1/2 SLSFAC SFS m1 m2 /
/// (m1 + m2) / dt^2, with the masses of the segments, which are those of their nodes (LS-DYNA Keyword User's
/// Manual, *CONTACT, optional card A) [force/length].
double Forces::stiffness_by_mass(const domain::NodeFields& nodes, const Touch& touch, double step) const {
  if (step <= 0) return 0;
  std::array<double, 2> mass{};
  for (int i = 0; i < touch.nodes; ++i) {
    const double weight = touch.weight[i];
    const double own = nodes.mass[surface_->nodes[touch.place[i]]];
    mass[weight > 0 ? 0 : 1] += std::fabs(weight) * own;
  }
  if (mass[0] + mass[1] <= 0) return 0;
  const double unit = 0.5 / (step * step);
  return contact_.mass_stiffness ? unit * stiffness_scale_ * mass[0] * mass[1] / (mass[0] + mass[1])
                                 : unit * contact_.soft_scale / whole_inverse_mass(nodes, touch);
}

/// The stiffness before stability limits it. What masses and steps give a touch keeps while it lasts, and
/// what the faces of a node of solids give: a slope that changed as the body turns would have no potential.
/// Only where the touch began with faces that hardly met the other surface does it change.
double Forces::stiffness(const domain::NodeFields& nodes, Touch& touch, double step) const {
  double& kept = touch.penalty.stiffness;
  const bool turns = touch.turning_stiffness > 0;
  if (!contact_.mass_stiffness && contact_.soft_scale <= 0) {
    if (!turns) return touch.stiffness;
    if (touch.turning_stiffness > tolerances::regained_stiffness * kept) kept = touch.turning_stiffness;
    return std::min(kept, touch.stiffness);
  }
  if (kept <= 0) {
    kept = stiffness_by_mass(nodes, touch, step);
    if (turns && !contact_.mass_stiffness)
      kept = std::max(kept, std::min(touch.turning_stiffness, touch.stiffness));
  }
  return turns || contact_.mass_stiffness ? kept : std::max(touch.stiffness, kept);
}

/// Penetration beyond the rest depth at which a spring that now has `force` will have stopped its points
/// [length].
double depth_ahead(double depth, double speed, double force, double inverse) {
  return force > 0 ? std::sqrt(depth * depth + speed * speed * depth / (force * inverse)) : depth;
}

/// The rest depth at a penetration, where the points parted by `apart` in the last step. A penetration that
/// falls without such a motion, as where the touch passes to another place, takes the rest depth along
/// [length].
double rest_depth_left(const PenaltyMemory& before, double penetration, double apart) {
  const double expected = std::max(0.0, before.depth - apart);
  return std::clamp(penetration - expected, 0.0, std::min(before.rest_depth, penetration));
}

/// What a touch has before it is too deep. Behind the face of a solid that goes by the height that the solid
/// has now, and so it does where the node is of one that is crushed: foam between hard faces ends as a
/// fraction of what it was.
Forces::Room Forces::room_of(const domain::NodeFields& nodes, const Touch& touch) const {
  const bool has_middle = touch.reach < std::numeric_limits<double>::max();
  const double most =
      has_middle ? tolerances::bounds_step * touch.reach : tolerances::bounds_step_in_solid * touch.most;
  Room room{std::numeric_limits<double>::max(), most};
  if (touch.segment == no_index) return room;
  const auto keep_within = [&](double stiffens, double bounds_step) {
    room.most = std::min(room.most, bounds_step);
    room.stiffens = std::min({room.stiffens, stiffens, room.most});
  };
  const auto see_crushable = [&](Index segment) {
    if (surface_->crushable[segment] == 0) return;
    const double height = height_now(*surface_, nodes, segment);
    keep_within(tolerances::stiffens_in_crushable * height, tolerances::bounds_step_in_crushable * height);
  };
  if (surface_->some_crushable && touch.penetration > tolerances::far_from_room_in_crushable * touch.most) {
    see_crushable(touch.segment);
    for (const Index own : surface_->topology.at_node(touch.place[0])) see_crushable(own);
  }
  if (surface_->of_solid[touch.segment] != 0 && touch.penetration > tolerances::far_from_room * touch.most) {
    const double half = tolerances::deepest_in_solid * height_now(*surface_, nodes, touch.segment);
    keep_within(tolerances::bounds_step_in_solid * half, tolerances::bounds_step_in_solid * half);
  }
  return room;
}

/// After its law has changed the spring of a touch holds the energy that it held, from a deeper rest depth
/// on.
void Forces::keep_energy(Touch& touch, const PenaltyLaw& law) const {
  PenaltyMemory& now = touch.penalty;
  const double depth = touch.penetration - now.rest_depth;
  // A linear spring holds 1/2 k x(n-1) x(n) between two steps: what it would hold in the middle, less this.
  const double half = -0.5 * now.speed * steps_.last;
  const double more = depth > 0 ? 0.5 * half * half * law.force(depth) / depth : 0;
  const double middle = law.penetration_of(std::max(0.0, now.energy) + more, depth);
  now.rest_depth = touch.penetration - std::min(depth, half + middle);
}

/// The stiffness with which a spring that holds `energy` stops its points within `left`. Where there is
/// nothing left, or much is missing, it grows from step to step [force/length].
double stiffness_within(double left, double stiffness, double energy, double speed, double inverse) {
  const double most = tolerances::stiffness_growth * stiffness;
  if (left <= 0) return most;
  const double root = (std::sqrt(2 * energy + speed * speed / inverse) - std::sqrt(2 * energy)) / left;
  return std::max(most, root * root);
}

/// Where a touch is heading too deep it gets a larger stiffness than the undeformed surfaces or the masses
/// gave it, up to what stability allows. Where that limits its slope, it gets what the present step allows,
/// though it began with less, and asks for a shorter step if that does not do either.
void Forces::hold_depth(const domain::NodeFields& nodes, Touch& touch, PenaltyLaw& law, double inverse,
                        Outcome& outcome) const {
  PenaltyMemory& now = touch.penalty;
  const double step = steps_.judged;
  if (step <= 0 || now.speed >= 0) return;
  const Room room = room_of(nodes, touch);
  const auto heading = [&] {
    const double depth = touch.penetration - now.rest_depth;
    return touch.penetration - depth + depth_ahead(depth, now.speed, law.force(depth), inverse);
  };
  if (heading() <= std::min(room.stiffens, room.most)) return;
  const double allowed = std::max(law.limit, budget_ / (step * step * inverse));
  const bool far = heading() > room.most;
  if (law.is_limited_at(touch.penetration - now.rest_depth)) {
    if (allowed > law.limit) {
      law.limit = allowed;
      keep_energy(touch, law);
    }
  } else if (heading() > room.stiffens) {
    law.stiffness = now.raised =
        std::min(allowed, stiffness_within((far ? room.most : room.stiffens) - touch.penetration,
                                           law.stiffness, std::max(0.0, now.energy), now.speed, inverse));
    law.limit = std::max(law.limit, law.stiffness);
    keep_energy(touch, law);
  } else {
    return;
  }
  now.slope_limit = law.limit;
  if (far) outcome.step = std::min(outcome.step, step * std::min(1.0, room.most / heading()));
}

/// Writes the forces of a touch, and adds to what is known of all.
void Forces::evaluate_touch(const domain::Domain& domain, Touch& touch, Outcome& outcome) const {
  if (touch.penetration <= 0) {
    touch.friction = touch.normal_force = Vec3{};
    touch.penalty = {};
    return;
  }
  const domain::NodeFields& nodes = domain.nodes;
  const double inverse = inverse_mass(domain, touch);
  const double step = steps_.judged;
  Vec3 relative;
  for (int i = 0; i < touch.nodes; ++i)
    relative += touch.weight[i] * nodes.velocity[surface_->nodes[touch.place[i]]];
  const PenaltyMemory before = touch.penalty;
  touch.penalty.slope_limit = slope_limit(before, inverse, step);
  touch.penalty.energy = before.energy - 0.5 * steps_.last_kick * before.force * touch.last_speed;
  touch.penalty.speed = dot(relative, touch.normal);
  touch.penalty.rest_depth = rest_depth_left(before, touch.penetration, touch.penalty.speed * steps_.last);
  PenaltyLaw law;
  law.stiffness = std::max(stiffness(nodes, touch, step), before.raised);
  law.limit = touch.penalty.slope_limit;
  law.reach = touch.reach;
  hold_depth(nodes, touch, law, inverse, outcome);
  touch.penalty.depth = touch.penetration - touch.penalty.rest_depth;
  const double stiffness = std::min(law.stiffness, law.limit);
  const double factor = factor_in_step(before, touch.penalty, steps_, stiffness * inverse);
  const double damping = 2 * contact_.viscous_damping * std::sqrt(stiffness / inverse);
  const double acting = touch.share * touch.fade;
  const double wanted = acting * factor * law.force(touch.penalty.depth);
  const double spring = passive_spring_force(nodes, before, touch, wanted, inverse);
  // Damping may take the force down to zero, but never pulls.
  const double size = std::max(0.0, spring - acting * damping * touch.penalty.speed);

  touch.normal_force = size * touch.normal;
  touch.damping = size - spring;
  add_friction(domain, touch, law.stiffness, inverse);
  if (law.limit < law.stiffness) ++outcome.limited;
}

/// Force of the contact spring, limited so that the spring never returns more energy than it has absorbed
/// (passivity). The energy is integrated by the trapezoidal rule. Without the limit a penetration that grows
/// without an approach (another point of the surface becomes the nearest, a share grows, a node changes
/// sides) would create energy [force].
double Forces::passive_spring_force(const domain::NodeFields& nodes, const PenaltyMemory& before,
                                    Touch& touch, double wanted, double inverse) const {
  PenaltyMemory& now = touch.penalty;
  const double step = steps_.judged;
  double energy = now.energy;
  if (before.slope_limit <= 0 && touch.starts_loaded)
    energy = std::max(energy, 0.5 * wanted * touch.penetration);
  now.force = wanted;
  now.most_energy = std::max(before.most_energy, energy);
  if (step > 0 && !touch.has_potential) {
    const double held = energy + tolerances::passivity * now.most_energy;
    double most = passive_force(held, now.speed, inverse, step);
    // Separating points move with their whole masses. The masses shared among touches would cut the force in
    // the last steps of an impact.
    if (most < wanted && now.speed > 0)
      most = passive_force(held, now.speed, whole_inverse_mass(nodes, touch), step);
    touch.withheld = std::max(0.0, wanted - most);
    now.force = std::min(wanted, most);
  }
  now.energy = energy - 0.5 * steps_.kick * now.force * now.speed;
  now.most_energy = std::max(now.most_energy, now.energy);
  return now.force;
}

/// A touch keeps the limit with which it began, as a slope that changes under load makes or eats energy,
/// until that is too much beside the others that have come [force/length].
double Forces::slope_limit(const PenaltyMemory& before, double inverse, double step) const {
  if (step <= 0) return std::numeric_limits<double>::max();
  const double unit = 1 / (step * step * inverse);
  return before.slope_limit > 0 ? std::min(before.slope_limit, largest_budget_ * unit) : budget_ * unit;
}

/// What a normal force that uses `used` of (omega dt)^2 leaves to friction.
double Forces::friction_budget(double used) const {
  return budget_ *
         std::clamp(std::max(tolerances::budget_with_friction, largest_budget_ / budget_) - used / budget_,
                    tolerances::least_friction_budget, 1.0);
}

/// Friction acts at the two points, which are an arm apart: the nodes of the second take the couple of the
/// two as well, so that the moment of momentum is kept, and a touch that sticks feels no work where both turn
/// together. The same goes for a face that pushes straight out beyond its rim.
void Forces::add_friction(const domain::Domain& domain, Touch& touch, double stiffness,
                          double inverse) const {
  const domain::NodeFields& nodes = domain.nodes;
  const model::Friction law = contact_.friction_between(touch.part[0], touch.part[1]);
  const bool rough = law.acts();
  std::array<Vec3, Touch::most_nodes> x;
  Vec3 arm;
  for (int i = 0; i < touch.nodes; ++i) {
    x[i] = nodes.position[surface_->nodes[touch.place[i]]];
    arm += touch.weight[i] * x[i];
  }
  const double size = norm(touch.normal_force);
  if (!rough) {
    touch.friction = Vec3{};
    const bool bears =
        touch.is_raised() || norm(cross(arm, touch.normal_force)) > tolerances::no_moment * norm(arm) * size;
    if (!bears) return;
  }
  const int first = first_bearing(touch);
  const Couple couple({&x[first], static_cast<std::size_t>(touch.nodes - first)},
                      has_equal_halves(touch) ? Couple::Bearing::EachHalf : Couple::Bearing::All);
  if (rough) {
    double lightest = 0;
    for (int i = first; i < touch.nodes; ++i) {
      const Index node = surface_->nodes[touch.place[i]];
      lightest =
          std::max(lightest, domain.contact_weight[node] / (lent_weight(touch.weight[i]) * nodes.mass[node]));
    }
    const double turning = couple.largest_square(arm) * lightest;
    const double step = steps_.judged;
    if (step > 0)
      stiffness = std::min(stiffness, friction_budget(touch.penalty.slope_limit * step * step * inverse) /
                                          (step * step * (inverse + turning)));
    touch.friction = friction(law, touch, size, touch.share * touch.fade * stiffness, domain.clock.step);
  }
  // Where the points are above their segments the normal force has no moment.
  touch.couple = couple.forces(-cross(arm, touch.is_raised() ? touch.friction : touch.force()));
  if (touch.is_raised()) add_turning({x.data(), static_cast<std::size_t>(touch.nodes)}, touch);
}

/// Coulomb friction by a tangential spring that gives way at mu f: sticks below, slips above
/// (Hallquist, LS-DYNA Theory Manual, friction of sliding interfaces).
Vec3 Forces::friction(const model::Friction& law, const Touch& touch, double normal_force, double stiffness,
                      double step) {
  const auto tangential = [&](const Vec3& a) { return a - dot(a, touch.normal) * touch.normal; };
  const Vec3 slip = tangential(touch.slip);
  const double more = law.at_rest - law.when_sliding;
  double mu = law.when_sliding;
  if (more != 0) {
    const double speed = step > 0 ? norm(slip) / step : 0.0;
    mu += more * decay(law.decay * speed);
  }
  const Vec3 trial = tangential(touch.friction) - stiffness * slip;
  const double size = norm(trial);
  double capacity = mu * normal_force;
  if (law.stress > 0) capacity = std::min(capacity, law.stress * touch.area);
  return size > capacity ? capacity / size * trial : trial;
}

}  // namespace crumple::contact
