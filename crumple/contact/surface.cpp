// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <variant>

#include "base/error.hpp"

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

/// What a node takes from its active segments.
void measure_nodes(Surface& surface) {
  surface.node_half_thickness.assign(surface.nodes.size(), 0.0);
  surface.node_stiffness.assign(surface.nodes.size(), std::numeric_limits<double>::max());
  for (Index s = 0; s < surface.segments(); ++s) {
    if (surface.active[s] == 0) continue;
    for (int k = 0; k < 4; ++k) {
      const Index place = surface.place[surface.segment(s)[k]];
      double& half = surface.node_half_thickness[place];
      half = std::max(half, surface.half_thickness[s]);
      double& stiffness = surface.node_stiffness[place];
      stiffness = std::min(stiffness, surface.stiffness[s]);
    }
  }
}

}  // namespace

Surface build_surface(const model::Model& model, const domain::Domain& domain,
                      const model::SingleSurfaceContact& contact) {
  Surface surface;
  double edge_sum = 0;
  double edges = 0;
  for (Index b = 0; b < static_cast<Index>(domain.shells.size()); ++b) {
    const domain::ShellBlock& block = domain.shells[b];
    if (!std::binary_search(contact.parts.begin(), contact.parts.end(), block.part)) continue;
    surface.blocks.push_back(b);
    const double modulus = bulk_modulus(model, model.parts[block.part]);
    for (Index at = 0; at < block.elements; ++at) {
      const std::array<Index, 4> nodes = block.nodes_of(at);
      const model::ShellElement& shell = model.shells[block.element[at]];
      const Measure size = measure(domain.nodes, nodes.data());
      const double automatic =
          std::min(contact.thickness_scale * true_thickness(model, shell), edge_share * size.shortest_edge);
      const double thickness = contact.contact_thickness > 0 ? contact.contact_thickness : automatic;
      surface.connectivity.insert(surface.connectivity.end(), nodes.begin(), nodes.end());
      surface.segment_id.push_back(shell.id);
      surface.half_thickness.push_back(0.5 * thickness);
      surface.stiffness.push_back(model.control.contact_stiffness_scale * contact.stiffness_scale * modulus *
                                  size.area / size.largest_diagonal);
      surface.largest_half_thickness = std::max(surface.largest_half_thickness, 0.5 * thickness);
      edge_sum += size.edge_sum;
      edges += size.edges;
    }
  }
  if (surface.segment_id.empty())
    throw Error("Contact " + std::to_string(contact.id) +
                " has no shells: none of its parts has any, so there is nothing that could touch.");
  surface.mean_edge = edge_sum / edges;
  surface.active.assign(surface.segment_id.size(), 1);
  orient_alike(surface.connectivity);
  collect_nodes(model, domain.nodes, surface);
  measure_nodes(surface);
  surface.topology =
      build_topology(surface.connectivity, surface.active, surface.place, surface.node_count());
  return surface;
}

bool drop_eroded(Surface& surface, const domain::Domain& domain) {
  Index eroded = 0;
  for (const Index b : surface.blocks) eroded += domain.shells[b].eroded;
  if (eroded == surface.eroded) return false;
  surface.eroded = eroded;
  std::size_t segment = 0;
  for (const Index b : surface.blocks) {
    const domain::ShellBlock& block = domain.shells[b];
    const Index active = block.find("active")->first;
    for (Index at = 0; at < block.elements; ++at, ++segment)
      surface.active[segment] = block.state(at, active) != 0 ? 1 : 0;
  }
  measure_nodes(surface);
  surface.topology =
      build_topology(surface.connectivity, surface.active, surface.place, surface.node_count());
  return true;
}

}  // namespace crumple::contact
