// SPDX-License-Identifier: BSD-3-Clause
// Loads on nodes and segments.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "deck/build/build.hpp"
#include "model/solid_faces.hpp"

namespace crumple::deck {

namespace {

void build_nodal_load(const RawNodalLoad& raw, Build& build) {
  const Index curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  std::vector<Index> nodes;
  if (raw.is_set) {
    const Index set = build.find(Item::NodeSet, {raw.target, "NSID", raw.where});
    if (set != no_index) nodes = build.model.node_sets[static_cast<std::size_t>(set)].nodes;
  } else if (const Index node = build.find(Item::Node, {raw.target, "NID", raw.where}); node != no_index) {
    nodes.push_back(node);
  }
  const auto acting = find_force(build, raw.direction, raw.scale, raw.system, raw.plane, raw.where);
  if (curve == no_index || !acting) return;
  for (const Index node : nodes) {
    model::NodalLoad load;
    load.node = node;
    load.curve = curve;
    load.force = acting->force;
    load.moment = acting->moment;
    load.plane = acting->plane;
    build.model.nodal_loads.push_back(load);
  }
}

/// The same load on every shell or segment of a set.
void build_pressure_on_set(const RawPressureLoad& raw, model::PressureLoad load, Build& build) {
  const bool of_shells = raw.shell_set != 0;
  const Index set = of_shells ? build.find(Item::ShellSet, {raw.shell_set, "ESID", raw.where})
                              : build.find(Item::SegmentSet, {raw.segment_set, "SSID", raw.where});
  if (set == no_index || load.curve == no_index) return;
  if (!of_shells) {
    for (const std::array<Index, 4>& segment :
         build.model.segment_sets[static_cast<std::size_t>(set)].segments) {
      load.node = segment;
      build.model.pressure_loads.push_back(load);
    }
    return;
  }
  for (const Index shell : build.model.shell_sets[static_cast<std::size_t>(set)].shells) {
    load.shell = shell;
    load.node = build.model.shells[static_cast<std::size_t>(shell)].node;
    build.model.pressure_loads.push_back(load);
  }
}

void build_pressure_load(const RawPressureLoad& raw, Build& build) {
  model::PressureLoad load;
  load.pressure = raw.scale;
  load.arrival = raw.arrival;
  load.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  if (raw.shell_set != 0 || raw.segment_set != 0) {
    build_pressure_on_set(raw, load, build);
    return;
  }
  if (raw.shell != 0) {
    const Index shell = build.find(Item::Shell, {raw.shell, "EID", raw.where});
    if (shell == no_index) return;
    load.node = build.model.shells[static_cast<std::size_t>(shell)].node;
    load.shell = shell;
  } else {
    constexpr std::array<std::string_view, 4> fields = {"N1", "N2", "N3", "N4"};
    const std::size_t corners = raw.node[3] == raw.node[2] ? 3 : 4;
    for (std::size_t k = 0; k < corners; ++k)
      load.node[k] = build.find(Item::Node, {raw.node[k], fields[k], raw.where});
    if (corners == 3) load.node[3] = load.node[2];
  }
  for (const Index node : load.node)
    if (node == no_index) return;
  if (load.curve != no_index) build.model.pressure_loads.push_back(load);
}

/// A segment that is a shell is loaded as long as that shell is there.
void find_loaded_shells(model::Model& model) {
  const auto segment = [](const model::PressureLoad& load) { return load.shell == no_index; };
  if (model.blast_segments.empty() &&
      std::none_of(model.pressure_loads.begin(), model.pressure_loads.end(), segment))
    return;
  std::map<std::array<Index, 4>, Index> shells;
  for (std::size_t i = 0; i < model.shells.size(); ++i)
    shells.emplace(model::key_of(model.shells[i].node), static_cast<Index>(i));
  const auto shell_of = [&](const std::array<Index, 4>& node) {
    const auto found = shells.find(model::key_of(node));
    return found == shells.end() ? no_index : found->second;
  };
  for (model::PressureLoad& load : model.pressure_loads)
    if (segment(load)) load.shell = shell_of(load.node);
  for (model::BlastSegment& load : model.blast_segments) load.shell = shell_of(load.node);
}

/// Warns of pressure on the three corners of a face of a tetrahedron with ten nodes, which leaves its
/// mid-side nodes out. `first_load` has, of each card, the place of its first segment in
/// Model::pressure_loads.
void warn_of_lone_corners(const std::vector<std::size_t>& first_load, Build& build) {
  const std::vector<model::PressureLoad>& loads = build.model.pressure_loads;
  if (loads.empty()) return;
  std::set<std::array<Index, 4>> faces;
  for (const model::SolidElement& solid : build.model.solids) {
    if (!solid.node.has_middles()) continue;
    const auto& at = model::corners_of_tetrahedron;
    for (std::size_t left_out = 0; left_out < at.size(); ++left_out) {
      std::array<Index, 4> face{};
      for (std::size_t k = 0; k < 3; ++k) face[k] = solid.node[at[(left_out + 1 + k) % at.size()]];
      face[3] = face[2];
      faces.insert(model::key_of(face));
    }
  }
  const auto lone = [&](const model::PressureLoad& load) { return faces.contains(model::key_of(load.node)); };
  const auto found = std::find_if(loads.begin(), loads.end(), lone);
  if (found == loads.end()) return;
  const auto card =
      std::upper_bound(first_load.begin(), first_load.end(), static_cast<std::size_t>(found - loads.begin()));
  build.report.warning(
      build.deck.pressure_loads[static_cast<std::size_t>(card - first_load.begin()) - 1].where, "corners",
      fmt::format(
          "{} segments with pressure are the three corners of a face of a tetrahedron with ten nodes; "
          "the pressure acts on these alone; give the face as four segments, with the nodes in the "
          "middle of its sides",
          std::count_if(loads.begin(), loads.end(), lone)));
}

}  // namespace

std::optional<ForceAndMoment> find_force(Build& build, int direction, double scale, UserId system,
                                         const std::array<UserId, 3>& plane, const Where& where) {
  constexpr int along_normal = 4;
  constexpr int about_normal = 8;
  const bool is_force = direction <= along_normal;
  const bool follows = direction == along_normal || direction == about_normal;
  ForceAndMoment result;
  Vector& vector = is_force ? result.force : result.moment;
  vector[follows ? 0 : static_cast<std::size_t>(is_force ? direction - 1 : direction - 5)] = scale;
  if (!follows) {
    const auto global = turned(build, vector, system, "CID", where);
    if (!global) return std::nullopt;
    vector = *global;
    return result;
  }
  constexpr std::array<std::string_view, 3> fields = {"M1", "M2", "M3"};
  for (std::size_t k = 0; k < 3; ++k) {
    result.plane.node[k] = build.find(Item::Node, {plane[k], fields[k], where});
    if (result.plane.node[k] == no_index) return std::nullopt;
  }
  return result;
}

void build_loads(Build& build) {
  for (const RawNodalLoad& raw : build.deck.nodal_loads) build_nodal_load(raw, build);
  std::vector<std::size_t> first_load;
  for (const RawPressureLoad& raw : build.deck.pressure_loads) {
    first_load.push_back(build.model.pressure_loads.size());
    build_pressure_load(raw, build);
  }
  build_blasts(build);
  find_loaded_shells(build.model);
  warn_of_lone_corners(first_load, build);
}

}  // namespace crumple::deck
