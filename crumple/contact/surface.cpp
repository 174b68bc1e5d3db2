// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <variant>

#include "base/error.hpp"
#include "model/solid_faces.hpp"

namespace crumple::contact {
namespace {

/// Share of the shortest edge that the contact thickness may not exceed.
constexpr double edge_share = 0.4;

/// Smallest 1 - 2 nu that enters the bulk modulus: nearly incompressible laws would ask for any stiffness.
constexpr double smallest_compressibility = 0.02;

double bulk_modulus(const model::Model& model, const model::Part& part) {
  const model::Material& material = model.materials[part.material];
  if (const auto* equation = model::equation_of_state_of(model, part))
    return model::initial_bulk_modulus(*equation, material.density);
  return std::visit(
      [](const auto& law) {
        const double compressibility = std::max(1.0 - 2.0 * law.poissons_ratio, smallest_compressibility);
        return law.youngs_modulus / (3.0 * compressibility);
      },
      material.law);
}

/// Lengths of one segment in the reference geometry.
struct Measure {
  double shortest_edge = std::numeric_limits<double>::max();
  double edge_sum = 0;
  int edges = 0;
  double area = 0;
  double largest_diagonal = 0;
};

Measure measure(const domain::NodeFields& nodes, const Index* segment) {
  Measure found;
  std::array<Vec3, 4> x;
  for (int k = 0; k < 4; ++k) x[k] = nodes.reference[segment[k]];
  for (int k = 0; k < 4; ++k) {
    if (!has_edge(segment, k)) continue;
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

double true_thickness(const model::Model& model, const model::ShellElement& shell) {
  const std::array<double, 4> at_nodes = model::shell_thickness(model, shell);
  return 0.25 * (at_nodes[0] + at_nodes[1] + at_nodes[2] + at_nodes[3]);
}

void collect_nodes(const model::Model& model, const domain::NodeFields& nodes, Surface& surface) {
  surface.nodes = surface.connectivity;
  std::sort(surface.nodes.begin(), surface.nodes.end());
  surface.nodes.erase(std::unique(surface.nodes.begin(), surface.nodes.end()), surface.nodes.end());
  surface.place.assign(nodes.count(), no_index);
  for (Index i = 0; i < surface.node_count(); ++i) {
    surface.place[surface.nodes[i]] = i;
    surface.node_id.push_back(model.nodes.id[nodes.model_node[surface.nodes[i]]]);
  }
}

/// What a node takes from its active segments: the softest shell; of faces the stiffest, as small ones at a
/// rim say nothing of the solid.
void measure_nodes(Surface& surface) {
  constexpr double none = std::numeric_limits<double>::max();
  surface.node_half_thickness.assign(surface.nodes.size(), 0.0);
  surface.node_stiffness.assign(surface.nodes.size(), none);
  std::vector<double> of_faces(surface.nodes.size(), 0.0);
  for (Index s = 0; s < surface.segments(); ++s) {
    if (surface.active[s] == 0) continue;
    for (int k = 0; k < 4; ++k) {
      const Index place = surface.place[surface.segment(s)[k]];
      double& half = surface.node_half_thickness[place];
      half = std::max(half, surface.half_thickness[s]);
      if (surface.is_face(s)) {
        of_faces[place] = std::max(of_faces[place], surface.stiffness[s]);
      } else {
        double& stiffness = surface.node_stiffness[place];
        stiffness = std::min(stiffness, surface.stiffness[s]);
      }
    }
  }
  for (std::size_t i = 0; i < of_faces.size(); ++i)
    if (of_faces[i] > 0) surface.node_stiffness[i] = std::min(surface.node_stiffness[i], of_faces[i]);
}

/// A segment to be added.
struct NewSegment {
  std::array<Index, 4> nodes{};
  UserId id = 0;
  double half_thickness = 0;
  double stiffness = 0;
  double height = 0;
  bool face = false;
  std::array<Index, 8> solid{};  ///< of a face: nodes of its solid
  Index block = no_index;
  Index element = no_index;
};

/// Collects segments one after the other.
class Collector {
 public:
  Collector(const model::Model& model, const domain::Domain& domain,
            const model::SingleSurfaceContact& contact, Surface& surface)
      : model_(model), domain_(domain), contact_(contact), surface_(surface) {}

  void add_faces();
  void add_shells();
  double mean_edge() const { return edge_sum_ / edges_; }

 private:
  bool takes_part(const domain::ElementBlock& block) const {
    return std::binary_search(contact_.parts.begin(), contact_.parts.end(), block.part);
  }
  double scale() const { return model_.control.contact_stiffness_scale * contact_.stiffness_scale; }
  void add(const NewSegment& segment, const Measure& size);
  std::vector<std::array<Index, 4>> covered() const;
  void add_face(const model::OuterFace& face, Index block, Index element);

  const model::Model& model_;
  const domain::Domain& domain_;
  const model::SingleSurfaceContact& contact_;
  Surface& surface_;
  double edge_sum_ = 0;
  double edges_ = 0;
};

void Collector::add(const NewSegment& segment, const Measure& size) {
  surface_.connectivity.insert(surface_.connectivity.end(), segment.nodes.begin(), segment.nodes.end());
  surface_.segment_id.push_back(segment.id);
  surface_.half_thickness.push_back(segment.half_thickness);
  surface_.stiffness.push_back(segment.stiffness);
  surface_.area.push_back(size.area);
  surface_.height.push_back(segment.height);
  surface_.of_solid.push_back(segment.face ? 1 : 0);
  if (segment.face) surface_.solid_nodes.push_back(segment.solid);
  surface_.block.push_back(segment.block);
  surface_.element.push_back(segment.element);
  surface_.largest_half_thickness = std::max(surface_.largest_half_thickness, segment.half_thickness);
  edge_sum_ += size.edge_sum;
  edges_ += size.edges;
}

void Collector::add_shells() {
  for (Index b = 0; b < static_cast<Index>(domain_.shells.size()); ++b) {
    const domain::ShellBlock& block = domain_.shells[b];
    if (!takes_part(block)) continue;
    const double modulus = bulk_modulus(model_, model_.parts[block.part]);
    for (Index at = 0; at < block.elements; ++at) {
      const model::ShellElement& shell = model_.shells[block.element[at]];
      NewSegment segment;
      segment.nodes = block.nodes_of(at);
      segment.id = shell.id;
      segment.block = b;
      segment.element = at;
      const Measure size = measure(domain_.nodes, segment.nodes.data());
      const double automatic =
          std::min(contact_.thickness_scale * true_thickness(model_, shell), edge_share * size.shortest_edge);
      segment.half_thickness =
          0.5 * (contact_.contact_thickness > 0 ? contact_.contact_thickness : automatic);
      segment.stiffness = scale() * modulus * size.area / size.largest_diagonal;
      add(segment, size);
    }
  }
}

/// Keys of the shells that take part, ascending.
std::vector<std::array<Index, 4>> Collector::covered() const {
  std::vector<std::array<Index, 4>> keys;
  for (const domain::ShellBlock& block : domain_.shells)
    if (takes_part(block))
      for (const Index shell : block.element) keys.push_back(model::key_of(model_.shells[shell].node));
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Volume from the areas and places of the faces, taken as flat (Gauss's theorem) [length^3].
double volume_of(const model::SolidElement& solid, const domain::NodeFields& nodes) {
  double sum = 0;
  for (const std::array<Index, 4>& face : model::faces_of(solid)) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = nodes.reference[nodes.domain_node[face[k]]];
    const double corners = face[2] == face[3] ? 3 : 4;
    const Vec3 centre = (1 / corners) * (x[0] + x[1] + x[2] + (corners == 4 ? x[3] : Vec3{}));
    sum += dot(centre, cross(x[2] - x[0], x[3] - x[1])) / 6;
  }
  return sum;
}

void Collector::add_face(const model::OuterFace& face, Index block, Index element) {
  const model::SolidElement& solid = model_.solids[face.solid];
  NewSegment segment;
  for (std::size_t k = 0; k < 4; ++k) segment.nodes[k] = domain_.nodes.domain_node[face.node[k]];
  segment.id = solid.id;
  segment.face = true;
  for (std::size_t k = 0; k < 8; ++k) segment.solid[k] = domain_.nodes.domain_node[solid.node[k]];
  segment.block = block;
  segment.element = element;
  const Measure size = measure(domain_.nodes, segment.nodes.data());
  segment.height = volume_of(solid, domain_.nodes) / size.area;
  segment.stiffness = scale() * bulk_modulus(model_, model_.parts[solid.part]) * size.area / segment.height;
  add(segment, size);
}

/// The faces of the parts that take part, of which no other solid of the model holds the other side.
void Collector::add_faces() {
  if (std::none_of(domain_.solids.begin(), domain_.solids.end(),
                   [&](const domain::SolidBlock& block) { return takes_part(block); }))
    return;
  std::vector<Index> all(model_.solids.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::array<Index, 2>> place(model_.solids.size(), {no_index, no_index});
  const auto first = static_cast<Index>(domain_.shells.size());
  for (Index b = 0; b < static_cast<Index>(domain_.solids.size()); ++b) {
    const domain::SolidBlock& block = domain_.solids[b];
    if (!takes_part(block)) continue;
    for (Index at = 0; at < block.elements; ++at) place[block.element[at]] = {first + b, at};
  }
  const std::vector<std::array<Index, 4>> shells = covered();
  for (const model::OuterFace& face : model::outer_faces(model_.solids, all)) {
    const auto [block, element] = place[face.solid];
    if (block == no_index || std::binary_search(shells.begin(), shells.end(), model::key_of(face.node)))
      continue;
    add_face(face, block, element);
  }
}

void collect_bodies(const domain::Domain& domain, Surface& surface) {
  surface.node_body.assign(surface.nodes.size(), no_index);
  surface.segment_body.assign(surface.segment_id.size(), no_index);
  if (domain.body_of_node.empty()) return;
  for (Index i = 0; i < surface.node_count(); ++i)
    surface.node_body[i] = domain.body_of_node[surface.nodes[i]];
  for (Index s = 0; s < surface.segments(); ++s) {
    const Index* nodes = surface.segment(s);
    const Index body = domain.body_of_node[nodes[0]];
    const bool all =
        std::all_of(nodes, nodes + 4, [&](Index node) { return domain.body_of_node[node] == body; });
    if (all) surface.segment_body[s] = body;
  }
}

}  // namespace

Surface build_surface(const model::Model& model, const domain::Domain& domain,
                      const model::SingleSurfaceContact& contact) {
  Surface surface;
  Collector collector(model, domain, contact, surface);
  // solid_nodes counts on the faces being first.
  collector.add_faces();
  collector.add_shells();
  if (surface.segment_id.empty())
    throw Error("Contact " + std::to_string(contact.id) +
                " has no segments: none of its parts has any shell or outer face of a solid, so there is "
                "nothing that could touch.");
  surface.mean_edge = collector.mean_edge();
  surface.active.assign(surface.segment_id.size(), 1);
  orient_alike(surface.connectivity, surface.of_solid);
  collect_nodes(model, domain.nodes, surface);
  collect_bodies(domain, surface);
  measure_nodes(surface);
  surface.topology =
      build_topology(surface.connectivity, surface.active, surface.place, surface.node_count());
  return surface;
}

bool drop_eroded(Surface& surface, const domain::Domain& domain) {
  Index eroded = 0;
  for (const domain::ShellBlock& block : domain.shells) eroded += block.eroded;
  for (const domain::SolidBlock& block : domain.solids) eroded += block.eroded;
  if (eroded == surface.eroded) return false;
  surface.eroded = eroded;
  const auto blocks = domain.blocks();
  std::vector<Index> active;  // component of the state, by block
  active.reserve(blocks.size());
  for (const domain::ElementBlock* block : blocks) {
    const domain::StateItem* item = block->find("active");
    active.push_back(item != nullptr ? item->first : no_index);
  }
  bool changed = false;
  for (Index s = 0; s < surface.segments(); ++s) {
    const Index b = surface.block[s];
    if (surface.active[s] == 0 || active[b] == no_index) continue;
    if (blocks[b]->state(surface.element[s], active[b]) != 0) continue;
    surface.active[s] = 0;
    changed = true;
  }
  if (!changed) return false;
  measure_nodes(surface);
  surface.topology =
      build_topology(surface.connectivity, surface.active, surface.place, surface.node_count());
  return true;
}

}  // namespace crumple::contact
