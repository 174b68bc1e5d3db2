// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "contact/surface/beams.hpp"
#include "contact/surface/orientation.hpp"
#include "contact/surface/segment_collector.hpp"
#include "contact/surface/sides.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

void collect_nodes(const model::Model& model, const domain::NodeFields& nodes, const model::Contact& contact,
                   const std::vector<ContactBeam>& beams, Surface& surface) {
  surface.nodes = surface.connectivity;
  for (const ContactBeam& beam : beams)
    surface.nodes.insert(surface.nodes.end(), beam.nodes.begin(), beam.nodes.end());
  for (const model::ContactSide& side : contact.side)
    for (const Index node : side.nodes) surface.nodes.push_back(nodes.domain_node[node]);
  std::sort(surface.nodes.begin(), surface.nodes.end());
  surface.nodes.erase(std::unique(surface.nodes.begin(), surface.nodes.end()), surface.nodes.end());
  surface.place.assign(nodes.count(), no_index);
  surface.node_id.reserve(surface.nodes.size());
  for (Index i = 0; i < surface.node_count(); ++i) {
    surface.place[surface.nodes[i]] = i;
    surface.node_id.push_back(model.nodes.id[nodes.model_node[surface.nodes[i]]]);
  }
  surface.node_side.assign(surface.nodes.size(), 0);
  for (std::size_t i = 0; i < surface.connectivity.size(); ++i)
    surface.node_side[surface.place[surface.connectivity[i]]] |= surface.segment_side[i / 4];
  surface.lone.assign(surface.nodes.size(), 0);
  for (std::size_t i = 0; i < contact.side.size(); ++i)
    for (const Index node : contact.side[i].nodes) {
      const Index place = surface.place[nodes.domain_node[node]];
      surface.node_side[place] |= i == 0 ? first_side : second_side;
      surface.lone[place] = 1;
    }
}

/// Nodes that stand alone have the thickness of the shells that they belong to, in the contact or not.
void measure_lone_nodes(const model::Model& model, const domain::NodeFields& nodes,
                        const model::Contact& contact, Surface& surface) {
  surface.lone_half_thickness.assign(surface.nodes.size(), 0.0);
  if (contact.side[0].nodes.empty() && contact.side[1].nodes.empty()) return;
  for (const model::ShellElement& shell : model.shells) {
    const model::Part& part = model.parts[shell.part];
    const bool rigid = model::is_rigid(model, part);
    if (!(rigid ? contact.rigid_shell_thickness : contact.shell_thickness)) continue;
    const std::array<double, 4> thickness = model::shell_thickness(model, shell);
    for (std::size_t k = 0; k < 4; ++k) {
      const Index place = surface.place[nodes.domain_node[shell.node[k]]];
      if (place == no_index || surface.lone[place] == 0) continue;
      const model::ContactSide& side = contact.side[(surface.node_side[place] & first_side) != 0 ? 0 : 1];
      const double own = part.contact_thickness > 0 ? part.contact_thickness : side.contact_thickness;
      const double whole = own > 0 ? own : side.thickness_scale * part.contact_thickness_scale * thickness[k];
      double& half = surface.lone_half_thickness[place];
      half = std::max(half, 0.5 * whole);
      surface.largest_half_thickness = std::max(surface.largest_half_thickness, half);
    }
  }
}

/// Nodes of beams touch segments whether they have segments of their own or not, as long as `alive(beam)`.
template <class Alive>
void use_beams(const Alive& alive, Surface& surface) {
  for (const SurfaceBeam& beam : surface.beams)
    for (const Index place : beam.node) {
      surface.lone[place] = 0;
      surface.lone_half_thickness[place] = 0;
      surface.lone_stiffness[place] = std::numeric_limits<double>::max();
    }
  for (const SurfaceBeam& beam : surface.beams) {
    if (!alive(beam.place)) continue;
    for (const Index place : beam.node) {
      surface.lone[place] = 1;
      double& half = surface.lone_half_thickness[place];
      half = std::max(half, beam.radius);
      double& stiffness = surface.lone_stiffness[place];
      stiffness = std::min(stiffness, beam.stiffness);
    }
  }
}

void add_beams(const std::vector<ContactBeam>& beams, Surface& surface) {
  surface.lone_stiffness.assign(surface.nodes.size(), std::numeric_limits<double>::max());
  for (const ContactBeam& beam : beams) {
    const std::array<Index, 2> places{surface.place[beam.nodes[0]], surface.place[beam.nodes[1]]};
    for (const Index place : places) surface.node_side[place] |= beam.side;
    surface.largest_half_thickness = std::max(surface.largest_half_thickness, beam.radius);
    surface.beams.push_back({places, beam.place, beam.radius, beam.stiffness, beam.part});
  }
  use_beams([](const ElementPlace&) { return true; }, surface);
}

/// The part of the first segment that a node has, else of its first beam; of a node that stands alone that of
/// the first element of the model, shells before solids before beams.
void parts_of_nodes(const model::Model& model, const domain::NodeFields& nodes, Surface& surface) {
  surface.node_part.assign(surface.nodes.size(), no_index);
  const auto take = [&](Index place, Index part) {
    if (place != no_index && surface.node_part[place] == no_index) surface.node_part[place] = part;
  };
  for (std::size_t i = 0; i < surface.connectivity.size(); ++i)
    take(surface.place[surface.connectivity[i]], surface.segment_part[i / 4]);
  for (const SurfaceBeam& beam : surface.beams)
    for (const Index place : beam.node) take(place, beam.part);
  const auto take_element = [&](const auto& element) {
    for (const Index node : element.node) take(surface.place[nodes.domain_node[node]], element.part);
  };
  for (const model::ShellElement& shell : model.shells) take_element(shell);
  for (const model::SolidElement& solid : model.solids) take_element(solid);
  for (const model::BeamElement& beam : model.beams) take_element(beam);
}

/// Length to measure distances by where there are no segments [length].
double mean_length(const std::vector<ContactBeam>& beams, const domain::NodeFields& nodes) {
  double sum = 0;
  for (const ContactBeam& beam : beams)
    sum += norm(nodes.reference[beam.nodes[1]] - nodes.reference[beam.nodes[0]]);
  return sum / static_cast<double>(beams.size());
}

/// What a node takes from its active segments: the softest shell; of faces the stiffest, as small ones at a
/// rim say nothing of the solid.
void measure_nodes(Surface& surface) {
  surface.node_half_thickness = surface.lone_half_thickness;
  surface.node_stiffness = surface.lone_stiffness;
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

void collect_welds(const model::Model& model, const domain::NodeFields& nodes, Surface& surface) {
  if (model.spot_welds.empty()) return;
  surface.node_weld.assign(surface.nodes.size(), no_index);
  for (std::size_t i = 0; i < model.spot_welds.size(); ++i)
    for (const Index node : model.spot_welds[i].nodes) {
      const Index place = surface.place[nodes.domain_node[node]];
      if (place != no_index) surface.node_weld[place] = static_cast<Index>(i);
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

/// True if any node may touch any segment, now or after elements have eroded.
bool can_touch(const Surface& surface) {
  std::uint8_t nodes = 0;
  for (const std::uint8_t side : surface.node_side) nodes |= side;
  return std::any_of(surface.touched_by.begin(), surface.touched_by.end(),
                     [&](std::uint8_t sides) { return (sides & nodes) != 0; });
}

void follow_active(Surface& surface) {
  measure_nodes(surface);
  surface.topology =
      build_topology(surface.connectivity, surface.active, surface.place, surface.node_count());
  surface.some_inactive = false;
  for (const std::uint8_t active : surface.active) surface.some_inactive |= active == 0;
  for (const SurfaceBeam& beam : surface.beams)
    for (const Index place : beam.node) surface.some_inactive |= !surface.bears(place);
}

/// Whether elements are still there.
class Alive {
 public:
  explicit Alive(const domain::Domain& domain) : blocks_(domain.blocks()) {
    active_.reserve(blocks_.size());
    for (const domain::ElementBlock* block : blocks_) {
      const domain::StateItem* item = block->find("active");
      active_.push_back(item != nullptr ? item->first : no_index);
    }
  }

  bool operator()(const ElementPlace& place) const {
    const Index component = active_[place.block];
    return component == no_index || blocks_[place.block]->state(place.element, component) != 0;
  }

 private:
  std::vector<const domain::ElementBlock*> blocks_;
  std::vector<Index> active_;  ///< component of the state, by block
};

/// The same where supports along axes of their own hold some of the nodes, during the whole run.
bool hold_as_symmetry_plane(const domain::NodeFields& nodes, const Index* corners, const Vec3& across) {
  const auto local = [&](Index node) { return nodes.local_hold_of(node) != nullptr; };
  if (std::none_of(corners, corners + 4, local) || !(norm(across) > 0)) return false;
  const Vec3 normal = normalised(across);
  const double most_free = std::sqrt(1 - tolerances::along_axis * tolerances::along_axis);
  bool all_fixed = true;
  for (int k = 0; k < 4; ++k) {
    const domain::LocalHold* const hold = nodes.local_hold_of(corners[k]);
    if (hold != nullptr && !hold->lasts) return false;
    if (norm(nodes.free_translation(corners[k], normal)) > most_free) return false;
    all_fixed = all_fixed && (hold != nullptr ? hold->held == 3 : (nodes.fixed[corners[k]] & 7U) == 7U);
  }
  return !all_fixed;
}

/// Faces of solids in a plane whose nodes are all held along its normal, but not altogether, are on a plane
/// of symmetry: nothing comes from beyond it. They stay in the mesh, as the rims of their neighbours would
/// become free edges without them.
void leave_symmetry_planes_alone(const domain::NodeFields& nodes, Surface& surface) {
  for (Index s = 0; s < surface.segments(); ++s) {
    if (surface.of_solid[s] == 0) continue;
    const Index* own = surface.segment(s);
    const Vec3 across = cross(nodes.reference[own[2]] - nodes.reference[own[0]],
                              nodes.reference[own[3]] - nodes.reference[own[1]]);
    const auto held = [&](Index node, int axis) {
      return (nodes.fixed[node] & domain::fixed_translation(axis)) != 0;
    };
    const bool all_fixed = std::all_of(
        own, own + 4, [&](Index node) { return held(node, 0) && held(node, 1) && held(node, 2); });
    if (hold_as_symmetry_plane(nodes, own, across)) surface.touched_by[s] = 0;
    for (int axis = 0; axis < 3 && !all_fixed; ++axis)
      if (std::fabs(across[axis]) > tolerances::along_axis * norm(across) &&
          std::all_of(own, own + 4, [&](Index node) { return held(node, axis); }))
        surface.touched_by[s] = 0;
  }
}

/// True if welds have broken since the last look.
bool release_broken_welds(const domain::Domain& domain, Surface& surface) {
  if (surface.node_weld.empty()) return false;
  const auto broken = static_cast<Index>(std::ranges::count_if(domain.welds, &domain::WeldReport::broken));
  if (broken == surface.broken_welds) return false;
  surface.broken_welds = broken;
  for (Index& weld : surface.node_weld)
    if (weld != no_index && domain.welds[weld].broken) weld = no_index;
  return true;
}

bool follow_eroded_elements(Surface& surface, const domain::Domain& domain) {
  Index eroded = 0;
  for (const domain::ShellBlock& block : domain.shells) eroded += block.eroded;
  for (const domain::SolidBlock& block : domain.solids) eroded += block.eroded;
  for (const domain::BeamBlock& block : domain.beams) eroded += block.eroded;
  if (eroded == surface.eroded) return false;
  surface.eroded = eroded;
  const Alive alive(domain);
  bool changed = false;
  for (Index s = 0; s < surface.segments(); ++s) {
    const bool hidden = surface.ahead[s].exists() && alive(surface.ahead[s]);
    const std::uint8_t active = alive(surface.behind[s]) && !hidden ? 1 : 0;
    changed = changed || active != surface.active[s];
    surface.active[s] = active;
  }
  for (const SurfaceBeam& beam : surface.beams) changed = changed || !alive(beam.place);
  if (!changed) return false;
  use_beams(alive, surface);
  follow_active(surface);
  return true;
}

}  // namespace

Surface build_surface(const model::Model& model, const domain::Domain& domain,
                      const model::Contact& contact) {
  Surface surface;
  SegmentCollector collector(model, domain, contact, surface);
  // nodes_behind counts on the faces being first.
  collector.add_faces();
  collector.add_shells();
  surface.active.assign(surface.segment_id.size(), 1);
  for (Index s = 0; s < surface.segments(); ++s)
    if (surface.ahead[s].exists()) surface.active[s] = 0;
  orient_alike(surface.connectivity, surface.active, collector.known_orientation());
  const std::vector<ContactBeam> beams = collect_beams(model, domain, contact);
  collect_nodes(model, domain.nodes, contact, beams, surface);
  if (!can_touch(surface) && beams.empty())
    throw Error("Contact " + std::to_string(contact.id) +
                " has no segments: none of its parts has any shell or outer face of a solid, so there is "
                "nothing that could touch.");
  surface.mean_edge = surface.segments() > 0 ? collector.mean_edge() : mean_length(beams, domain.nodes);
  collect_bodies(domain, surface);
  collect_welds(model, domain.nodes, surface);
  join_nodes(domain, contact.id, surface);
  if (contact.symmetry_planes) leave_symmetry_planes_alone(domain.nodes, surface);
  measure_lone_nodes(model, domain.nodes, contact, surface);
  add_beams(beams, surface);
  parts_of_nodes(model, domain.nodes, surface);
  follow_active(surface);
  if (contact.oriented && face_other_side(surface, domain.nodes, collector.known_orientation()))
    follow_active(surface);
  return surface;
}

bool follow_erosion(Surface& surface, const domain::Domain& domain, UserId contact) {
  const bool released = release_broken_welds(domain, surface);
  const bool ended = follow_ended_ties(domain, contact, surface);
  return follow_eroded_elements(surface, domain) || released || ended;
}

}  // namespace crumple::contact
