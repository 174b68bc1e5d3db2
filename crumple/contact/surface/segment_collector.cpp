// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/segment_collector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "contact/surface/bulk_modulus.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {

struct SegmentCollector::NewSegment {
  std::array<Index, 4> nodes{};
  UserId id = 0;
  Index part = no_index;
  double half_thickness = 0;
  double stiffness = 0;
  double height = 0;
  std::uint8_t sides = 0;
  bool face = false;
  bool of_solid = false;
  bool crushable = false;
  bool known_orientation = false;
  std::array<Index, most_nodes_of_solid> nodes_behind{};  ///< of a face
  ElementPlace behind;
  ElementPlace ahead;
};

/// Lengths of one segment in the reference geometry.
struct SegmentCollector::Measure {
  double shortest_edge = std::numeric_limits<double>::max();
  double edge_sum = 0;
  int edges = 0;
  double area = 0;
  double largest_diagonal = 0;
};

namespace {

double true_thickness(const model::Model& model, const model::ShellElement& shell) {
  const std::array<double, 4> at_nodes = model::shell_thickness(model, shell);
  return 0.25 * (at_nodes[0] + at_nodes[1] + at_nodes[2] + at_nodes[3]);
}

/// Domain nodes of a solid, some of them more than once.
std::array<Index, most_nodes_of_solid> nodes_of(const model::SolidElement& solid,
                                                const domain::NodeFields& nodes) {
  std::array<Index, most_nodes_of_solid> found{};
  found.fill(nodes.domain_node[solid.node[0]]);
  std::size_t count = 0;
  for (std::size_t k = 0; k < solid.node.size(); ++k) {
    // Of a tetrahedron with ten nodes the corners that are repeated are left out.
    if (solid.node.has_middles() && k < model::SolidNodes::corners &&
        std::ranges::find(model::corners_of_tetrahedron, k) == model::corners_of_tetrahedron.end())
      continue;
    found[count++] = nodes.domain_node[solid.node[k]];
  }
  return found;
}

/// Volume from the areas and places of the faces, taken as flat (Gauss's theorem) [length^3]; of a
/// tetrahedron with ten nodes that of the eight it is cut into, as its segments are theirs.
double volume_of(const model::SolidElement& solid, const domain::NodeFields& nodes) {
  double sum = 0;
  for (const std::array<Index, 4>& face : model::faces_of(solid)) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = nodes.reference[nodes.domain_node[face[k]]];
    const double corners = face[2] == face[3] ? 3 : 4;
    const Vec3 centre = (1 / corners) * (x[0] + x[1] + x[2] + (corners == 4 ? x[3] : Vec3{}));
    sum += dot(centre, cross(x[2] - x[0], x[3] - x[1])) / 6;
  }
  return solid.node.has_middles() ? sum / 8 : sum;
}

bool is_cohesive(const model::Model& model, Index solid) {
  const Index section = model.parts[model.solids[solid].part].solid_section;
  return section != no_index && model::is_cohesive(model.solid_sections[section].formulation);
}

}  // namespace

SegmentCollector::SegmentCollector(const model::Model& model, const domain::Domain& domain,
                                   const model::Contact& contact, Surface& surface)
    : model_(model),
      domain_(domain),
      contact_(contact),
      sides_(model, contact),
      surface_(surface),
      sides_of_node_(sides_.of_nodes()),
      solid_place_(model.solids.size()) {
  // Elements that cannot fail do not keep the energy that they would take along.
  for (const domain::ElementBlock* block : domain.blocks())
    erodes_.push_back(block->find("energy") != nullptr ? 1 : 0);
  const auto first = static_cast<Index>(domain.shells.size());
  for (Index b = 0; b < static_cast<Index>(domain.solids.size()); ++b)
    for (Index at = 0; at < domain.solids[b].elements; ++at)
      solid_place_[domain.solids[b].element[at]] = {first + b, at};
}

SegmentCollector::Measure SegmentCollector::measure(const std::array<Index, 4>& segment) const {
  Measure found;
  std::array<Vec3, 4> x;
  for (std::size_t k = 0; k < 4; ++k) x[k] = domain_.nodes.reference[segment[k]];
  for (int k = 0; k < 4; ++k) {
    if (!has_edge(segment.data(), k)) continue;
    const double length = norm(x[(k + 1) % 4] - x[k]);
    found.shortest_edge = std::min(found.shortest_edge, length);
    found.edge_sum += length;
    ++found.edges;
  }
  found.area = 0.5 * norm(cross(x[2] - x[0], x[3] - x[1]));
  // A triangle has no diagonals; its two sides at the repeated node take their place.
  found.largest_diagonal = std::max(norm(x[2] - x[0]), norm(x[3] - x[1]));
  return found;
}

void SegmentCollector::add(const NewSegment& segment, const Measure& size) {
  surface_.connectivity.insert(surface_.connectivity.end(), segment.nodes.begin(), segment.nodes.end());
  surface_.segment_id.push_back(segment.id);
  surface_.segment_part.push_back(segment.part);
  surface_.half_thickness.push_back(segment.half_thickness);
  surface_.stiffness.push_back(segment.stiffness);
  surface_.area.push_back(size.area);
  surface_.height.push_back(segment.height);
  surface_.release_depth.push_back(release_depth(segment));
  surface_.face.push_back(segment.face ? 1 : 0);
  if (segment.face) surface_.nodes_behind.push_back(segment.nodes_behind);
  surface_.of_solid.push_back(segment.of_solid ? 1 : 0);
  surface_.crushable.push_back(segment.crushable ? 1 : 0);
  surface_.some_crushable = surface_.some_crushable || segment.crushable;
  known_orientation_.push_back(segment.known_orientation ? 1 : 0);
  surface_.segment_side.push_back(segment.sides);
  surface_.touched_by.push_back(touched_by(contact_.kind, segment.sides));
  surface_.behind.push_back(segment.behind);
  surface_.ahead.push_back(segment.ahead);
  surface_.largest_half_thickness = std::max(surface_.largest_half_thickness, segment.half_thickness);
  edge_sum_ += size.edge_sum;
  edges_ += size.edges;
}

double SegmentCollector::release_depth(const NewSegment& segment) const {
  if (contact_.release_depth <= 0) return std::numeric_limits<double>::max();
  if (contact_.oriented) return contact_.release_depth;
  return contact_.release_depth * (segment.of_solid ? segment.height : 2 * segment.half_thickness);
}

double SegmentCollector::thickness_of(const model::ShellElement& shell, std::uint8_t sides,
                                      double shortest_edge) {
  const model::Part& part = model_.parts[shell.part];
  const bool rigid = model::is_rigid(model_, part);
  if (!(rigid ? contact_.rigid_shell_thickness : contact_.shell_thickness)) return 0;
  const model::ContactSide& side = side_of(sides);
  if (part.contact_thickness > 0) return part.contact_thickness;
  if (side.contact_thickness > 0) return side.contact_thickness;
  const double whole = side.thickness_scale * part.contact_thickness_scale * true_thickness(model_, shell);
  const double most = tolerances::thickness_over_edge * shortest_edge;
  if (whole <= most || !meets_itself(shell, sides)) return whole;
  domain::ThicknessCut& cut = surface_.thickness_cut;
  ++cut.shells;
  if (cut.shells == 1 || whole * cut.to > cut.from * most) cut = {cut.shells, whole, most, shell.id, part.id};
  return most;
}

/// True if nodes of the shell may touch segments on the sides that it is on, and so the surface around it.
bool SegmentCollector::meets_itself(const model::ShellElement& shell, std::uint8_t sides) const {
  const std::uint8_t touching = touched_by(contact_.kind, sides);
  return std::ranges::any_of(shell.node, [&](Index node) { return (sides_of_node_[node] & touching) != 0; });
}

void SegmentCollector::add_shell(Index shell, const ElementPlace& place, double modulus) {
  const model::ShellElement& element = model_.shells[shell];
  NewSegment segment;
  segment.sides = sides_.of_shell(shell);
  if (segment.sides == 0) return;
  const std::array<Index, 4>* given = contact_.oriented ? sides_.given(shell) : nullptr;
  for (std::size_t k = 0; k < 4; ++k)
    segment.nodes[k] = domain_.nodes.domain_node[given != nullptr ? (*given)[k] : element.node[k]];
  segment.known_orientation = given != nullptr;
  segment.id = element.id;
  segment.part = element.part;
  segment.behind = place;
  const Measure size = measure(segment.nodes);
  if (contact_.oriented) {
    segment.face = true;
    segment.height = std::sqrt(size.area);
    for (std::size_t k = 0; k < most_nodes_of_solid; ++k) segment.nodes_behind[k] = segment.nodes[k % 4];
  }
  segment.half_thickness = 0.5 * thickness_of(element, segment.sides, size.shortest_edge);
  segment.stiffness = stiffness_scale(segment.sides) * modulus * size.area / size.largest_diagonal;
  add(segment, size);
}

void SegmentCollector::add_shells() {
  for (Index b = 0; b < static_cast<Index>(domain_.shells.size()); ++b) {
    const domain::ShellBlock& block = domain_.shells[b];
    const double modulus = bulk_modulus(model_, model_.parts[block.part]);
    for (Index at = 0; at < block.elements; ++at) add_shell(block.element[at], {b, at}, modulus);
  }
}

/// The shells of the contact by the keys of their nodes.
std::vector<SegmentCollector::Cover> SegmentCollector::covers() const {
  std::vector<Cover> found;
  for (Index b = 0; b < static_cast<Index>(domain_.shells.size()); ++b) {
    const domain::ShellBlock& block = domain_.shells[b];
    for (Index at = 0; at < block.elements; ++at) {
      const std::uint8_t sides = sides_.of_shell(block.element[at]);
      if (sides != 0) found.push_back({model::key_of(model_.shells[block.element[at]].node), {b, at}, sides});
    }
  }
  std::sort(found.begin(), found.end(), [](const Cover& a, const Cover& b) { return a.key < b.key; });
  return found;
}

void SegmentCollector::add_face(const model::SolidFace& face, std::uint8_t sides, const ElementPlace& ahead) {
  const model::SolidElement& solid = model_.solids[face.solid];
  NewSegment segment;
  for (std::size_t k = 0; k < 4; ++k) segment.nodes[k] = domain_.nodes.domain_node[face.node[k]];
  segment.nodes_behind = nodes_of(solid, domain_.nodes);
  segment.id = solid.id;
  segment.part = solid.part;
  segment.sides = sides;
  segment.face = segment.of_solid = true;
  segment.crushable = model::is_crushable(model_.materials[model_.parts[solid.part].material].law);
  segment.known_orientation = true;
  segment.behind = solid_place_[face.solid];
  segment.ahead = ahead;
  const Measure size = measure(segment.nodes);
  segment.height = volume_of(solid, domain_.nodes) / size.area;
  segment.half_thickness = 0.5 * contact_.solid_thickness;
  const double modulus =
      contact_.solid_modulus > 0 ? contact_.solid_modulus : bulk_modulus(model_, model_.parts[solid.part]);
  segment.stiffness = stiffness_scale(sides) * modulus * size.area / segment.height;
  add(segment, size);
}

/// The faces that no other solid of the model and no shell of the contact hides for good.
void SegmentCollector::add_faces() {
  if (!sides_.may_have_faces()) return;
  std::vector<Index> all(model_.solids.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<Cover> shells = covers();
  const auto before = [](const Cover& a, const std::array<Index, 4>& b) { return a.key < b; };
  for (const model::SolidFace& face : model::all_faces(model_.solids, all)) {
    // The faces of a cohesive solid are those of its neighbours, which it hides until it goes.
    if (is_cohesive(model_, face.solid)) continue;
    const std::uint8_t sides = sides_.of_face(face.solid, face.node);
    if (sides == 0 || !solid_place_[face.solid].exists()) continue;
    ElementPlace ahead;
    if (face.neighbour != no_index) {
      ahead = solid_place_[face.neighbour];
      if (!ahead.exists()) continue;
    } else if (!shells.empty()) {
      const std::array<Index, 4> key = model::key_of(face.node);
      auto cover = std::lower_bound(shells.begin(), shells.end(), key, before);
      while (cover != shells.end() && cover->key == key && cover->sides != sides) ++cover;
      if (cover != shells.end() && cover->key == key) ahead = cover->place;
    }
    if (ahead.exists() && erodes_[ahead.block] == 0) continue;
    add_face(face, sides, ahead);
  }
}

}  // namespace crumple::contact
