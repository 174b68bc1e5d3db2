// SPDX-License-Identifier: BSD-3-Clause
// Cross sections of beams, and the points that they take from rules of their own.
#include <fmt/core.h>

#include <map>
#include <utility>

#include "deck/build/build.hpp"
#include "model/beam_section.hpp"

namespace crumple::deck {

namespace {

/// Points of a standard shape, with the nodes where the rule or, if it says nothing, the section has them.
std::vector<model::SectionPoint> shape_points(const RawBeamRule& rule, const RawBeamSection& section) {
  std::vector<model::SectionPoint> points = rule.shape;
  std::array<double, 2> node{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double place = rule.reference[axis] != 0 ? rule.reference[axis] : section.reference[axis];
    node[axis] = place > 0 ? place * rule.most[axis] : -place * rule.least[axis];
  }
  model::move_nodes(points, node[0], node[1]);
  return points;
}

/// Points that the deck gives, within the two thicknesses of the section.
std::vector<model::SectionPoint> own_points(const RawBeamRule& rule, const RawBeamSection& section) {
  std::vector<model::SectionPoint> points = rule.points;
  const auto& [s, t] = section.size;
  for (model::SectionPoint& point : points)
    point = {0.5 * s * point.s, 0.5 * t * point.t, rule.relative_area * s * t * point.area};
  model::move_nodes(points, 0.5 * section.reference[0] * s, 0.5 * section.reference[1] * t);
  return points;
}

using Rules = std::map<UserId, const RawBeamRule*>;

void take_rule(const RawBeamSection& raw, const Rules& rules, model::BeamSection& section, Build& build) {
  const auto found = rules.find(raw.rule);
  const std::string id = std::to_string(-raw.rule);
  if (found == rules.end()) {
    build.report.field_error(
        raw.where, {"QR", id, "minus the id of an integration rule of beams",
                    fmt::format("the deck has no rule {}; add it with *INTEGRATION_BEAM", raw.rule), "rule"});
    return;
  }
  const RawBeamRule* const rule = found->second;
  if (!rule->shape.empty()) {
    model::set_points(section, shape_points(*rule, raw));
  } else if (!rule->points.empty() && (!(raw.size[0] > 0) || !(raw.size[1] > 0))) {
    build.report.field_error(raw.where,
                             {"TS1", fmt::format("{:g}", raw.size[0]), "numbers above zero for TS1 and TT1",
                              "the points of the rule lie within these two thicknesses", "size"});
  } else if (!rule->points.empty()) {
    model::set_points(section, own_points(*rule, raw));
  } else if (!build.report.has_errors()) {
    build.report.field_error(raw.where, {"QR", id, "an integration rule of beams that has points",
                                         "see the message at the rule", "rule"});
  }
}

Rules rules_by_id(Build& build) {
  Rules rules;
  for (const RawBeamRule& rule : build.deck.beam_rules) {
    const auto [first, is_new] = rules.try_emplace(rule.id, &rule);
    if (!is_new)
      build.report.field_error(
          rule.where, {"IRID", std::to_string(rule.id), "an id of its own",
                       fmt::format("{} has the same", build.report.place(first->second->where)), "id"});
  }
  return rules;
}

}  // namespace

void build_beam_sections(Build& build) {
  const Rules rules = rules_by_id(build);
  for (const RawBeamSection& raw : build.deck.beam_sections) {
    build.model.beam_sections.push_back(raw.section);
    if (raw.rule != 0) take_rule(raw, rules, build.model.beam_sections.back(), build);
  }
}

void settle_discrete_beams(Build& build) {
  for (std::size_t i = 0; i < build.deck.beam_sections.size(); ++i) {
    const RawBeamSection& raw = build.deck.beam_sections[i];
    if (raw.system != 0)
      build.model.beam_sections[i].discrete.axes = find_axes(build, raw.system, "CID", raw.where);
  }
}

}  // namespace crumple::deck
