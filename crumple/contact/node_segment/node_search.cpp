// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/node_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/node_segment/rim.hpp"
#include "contact/node_segment/solid_overlaps.hpp"
#include "contact/surface/crossing.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

double share_of_other(double cosine) {
  return std::clamp((tolerances::same_surface - cosine) / (tolerances::same_surface - tolerances::two_walls),
                    0.0, 1.0);
}

/// True if the node is in front of a face and has no contact with it yet.
bool waits(const ContactPair& pair) {
  return pair.penetration() <= 0 && pair.offset <= 0;
}

int sign_of(double a) {
  return a > 0 ? 1 : a < 0 ? -1 : 0;
}

/// Whether a contact point lies on an edge of its segment. A node beyond the edge slides while its point does
/// not move over the segment.
bool is_on_edge(const std::array<double, 4>& weight) {
  constexpr double none = 1e-12;
  return std::ranges::count_if(weight, [](double part) { return part <= none; }) >= 2;
}

}  // namespace

NodeSearch::NodeSearch(const StepView& view, Index place, std::span<const RememberedPair> remembered)
    : view_(view),
      surface_(*view.now.surface),
      place_(place),
      node_(surface_.nodes[place]),
      p_(view.now.x[node_]),
      remembered_(remembered),
      freed_(surface_.joined.has_freed(place)) {
  for (const RememberedPair& pair : remembered_) astray_ = astray_ || pair.wrong != 0;
}

void NodeSearch::find(std::vector<ContactPair>& found) {
  GlobalSearch& candidates = *view_.candidates;
  const std::size_t before = found.size();
  if (begins()) measure_faces();
  for (std::int64_t c = candidates.first(place_); c < candidates.first(place_ + 1); ++c) {
    if (!looks_at_all() && candidates.slack(c) > candidates.consumed()) continue;
    const double gap = examine(candidates.segment(c), candidates.contact_distance(c), found);
    if (gap > 0) candidates.put_off(c, gap);
  }
  candidates.refresh_node(place_);
  if (found.size() - before > 1) keep_owners(found, before);
  const std::span<ContactPair> present = std::span(found).subspan(before);
  for (ContactPair& pair : present) carry_on(pair, present);
}

const RememberedPair* NodeSearch::memory_of(Index segment) const {
  for (const RememberedPair& pair : remembered_)
    if (pair.segment == segment) return &pair;
  return nullptr;
}

/// True if the node was in contact with that segment of the same surface, or of one that goes on over a seam,
/// and now is nearer to another one.
bool NodeSearch::came_from(const RememberedPair& other, Index segment) const {
  return other.side != 0 && other.segment != segment &&
         (same_sides(surface_, segment, other.segment) ||
          goes_on_over_seam(here(), other.segment, segment)) &&
         hold(other.segment, view_.nearest_point(view_.now.shape(other.segment), p_), &other, false) == 0;
}

/// The segments at the edge or corner where the nearest point of a segment is, itself among them.
std::span<const Index> NodeSearch::around(Index segment, const NearestPoint& nearest) const {
  const Topology& topology = surface_.topology;
  if (nearest.feature == Feature::Edge) return topology.at_edge(topology.edges_of[segment][nearest.local]);
  return topology.at_node(surface_.place[surface_.segment(segment)[nearest.local]]);
}

/// True if the node, near both, cannot be on different sides of them: of two segments of one surface that
/// bends by less than 60 degrees between them, or that have the same nearest point, on an edge that they
/// share.
bool NodeSearch::agree(Index a, Index b, const NearestPoint& nearest_of_a) const {
  if (a == b || !same_sides(surface_, a, b)) return false;
  const SegmentShape shape = view_.now.shape(b);
  const Vec3 normal = normalised(area_normal(view_.now.shape(a)));
  if (dot(normal, normalised(area_normal(shape))) > tolerances::two_walls) return true;
  if (nearest_of_a.feature == Feature::Face) return false;
  const Vec3 apart = view_.nearest_point(shape, p_).point - nearest_of_a.point;
  return norm(apart) <= tolerances::on_surface * std::sqrt(surface_.area[a]);
}

/// The side from which the node went in this step through the segment or through one beside it that must
/// agree with it; 0 if it did not.
int NodeSearch::crossed_around(Index segment, const NearestPoint& nearest) const {
  const int own = crossed_from(view_.now, node_, segment, view_.step);
  if (own != 0) return own;
  for (const Index edge : surface_.topology.edges_of[segment]) {
    if (edge == no_index) continue;
    for (const Index other : surface_.topology.at_edge(edge)) {
      if (!agree(segment, other, nearest)) continue;
      const int from = crossed_from(view_.now, node_, other, view_.step);
      if (from != 0) return from;
    }
  }
  return 0;
}

/// True if the solid's surface goes on beyond the rim of a face, bent by less than 60 degrees, in a face that
/// has the node right behind it: that one takes the contact over at once, as on a shell.
bool NodeSearch::goes_on(Index segment, const NearestPoint& nearest, const Vec3& normal) const {
  for (const Index other : around(segment, nearest)) {
    if (other == segment || !surface_.is_face(other) || !surface_.may_touch(place_, other) ||
        !same_sides(surface_, segment, other))
      continue;
    const SegmentShape shape = view_.now.shape(other);
    const Vec3 beyond = normalised(area_normal(shape));
    if (dot(beyond, normal) <= tolerances::two_walls) continue;
    const NearestPoint foot = view_.nearest_point(shape, p_);
    if (dot(p_ - foot.point, beyond) < 0 && nearest_around(view_.now, node_, other, foot)) return true;
  }
  return false;
}

/// How much of a contact with the segment there is: 1 if it is the nearest around, else 0; but a node that is
/// right behind the face of a solid stays with it, be other faces of the solid nearer or not, as it is
/// through this one that it came. Over the rim of the face its share fades, for a new one at once. A face
/// that the node's own faces cannot meet is never entered. `near`: they touch where the node is.
double NodeSearch::hold(Index segment, const NearestPoint& nearest, const RememberedPair* memory,
                        bool near) const {
  const bool nearest_of_all = nearest_around(view_.now, node_, segment, nearest);
  if (!surface_.is_face(segment)) return nearest_of_all ? 1 : 0;
  const Vec3 away = p_ - nearest.point;
  const SegmentShape shape = view_.now.shape(segment);
  const Vec3 normal = normalised(area_normal(shape));
  const double depth = -dot(away, normal);
  const bool inside = memory != nullptr && memory->wrong != 0;
  if (depth > 0 && !inside && !may_enter(view_.now, place_, normal)) return 0;
  const std::span<const Index> candidates = view_.candidates->segments_of(place_);
  // One that waits in front of a rim and does not come through this face comes under the one beside.
  if (depth > 0 && !inside && memory != nullptr && passes_front(here(), segment, candidates)) return 0;
  if (inside && depth > 0 && nearest.feature != Feature::Face &&
      is_taken_over_seam(here(), segment, candidates))
    return 0;
  if (nearest_of_all) return 1;
  if (depth <= 0) return !near && stands_at_rim(here(), segment, shape, nearest) ? 1 : 0;
  const double beyond = norm(away + depth * normal);
  const double side = std::sqrt(surface_.area[segment]);
  const bool was_in_front = memory != nullptr || depth <= on_face(segment);
  if (!inside && beyond > tolerances::beside_rim * (was_in_front ? side : depth)) return 0;
  if (!inside && !reaches_over_rim(here(), segment, shape, nearest)) return 0;
  if (nearest.feature != Feature::Face && goes_on(segment, nearest, normal)) return 0;
  return share_beyond_rim(beyond, side);
}

/// Distance up to which a node lies on a face, by the round-off of coordinates [length].
double NodeSearch::on_face(Index segment) const {
  return tolerances::on_surface * surface_.height[segment];
}

/// True if a node that has just come behind a face of a solid did not come through it, but past it through
/// the seam of two bodies.
bool NodeSearch::goes_past(Index face) const {
  const std::span<const Index> candidates = view_.candidates->segments_of(place_);
  return passes_side(here(), face, candidates, remembered_) || passes_front(here(), face, candidates);
}

/// Of the faces of other solids that the node does not lie on, the nearest.
void NodeSearch::measure_faces() {
  const GlobalSearch& candidates = *view_.candidates;
  nearest_face_ = std::numeric_limits<double>::max();
  for (std::int64_t c = candidates.first(place_); c < candidates.first(place_ + 1); ++c) {
    const Index segment = candidates.segment(c);
    if (!surface_.is_face(segment) || surface_.behind_has(segment, node_)) continue;
    const double distance = std::sqrt(view_.nearest_point(view_.now.shape(segment), p_).distance_squared);
    if (distance > on_face(segment)) nearest_face_ = std::min(nearest_face_, distance);
  }
}

/// Whether a node behind a face when the contact begins lies on it or is inside of that solid, and not just
/// on the far side of a thin one: then no other face is nearer.
bool NodeSearch::starts_inside(Index segment, double distance) const {
  if (!begins() || surface_.behind_has(segment, node_)) return false;
  const auto deep = std::ranges::lower_bound(view_.deep, place_, {}, &DeepPair::node);
  if (view_.tracking && deep != view_.deep.end() && deep->node == place_) return deep->segment == segment;
  return distance <= on_face(segment) || (distance <= (1 + tolerances::as_near_as_nearest) * nearest_face_ &&
                                          distance < surface_.height[segment]);
}

/// The side of a shell on which the node belongs: the remembered side, unless the node is now on the other
/// one although its relative motion in the step was too small to pass through. Then the segment below it has
/// inverted (crushed in its plane, or warped until one of its four triangles flips), and the side flips too.
int NodeSearch::kept_side(Index segment, const RememberedPair& memory, double distance, int present) const {
  const int expected = memory.wrong != 0 ? -memory.side : memory.side;
  if (present == 0 || present == expected || view_.step <= 0) return memory.side;
  const double way =
      (1 + tolerances::motion_round_off) * relative_motion(view_.now, node_, segment, view_.step);
  return distance + std::fabs(memory.gap) > way ? -memory.side : memory.side;
}

/// The side on which the node belongs: as remembered; or as on the segment from which it came, if it was on
/// the wrong side of that or went through it in this step; or where it was before it went through this one;
/// or where it is. Behind a face of a solid a node belongs in front of it if it was in front of one beside it
/// a step ago; one that did not come through it is none of its business.
int NodeSearch::side_of(Index segment, const RememberedPair* memory, const NearestPoint& nearest,
                        int present) const {
  const double distance = std::sqrt(nearest.distance_squared);
  if (memory != nullptr && memory->side != 0)
    return surface_.is_face(segment) ? memory->side : kept_side(segment, *memory, distance, present);
  if (surface_.is_face(segment) && (present > 0 || starts_inside(segment, distance))) return 1;
  const bool may_cross = view_.step > 0 && distance <= relative_motion(view_.now, node_, segment, view_.step);
  const bool face = surface_.is_face(segment);
  if (!astray_ && !may_cross && !face) return present;
  for (const RememberedPair& other : remembered_) {
    const bool is_beside =
        !face && other.wrong != 0 && other.side != 0 && agree(segment, other.segment, nearest);
    if (!is_beside && !came_from(other, segment)) continue;
    if (face && other.wrong != 0 && stand_out(other.segment, segment)) continue;
    if (face) return other.side;
    const bool was_wrong = other.wrong != 0;
    const bool crossed = crossed_from(view_.now, node_, other.segment, view_.step) != 0;
    // One that comes back while it passes on to this segment is on its own side again.
    if (was_wrong || crossed) return was_wrong != crossed ? -present : present;
  }
  const int from = !may_cross ? 0
                   : face     ? crossed_from(view_.now, node_, segment, view_.step)
                              : crossed_around(segment, nearest);
  if (from != 0) return from;
  // Right on the mid-surface it belongs where it comes from, not where it goes to.
  return present == 0 && may_cross ? side_before(view_.now, node_, segment, view_.step) : present;
}

/// True if two faces fall away from each other by 60 degrees or more: a node comes through one of them.
bool NodeSearch::stand_out(Index a, Index b) const {
  const SegmentShape shape = view_.now.shape(a);
  const SegmentShape other = view_.now.shape(b);
  const Vec3 normal = normalised(area_normal(shape));
  return dot(normal, normalised(area_normal(other))) <= tolerances::two_walls &&
         dot(other.centre - shape.centre, normal) < 0;
}

/// By how much the contact distance of a pair is reduced when the node is at `gap`. A contact cannot begin
/// deeper than the node was in the connected ones it comes from, plus its approach in the step: the rest was
/// no approach (meshes that overlap from the start, a place of the surface that only now became the nearest),
/// and pushing it out would make energy from nothing.
double NodeSearch::offset_of(Index segment, const RememberedPair* memory, double full, double gap) const {
  if (memory != nullptr) return memory->offset;
  double inherited = 0;
  double depth = 0;
  for (const RememberedPair& other : remembered_) {
    if (!connected(surface_, segment, other.segment)) {
      // What the face beyond a seam stands out more is no approach.
      if (gap < 0 && goes_on_over_seam(here(), other.segment, segment))
        inherited = std::max(inherited, other.offset + deeper_by(here(), other.segment, segment));
      continue;
    }
    inherited = std::max(inherited, other.offset);
    depth = std::max(depth, other.depth);
  }
  SurfaceAt before = view_.now;
  before.x.back = view_.step;
  const double distance =
      std::sqrt(view_.nearest_point(before.shape(segment), before.x[node_]).distance_squared);
  return std::max(inherited, full - std::max(distance, gap) - depth);
}

/// Sets gap and direction of a pair, for a node `away` from the contact point, at that distance; `normal`
/// tells the sides apart, or is zero where the surface is round.
void NodeSearch::measure(const Vec3& away, double distance, const Vec3& normal, ContactPair& pair) {
  const double sign = pair.wrong != 0 ? -1.0 : 1.0;
  pair.gap = sign * distance;
  pair.normal = distance > 0 ? sign / distance * away : (pair.side < 0 ? -1.0 : 1.0) * normal;
}

/// Deep contacts near a shallow edge push along a smooth normal. In front of the edge the force points along
/// the line to it, which turns faster the nearer the node is, up to a lateral instability at the surface
/// itself; behind it the normal jumps from one segment to the next. Both turn symmetric impacts into oblique
/// ones. The smooth normal is the mean of those at the corners, weighted by the contact point; it takes over
/// where the node is nearer to an edge than a share of the penetration.
void NodeSearch::smooth_direction(const SegmentShape& shape, const NearestPoint& nearest,
                                  ContactPair& pair) const {
  const double zone = tolerances::smooth_in_front * pair.penetration() -
                      (tolerances::smooth_behind - tolerances::smooth_in_front) * std::min(0.0, pair.gap);
  if (pair.side == 0 || std::fabs(pair.gap) >= zone) return;
  const double beside = distance_to_edges(shape, nearest.point);
  const double square = (beside * beside + pair.gap * pair.gap) / (zone * zone);
  if (square >= 1) return;
  const Vec3 own = (pair.side < 0 ? -1.0 : 1.0) * normalised(area_normal(shape));
  Vec3 smooth;
  for (int k = 0; k < 4; ++k) {
    if (pair.weight[k] == 0) continue;
    const Vec3 mean = corner_normal(view_.now, surface_.segment(pair.segment)[k], own);
    smooth += pair.weight[k] * (dot(mean, own) > tolerances::same_surface ? mean : own);
  }
  // Around a sharp edge the line to it is right.
  const double share = (1 - square * square) * (1 - share_of_other(dot(pair.normal, normalised(smooth))));
  pair.normal = normalised((1 - share) * pair.normal + share * smooth);
}

/// `full`: the distance at which the pair touches, before what is allowed for is deducted. Returns what the
/// node has to go before it is worth another look; 0 if it is near, or may have come through [length].
double NodeSearch::examine(Index segment, double full, std::vector<ContactPair>& found) {
  const RememberedPair* memory = memory_of(segment);
  const SegmentShape shape = view_.now.shape(segment);
  const bool face = surface_.is_face(segment);
  const bool known_face = face && memory != nullptr;
  const NearestPoint nearest = view_.nearest_point(shape, p_);
  const double distance = std::sqrt(nearest.distance_squared);
  const bool near = distance < full;
  const double gap = distance - full - surface_.watch(segment);
  const bool watched = gap < 0;
  // One that may have gone through the segment in this step is near as well.
  if (!near && !watched && !known_face && !looks_at_all() &&
      distance > relative_motion(view_.now, node_, segment, view_.step))
    return gap;
  const double share = hold(segment, nearest, memory, near);
  if (share == 0) return 0;

  const Vec3 away = p_ - nearest.point;
  // Beyond the rim a face still tells its sides apart, and pushes, by its own normal.
  const bool over_rim =
      face && nearest.feature != Feature::Face && !nearest_around(view_.now, node_, segment, nearest);
  const Vec3 normal =
      over_rim ? normalised(area_normal(shape)) : side_normal(view_.now, segment, shape, nearest, away);
  const bool round = dot(normal, normal) == 0;
  const bool at_rim = !near && stands_at_rim(here(), segment, shape, nearest);
  const int present = round ? 0 : sign_of(dot(away, normal));
  const int side = at_rim ? 1 : round ? 0 : side_of(segment, memory, nearest, present);
  if (side < 0 && face) return 0;
  const bool wrong = present != 0 && side != 0 && present != side;
  if (face && wrong && (memory == nullptr || memory->wrong == 0) && !is_tracked(memory) && goes_past(segment))
    return 0;
  // What is in front of a face is remembered, so that it is known later which way it came.
  const bool waits = face && side > 0 && watched;
  if (!near && !wrong && !waits) return 0;

  ContactPair pair;
  pair.node = place_;
  pair.segment = segment;
  pair.side = side;
  pair.wrong = wrong ? 1 : 0;
  pair.weight = nearest.weight;
  pair.point = nearest.point;
  measure(away, distance, normal, pair);
  if (over_rim && wrong) {
    pair.normal = normal;
    pair.gap = dot(away, normal);
  }
  // On a face the way to it is round-off and has no direction.
  if (face && distance <= on_face(segment)) pair.normal = normalised(area_normal(shape));
  const double overlap = std::max(0.0, full - pair.gap);
  // What has opened stays open: the allowance only shrinks.
  pair.share = share;
  pair.offset =
      is_tracked(memory) ? overlap : std::clamp(offset_of(segment, memory, full, pair.gap), 0.0, overlap);
  const double release_depth = surface_.release_depth[segment];
  const bool away_from = memory != nullptr && memory->let_go != 0;
  pair.let_go = overlap - (away_from ? 0 : pair.offset) > release_depth ? 1 : 0;
  if (pair.let_go != 0 || away_from) pair.offset = overlap;
  pair.reach = full - pair.offset;
  smooth_direction(shape, nearest, pair);
  if (over_rim && wrong && pair.gap < -on_face(segment))
    push_off_rim(away, normal, std::sqrt(surface_.area[segment]), pair);
  if (pair.penetration() > 0 || pair.offset > 0 || waits) found.push_back(pair);
  return 0;
}

/// True if the node is behind two faces of a solid that meet in an edge or corner standing out: it has come
/// through one of them.
bool NodeSearch::enters_once(const ContactPair& a, const ContactPair& b) const {
  if (a.wrong == 0 || b.wrong == 0 || !surface_.is_face(a.segment) || !surface_.is_face(b.segment))
    return false;
  const Vec3 between = view_.now.shape(b.segment).centre - view_.now.shape(a.segment).centre;
  return dot(a.normal, between) < 0 && dot(b.normal, between) > 0;
}

/// Of two faces the node came through the one that it was behind before, or is further behind. One that came
/// in at their edge is as far behind both: with the depths a and b they push from then on by the potential
/// 1/2 k a^2 b^2 / (a^2 + b^2), along the bisector where they are equal.
void NodeSearch::enter_between(ContactPair& a, ContactPair& b) const {
  const auto was_behind = [&](const ContactPair& pair) {
    const RememberedPair* memory = memory_of(pair.segment);
    return memory != nullptr && memory->wrong != 0;
  };
  const bool a_was = was_behind(a);
  const bool b_was = was_behind(b);
  const double depth_a = -a.gap;
  const double depth_b = -b.gap;
  const double less = std::min(depth_a, depth_b);
  const bool at_edge = less > tolerances::as_deep_at_edge * std::max(depth_a, depth_b) &&
                       less > std::max(on_face(a.segment), on_face(b.segment));
  if (a_was != b_was || !(a_was || at_edge)) {
    const bool through_a = a_was != b_was ? a_was : depth_a >= depth_b;
    (through_a ? b : a).share = 0;
    return;
  }
  const auto give = [](ContactPair& pair, double own, double other) {
    const double part = own + other > 0 ? other / (own + other) : 0.5;
    // Never none: the pair stays known.
    pair.share = std::min(pair.share, std::max(part * part, tolerances::least_share_at_edge));
  };
  give(a, depth_a * depth_a, depth_b * depth_b);
  give(b, depth_b * depth_b, depth_a * depth_a);
}

/// Of connected segments that push in almost the same direction only the owner keeps its contact.
void NodeSearch::keep_owners(std::vector<ContactPair>& found, std::size_t first) const {
  const std::size_t last = found.size();
  for (std::size_t i = first; i < last; ++i)
    for (std::size_t j = i + 1; j < last; ++j) {
      ContactPair& a = found[i];
      ContactPair& b = found[j];
      if (a.share == 0 || b.share == 0 || !connected(surface_, a.segment, b.segment)) continue;
      // One that only waits in front of a face takes nothing from one that pushes, nor from another one:
      // beside a rim it is not known yet which face the node will come through.
      if ((a.penetration() > 0) != (b.penetration() > 0) || (waits(a) && waits(b))) continue;
      const double share = share_of_other(dot(a.normal, b.normal));
      if (share == 1) {
        if (enters_once(a, b)) enter_between(a, b);
        continue;
      }
      const bool a_owns = owns_first(view_.now, a.segment, b.segment, p_, std::fabs(a.gap), std::fabs(b.gap));
      ContactPair& other = a_owns ? b : a;
      other.share = std::min(other.share, share);
    }
  const auto begin = found.begin() + static_cast<std::ptrdiff_t>(first);
  found.erase(std::remove_if(begin, found.end(), [](const ContactPair& pair) { return pair.share == 0; }),
              found.end());
}

/// Movement of the node over the segment `from` since the last step. Beyond an edge the contact point does
/// not follow: there it is the change of the way from the last point to the node, in the axes of the segment.
Vec3 NodeSearch::slip_since(const RememberedPair& from, const SegmentShape& shape,
                            const ContactPair& pair) const {
  Vec3 old_point;
  for (int k = 0; k < 4; ++k) old_point += from.weight[k] * shape.corner[k];
  if (!is_on_edge(pair.weight) && !is_on_edge(from.weight)) return pair.point - old_point;
  const Vec3* v = view_.now.x.velocity;
  const Index* nodes = surface_.segment(from.segment);
  SegmentShape before = shape;
  Vec3 way = p_ - view_.step * v[node_];
  for (int k = 0; k < 4; ++k) {
    before.corner[k] -= view_.step * v[nodes[k]];
    way -= from.weight[k] * before.corner[k];
  }
  return p_ - old_point - frame_of(shape).to_global(frame_of(before).to_local(way));
}

/// Finds the friction force, the largest slope and the contact point of the step before, on this segment or
/// on a connected one that pushes the node no longer.
void NodeSearch::carry_on(ContactPair& pair, std::span<const ContactPair> present) {
  const auto left = [&](Index segment) {
    return std::none_of(present.begin(), present.end(), [&](const ContactPair& other) {
      return other.segment == segment && other.penetration() > 0;
    });
  };
  const RememberedPair* from = memory_of(pair.segment);
  // A pair that only waits in front of a face inherits no spring: that belongs to a pair in penetration.
  const bool inherits = !waits(pair);
  for (std::size_t i = 0; i < remembered_.size() && inherits && (from == nullptr || !from->loaded()); ++i) {
    const RememberedPair& other = remembered_[i];
    if (other.segment == pair.segment || (!connected(surface_, pair.segment, other.segment) &&
                                          !goes_on_over_seam(here(), other.segment, pair.segment)))
      continue;
    if (left(other.segment) && (from == nullptr || other.loaded())) from = &other;
  }
  if (from == nullptr) return;
  const SegmentShape shape = view_.now.shape(from->segment);
  pair.slip = slip_since(*from, shape, pair);
  if (dot(from->friction, from->friction) > 0) {
    const Frame frame = frame_of(shape);
    pair.friction = frame.to_global(from->friction);
    if (from->segment == pair.segment) pair.frame = frame;
  }
  pair.penalty = from->penalty;
  pair.heir_of = from->segment;
  const Vec3* v = view_.now.x.velocity;
  Vec3 relative = v[node_];
  for (int k = 0; k < 4; ++k) relative -= from->weight[k] * v[surface_.segment(from->segment)[k]];
  pair.last_speed = dot(relative, from->normal);
  if (from->segment == pair.segment) return;
  // What the spring holds goes to one successor only.
  const std::uint64_t bit = std::uint64_t{1} << std::min<std::ptrdiff_t>(63, from - remembered_.data());
  if ((handed_on_ & bit) != 0) {
    pair.penalty.force = pair.penalty.energy = pair.penalty.most_energy = 0;
    pair.heir_of = no_index;
  }
  handed_on_ |= bit;
}

}  // namespace crumple::contact
