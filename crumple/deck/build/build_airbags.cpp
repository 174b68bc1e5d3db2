// SPDX-License-Identifier: BSD-3-Clause
// Control volumes: their surfaces must be closed, and have one outside.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "deck/build/build.hpp"
#include "model/solid_faces.hpp"

namespace crumple::deck {

namespace {

using Segment = std::array<Index, 4>;

/// An edge of a segment, from its lower to its higher node.
struct SurfaceEdge {
  Index low = 0;
  Index high = 0;
  Index segment = 0;
  bool forward = false;  ///< the segment goes round from low to high

  bool joins_same(const SurfaceEdge& other) const { return low == other.low && high == other.high; }
};

/// A triangle with its repeated node last.
Segment triangle_last(const Segment& node) {
  const int repeated = model::repeated_entry(node);
  if (repeated < 0) return node;
  const auto at = [&](int k) { return node[static_cast<std::size_t>(repeated + k) % 4]; };
  return {at(2), at(3), at(0), at(0)};
}

std::vector<SurfaceEdge> edges_of(const std::vector<Segment>& segments) {
  std::vector<SurfaceEdge> edges;
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (std::size_t k = 0; k < 4; ++k) {
      const Index a = segments[s][k];
      const Index b = segments[s][(k + 1) % 4];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(s), a < b});
    }
  std::sort(edges.begin(), edges.end(), [](const SurfaceEdge& a, const SurfaceEdge& b) {
    return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
  });
  return edges;
}

/// Gives the segments of a closed surface one outside: each is turned if most of those that it is connected
/// with go round the other way.
class Orientation {
 public:
  Orientation(std::vector<Segment>& segments, const std::vector<SurfaceEdge>& edges)
      : segments_(segments), neighbours_(segments.size()), state_(segments.size(), State::Unknown) {
    for (std::size_t e = 0; e + 1 < edges.size(); e += 2) {
      const bool agree = edges[e].forward != edges[e + 1].forward;
      neighbours_[static_cast<std::size_t>(edges[e].segment)].emplace_back(edges[e + 1].segment, agree);
      neighbours_[static_cast<std::size_t>(edges[e + 1].segment)].emplace_back(edges[e].segment, agree);
    }
  }

  /// Returns how many segments it has turned; empty if the surface has but one side.
  std::optional<std::size_t> unite() {
    std::size_t turned = 0;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (state_[s] != State::Unknown) continue;
      if (!walk(static_cast<Index>(s))) return std::nullopt;
      turned += turn_minority();
    }
    return turned;
  }

 private:
  enum class State : char { Unknown, Kept, Turned };

  /// Visits what is connected with a segment; false where it comes back to one with the wrong side.
  bool walk(Index first) {
    connected_.assign(1, first);
    state_[static_cast<std::size_t>(first)] = State::Kept;
    for (std::size_t i = 0; i < connected_.size(); ++i) {
      const State here = state_[static_cast<std::size_t>(connected_[i])];
      for (const auto& [next, agree] : neighbours_[static_cast<std::size_t>(connected_[i])]) {
        const State expected = (here == State::Kept) == agree ? State::Kept : State::Turned;
        State& there = state_[static_cast<std::size_t>(next)];
        if (there == State::Unknown) {
          there = expected;
          connected_.push_back(next);
        } else if (there != expected) {
          return false;
        }
      }
    }
    return true;
  }

  std::size_t turn_minority() {
    const auto is_turned = [&](Index s) { return state_[static_cast<std::size_t>(s)] == State::Turned; };
    const auto turned =
        static_cast<std::size_t>(std::count_if(connected_.begin(), connected_.end(), is_turned));
    const bool most = 2 * turned > connected_.size();
    for (const Index s : connected_)
      if (is_turned(s) != most) {
        Segment& node = segments_[static_cast<std::size_t>(s)];
        node = node[2] == node[3] ? Segment{node[1], node[0], node[2], node[2]}
                                  : Segment{node[3], node[2], node[1], node[0]};
      }
    return most ? connected_.size() - turned : turned;
  }

  std::vector<Segment>& segments_;
  std::vector<std::vector<std::pair<Index, bool>>> neighbours_;  ///< and whether they go round alike
  std::vector<State> state_;
  std::vector<Index> connected_;
};

/// False of a segment with a node that the deck does not define, which has been reported.
bool is_whole(const Segment& segment) {
  return std::find(segment.begin(), segment.end(), no_index) == segment.end();
}

/// The segments that the set names; nothing, with a message, if there are none, and nothing if one of them is
/// not whole.
std::vector<Segment> named_segments(const RawControlVolume& raw, Build& build) {
  std::vector<Segment> segments;
  const model::Model& model = build.model;
  const Reference reference{raw.set, "SID", raw.where};
  const Index set = build.find(raw.is_parts ? Item::PartSet : Item::SegmentSet, reference);
  if (set == no_index) return segments;
  if (!raw.is_parts) {
    segments = model.segment_sets[static_cast<std::size_t>(set)].segments;
  } else {
    const std::vector<Index>& parts = model.part_sets[static_cast<std::size_t>(set)].parts;
    const std::set<Index> members(parts.begin(), parts.end());
    for (const model::ShellElement& shell : model.shells)
      if (members.count(shell.part) != 0) segments.push_back(shell.node);
  }
  if (!std::all_of(segments.begin(), segments.end(), is_whole)) return {};
  for (Segment& segment : segments) segment = triangle_last(segment);
  if (segments.empty())
    build.report.field_error(raw.where, {"SID", std::to_string(raw.set), "a set with segments or shells",
                                         "the set is empty, or its parts have no shells", "empty"});
  return segments;
}

/// False, with a message, if an edge belongs to another number of segments than two.
bool is_closed(const RawControlVolume& raw, const std::vector<SurfaceEdge>& edges, Build& build) {
  std::size_t faults = 0;
  std::string first;
  for (std::size_t e = 0; e < edges.size();) {
    std::size_t end = e + 1;
    while (end < edges.size() && edges[end].joins_same(edges[e])) ++end;
    if (end - e != 2 && ++faults == 1) {
      const auto node = [&](Index index) { return build.model.nodes.id[static_cast<std::size_t>(index)]; };
      first = fmt::format("the edge between nodes {} and {} belongs to {} segment{}", node(edges[e].low),
                          node(edges[e].high), end - e, end - e == 1 ? "" : "s");
    }
    e = end;
  }
  if (faults == 0) return true;
  build.report.field_error(
      raw.where,
      {"SID", std::to_string(raw.set), "a closed surface, where two segments meet at each edge",
       fmt::format(
           "{}{}; close openings with shells of *MAT_NULL, and leave inner walls and repeated segments out",
           first, faults == 1 ? "" : fmt::format(", one of {} such edges", faults)),
       "open"});
  return false;
}

/// Gives the surface one outside. False, with a message, if it has none, or is inside out.
bool is_oriented(const RawControlVolume& raw, const std::vector<SurfaceEdge>& edges,
                 std::vector<Segment>& segments, Build& build) {
  const std::optional<std::size_t> turned = Orientation(segments, edges).unite();
  if (!turned) {
    build.report.field_error(raw.where, {"SID", std::to_string(raw.set), "a surface with two sides",
                                         "this one has no outside", "one_sided"});
    return false;
  }
  if (*turned > 0)
    build.report.field_warning(
        raw.where,
        {"SID", std::to_string(raw.set), "segments whose normals are all outwards",
         fmt::format("{} of {} are turned, as most of those around them", *turned, segments.size()),
         "turned"});
  const double volume = model::enclosed_volume(build.model.nodes.position, segments);
  if (volume > 0) return true;
  build.report.field_error(raw.where,
                           {"SID", std::to_string(raw.set), "a surface with its normals outwards",
                            fmt::format("it encloses a volume of {:g}; turn the segments, and close a folded "
                                        "surface around some volume",
                                        volume),
                            "volume"});
  return false;
}

/// The curves of a filling, in the order of RawControlVolume::curves.
class FillingCurves {
 public:
  FillingCurves(const RawControlVolume& raw, Build& build) : raw_(raw), build_(build) {}

  void operator()(model::PressureOfVolume& filling) {
    filling.curve = find(0, "LCID", raw_.gas_where);
    if (raw_.curves[0] == 0 && filling.coefficient == 0)
      build_.report.field_error(raw_.gas_where, {"CN", "0", "a number above zero",
                                                 "or give the pressure as a curve with LCID", "cn"});
  }
  void operator()(model::AdiabaticGas&) {}
  void operator()(model::LinearFluid& filling) {
    filling.inflow = find(0, "LCINT", raw_.gas_where);
    filling.outflow = find(1, "LCOUTT", raw_.gas_where);
    filling.outflow_pressure = find(2, "LCOUTP", raw_.gas_where);
    filling.added_pressure = find(3, "LCFIT", raw_.gas_where);
    filling.bulk_modulus_time = find(4, "LCBULK", raw_.gas_where);
    filling.limit_time = find(5, "P_LIMLC", raw_.more_where);
  }
  void operator()(model::InflatedGas& filling) {
    filling.inflow = find(0, raw_.gas_where.keyword.find("WANG") != std::string_view::npos ? "LCMT" : "LCID",
                          raw_.gas_where);
    filling.outflow = find(1, "LOU", raw_.more_where);
    filling.temperature_time = find(2, "LCT", raw_.gas_where);
    if (raw_.curves[1] != 0 && filling.vent != 0)
      build_.report.field_error(raw_.more_where,
                                {"LOU", std::to_string(raw_.curves[1]), "0 where MU and AREA are given",
                                 "the gas leaves through an orifice or by a curve", "two_outflows"});
  }

 private:
  Index find(std::size_t place, std::string_view field, const Where& where) {
    const UserId id = raw_.curves[place];
    return id == 0 ? no_index : build_.find(Item::Curve, {id, field, where});
  }

  const RawControlVolume& raw_;
  Build& build_;
};

/// The material of each shell, by its corners.
std::map<Segment, Index> material_of_shells(const model::Model& model) {
  std::map<Segment, Index> found;
  for (const model::ShellElement& shell : model.shells) {
    if (shell.part == no_index || !is_whole(shell.node)) continue;
    const Index material = model.parts[static_cast<std::size_t>(shell.part)].material;
    if (material != no_index) found[model::key_of(triangle_last(shell.node))] = material;
  }
  return found;
}

/// Adds the fabric of the surface that lets gas through, by material.
void take_porous_fabric(const RawControlVolume& raw, model::ControlVolume& volume, Build& build) {
  const std::map<Segment, Index> material_of = material_of_shells(build.model);
  std::map<Index, model::PorousFabric> porous;
  bool is_reported = false;
  for (const Segment& segment : volume.segments) {
    const auto found = material_of.find(model::key_of(segment));
    if (found == material_of.end()) continue;
    const auto* fabric =
        std::get_if<model::Fabric>(&build.model.materials[static_cast<std::size_t>(found->second)].law);
    if (fabric == nullptr) continue;
    const model::FabricLeakage& leakage = fabric->leakage;
    if (leakage.coefficient == 0 && leakage.coefficient_time == no_index) continue;
    const int venting = leakage.venting != 0 ? leakage.venting : raw.fabric_venting;
    if (!raw.vents_fabric || venting == 0) {
      if (!is_reported)
        build.report.warning(raw.where, "porous",
                             "the surface has *MAT_FABRIC with FLC, but no gas leaves through it: of "
                             "*AIRBAG_WANG_NEFSKE it does, with OPT, or FVOPT of the fabric");
      is_reported = true;
      continue;
    }
    porous[found->second] = {.segments = std::move(porous[found->second].segments),
                             .coefficient = leakage.coefficient,
                             .coefficient_time = leakage.coefficient_time,
                             .area = leakage.area,
                             .area_pressure = leakage.area_pressure,
                             .by_velocity = venting == 7};
    porous[found->second].segments.push_back(segment);
  }
  for (const auto& [material, fabric] : porous) volume.porous.push_back(fabric);
}

/// Id of a volume that the deck gives none, from its place among all; of no other one.
UserId unnamed_id(const Build& build, std::size_t place) {
  UserId id = static_cast<UserId>(place) + 1;
  while (build.find_quietly(Item::ControlVolume, id) != no_index) ++id;
  return id;
}

}  // namespace

void build_airbags(Build& build) {
  const std::vector<RawControlVolume>& all = build.deck.control_volumes;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].volume.id != 0) build.enter(Item::ControlVolume, {all[i].volume.id, "ABID", all[i].where}, i);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RawControlVolume& raw = all[i];
    model::ControlVolume volume = raw.volume;
    if (volume.id == 0) {
      volume.id = unnamed_id(build, i);
      build.enter(Item::ControlVolume, {volume.id, "ABID", raw.where}, i);
    }
    std::visit(FillingCurves(raw, build), volume.filling);
    if (raw.set == 0) continue;
    volume.segments = named_segments(raw, build);
    if (volume.segments.empty()) continue;
    const std::vector<SurfaceEdge> edges = edges_of(volume.segments);
    if (!is_closed(raw, edges, build) || !is_oriented(raw, edges, volume.segments, build)) continue;
    take_porous_fabric(raw, volume, build);
    build.model.control_volumes.push_back(volume);
  }
}

}  // namespace crumple::deck
