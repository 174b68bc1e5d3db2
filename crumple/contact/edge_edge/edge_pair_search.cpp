// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_edge/edge_pair_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

double ramp(double value, double low, double high) {
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

bool of_first(EdgeMeeting meeting) {
  return meeting == EdgeMeeting::FirstStart || meeting == EdgeMeeting::FirstEnd;
}

bool of_start(EdgeMeeting meeting) {
  return meeting == EdgeMeeting::FirstStart || meeting == EdgeMeeting::SecondStart;
}

/// The points of a contact of an end: that end, and the point of the other edge nearest to it.
NearestOnEdges end_points(const EdgeShape& first, const EdgeShape& second, EdgeMeeting meeting) {
  NearestOnEdges found;
  const int own = of_first(meeting) ? 0 : 1;
  const double end = of_start(meeting) ? 0.0 : 1.0;
  found.fraction[own] = end;
  found.fraction[1 - own] =
      own == 0 ? nearest_fraction(second, first.at(end)) : nearest_fraction(first, second.at(end));
  found.away = first.at(found.fraction[0]) - second.at(found.fraction[1]);
  found.distance = norm(found.away);
  return found;
}

/// Of the active edges at a node the lowest that may touch `other`, or no_index.
Index lowest_at(const Edges& edges, const Surface& surface, Index node, Index other) {
  for (const Index edge : edges.at_node(surface.place[node]))
    if (edge != other && !edges.share_node(edge, other) && edges.may_touch(surface, edge, other)) return edge;
  return no_index;
}

}  // namespace

Index end_of(const Edges& edges, const EdgePairKey& key) {
  const EdgeNodes ends = edges.ends(of_first(key.meeting) ? key.first : key.second);
  return of_start(key.meeting) ? ends[0] : ends[1];
}

void EdgePairSearch::find(std::vector<EdgePair>& found) {
  const EdgeSearch& candidates = *view_.candidates;
  auto known = own_.begin();
  // What is remembered is looked at, whether the search still lists it or not.
  const auto examine_known_before = [&](Index other) {
    while (known != own_.end() && known->key.second < other) {
      const Index second = known->key.second;
      examine(second, candidates.contact_distance(*view_.motion, edge_, second), found);
      while (known != own_.end() && known->key.second == second) ++known;
    }
  };
  for (std::int64_t pair = candidates.first(edge_); pair < candidates.first(edge_ + 1); ++pair) {
    const Index other = candidates.other(pair);
    examine_known_before(other);
    const bool remembered = known != own_.end() && known->key.second == other;
    while (known != own_.end() && known->key.second == other) ++known;
    if (!edges_.may_touch(*view_.surface, edge_, other)) continue;
    const double full = candidates.contact_distance(pair);
    if (remembered || view_.may_take_over(edge_, other) ||
        ((view_.tracking || candidates.slack(pair) <= candidates.consumed()) && may_meet(other, full)))
      examine(other, full, found);
  }
  examine_known_before(edges_.count());
}

/// False only if two edges neither touch nor may have gone through each other in the step. Cheap: compares
/// their boxes.
bool EdgePairSearch::may_meet(Index other, double full) const {
  const EdgeNodes own = edges_.ends(edge_);
  const EdgeNodes others = edges_.ends(other);
  const double reach = std::max(full, relative_motion(own, others, view_.now.velocity, view_.step));
  const EdgeShape first = view_.shape(edge_);
  const EdgeShape second = view_.shape(other);
  for (int axis = 0; axis < 3; ++axis) {
    const std::pair<double, double> own_range = std::minmax({first.start[axis], first.end[axis]});
    const std::pair<double, double> range = std::minmax({second.start[axis], second.end[axis]});
    if (own_range.first - range.second > reach || range.first - own_range.second > reach) return false;
  }
  return true;
}

void EdgePairSearch::examine(Index other, double full, std::vector<EdgePair>& found) {
  const NearestOnEdges nearest = nearest_points(view_.shape(edge_), view_.shape(other));
  examine_crossing(nearest, other, full, found);
  if (nearest.distance >= full) return;
  if (edges_.bare[other] != 0) {
    examine_end(EdgeMeeting::FirstStart, other, full, found);
    examine_end(EdgeMeeting::FirstEnd, other, full, found);
  }
  if (edges_.bare[edge_] != 0) {
    examine_end(EdgeMeeting::SecondStart, other, full, found);
    examine_end(EdgeMeeting::SecondEnd, other, full, found);
  }
}

const RememberedEdgePair* EdgePairSearch::memory_of(const EdgePairKey& key) const {
  for (const RememberedEdgePair& pair : own_)
    if (pair.key == key) return &pair;
  return nullptr;
}

/// The side of the second edge on which a new pair belongs: as its neighbours know if these have gone through
/// each other, also where it comes back in this step; or where it was before it went through in this step, or
/// its neighbours did; else it is where it is.
EdgePairSearch::Side EdgePairSearch::known_side(const EdgePairKey& key, bool may_pass) const {
  if (view_.tracking) return {};
  const auto passed = [&](const EdgePairKey& k) {
    return may_pass ? passed_from(edges_.ends(k.first), edges_.ends(k.second), view_.now, view_.step)
                    : Vec3{};
  };
  const auto is_zero = [](const Vec3& a) { return dot(a, a) == 0; };
  Side side;
  visit_connected(view_, view_.remembered, key, [&](const RememberedEdgePair& pair, double sign) {
    if (pair.key.meeting == EdgeMeeting::Crossing && pair.wrong != 0 && is_zero(side.normal))
      side.normal = sign * pair.side;
  });
  if (!is_zero(side.normal)) return side;
  side = {passed(key), true};
  visit_connected(view_, view_.remembered, key, [&](const RememberedEdgePair& pair, double sign) {
    if (pair.key.meeting == EdgeMeeting::Crossing && is_zero(side.normal))
      side.normal = sign * passed(pair.key);
  });
  return side;
}

/// True if a pair of edges that have gone through each other now ends at a node that these two continue: the
/// contact goes over to them, however deep it is by then.
bool EdgePairSearch::takes_over(const EdgePairKey& key) const {
  if (!view_.may_take_over(key.first, key.second)) return false;
  bool found = false;
  visit_connected(view_, view_.remembered, key, [&](const RememberedEdgePair& pair, double sign) {
    if (found || pair.wrong == 0 || pair.key.meeting != EdgeMeeting::Crossing) return;
    const std::array<Index, 2> from{pair.key.first, pair.key.second};
    std::array<Index, 2> to{key.first, key.second};
    if (sign < 0) std::swap(to[0], to[1]);
    const NearestOnEdges nearest = nearest_points(view_.shape(from[0]), view_.shape(from[1]));
    found = !nearest.both_inside();
    for (int i = 0; i < 2; ++i) {
      if (to[i] == from[i]) continue;
      const EdgeNodes ends = edges_.ends(to[i]);
      const Index node = edges_.ends(from[i])[nearest.fraction[i] == 0 ? 0 : 1];
      found = found && !nearest.inside(i) && (ends[0] == node || ends[1] == node);
    }
  });
  return found;
}

void EdgePairSearch::examine_crossing(const NearestOnEdges& nearest, Index other, double full,
                                      std::vector<EdgePair>& found) const {
  const EdgePairKey key{edge_, other, EdgeMeeting::Crossing};
  const RememberedEdgePair* memory = memory_of(key);
  const EdgeShape first = view_.shape(edge_);
  const EdgeShape second = view_.shape(other);
  const bool near = nearest.distance < full;
  const bool knows_side = memory != nullptr && memory->knows_side();
  const bool may_pass = !knows_side && view_.step > 0 &&
                        nearest.distance <= relative_motion(edges_.ends(edge_), edges_.ends(other),
                                                            view_.now.velocity, view_.step);
  if (!near && memory == nullptr && !may_pass && !takes_over(key)) return;
  const double sine = sine_between(first, second);
  if (sine < tolerances::parallel) return;

  // Where the lines cross, their common perpendicular tells the sides apart however near they are.
  const bool crosses = nearest.both_inside();
  if (!crosses && nearest.distance == 0) return;
  const Vec3 across = cross(first.along(), second.along());
  const double towards = dot(nearest.away, across) >= 0 ? 1.0 : -1.0;
  const Vec3 present = crosses ? towards / norm(across) * across : (1.0 / nearest.distance) * nearest.away;
  const Side known = knows_side ? Side{memory->side, memory->wrong == 0} : known_side(key, may_pass);
  const bool wrong = dot(present, known.normal) < 0;
  if (!near && !wrong) return;
  // Off the end of an edge that nothing continues, or further than the edges are long, the pair is lost.
  if (wrong && (nearest.distance > std::min(norm(first.along()), norm(second.along())) ||
                (!crosses && !owns_ends(nearest, other))))
    return;

  EdgePair pair;
  pair.key = key;
  pair.wrong = wrong ? 1 : 0;
  pair.fraction = nearest.fraction;
  pair.normal = wrong ? -present : present;
  pair.side = pair.normal;
  if (wrong && !crosses) pair.side = (dot(across, known.normal) >= 0 ? 1.0 : -1.0) / norm(across) * across;
  pair.gap = crosses ? dot(nearest.away, pair.normal) : (wrong ? -1 : 1) * nearest.distance;
  pair.share = share_of(nearest, pair, sine);
  pair.starts_loaded = deepest_node(key) > 0;
  set_offset(pair, full, memory, wrong && !known.passed_now);
  found.push_back(pair);
}

/// Whether another edge goes on where the nearest points are at ends, and this pair is the lowest of those
/// that meet there, unless one of the others crosses inside of its edges.
bool EdgePairSearch::owns_ends(const NearestOnEdges& nearest, Index other) const {
  const std::array<Index, 2> own{edge_, other};
  for (int i = 0; i < 2; ++i) {
    if (nearest.inside(i)) continue;
    const Index node = edges_.ends(own[i])[nearest.fraction[i] == 0 ? 0 : 1];
    const auto around = edges_.at_node(view_.surface->place[node]);
    if (around.size() < 2 || lowest_at(edges_, *view_.surface, node, own[1 - i]) != own[i]) return false;
    const EdgeShape target = view_.shape(own[1 - i]);
    for (const Index next : around)
      if (next != own[i] && !edges_.share_node(next, own[1 - i]) &&
          nearest_points(view_.shape(next), target).both_inside())
        return false;
  }
  return true;
}

/// Share of the force of a crossing. Edges that are almost parallel leave the contact to their ends, and ends
/// are seen to by nodes, unless the edges have gone through each other: nodes know nothing of that.
double EdgePairSearch::share_of(const NearestOnEdges& nearest, const EdgePair& pair, double sine) const {
  if (!nearest.both_inside())
    return pair.wrong != 0 ? ramp(sine, tolerances::almost_parallel, tolerances::crossing) : 0;
  const Vec3 on_first = view_.shape(pair.key.first).at(nearest.fraction[0]);
  const Vec3 on_second = on_first - nearest.away;
  const double first = fall_away(pair.key.first, on_first, pair.normal);
  const double second = fall_away(pair.key.second, on_second, -pair.normal);
  return ramp(sine, tolerances::almost_parallel, tolerances::crossing) *
         ramp(std::max(first, second), tolerances::flat, tolerances::folded) *
         ramp(std::min(first, second), tolerances::hollow, tolerances::almost_flat);
}

/// Sine of the angle by which the surface falls away from an edge, in the direction in which it is pushed, on
/// the flatter of its sides; 1 of free edges and beams. Inside of a surface an edge touches where it stands
/// out. What is flat or hollow there the nodes see to.
double EdgePairSearch::fall_away(Index edge, const Vec3& point, const Vec3& push) const {
  int segments = 0;
  double least = 1;
  const EdgeShape shape = view_.shape(edge);
  const Vec3 along = normalised(shape.along());
  for (const Index s : edges_.segments_at(edge)) {
    if (view_.surface->active[s] == 0) continue;
    ++segments;
    const Vec3 to_centre = shape_of(*view_.surface, view_.now, s).centre - point;
    const Vec3 into = to_centre - dot(to_centre, along) * along;
    const double length = norm(into);
    least = std::min(least, length > 0 ? dot(push, into) / length : 0.0);
  }
  return segments < 2 ? 1 : least;
}

/// By how much the contact distance is reduced. What has opened stays open: the allowance only shrinks, but
/// for a contact that now takes over the force from others.
void EdgePairSearch::set_offset(EdgePair& pair, double full, const RememberedEdgePair* memory,
                                bool was_wrong) const {
  const double overlap = std::max(0.0, full - pair.gap);
  double offset = memory != nullptr ? memory->offset : 0;
  if (view_.tracking)
    offset = overlap;
  else if (memory == nullptr || (memory->share == 0 && pair.share > 0))
    offset = std::max(offset, new_offset(pair, full, was_wrong));
  pair.offset = std::clamp(offset, 0.0, overlap);
  pair.reach = full - pair.offset;
}

/// As NodeSearch::offset_of: a contact cannot begin deeper than those were from which it comes, of edges or
/// of their ends, plus its approach in the step.
double EdgePairSearch::new_offset(const EdgePair& pair, double full, bool was_wrong) const {
  const EdgePairKey& key = pair.key;
  double inherited = 0;
  double depth = 0;
  visit_connected(view_, view_.remembered, key, [&](const RememberedEdgePair& other, double) {
    inherited = std::max(inherited, other.offset);
    depth = std::max(depth, other.depth);
  });
  depth = std::max(depth, deepest_node(key));
  Configuration before = view_.now;
  before.back = view_.step;
  const EdgeShape first = edge_shape(edges_.ends(key.first), before);
  const EdgeShape second = edge_shape(edges_.ends(key.second), before);
  const double distance = key.meeting == EdgeMeeting::Crossing
                              ? nearest_points(first, second).distance
                              : end_points(first, second, key.meeting).distance;
  return std::max(inherited, full - std::max(was_wrong ? -distance : distance, pair.gap) - depth);
}

/// Penetration that a node had at an edge in the step before, of those contacts that are the nodes' business.
double EdgePairSearch::node_depth(Index node, Index edge) const {
  const NodeOnEdge wanted{node, edge, 0};
  double depth = 0;
  for (auto at = std::lower_bound(view_.node_depths.begin(), view_.node_depths.end(), wanted);
       at != view_.node_depths.end() && at->node == node && at->edge == edge; ++at)
    depth = std::max(depth, at->value);
  return depth;
}

/// The same of the ends of two edges, each with the other edge.
double EdgePairSearch::deepest_node(const EdgePairKey& key) const {
  double depth = 0;
  for (const Index node : edges_.ends(key.first)) depth = std::max(depth, node_depth(node, key.second));
  for (const Index node : edges_.ends(key.second)) depth = std::max(depth, node_depth(node, key.first));
  return depth;
}

/// True unless another edge at an end of `edge`, where the point nearest to `node` is, comes nearer to the
/// node or is as near and lower. `away` points from that point to the node.
bool EdgePairSearch::nearest_of_others(Index node, Index edge, double fraction, const Vec3& away) const {
  if (fraction > 0 && fraction < 1) return true;
  const Index corner = edges_.ends(edge)[fraction == 0 ? 0 : 1];
  const Vec3 at_corner = view_.now[corner];
  for (const Index other : edges_.at_node(view_.surface->place[corner])) {
    if (other == edge) continue;
    if (edges_.has(other, node)) return false;
    const EdgeNodes ends = edges_.ends(other);
    const Vec3 into = view_.now[ends[0] == corner ? ends[1] : ends[0]] - at_corner;
    if (dot(away, into) > tolerances::comes_nearer * norm(away) * norm(into)) return false;
    if (other < edge && lowest_at(edges_, *view_.surface, node, other) != no_index) return false;
  }
  return true;
}

/// The contact of an end of one edge with the other, which is a beam that no node search sees.
void EdgePairSearch::examine_end(EdgeMeeting meeting, Index other, double full,
                                 std::vector<EdgePair>& found) const {
  const EdgePairKey key{edge_, other, meeting};
  const Index own = of_first(meeting) ? edge_ : other;
  const Index target = of_first(meeting) ? other : edge_;
  const Index node = end_of(edges_, key);
  // The lowest of the edges that end there stands for the node.
  if (lowest_at(edges_, *view_.surface, node, target) != own) return;
  const NearestOnEdges nearest = end_points(view_.shape(edge_), view_.shape(other), meeting);
  if (nearest.distance >= full || nearest.distance == 0) return;
  const Vec3 from_target = of_first(meeting) ? nearest.away : -nearest.away;
  if (!nearest_of_others(node, target, nearest.fraction[of_first(meeting) ? 1 : 0], from_target)) return;

  const RememberedEdgePair* memory = memory_of(key);
  EdgePair pair;
  pair.key = key;
  pair.fraction = nearest.fraction;
  pair.normal = (1.0 / nearest.distance) * nearest.away;
  pair.gap = nearest.distance;
  set_offset(pair, full, memory, false);
  found.push_back(pair);
}

void carry_on(const EdgeView& view, std::span<const EdgePair> present, EdgePair& pair) {
  if (pair.share == 0) return;
  const RememberedEdgePair* from = nullptr;
  double turned = 1;
  const auto rests = [&](const EdgePairKey& key) {
    const auto before = [](const EdgePair& other, const EdgePairKey& k) { return other.key < k; };
    const auto at = std::lower_bound(present.begin(), present.end(), key, before);
    return at == present.end() || at->key != key || at->share == 0;
  };
  visit_connected(view, view.remembered, pair.key, [&](const RememberedEdgePair& other, double sign) {
    const bool own = other.key == pair.key;
    if (!own && (!other.loaded() || !rests(other.key))) return;
    // The pair itself comes before its neighbours if it has anything to remember.
    const bool better =
        from == nullptr || (own && other.loaded()) || (from->key == pair.key && !from->loaded());
    if (!better) return;
    from = &other;
    turned = sign;
  });
  if (from == nullptr) return;
  bool shared = false;
  if (from->key != pair.key)
    visit_connected(view, present, from->key, [&](const EdgePair& other, double) {
      shared = shared || (other.share > 0 && other.key < pair.key);
    });
  const EdgeShape first = view.shape(from->key.first);
  const EdgeShape second = view.shape(from->key.second);
  // The normal has turned with the edges since; the friction lies across it.
  const Vec3 normal = from->key == pair.key ? pair.normal : turned * pair.normal;
  pair.slip = turned * (first.at(from->fraction[0]) - second.at(from->fraction[1]));
  pair.friction = turned * frame_of(first, second, normal).to_global(from->friction);
  pair.penalty = from->penalty;
  // What the spring holds goes to one successor only.
  if (shared) pair.penalty.force = pair.penalty.energy = pair.penalty.most_energy = 0;
  const auto velocity_at = [&](Index edge, double fraction) {
    const EdgeNodes ends = view.edges->ends(edge);
    return (1 - fraction) * view.now.velocity[ends[0]] + fraction * view.now.velocity[ends[1]];
  };
  pair.last_speed =
      dot(velocity_at(from->key.first, from->fraction[0]) - velocity_at(from->key.second, from->fraction[1]),
          from->normal);
}

Frame frame_of(const EdgeShape& first, const EdgeShape& second, const Vec3& normal) {
  Frame frame;
  frame.third = normal;
  const auto across = [&](const Vec3& a) { return a - dot(a, normal) * normal; };
  const std::array<Vec3, 5> choices{first.along(), second.along(), Vec3{1, 0, 0}, Vec3{0, 1, 0},
                                    Vec3{0, 0, 1}};
  for (const Vec3& choice : choices) {
    const Vec3 axis = across(choice);
    if (norm(axis) <= tolerances::no_direction * norm(choice)) continue;
    frame.first = normalised(axis);
    break;
  }
  frame.second = cross(frame.third, frame.first);
  return frame;
}

}  // namespace crumple::contact
