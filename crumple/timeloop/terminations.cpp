// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/terminations.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::timeloop {

using domain::Domain;
using math::Vec3;
using model::Termination;

namespace {

constexpr double still_acts = -1;

bool out_of_bounds(const Termination& given, double value) {
  return value > given.most || value < given.least;
}

long eroded_elements(const Domain& domain, const std::vector<Index>& parts) {
  long sum = 0;
  for (const domain::ElementBlock* block : domain.blocks())
    if (std::find(parts.begin(), parts.end(), block->part) != parts.end()) sum += block->eroded;
  return sum;
}

/// Node and axis in words.
std::string sentence(const Termination& given) {
  static constexpr const char* axes[] = {"x", "y", "z"};
  const std::string id = std::to_string(given.id);
  const std::string axis = axes[std::max(given.axis, 0)];
  switch (given.kind) {
    case Termination::Kind::Place:
      return "node " + id + " has passed its bound along " + axis;
    case Termination::Kind::Touch:
      return "a contact acts on node " + id;
    case Termination::Kind::Displacement:
      return "rigid body " + id + " has passed its bound along " + axis;
    case Termination::Kind::Distance:
      return "rigid body " + id + " has moved as far as it may";
    case Termination::Kind::NoContact:
      return "contact " + id + " has no force any more";
    default:
      return "elements of part or set " + id + " have eroded";
  }
}

}  // namespace

Terminations::Terminations(const model::Model& model, const Domain& domain) : model_(&model) {
  for (const Termination& given : model.terminations) {
    const bool of_body =
        given.kind == Termination::Kind::Displacement || given.kind == Termination::Kind::Distance;
    start_.push_back(of_body ? domain.rigid_bodies[static_cast<std::size_t>(given.item)].centre : Vec3{});
    without_since_.push_back(still_acts);
  }
}

bool Terminations::holds(std::size_t which, const Domain& domain) {
  const Termination& given = model_->terminations[which];
  const auto item = static_cast<std::size_t>(given.item);
  switch (given.kind) {
    case Termination::Kind::Place:
      return out_of_bounds(given, domain.nodes.position[domain.nodes.domain_node[item]][given.axis]);
    case Termination::Kind::Touch: {
      const Vec3 force =
          domain.contact_force.empty() ? Vec3{} : domain.contact_force[domain.nodes.domain_node[item]];
      return dot(force, force) > 0;
    }
    case Termination::Kind::Displacement:
      return out_of_bounds(given, (domain.rigid_bodies[item].centre - start_[which])[given.axis]);
    case Termination::Kind::Distance:
      return norm(domain.rigid_bodies[item].centre - start_[which]) > given.most;
    case Termination::Kind::Deleted:
      return eroded_elements(domain, given.parts) >= given.count;
    default:
      break;
  }
  const Vec3& force = domain.contacts[item].force;
  const double size = given.axis < 0 ? norm(force) : std::fabs(force[given.axis]);
  const double time = domain.clock.time;
  double& since = without_since_[which];
  if (time < given.activation || size > given.threshold)
    since = still_acts;
  else if (since < 0)
    since = time;
  return since >= 0 && time - since >= given.duration;
}

void Terminations::observe(const Domain& domain) {
  for (std::size_t which = 0; which < start_.size(); ++which)
    if (holds(which, domain) && !met()) met_ = static_cast<Index>(which);
}

std::optional<std::string> Terminations::reason() const {
  if (!met()) return std::nullopt;
  return sentence(model_->terminations[static_cast<std::size_t>(met_)]);
}

void Terminations::declare(domain::StateList& list) {
  if (start_.empty()) return;
  list.keep_list("termination_without_contact", "time", domain::Entity::Run, 1, without_since_);
  list.keep("termination_met", "-", domain::Entity::Run, met_);
}

}  // namespace crumple::timeloop
