// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/solid_overlaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <cellsearch/search.hpp>

#include "contact/surface/segment_shape.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

/// Sides of a hexahedron by its corners. Those of a tetrahedron that repeats corners are some of them, the
/// rest are flat.
constexpr std::array<std::array<std::size_t, 4>, 6> sides{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(b - a, cross(c - a, d - a)) / 6;
}

/// An element as the tetrahedra between its centre and the sub-triangles of its sides.
struct SolidShape {
  std::array<Vec3, 8> corner;
  Vec3 centre;

  SegmentShape side(std::size_t k) const {
    SegmentShape shape;
    for (std::size_t i = 0; i < 4; ++i) shape.corner[i] = corner[sides[k][i]];
    shape.centre = 0.25 * ((shape.corner[0] + shape.corner[1]) + (shape.corner[2] + shape.corner[3]));
    return shape;
  }
};

bool in_tetrahedron(const std::array<Vec3, 4>& x, const Vec3& p) {
  const double whole = volume(x[0], x[1], x[2], x[3]);
  if (whole == 0) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Vec3, 4> part = x;
    part[i] = p;
    if (volume(part[0], part[1], part[2], part[3]) / whole < -tolerances::outside_tetrahedron) return false;
  }
  return true;
}

/// Where a point is in an element.
struct PlaceInSolid {
  bool inside = false;
  unsigned on_sides = 0;  ///< bits of the sides that it is on
  double depth = 0;       ///< distance from the nearest of the others [length]
};

PlaceInSolid place_in(const SolidShape& solid, const Vec3& p) {
  PlaceInSolid found;
  double size = 0;
  std::array<double, sides.size()> distance{};
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const SegmentShape side = solid.side(k);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::array<Vec3, 4> part{solid.centre, side.centre, side.corner[i], side.corner[(i + 1) % 4]};
      size += std::fabs(volume(part[0], part[1], part[2], part[3]));
      found.inside = found.inside || in_tetrahedron(part, p);
    }
    const bool flat = norm(area_normal(side)) == 0;
    distance[k] =
        flat ? std::numeric_limits<double>::max() : std::sqrt(nearest_point(side, p).distance_squared);
  }
  const double least = tolerances::on_side_of_solid * std::cbrt(size);
  found.depth = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (distance[k] <= least)
      found.on_sides |= 1U << k;
    else
      found.depth = std::min(found.depth, distance[k]);
  return found;
}

/// The solids of a contact, with the sides of the contact whose nodes may touch them.
struct Solids {
  std::vector<ElementPlace> place;
  std::vector<std::uint8_t> touched_by;
};

Solids solids_of(const Surface& surface, const domain::Domain& domain) {
  const auto first = static_cast<Index>(domain.shells.size());
  std::vector<std::uint8_t> touched(domain.solids.size(), 0);
  for (Index s = 0; s < surface.segments(); ++s)
    if (surface.of_solid[s] != 0) touched[surface.behind[s].block - first] |= surface.touched_by[s];
  Solids found;
  for (Index b = 0; b < static_cast<Index>(domain.solids.size()); ++b) {
    const domain::SolidBlock& block = domain.solids[b];
    const domain::StateItem* active = block.find("active");
    for (Index at = 0; touched[b] != 0 && at < block.elements; ++at) {
      if (active != nullptr && block.state(at, active->first) == 0) continue;
      found.place.push_back({first + b, at});
      found.touched_by.push_back(touched[b]);
    }
  }
  return found;
}

using Key = std::array<Index, 4>;

Key key_of(const std::array<Index, 8>& nodes, std::size_t side) {
  Key key;
  for (std::size_t i = 0; i < 4; ++i) key[i] = nodes[sides[side][i]];
  std::ranges::sort(key);
  return key;
}

std::array<Index, 8> nodes_of(const domain::Domain& domain, const ElementPlace& place) {
  return domain.solids[place.block - static_cast<Index>(domain.shells.size())].nodes_of(place.element);
}

/// True for all nodes of an element, those between its corners among them.
bool has_node(const domain::Domain& domain, const ElementPlace& place, Index node) {
  const domain::SolidBlock& block = domain.solids[place.block - static_cast<Index>(domain.shells.size())];
  for (Index corner = 0; corner < block.corners; ++corner)
    if (block.node_of(place.element, corner) == node) return true;
  return false;
}

SolidShape shape_of(const domain::Domain& domain, const std::array<Index, 8>& nodes) {
  SolidShape shape;
  for (std::size_t k = 0; k < 8; ++k) {
    shape.corner[k] = domain.nodes.position[nodes[k]];
    shape.centre += 0.125 * shape.corner[k];
  }
  return shape;
}

/// The sides of the solids that no other one of them has.
std::vector<Key> outer_sides(const Solids& solids, const domain::Domain& domain) {
  std::vector<Key> all;
  for (const ElementPlace& place : solids.place) {
    const std::array<Index, 8> nodes = nodes_of(domain, place);
    for (std::size_t k = 0; k < sides.size(); ++k) all.push_back(key_of(nodes, k));
  }
  std::ranges::sort(all);
  std::vector<Key> once;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i + 1;
    while (end < all.size() && all[end] == all[i]) ++end;
    if (end == i + 1) once.push_back(all[i]);
    i = end;
  }
  return once;
}

/// True unless node and element are of one rigid body.
bool may_move_apart(const Surface& surface, const domain::Domain& domain, Index place,
                    const std::array<Index, 8>& nodes) {
  return surface.node_body[place] == no_index || domain.body_of_node.empty() ||
         std::ranges::any_of(
             nodes, [&](Index node) { return domain.body_of_node[node] != surface.node_body[place]; });
}

/// A node in an element or on its sides.
struct Found {
  Index node = no_index;
  Index solid = no_index;
  PlaceInSolid where;
};

/// The boxes of the solids as segments of a search: each is that of two points.
struct Boxes {
  std::vector<double> points;
  std::vector<Index> segments;

  void append(const Vec3& a) { points.insert(points.end(), {a.x, a.y, a.z}); }
  void add(const SolidShape& shape) {
    Vec3 low = shape.corner[0];
    Vec3 high = low;
    for (const Vec3& x : shape.corner)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], x[axis]);
        high[axis] = std::max(high[axis], x[axis]);
      }
    const auto at = static_cast<Index>(points.size() / 3);
    append(low);
    append(high);
    segments.insert(segments.end(), {at, at + 1, at + 1, at + 1});
  }
};

/// All nodes in or on solids that are not their own, ascending.
std::vector<Found> find_nodes(const Surface& surface, const domain::Domain& domain, const Solids& solids) {
  Boxes boxes;
  for (const Vec3& x : domain.nodes.position) boxes.append(x);
  for (const ElementPlace& place : solids.place) boxes.add(shape_of(domain, nodes_of(domain, place)));
  cellsearch::Scene scene;
  scene.positions = cellsearch::Positions(boxes.points);
  scene.segments = cellsearch::Segments(boxes.segments);
  scene.nodes = std::span<const cellsearch::Index>(surface.nodes);
  cellsearch::Settings settings;
  settings.threads = domain.execution.threads;
  cellsearch::Search search(settings);
  const cellsearch::Candidates& near = search.find(scene);
  std::vector<Found> found;
  for (Index s = 0; s < near.segments(); ++s) {
    const std::array<Index, 8> nodes = nodes_of(domain, solids.place[s]);
    const SolidShape shape = shape_of(domain, nodes);
    for (const Index node : near.of(s)) {
      const Index place = surface.place[node];
      if (!surface.bears(place) || (surface.node_side[place] & solids.touched_by[s]) == 0 ||
          has_node(domain, solids.place[s], node) || !may_move_apart(surface, domain, place, nodes))
        continue;
      const PlaceInSolid where = place_in(shape, domain.nodes.position[node]);
      if (where.inside) found.push_back({place, s, where});
    }
  }
  std::ranges::stable_sort(found, {}, &Found::node);
  return found;
}

}  // namespace

std::vector<NodeInSolid> nodes_in_solids(const Surface& surface, const domain::Domain& domain) {
  const Solids solids = solids_of(surface, domain);
  std::vector<NodeInSolid> inside;
  if (solids.place.empty()) return inside;
  const std::vector<Found> found = find_nodes(surface, domain, solids);
  const bool some_on_sides = std::ranges::any_of(found, [](const Found& f) { return f.where.on_sides != 0; });
  const std::vector<Key> outer = some_on_sides ? outer_sides(solids, domain) : std::vector<Key>{};
  // One that is on an outer side of any element only touches it.
  const auto touches = [&](const Found& f) {
    const std::array<Index, 8> nodes = nodes_of(domain, solids.place[f.solid]);
    for (std::size_t k = 0; k < sides.size(); ++k)
      if ((f.where.on_sides >> k & 1U) != 0 && std::ranges::binary_search(outer, key_of(nodes, k)))
        return true;
    return false;
  };
  for (std::size_t i = 0; i < found.size();) {
    std::size_t end = i;
    bool touching = false;
    for (; end < found.size() && found[end].node == found[i].node; ++end)
      touching = touching || touches(found[end]);
    if (!touching) inside.push_back({found[i].node, solids.place[found[i].solid], found[i].where.depth});
    i = end;
  }
  return inside;
}

std::vector<DeepPair> faces_over(const SurfaceAt& now, const std::vector<NodeInSolid>& inside) {
  const Surface& surface = *now.surface;
  std::vector<DeepPair> found;
  for (const NodeInSolid& deep : inside) {
    const Vec3 p = now.x[surface.nodes[deep.node]];
    DeepPair best;
    double nearest_of_all = std::numeric_limits<double>::max();
    for (Index s = 0; s < surface.segments(); ++s) {
      if (surface.of_solid[s] == 0 || surface.active[s] == 0 ||
          surface.behind[s].block != deep.element.block || !surface.may_touch(deep.node, s))
        continue;
      const SegmentShape shape = now.shape(s);
      const NearestPoint nearest = nearest_point(shape, p);
      const double distance = std::sqrt(nearest.distance_squared);
      nearest_of_all = std::min(nearest_of_all, distance);
      if (best.segment != no_index && distance >= best.depth) continue;
      const Vec3 normal = normalised(area_normal(shape));
      if (dot(p - nearest.point, normal) < 0 && nearest.feature == Feature::Face &&
          may_enter(now, deep.node, normal))
        best = {deep.node, s, distance};
    }
    if (best.segment != no_index && best.depth <= tolerances::ambiguous_face * nearest_of_all)
      found.push_back(best);
  }
  return found;
}

void inspect_solids(const Surface& surface, const domain::Domain& domain,
                    std::span<const RememberedPair> remembered, std::span<const Index> at_start,
                    domain::ContactInspection& seen) {
  seen.nodes_in_solids = 0;
  for (const NodeInSolid& found : nodes_in_solids(surface, domain)) {
    const bool known = std::ranges::any_of(
        remembered, [&](const RememberedPair& pair) { return pair.node == found.node && pair.wrong != 0; });
    if (known || std::ranges::binary_search(at_start, found.node)) continue;
    if (seen.nodes_in_solids++ == 0) seen.node_in_solid = surface.node_id[found.node];
  }
}

bool may_enter(const SurfaceAt& now, Index place, const Vec3& normal, std::span<const Index> hidden) {
  const Surface& surface = *now.surface;
  Vec3 sum;
  const auto around = surface.topology.at_node(place);
  if (around.empty()) return true;
  for (const Index own : around) {
    if (std::ranges::find(hidden, own) != hidden.end()) continue;
    if (surface.of_solid[own] == 0) return true;
    const Vec3 outward = normalised(area_normal(now.shape(own)));
    if (dot(outward, normal) < -tolerances::opposed) return true;
    sum += outward;
  }
  const double size = norm(sum);
  return size < tolerances::pointed * static_cast<double>(around.size() - hidden.size()) ||
         dot(sum, normal) < -tolerances::opposed * size;
}

}  // namespace crumple::contact
