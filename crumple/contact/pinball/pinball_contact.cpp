// SPDX-License-Identifier: BSD-3-Clause
#include "contact/pinball/pinball_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "contact/search/search_calls.hpp"
#include "contact/surface/inside_outside.hpp"
#include "contact/surface/saved_state.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

constexpr Index pairs_in_piece = 256;

Configuration now(const Kinematics& motion) {
  return {motion.position.data(), motion.velocity.data(), 0};
}

cellsearch::SegmentPairSettings settings_of(int threads) {
  cellsearch::SegmentPairSettings found;
  found.threads = threads;
  return found;
}

Vec3 point_of(const SegmentShape& shape, const std::array<double, 4>& weight) {
  Vec3 point;
  for (std::size_t k = 0; k < 4; ++k) point += weight[k] * shape.corner[k];
  return point;
}

bool before(const RememberedPinballs& pair, Index first, Index second) {
  return pair.first != first ? pair.first < first : pair.second < second;
}

void refuse_what_has_no_balls(const Surface& surface, const model::SearchSettings& settings) {
  if (settings.has_cells)
    throw Error("The cells and the domain of the search are for nodes: pinballs have none.");
  const bool alone =
      std::any_of(surface.lone.begin(), surface.lone.end(), [](auto lone) { return lone != 0; });
  if (alone || !surface.beams.empty())
    throw Error(
        "Pinballs are embedded in segments: a contact with nodes or beams alone needs "
        "--local-search inside-outside.");
  for (Index s = 0; s < surface.segments(); ++s)
    if (surface.is_face(s) && surface.of_solid[s] == 0)
      throw Error(
          "Pinballs do not know on which side of a shell they are: a contact with orientation needs "
          "--local-search inside-outside.");
}

}  // namespace

PinballContact::PinballContact(const Surface& surface, const model::SearchSettings& settings,
                               const Kinematics& start)
    : surface_(&surface),
      pinballs_(embed_pinballs(surface, now(start))),
      margin_(margin_of(surface, settings)),
      search_(settings_of(start.threads)),
      motion_(0, 0, start.threads),
      travel_(tolerances::leg_over_margin * margin_, start.threads) {
  refuse_what_has_no_balls(surface, settings);
  // A margin that is not finite comes from a bad position, which the first search will name.
  if (std::isfinite(margin_)) motion_ = cellsearch::MotionTracker(margin_, 0, start.threads);
  expansion_ = pinballs_.radius;
}

double PinballContact::update(const domain::Domain& /*domain*/, const Kinematics& motion,
                              bool surface_changed, bool /*start*/) {
  try {
    if (searches_ > 0) {
      motion_.update(view(motion.position));
      travel_.update(motion.position, motion.way);
    }
    if (motion_.due() || surface_changed) search(motion);
  } catch (const cellsearch::Error& error) {
    rethrow(error, *surface_);
  }
  return 0;
}

/// Finds the candidates for these positions, all due for a look, and counts the motion from there.
void PinballContact::collect(std::span<const Vec3> position) {
  cellsearch::Scene scene;
  scene.positions = view(position);
  scene.segments = cellsearch::Segments(surface_->connectivity);
  scene.expansion = 0.5 * margin_;
  // The balls of a face reach as far above it as its thickness is, and as far below it as they are sunk.
  for (Index s = 0; s < surface_->segments(); ++s) {
    const double radius = pinballs_.radius[s];
    const double above = surface_->half_thickness[s];
    expansion_[s] = surface_->is_face(s) ? std::max({radius, above, 2 * radius - above}) : radius;
  }
  scene.segment_expansion = expansion_;
  scene.segment_active = surface_->active;
  search_.find(scene);
  pairs_ = search_.take();
  slack_.resize(pairs_.second.size());
  for (Index first = 0; first < pairs_.rows(); ++first)
    for (std::int64_t at = pairs_.first[first]; at < pairs_.first[first + 1]; ++at)
      slack_[at] = may_touch(first, pairs_.second[at]) ? 0 : std::numeric_limits<double>::max();
  motion_.start(scene.positions, surface_->nodes);
}

void PinballContact::search(const Kinematics& motion) {
  collect(motion.position);
  travel_.start(motion.position, surface_->nodes);
  std::erase_if(remembered_, [&](const RememberedPinballs& pair) {
    return surface_->active[pair.first] == 0 || surface_->active[pair.second] == 0;
  });
  ++searches_;
  candidates_ += pairs_.count();
}

bool PinballContact::may_touch(Index first, Index second) const {
  const Surface& s = *surface_;
  const bool touching = (s.segment_side[first] & s.touched_by[second]) != 0 ||
                        (s.segment_side[second] & s.touched_by[first]) != 0;
  const bool one_body = s.segment_body[first] != no_index && s.segment_body[first] == s.segment_body[second];
  if (!touching || one_body) return false;
  const Index* own = s.segment(first);
  return std::none_of(own, own + 4, [&](Index node) { return s.joined_to(s.place[node], second); });
}

/// True if a third segment has nodes of both: the balls of such neighbours may overlap in the undeformed
/// mesh.
bool PinballContact::next_neighbours(Index first, Index second) const {
  const Index* nodes = surface_->segment(first);
  for (int k = 0; k < 4; ++k)
    for (const Index between : surface_->topology.at_node(surface_->place[nodes[k]]))
      if (connected(*surface_, between, second)) return true;
  return false;
}

double PinballContact::contact_distance(Index first, Index second) const {
  return pinballs_.radius[first] + pinballs_.radius[second];
}

/// The overlap of next neighbours in the undeformed mesh, which is no contact.
double PinballContact::offset_at_start(const Kinematics& motion, Index first, Index second) const {
  if (!next_neighbours(first, second)) return 0;
  const Configuration x{motion.reference.data(), nullptr, 0};
  const auto overlap = deepest_overlap(pinball_shape(*surface_, pinballs_, x, first),
                                       pinball_shape(*surface_, pinballs_, x, second));
  return overlap ? overlap->depth : 0;
}

const RememberedPinballs* PinballContact::memory_of(Index first, Index second) const {
  const auto found = std::lower_bound(
      remembered_.begin(), remembered_.end(), second,
      [&](const RememberedPinballs& pair, Index wanted) { return before(pair, first, wanted); });
  const bool known = found != remembered_.end() && found->first == first && found->second == second;
  return known ? &*found : nullptr;
}

/// How far the pair is from touching, the margin at most; if it touches, 0 or less, and the rest of it is
/// filled [length].
double PinballContact::examine(const Kinematics& motion, bool tracking, PinballPair& pair) const {
  const Configuration x = now(motion);
  const PinballShape first = pinball_shape(*surface_, pinballs_, x, pair.first);
  const PinballShape second = pinball_shape(*surface_, pinballs_, x, pair.second);
  const std::optional<PinballOverlap> overlap = deepest_overlap(first, second, -margin_);
  // Balls below a face move with its normal as well, by twice their depth at most.
  const double turning = 2 * (norm(first.sunk) + norm(second.sunk));
  if (!overlap) return margin_ - turning;
  // Balls of one centre push nowhere.
  if (overlap->depth <= 0 || norm(overlap->away) == 0) return -overlap->depth - turning;
  pair.overlap = *overlap;
  const RememberedPinballs* memory = memory_of(pair.first, pair.second);
  if (memory != nullptr) {
    // What has opened stays open.
    pair.offset = std::min(memory->offset, overlap->depth);
    carry_on(x, *memory, pair);
    return -overlap->depth;
  }
  const double by_mesh = std::min(overlap->depth, offset_at_start(motion, pair.first, pair.second));
  pair.offset = tracking ? overlap->depth : by_mesh;
  pair.initial_overlap = pair.offset - by_mesh;
  return -overlap->depth;
}

void PinballContact::carry_on(const Configuration& x, const RememberedPinballs& memory,
                              PinballPair& pair) const {
  const SegmentShape first = shape_of(*surface_, x, pair.first);
  const SegmentShape second = shape_of(*surface_, x, pair.second);
  const Frame frame = frame_of(first);
  // Of the points that touched then, the one has moved away from the other.
  const Vec3 apart = point_of(first, memory.first_weight) - point_of(second, memory.second_weight);
  pair.slip = apart - frame.to_global(memory.apart);
  pair.friction = frame.to_global(memory.friction);
  pair.penalty = memory.penalty;
}

double PinballContact::find(const domain::Domain& /*domain*/, const Kinematics& motion, bool start,
                            domain::ContactReport& /*report*/) {
  const Index rows = pairs_.rows();
  parts_.resize(static_cast<std::size_t>(pieces(rows, pairs_in_piece)));
  parallel_for(pieces(rows, pairs_in_piece), motion.threads, [&](Index part) {
    std::vector<PinballPair>& found = parts_[static_cast<std::size_t>(part)];
    found.clear();
    for (Index first = part * pairs_in_piece; first < std::min((part + 1) * pairs_in_piece, rows); ++first)
      for (std::int64_t at = pairs_.first[first]; at < pairs_.first[first + 1]; ++at) {
        if (slack_[at] > travel_.length()) continue;
        PinballPair pair;
        pair.first = first;
        pair.second = pairs_.second[at];
        const double gap = examine(motion, start, pair);
        if (gap > 0) slack_[at] = travel_.length_to_meet(gap);
        if (pair.overlap.depth > 0) found.push_back(pair);
      }
  });
  present_.clear();
  for (const auto& found : parts_) present_.insert(present_.end(), found.begin(), found.end());
  return 0;
}

Touch PinballContact::touch_of(const PinballPair& pair) const {
  Touch touch;
  const auto add = [&](Index segment, const std::array<double, 4>& weight, double sign) {
    const Index* nodes = surface_->segment(segment);
    const bool triangle = surface_->is_triangle(segment);
    for (int k = 0; k < (triangle ? 3 : 4); ++k)
      touch.add(surface_->place[nodes[k]], sign * (triangle && k == 2 ? weight[2] + weight[3] : weight[k]));
  };
  add(pair.first, pair.overlap.first, 1);
  add(pair.second, pair.overlap.second, -1);
  touch.normal = normalised(pair.overlap.away);
  touch.penetration = pair.overlap.depth - pair.offset;
  touch.reach = contact_distance(pair.first, pair.second) - pair.offset;
  touch.stiffness = std::min(surface_->stiffness[pair.first], surface_->stiffness[pair.second]);
  touch.area = std::min(surface_->area[pair.first], surface_->area[pair.second]);
  touch.part = {surface_->segment_part[pair.first], surface_->segment_part[pair.second]};
  touch.height = {ball_height(*surface_, pinballs_, pair.first),
                  ball_height(*surface_, pinballs_, pair.second)};
  touch.slip = pair.slip;
  touch.friction = pair.friction;
  touch.penalty = pair.penalty;
  touch.has_potential = true;
  return touch;
}

void PinballContact::fill(const Kinematics& /*motion*/, std::span<Touch> touches) const {
  std::ranges::transform(present_, touches.begin(), [&](const PinballPair& pair) { return touch_of(pair); });
}

/// Id of the node of the first segment that is nearest to the contact.
UserId PinballContact::node_id(const PinballPair& pair) const {
  const auto& weight = pair.overlap.first;
  const auto nearest = std::max_element(weight.begin(), weight.end()) - weight.begin();
  return surface_->node_id[surface_->place[surface_->segment(pair.first)[nearest]]];
}

void PinballContact::remember(const Kinematics& motion, std::span<const Touch> touches, TouchNotes& notes) {
  const Configuration x = now(motion);
  remembered_.clear();
  for (std::size_t i = 0; i < present_.size(); ++i) {
    const PinballPair& pair = present_[i];
    notes.stored_energy += touches[i].stored_energy();
    RememberedPinballs memory;
    memory.first = pair.first;
    memory.second = pair.second;
    memory.first_weight = pair.overlap.first;
    memory.second_weight = pair.overlap.second;
    memory.offset = pair.offset;
    const SegmentShape first = shape_of(*surface_, x, pair.first);
    const Frame frame = frame_of(first);
    const Vec3 second_point = point_of(shape_of(*surface_, x, pair.second), pair.overlap.second);
    memory.apart = frame.to_local(point_of(first, pair.overlap.first) - second_point);
    memory.friction = frame.to_local(touches[i].friction);
    memory.penalty = touches[i].penalty;
    remembered_.push_back(memory);
    if (touches[i].penetration > 0)
      notes.penetrations.push_back({touches[i].penetration, contact_distance(pair.first, pair.second),
                                    node_id(pair), surface_->segment_id[pair.second],
                                    contact_distance(pair.first, pair.second)});
  }
}

void PinballContact::append_initial_overlaps(std::vector<domain::InitialOverlap>& overlaps) const {
  for (const PinballPair& pair : present_)
    if (pair.initial_overlap > 0)
      overlaps.push_back({node_id(pair), surface_->segment_id[pair.second], pair.initial_overlap});
}

void PinballContact::report(domain::ContactReport& report, ContactStatistics& /*statistics*/) const {
  report.searches += searches_;
  report.candidates += candidates_;
  report.search.expansion = 2 * surface_->largest_half_thickness + margin_;
}

void PinballContact::verify(const Kinematics& motion) {
  const Configuration x = now(motion);
  const Index count = surface_->segments();
  std::vector<PinballShape> shapes;
  shapes.reserve(static_cast<std::size_t>(count));
  for (Index s = 0; s < count; ++s) shapes.push_back(pinball_shape(*surface_, pinballs_, x, s));
  for (Index first = 0; first < count; ++first)
    for (Index second = first + 1; second < count; ++second) {
      if (surface_->active[first] == 0 || surface_->active[second] == 0 || !may_touch(first, second) ||
          connected(*surface_, first, second) || distance_at_least(shapes[first], shapes[second]) > 0)
        continue;
      const auto row = pairs_.of(first);
      if (std::binary_search(row.begin(), row.end(), second) ||
          !deepest_overlap(shapes[first], shapes[second]))
        continue;
      throw Error("The contact search missed a pair at cycle " + std::to_string(motion.cycle) +
                  ": elements " + std::to_string(surface_->segment_id[first]) + " and " +
                  std::to_string(surface_->segment_id[second]) + " touch, but are no candidates.");
    }
}

void PinballContact::declare_search(domain::StateList& list) {
  searched_position_.assign(motion_.reference().begin(), motion_.reference().end());
  list.add_list("contact_searched_segment_position", "length", domain::Entity::Contact, 3,
                searched_position_);
}

void PinballContact::declare_pairs(domain::StateList& list) {
  list.add_list("contact_pinball_pairs", "by item", domain::Entity::Contact, 1, remembered_);
  list.keep("contact_pinball_searches", "-", domain::Entity::Contact, searches_);
  list.keep("contact_pinball_candidates", "-", domain::Entity::Contact, candidates_);
}

void PinballContact::resume(const domain::Domain& /*domain*/, const Kinematics& motion) {
  const auto fits = [this](const RememberedPinballs& pair) {
    const std::size_t segments = surface_->segment_id.size();
    return is_one_of(pair.first, segments) && is_one_of(pair.second, segments) && pair.first < pair.second;
  };
  require_all_saved(remembered_, fits, "pairs of pinballs");
  require_saved(searches_ >= 0, "counts of searches");
  if (searches_ == 0) return;
  require_saved(searched_position_.size() == 3 * surface_->nodes.size(), "positions at the last search");
  collect(positions_at_search(motion.position, surface_->nodes, searched_position_));
  travel_.start(motion.position, surface_->nodes);
}

}  // namespace crumple::contact
