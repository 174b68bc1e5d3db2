// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_edge/edges.hpp"

#include <algorithm>
#include <limits>

#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

EdgeNodes ordered(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

class Builder {
 public:
  Builder(const Surface& surface, Edges& edges) : surface_(surface), edges_(edges) {}

  void number();
  void link_segments();
  void measure(const domain::Domain& domain);

 private:
  Index number_of(const EdgeNodes& ends) const {
    return static_cast<Index>(std::lower_bound(ends_.begin(), ends_.end(), ends) - ends_.begin());
  }
  template <class Visit>
  void for_each_side(const Visit& visit) const {
    for (Index s = 0; s < surface_.segments(); ++s) {
      const Index* nodes = surface_.segment(s);
      for (int k = 0; k < 4; ++k)
        if (has_edge(nodes, k)) visit(s, k, ordered(nodes[k], nodes[(k + 1) % 4]));
    }
  }

  const Surface& surface_;
  Edges& edges_;
  std::vector<EdgeNodes> ends_;
};

void Builder::number() {
  ends_.reserve(4 * surface_.segment_id.size() + edges_.beams.size());
  for_each_side([&](Index, int, const EdgeNodes& ends) { ends_.push_back(ends); });
  for (const ContactBeam& beam : edges_.beams) ends_.push_back(beam.nodes);
  std::sort(ends_.begin(), ends_.end());
  ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
  edges_.nodes.reserve(2 * ends_.size());
  for (const EdgeNodes& ends : ends_) edges_.nodes.insert(edges_.nodes.end(), ends.begin(), ends.end());
  edges_.edge_of_beam.reserve(edges_.beams.size());
  for (const ContactBeam& beam : edges_.beams) edges_.edge_of_beam.push_back(number_of(beam.nodes));
}

void Builder::link_segments() {
  edges_.of_segment.assign(surface_.segment_id.size(), {no_index, no_index, no_index, no_index});
  edges_.first_segment.assign(ends_.size() + 1, 0);
  for_each_side([&](Index s, int k, const EdgeNodes& ends) {
    const Index edge = number_of(ends);
    edges_.of_segment[s][k] = edge;
    ++edges_.first_segment[edge + 1];
  });
  for (std::size_t e = 0; e < ends_.size(); ++e) edges_.first_segment[e + 1] += edges_.first_segment[e];
  edges_.segment_at_edge.resize(static_cast<std::size_t>(edges_.first_segment.back()));
  std::vector<Index> next(edges_.first_segment.begin(), edges_.first_segment.end() - 1);
  for_each_side(
      [&](Index s, int k, const EdgeNodes&) { edges_.segment_at_edge[next[edges_.of_segment[s][k]]++] = s; });
}

void Builder::measure(const domain::Domain& domain) {
  const std::size_t count = ends_.size();
  edges_.body.assign(count, no_index);
  double sum = 0;
  for (std::size_t e = 0; e < count; ++e) {
    const auto [one, other] = ends_[e];
    sum += norm(domain.nodes.reference[one] - domain.nodes.reference[other]);
    if (!domain.body_of_node.empty() && domain.body_of_node[one] == domain.body_of_node[other])
      edges_.body[e] = domain.body_of_node[one];
  }
  edges_.mean_length = count > 0 ? sum / static_cast<double>(count) : 0;
  edges_.largest_half_thickness = surface_.largest_half_thickness;
  for (const ContactBeam& beam : edges_.beams)
    edges_.largest_half_thickness = std::max(edges_.largest_half_thickness, beam.radius);
}

/// True if the faces of solids at an edge fall away from it on both sides, undeformed. Two that have come to
/// meet by erosion count as sharp if no others are there.
bool stands_out(const Edges& edges, const Surface& surface, const domain::Domain& domain, Index edge) {
  const Configuration x{domain.nodes.reference.data(), nullptr, 0};
  const EdgeNodes ends = edges.ends(edge);
  const Vec3 start = domain.nodes.reference[ends[0]];
  const Vec3 along = normalised(domain.nodes.reference[ends[1]] - start);
  const auto faces = edges.segments_at(edge);
  for (const Index one : faces)
    for (const Index other : faces) {
      if (one == other || !surface.is_face(one) || !surface.is_face(other)) continue;
      const Vec3 to_centre = shape_of(surface, x, other).centre - start;
      const Vec3 into = normalised(to_centre - dot(to_centre, along) * along);
      if (dot(into, normalised(area_normal(shape_of(surface, x, one)))) < -tolerances::sharp_edge)
        return true;
    }
  return false;
}

/// What an edge has of its active segments; whether it takes part for their sake.
void take_from_segments(Edges& edges, const Surface& surface) {
  for (Index e = 0; e < edges.count(); ++e) {
    int segments = 0;
    int shells = 0;
    int faces = 0;
    for (const Index s : edges.segments_at(e)) {
      if (surface.active[s] == 0) continue;
      ++segments;
      if (surface.is_face(s) && edges.sharp[e] == 0) continue;
      if (surface.is_face(s)) edges.height[e] = std::max(edges.height[e], surface.height[s]);
      ++(surface.is_face(s) ? faces : shells);
      edges.side[e] |= surface.segment_side[s];
      edges.half_thickness[e] = std::max(edges.half_thickness[e], surface.half_thickness[s]);
      edges.stiffness[e] = std::min(edges.stiffness[e], surface.stiffness[s]);
      edges.area[e] = std::min(edges.area[e], surface.area[s]);
      if (edges.id[e] == 0) edges.id[e] = surface.segment_id[s];
      if (edges.part[e] == no_index) edges.part[e] = surface.segment_part[s];
    }
    const bool free = segments == 1 && shells == 1;
    edges.active[e] = free || faces > 0 || (edges.which == model::ContactEdges::All && shells > 0) ? 1 : 0;
    edges.bare[e] = segments == 0 ? 1 : 0;
  }
}

void take_from_beams(Edges& edges, const domain::Domain& domain) {
  const auto blocks = domain.blocks();
  for (std::size_t i = 0; i < edges.beams.size(); ++i) {
    const ContactBeam& beam = edges.beams[i];
    const domain::ElementBlock& block = *blocks[beam.place.block];
    const domain::StateItem* item = block.find("active");
    if (item != nullptr && block.state(beam.place.element, item->first) == 0) continue;
    const Index e = edges.edge_of_beam[i];
    edges.active[e] = 1;
    edges.side[e] |= beam.side;
    edges.half_thickness[e] = std::max(edges.half_thickness[e], beam.radius);
    edges.stiffness[e] = std::min(edges.stiffness[e], beam.stiffness);
    edges.area[e] = std::min(edges.area[e], beam.area);
    if (edges.id[e] == 0) edges.id[e] = beam.id;
    if (edges.part[e] == no_index) edges.part[e] = beam.part;
  }
}

void link_nodes(Edges& edges, const Surface& surface) {
  edges.taking_part.clear();
  edges.first_at_node.assign(surface.nodes.size() + 1, 0);
  for (Index e = 0; e < edges.count(); ++e) {
    if (edges.active[e] == 0) continue;
    edges.taking_part.push_back(e);
    for (const Index node : edges.ends(e)) ++edges.first_at_node[surface.place[node] + 1];
  }
  for (std::size_t i = 0; i < surface.nodes.size(); ++i) edges.first_at_node[i + 1] += edges.first_at_node[i];
  edges.edge_at_node.resize(static_cast<std::size_t>(edges.first_at_node.back()));
  std::vector<Index> next(edges.first_at_node.begin(), edges.first_at_node.end() - 1);
  for (const Index e : edges.taking_part)
    for (const Index node : edges.ends(e)) edges.edge_at_node[next[surface.place[node]]++] = e;
}

}  // namespace

bool Edges::next_neighbours(const Surface& surface, Index one, Index other) const {
  for (const Index a : ends(one)) {
    const Index place = surface.place[a];
    for (const Index link : at_node(place))
      if (share_node(link, other)) return true;
    for (const Index s : surface.topology.at_node(place))
      for (const Index b : ends(other))
        if (surface.owns(s, b)) return true;
  }
  return false;
}

Edges build_edges(const model::Model& model, const domain::Domain& domain, const model::Contact& contact,
                  const Surface& surface) {
  Edges edges;
  edges.which = contact.edges;
  edges.kind = contact.kind;
  if (!edges_take_part(contact)) return edges;
  Builder builder(surface, edges);
  edges.beams = collect_beams(model, domain, contact);
  builder.number();
  builder.link_segments();
  builder.measure(domain);
  edges.sharp.assign(static_cast<std::size_t>(edges.count()), 0);
  if (edges.which != model::ContactEdges::None)
    for (Index e = 0; e < edges.count(); ++e) edges.sharp[e] = stands_out(edges, surface, domain, e) ? 1 : 0;
  refresh(edges, surface, domain);
  return edges;
}

void refresh(Edges& edges, const Surface& surface, const domain::Domain& domain) {
  const auto count = static_cast<std::size_t>(edges.count());
  edges.side.assign(count, 0);
  edges.active.assign(count, 0);
  edges.bare.assign(count, 0);
  edges.half_thickness.assign(count, 0.0);
  edges.height.assign(count, 0.0);
  edges.stiffness.assign(count, std::numeric_limits<double>::max());
  edges.area.assign(count, std::numeric_limits<double>::max());
  edges.id.assign(count, 0);
  edges.part.assign(count, no_index);
  take_from_segments(edges, surface);
  take_from_beams(edges, domain);
  link_nodes(edges, surface);
}

}  // namespace crumple::contact
