// SPDX-License-Identifier: BSD-3-Clause
// Charges and the segments that they load: these must be where the fits of the wave hold.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "deck/build/build.hpp"
#include "deck/build/units.hpp"

namespace crumple::deck {

namespace {

using Segment = std::array<Index, 4>;

/// A factor of a thousand in mass or length would go unnoticed.
void check_units(const RawAirBlast& raw, Build& build) {
  constexpr std::array<std::string_view, 9> systems = {
      "", "", "kg, m, s", "lbf s^2/in, in, s", "g, cm, us", "", "kg, mm, ms", "t, mm, s", "g, mm, ms"};
  const std::string_view named = systems[static_cast<std::size_t>(raw.units)];
  const std::string guess = guess_units(build.model);
  if (named.empty() || guess.empty() || guess == named) return;
  build.report.field_warning(
      raw.where,
      {"UNIT", std::to_string(raw.units), "the units of the deck",
       fmt::format("UNIT = {} is {}; densities and moduli look like {}", raw.units, named, guess), "units"});
}

void build_charge(const RawAirBlast& raw, Build& build) {
  model::AirBlast blast = raw.blast;
  if (raw.node != 0) {
    blast.node = build.find(Item::Node, {raw.node, "NIDBO", raw.more_where});
    if (blast.node == no_index) return;
    blast.centre = build.model.nodes.position[static_cast<std::size_t>(blast.node)];
  }
  check_units(raw, build);
  build.enter(Item::AirBlast, {blast.id, "BID", raw.where}, build.model.air_blasts.size());
  build.model.air_blasts.push_back(blast);
}

/// The segments of a card; empty, with a message, where something is missing.
std::vector<Segment> segments_of(const RawBlastSegment& raw, Build& build) {
  if (raw.segment_set != 0) {
    const Index set = build.find(Item::SegmentSet, {raw.segment_set, "SSID", raw.where});
    if (set == no_index) return {};
    return build.model.segment_sets[static_cast<std::size_t>(set)].segments;
  }
  constexpr std::array<std::string_view, 4> fields = {"N1", "N2", "N3", "N4"};
  Segment node{};
  const std::size_t corners = raw.node[3] == raw.node[2] ? 3 : 4;
  for (std::size_t k = 0; k < corners; ++k)
    node[k] = build.find(Item::Node, {raw.node[k], fields[k], raw.where});
  if (corners == 3) node[3] = node[2];
  if (std::find(node.begin(), node.end(), no_index) != node.end()) return {};
  return {node};
}

/// Where a segment is, seen from a charge.
struct Sight {
  double distance = 0;  ///< of its centre
  bool faces = false;   ///< its normal points to the side of the charge
};

Sight sight_of(const model::Model& model, const Segment& node, const std::array<double, 3>& charge) {
  const auto x = [&](std::size_t k) { return model.nodes.position[static_cast<std::size_t>(node[k])]; };
  const std::size_t corners = node[2] == node[3] ? 3 : 4;
  std::array<double, 3> way = charge;
  for (std::size_t k = 0; k < corners; ++k)
    for (std::size_t i = 0; i < 3; ++i) way[i] -= x(k)[i] / static_cast<double>(corners);
  double along = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    along += way[i] * ((x(2)[j] - x(0)[j]) * (x(3)[k] - x(1)[k]) - (x(2)[k] - x(0)[k]) * (x(3)[j] - x(1)[j]));
  }
  return {std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]), along > 0};
}

/// The field and the value that say which segments are meant.
FieldFault fault_of(const RawBlastSegment& raw, std::string expected, std::string hint,
                    std::string_view kind) {
  const bool is_set = raw.segment_set != 0;
  return {is_set ? "SSID" : "N1", std::to_string(is_set ? raw.segment_set : raw.node[0]), std::move(expected),
          std::move(hint), kind};
}

/// The fits are polynomials of high order, without meaning where nothing was measured.
bool check_distances(const RawBlastSegment& raw, const model::AirBlast& blast,
                     const std::vector<Segment>& segments, Build& build) {
  const model::ScaledRange range = model::scaled_range(blast.burst);
  bool any_faces = false;
  for (const Segment& segment : segments) {
    const Sight sight = sight_of(build.model, segment, blast.centre);
    any_faces = any_faces || sight.faces;
    const double scaled = model::scaled_distance(blast, sight.distance);
    if (scaled >= range.nearest && scaled <= range.farthest) continue;
    const auto id = [&](std::size_t k) { return build.model.nodes.id[static_cast<std::size_t>(segment[k])]; };
    build.report.field_error(
        raw.where,
        fault_of(raw,
                 fmt::format("segments at {:g} to {:g} ft/lb^(1/3) from the charge, where the wave is known",
                             range.nearest, range.farthest),
                 fmt::format("the segment of the nodes {}, {}, {}, {} is {:.4g} away, {:.4g} ft/lb^(1/3); {}",
                             id(0), id(1), id(2), id(3), sight.distance, scaled,
                             scaled < range.nearest ? "move the charge, or give a pressure over time "
                                                      "with *LOAD_SEGMENT_SET"
                                                    : "leave it out: it is hardly loaded"),
                 "range"));
    return false;
  }
  if (!any_faces)
    build.report.field_warning(
        raw.where, fault_of(raw, "segments whose normals point to the side of the charge",
                            "no normal does, so that they get the incident pressure alone, towards "
                            "the charge; give their nodes in the opposite order",
                            "normals"));
  return true;
}

void build_segments(const RawBlastSegment& raw, Build& build) {
  const Index index = build.find(Item::AirBlast, {raw.blast, "BID", raw.where});
  const std::vector<Segment> segments = segments_of(raw, build);
  if (index == no_index || segments.empty()) return;
  const model::AirBlast& blast = build.model.air_blasts[static_cast<std::size_t>(index)];
  if (!check_distances(raw, blast, segments, build)) return;
  for (const Segment& segment : segments)
    build.model.blast_segments.push_back({.blast = index, .node = segment, .scale = raw.scale});
}

/// A charge that loads nothing is most likely one whose segments were forgotten.
void check_use(Build& build) {
  for (const RawAirBlast& raw : build.deck.air_blasts) {
    const auto loads = [&](const RawBlastSegment& segment) { return segment.blast == raw.blast.id; };
    if (std::none_of(build.deck.blast_segments.begin(), build.deck.blast_segments.end(), loads))
      build.report.field_warning(raw.where,
                                 {"BID", std::to_string(raw.blast.id), "a blast that loads segments",
                                  "it loads none; name them with *LOAD_BLAST_SEGMENT_SET", "unused"});
  }
}

}  // namespace

void build_blasts(Build& build) {
  for (const RawAirBlast& raw : build.deck.air_blasts) build_charge(raw, build);
  for (const RawBlastSegment& raw : build.deck.blast_segments) build_segments(raw, build);
  check_use(build);
}

}  // namespace crumple::deck
