// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/nodal_sums.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "contact/surface/saved_state.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

bool is_zero(const Vec3& a) {
  return a.x == 0 && a.y == 0 && a.z == 0;
}

/// Damping that takes the whole force of the spring does work, too.
bool has_force(const Touch& touch) {
  return !is_zero(touch.normal_force) || !is_zero(touch.friction) || touch.damping != 0;
}

/// By how many places data are prefetched before they are needed. In a large model they come from memory.
constexpr std::size_t places_ahead = 8;

template <class Prefetch>
void prefetch_later(std::size_t i, std::span<const Index> places, const Prefetch& fetch) {
  if (i + places_ahead < places.size()) fetch(places[i + places_ahead]);
}

}  // namespace

double lent_weight(double weight) {
  return std::fabs(weight) + tolerances::borrowed_mass;
}

int first_bearing(const Touch& touch) {
  constexpr int least = 3;
  return touch.nodes > least && touch.weight[1] <= 0 ? 1 : 0;
}

NodalSums::NodalSums(const Surface& surface, bool is_damped) : surface_(&surface) {
  const std::size_t places = surface.nodes.size();
  marked_.resize(places);
  normal_.resize(places);
  friction_.resize(places);
  previous_normal_.resize(places);
  previous_friction_.resize(places);
  if (!is_damped) return;
  damping_.resize(places);
  previous_damping_.resize(places);
}

NodalSums::Power& NodalSums::Power::operator+=(const Power& other) {
  normal += other.normal;
  friction += other.friction;
  damping += other.damping;
  return *this;
}

void NodalSums::clear(domain::Domain& domain) const {
  for (std::size_t i = 0; i < active_.size(); ++i) {
    prefetch_later(i, active_,
                   [&](Index next) { prefetch<true>(&domain.contact_force[surface_->nodes[next]], 1); });
    domain.contact_force[surface_->nodes[active_[i]]] = Vec3{};
  }
}

void NodalSums::count(domain::Domain& domain, std::span<const Touch> touches) {
  const auto acts = [](const Touch& touch) { return touch.penetration > 0; };
  dealt_.deal(touches, surface_->node_count(), domain.execution.threads, acts);
  is_dealt_ = true;
  parallel_for(dealt_.shares(), dealt_.shares(), [&](Index share) {
    dealt_.for_each(
        share, touches,
        [&](Index place) { prefetch<true>(&domain.contact_weight[surface_->nodes[place]], 1); },
        [&](const Touch& touch, int k) {
          if (acts(touch))
            domain.contact_weight[surface_->nodes[touch.place[k]]] += lent_weight(touch.weight[k]);
        });
  });
}

void NodalSums::add(domain::Domain& domain, std::span<const Touch> touches, domain::ContactReport& report) {
  if (!is_dealt_) dealt_.deal(touches, surface_->node_count(), domain.execution.threads, has_force);
  is_dealt_ = false;
  const Index count = dealt_.shares();
  if (shares_.size() < static_cast<std::size_t>(count)) shares_.resize(static_cast<std::size_t>(count));
  parallel_for(count, count, [&](Index share) {
    sum(domain, touches, share);
    measure_power(domain, share);
    hand_over(domain, share);
  });
  std::swap(previous_normal_, normal_);
  std::swap(previous_friction_, friction_);
  std::swap(previous_damping_, damping_);
  active_.clear();
  Power total;
  for (const Share& share : std::span(shares_).first(static_cast<std::size_t>(count))) {
    active_.insert(active_.end(), share.active.begin(), share.active.end());
    for (const Power& power : share.power) total += power;
  }
  report.energy -= 0.5 * domain.clock.step * total.normal;
  report.friction_energy -= 0.5 * domain.clock.step * total.friction;
  report.damping_energy -= 0.5 * domain.clock.step * total.damping;
}

/// Of the last call, those in the range of a share.
std::span<const Index> NodalSums::previous_places(Index share) const {
  const auto first = std::ranges::lower_bound(active_, dealt_.first_place(share));
  return {first, std::lower_bound(first, active_.end(), dealt_.first_place(share + 1))};
}

void NodalSums::sum(domain::Domain& domain, std::span<const Touch> touches, Index share) {
  std::vector<Index>& active = shares_[share].active;
  active.clear();
  dealt_.for_each(
      share, touches,
      [&](Index place) {
        prefetch<true>(&normal_[place], 1);
        prefetch<true>(&friction_[place], 1);
        prefetch<true>(&marked_[place], 1);
        prefetch<true>(&domain.contact_weight[surface_->nodes[place]], 1);
      },
      [&](const Touch& touch, int k) {
        domain.contact_weight[surface_->nodes[touch.place[k]]] = 0;
        if (has_force(touch)) add_corner(touch, k, active);
      });
  std::ranges::sort(active);
}

/// Without friction the couple is that of the normal force.
void NodalSums::add_corner(const Touch& touch, int corner, std::vector<Index>& active) {
  const Index place = touch.place[corner];
  normal_[place] += touch.weight[corner] * touch.normal_force;
  friction_[place] += touch.weight[corner] * touch.friction;
  if (!damping_.empty()) damping_[place] += touch.weight[corner] * touch.damping * touch.normal;
  const int first = first_bearing(touch);
  if (corner >= first) (is_zero(touch.friction) ? normal_ : friction_)[place] += touch.couple[corner - first];
  if (marked_[place] != 0) return;
  marked_[place] = 1;
  active.push_back(place);
}

/// Trapezoidal rule: the mean of the forces at both ends of the step, times the displacement between them.
void NodalSums::measure_power(const domain::Domain& domain, Index share) {
  auto& [active, both, power] = shares_[share];
  const std::span<const Index> previous = previous_places(share);
  both.clear();
  std::ranges::set_union(active, previous, std::back_inserter(both));
  power.resize(both.size());
  for (std::size_t i = 0; i < both.size(); ++i) {
    prefetch_later(i, both, [&](Index next) {
      prefetch<false>(&domain.nodes.velocity[surface_->nodes[next]], 1);
      prefetch<true>(&previous_normal_[next], 1);
      prefetch<true>(&previous_friction_[next], 1);
    });
    const Index place = both[i];
    const Vec3& v = domain.nodes.velocity[surface_->nodes[place]];
    power[i] = {dot(previous_normal_[place] + normal_[place], v),
                dot(previous_friction_[place] + friction_[place], v),
                damping_.empty() ? 0 : dot(previous_damping_[place] + damping_[place], v)};
  }
}

/// Adds the sums to the domain and clears the previous ones.
void NodalSums::hand_over(domain::Domain& domain, Index share) {
  const std::vector<Index>& active = shares_[share].active;
  for (std::size_t i = 0; i < active.size(); ++i) {
    prefetch_later(i, active, [&](Index next) {
      prefetch<true>(&domain.contact_force[surface_->nodes[next]], 1);
      prefetch<true>(&domain.nodes.force[surface_->nodes[next]], 1);
    });
    const Index place = active[i];
    const Index node = surface_->nodes[place];
    const Vec3 sum = normal_[place] + friction_[place];
    domain.contact_force[node] += sum;
    for (int axis = 0; axis < 3; ++axis) domain.nodes.force[node].force[axis] += sum[axis];
    marked_[place] = 0;
  }
  for (const Index place : previous_places(share)) {
    previous_normal_[place] = previous_friction_[place] = Vec3{};
    if (!damping_.empty()) previous_damping_[place] = Vec3{};
  }
}

void NodalSums::declare(domain::StateList& list) {
  list.add("contact_normal_force", "force", domain::Entity::Contact, 3, std::span(previous_normal_));
  list.add("contact_friction_force", "force", domain::Entity::Contact, 3, std::span(previous_friction_));
  if (!damping_.empty())
    list.keep_list("contact_damping_force", "force", domain::Entity::Contact, 3, previous_damping_);
  list.keep_list("contact_active_places", "-", domain::Entity::Contact, 1, active_);
}

void NodalSums::resume() const {
  const auto fits = [this](Index place) { return is_one_of(place, surface_->nodes.size()); };
  require_all_saved(active_, fits, "active nodes");
  require_saved(previous_damping_.size() == damping_.size(), "damping forces");
  const auto unordered = [](Index a, Index b) { return a >= b; };
  require_saved(std::ranges::adjacent_find(active_, unordered) == active_.end(), "active nodes");
}

}  // namespace crumple::contact
