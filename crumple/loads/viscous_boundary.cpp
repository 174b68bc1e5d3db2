// SPDX-License-Identifier: BSD-3-Clause
#include "loads/viscous_boundary.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace crumple::loads {

using math::Matrix3;
using math::Vec3;

namespace {

constexpr Index nodes_at_once = 1024;

/// The matrix that projects on the directions in which a node is free.
Matrix3 free_directions(const domain::NodeFields& nodes, Index node) {
  Matrix3 free = math::unit_matrix();
  for (Vec3& column : free.column) column = nodes.free_translation(node, column);
  return free;
}

}  // namespace

ViscousBoundary::ViscousBoundary(const model::Model& model, const domain::Domain& domain,
                                 const std::vector<Impedance>& impedances)
    : model_(&model) {
  for (const model::ViscousSegment& given : model.viscous_segments) {
    const Index part = model.solids[given.solid].part;
    segments_.push_back(segment_of(domain, given, impedances[static_cast<std::size_t>(part)]));
  }
  list_corners();
  previous_.resize(nodes_.size());
  for (Index node = 0; node < model.nodes.count(); ++node) {
    const Index own = domain.nodes.domain_node[node];
    if (domain.nodes.is_tied(own) && std::binary_search(nodes_.begin(), nodes_.end(), own))
      throw Error(
          "Node " + std::to_string(model.nodes.id[node]) +
          " of a non-reflecting boundary is tied to a segment, which moves it: the boundary cannot act "
          "there. Leave its segments or the node out of one of the two.");
  }
}

ViscousBoundary::Segment ViscousBoundary::segment_of(const domain::Domain& domain,
                                                     const model::ViscousSegment& given,
                                                     const Impedance& impedance) {
  Segment segment;
  segment.node = domain_nodes(domain, given.node);
  segment.solid = given.solid;
  const auto count = static_cast<double>(corners(segment.node));
  if (given.normal) segment.normal = impedance.normal / count;
  if (given.tangential) segment.tangential = impedance.tangential / count;
  return segment;
}

void ViscousBoundary::list_corners() {
  std::vector<std::pair<Index, Index>> pairs;  // node and segment
  for (std::size_t i = 0; i < segments_.size(); ++i)
    for (std::size_t k = 0; k < corners(segments_[i].node); ++k)
      pairs.emplace_back(segments_[i].node[k], static_cast<Index>(i));
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [node, segment] : pairs) {
    if (nodes_.empty() || nodes_.back() != node) {
      nodes_.push_back(node);
      first_corner_.push_back(static_cast<Index>(corners_.size()));
    }
    corners_.push_back(segment);
  }
  first_corner_.push_back(static_cast<Index>(corners_.size()));
}

void ViscousBoundary::find_eroded(const domain::Domain& domain) {
  Index eroded = 0;
  for (const domain::SolidBlock& block : domain.solids) eroded += block.eroded;
  if (eroded == eroded_) return;
  eroded_ = eroded;
  gone_.assign(model_->solids.size(), 0);
  for (const domain::SolidBlock& block : domain.solids) {
    const domain::StateItem* const active = block.find("active");
    for (Index place = 0; place < block.elements; ++place)
      gone_[block.element[place]] = block.state(place, active->first) == 0 ? 1 : 0;
  }
}

/// Force on a node per velocity, the other way round [mass/time].
Matrix3 ViscousBoundary::resistance(const domain::Domain& domain, std::size_t place) const {
  Matrix3 sum{};
  for (Index corner = first_corner_[place]; corner < first_corner_[place + 1]; ++corner) {
    const Segment& segment = segments_[corners_[corner]];
    if (gone_[segment.solid] != 0) continue;
    const Vec3 normal = vector_area(domain, segment.node);
    const double area = norm(normal);
    if (!(area > 0)) continue;
    const double along = (segment.normal - segment.tangential) / area;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3& column = sum.column[static_cast<std::size_t>(axis)];
      column += along * normal[axis] * normal;
      column[axis] += segment.tangential * area;
    }
  }
  return sum;
}

/// None on a node that something else moves, a rigid body or a tie: its velocity after the step is not known,
/// and a force by that before would not be stable.
ViscousBoundary::Push ViscousBoundary::push_on(const domain::NodeFields& nodes, Index node,
                                               const Matrix3& resistance, double interval) {
  if (!(nodes.mass[node] > 0) || !nodes.is_free(node) || nodes.is_tied(node))
    return {Vec3{}, nodes.velocity[node]};
  const double half = 0.5 * interval / nodes.mass[node];
  const Matrix3 free = free_directions(nodes, node);
  const double* const force = nodes.force[node].force;
  Vec3 velocity = free * (nodes.velocity[node] + half * Vec3{force[0], force[1], force[2]});
  Matrix3 system = math::unit_matrix();
  for (std::size_t axis = 0; axis < 3; ++axis)
    system.column[axis] += half * (free * (resistance * free.column[axis]));
  velocity = math::solve(system, velocity);
  return {-1.0 * (resistance * velocity), velocity};
}

void ViscousBoundary::add_forces(domain::Domain& domain, double interval) {
  if (segments_.empty()) return;
  find_eroded(domain);
  domain::NodeFields& nodes = domain.nodes;
  const double half_step = 0.5 * domain.clock.step;
  const auto count = static_cast<Index>(nodes_.size());
  taken_.assign(static_cast<std::size_t>(pieces(count, nodes_at_once)), 0.0);
  lost_at_start_ = taken_;
  parallel_for(pieces(count, nodes_at_once), domain.execution.threads, [&](Index p) {
    double taken = 0;
    double lost = 0;
    for (Index k = p * nodes_at_once; k < std::min((p + 1) * nodes_at_once, count); ++k) {
      const auto place = static_cast<std::size_t>(k);
      const Index node = nodes_[place];
      const Push now = push_on(nodes, node, resistance(domain, place), interval);
      for (int axis = 0; axis < 3; ++axis) nodes.force[node].force[axis] += now.force[axis];
      taken -= half_step * dot(previous_[place] + now.force, nodes.velocity[node]);
      lost += interval * dot(now.force, now.velocity - nodes.velocity[node]);
      previous_[place] = now.force;
    }
    taken_[static_cast<std::size_t>(p)] = taken;
    lost_at_start_[static_cast<std::size_t>(p)] = lost;
  });
  for (const double part : taken_) domain.energy.damping += part;
  if (domain.clock.cycle > 0) return;
  start_loss_ = 0;
  for (const double part : lost_at_start_) start_loss_ += part;
}

void ViscousBoundary::declare(domain::StateList& list) {
  if (!nodes_.empty()) list.keep_list("viscous_boundary", "force", domain::Entity::Node, 3, previous_);
}

}  // namespace crumple::loads
