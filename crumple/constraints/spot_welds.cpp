// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/spot_welds.hpp"

#include <algorithm>
#include <cmath>

#include "constraints/rigid_bodies.hpp"
#include "constraints/rigid_motion.hpp"

namespace crumple::constraints {

using domain::Domain;
using domain::RigidBody;
using math::Vec3;

namespace {

Vec3 force_on(const Domain& domain, Index node) {
  const double* const force = domain.nodes.force[node].force;
  return {force[0], force[1], force[2]};
}

Vec3 moment_on(const Domain& domain, Index node) {
  const double* const moment = domain.nodes.force[node].moment;
  return {moment[0], moment[1], moment[2]};
}

/// The force that a rigid body must put on one of its nodes, besides what else acts there, for the node to
/// follow it: m (a + alpha x r + omega x (omega x r)) - f.
Vec3 force_of_body(const Domain& domain, const RigidBody& body, Index node) {
  Vec3 force;
  Vec3 moment;
  for (const Index each : body.nodes) {
    force += force_on(domain, each);
    moment +=
        cross(domain.nodes.position[each] - body.centre, force_on(domain, each)) + moment_on(domain, each);
  }
  const Vec3& spin = body.spin;
  const Vec3 turning = spin_of(body, body.turn, moment - cross(spin, body.angular_momentum));
  const Vec3 arm = domain.nodes.position[node] - body.centre;
  const Vec3 acceleration = (1.0 / body.mass) * force + cross(turning, arm) + cross(spin, cross(spin, arm));
  return domain.nodes.mass[node] * acceleration - force_on(domain, node);
}

double power(double ratio, double exponent) {
  return exponent == 1 ? ratio : std::pow(ratio, exponent);
}

}  // namespace

SpotWelds::SpotWelds(const model::Model& model, Domain& domain) {
  const domain::NodeFields& nodes = domain.nodes;
  welds_.reserve(model.spot_welds.size());
  for (const model::SpotWeld& given : model.spot_welds) {
    Weld weld{given};
    if (given.nodes.size() == 2) {
      weld.first = nodes.domain_node[given.nodes[0]];
      weld.second = nodes.domain_node[given.nodes[1]];
    }
    std::vector<Index> members;
    members.reserve(given.nodes.size());
    for (const Index node : given.nodes) members.push_back(nodes.domain_node[node]);
    std::sort(members.begin(), members.end());
    weld.body = add_body(domain, body_of_nodes(domain, given.id, std::move(members)));
    welds_.push_back(std::move(weld));
    domain.welds.push_back({.id = given.id});
  }
  find_shells(domain);
}

void SpotWelds::find_shells(const Domain& domain) {
  const auto wanted = [](const Weld& weld) { return weld.limits.failure_strain > 0; };
  if (std::none_of(welds_.begin(), welds_.end(), wanted)) return;
  std::vector<std::vector<NearbyShell>> at_node(static_cast<std::size_t>(domain.nodes.count()));
  for (Index b = 0; b < static_cast<Index>(domain.shells.size()); ++b) {
    const domain::ShellBlock& block = domain.shells[b];
    if (block.find("plastic_strain") == nullptr) continue;
    for (Index place = 0; place < block.elements; ++place)
      for (const Index node : block.nodes_of(place)) {
        std::vector<NearbyShell>& shells = at_node[node];
        // A triangle repeats a node.
        if (shells.empty() || shells.back().block != b || shells.back().place != place)
          shells.push_back({b, place});
      }
  }
  for (Weld& weld : welds_)
    if (wanted(weld))
      for (const Index node : domain.rigid_bodies[weld.body].nodes) weld.around.push_back(at_node[node]);
}

double SpotWelds::plastic_strain(const Domain& domain, const std::vector<NearbyShell>& shells) {
  double sum = 0;
  Index count = 0;
  for (const NearbyShell& shell : shells) {
    const domain::ShellBlock& block = domain.shells[shell.block];
    const domain::StateItem& item = *block.find("plastic_strain");
    for (Index point = 0; point < item.count; ++point) sum += block.state(shell.place, item.first + point);
    count += item.count;
  }
  return count > 0 ? sum / count : 0;
}

bool SpotWelds::overloaded(const Domain& domain, const Weld& weld, domain::WeldReport& report) {
  const model::SpotWeld& limits = weld.limits;
  if (domain.clock.time >= limits.failure_time) return true;
  for (const std::vector<NearbyShell>& shells : weld.around)
    if (plastic_strain(domain, shells) > limits.failure_strain) return true;
  if (weld.first == no_index) return false;
  const Vec3 line = domain.nodes.position[weld.second] - domain.nodes.position[weld.first];
  const double length = norm(line);
  const Vec3 force = force_of_body(domain, domain.rigid_bodies[weld.body], weld.second);
  if (!(length > 0)) {
    report.shear = norm(force);
    return false;
  }
  const Vec3 direction = (1.0 / length) * line;
  report.axial = -dot(force, direction);
  report.shear = norm(force + report.axial * direction);
  double load = 0;
  if (limits.normal_strength > 0)
    load += power(std::max(report.axial, 0.0) / limits.normal_strength, limits.normal_exponent);
  if (limits.shear_strength > 0) load += power(report.shear / limits.shear_strength, limits.shear_exponent);
  return load >= 1;
}

void SpotWelds::break_overloaded(Domain& domain) const {
  for (std::size_t i = 0; i < welds_.size(); ++i) {
    const Weld& weld = welds_[i];
    domain::WeldReport& report = domain.welds[i];
    if (!domain.rigid_bodies[weld.body].active) continue;
    if (!overloaded(domain, weld, report)) continue;
    release_body(domain, weld.body);
    report = {.id = report.id, .axial = 0, .shear = 0, .broken = true, .failure_time = domain.clock.time};
  }
}

}  // namespace crumple::constraints
