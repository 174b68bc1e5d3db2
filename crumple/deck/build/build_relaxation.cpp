// SPDX-License-Identifier: BSD-3-Clause
// The dynamic relaxation before the run: whether there is one, and which loads and motions act in it.
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "deck/build/build.hpp"
#include "deck/build/timed_lists.hpp"

namespace crumple::deck {

namespace {

constexpr int turned_off = -999;

/// The curve of the deck at a place in Model::curves; null where there is none.
const RawCurve* raw_curve(const Build& build, Index curve) {
  const auto at = static_cast<std::size_t>(curve);
  return curve != no_index && at < build.deck.curves.size() ? &build.deck.curves[at] : nullptr;
}

/// A load or motion by a curve of the relaxation (SIDR 1, 2); null if there is none.
const RawCurve* curve_that_asks(Build& build) {
  const RawCurve* found = nullptr;
  const auto search = [&](const auto& list) {
    for (const auto& item : list)
      if (found == nullptr && phase_of_load(build, item.curve) != RawCurve::Phase::Run)
        found = raw_curve(build, item.curve);
  };
  for_each_list_of_phase(build.model, search);
  for_each_list_of_phase(build.relaxation, search);
  return found;
}

/// What of `list` acts in the relaxation.
template <class List>
void take_relaxing(const Build& build, const List& list, List& relaxing) {
  for (const auto& item : list)
    if (phase_of_load(build, item.curve) != RawCurve::Phase::Run) relaxing.push_back(item);
}

/// Body loads have been dealt out when they were made, as they may have a curve of their own for it.
model::DynamicRelaxation relaxing_loads(const Build& build) {
  const model::Model& model = build.model;
  model::DynamicRelaxation relaxing = build.relaxation;
  take_relaxing(build, model.nodal_loads, relaxing.nodal_loads);
  take_relaxing(build, model.pressure_loads, relaxing.pressure_loads);
  take_relaxing(build, model.rigid_body_loads, relaxing.rigid_body_loads);
  take_relaxing(build, model.prescribed_motions, relaxing.prescribed_motions);
  return relaxing;
}

/// What goes by curves of the relaxation alone does not act in the run.
void leave_out_of_run(Build& build) {
  std::vector<char> left_out(build.deck.curves.size(), 0);
  for_each_list_of_phase(build.model, [&](auto& list) {
    std::erase_if(list, [&](const auto& item) {
      const bool relaxes = phase_of_load(build, item.curve) == RawCurve::Phase::Relaxation;
      if (relaxes) left_out[static_cast<std::size_t>(item.curve)] = 1;
      return relaxes;
    });
  });
  if (build.model.relaxation) return;
  for (std::size_t i = 0; i < left_out.size(); ++i)
    if (left_out[i] != 0)
      build.report.warning(
          build.deck.curves[i].where, "relaxation " + std::to_string(build.deck.curves[i].curve.id),
          fmt::format("curve {} has SIDR = 1: it is of the dynamic relaxation before the run, which IDRFLG = "
                      "{} turns off; the loads and motions by it are left out",
                      build.deck.curves[i].curve.id, turned_off));
}

/// Refuses what moves or fills by itself over the time of the run.
void check_relaxation(const Where& where, Build& build) {
  const auto refuse = [&](std::string_view what) {
    build.report.error(where, "relaxation with " + std::string(what),
                       fmt::format("{} is not supported with a dynamic relaxation", what));
  };
  if (!build.model.control_volumes.empty()) refuse("an airbag");
  if (!build.model.viscous_segments.empty()) refuse("a non-reflecting boundary");
  const auto moves = [](const model::RigidWall& wall) {
    return wall.motion.curve != no_index || wall.mass > 0;
  };
  if (std::ranges::any_of(build.model.rigid_walls, moves)) refuse("a rigid wall that moves");
  const auto at_once = std::ranges::find_if(build.deck.velocities, &RawVelocity::begins_at_once);
  if (at_once != build.deck.velocities.end())
    build.report.field_warning(at_once->where, {"PHASE", "0", "1, after the dynamic relaxation",
                                                "the velocities begin with the run all the same", "phase"});
}

void warn_of_nothing_to_do(const Where& where, Build& build) {
  bool empty = build.model.shell_stresses.empty() && build.model.solid_stresses.empty();
  for_each_list_of_phase(*build.model.relaxation, [&](const auto& list) { empty = empty && list.empty(); });
  if (empty)
    build.report.warning(where, "idle relaxation",
                         "no curve of a load or motion has SIDR 1 or 2: nothing acts in the dynamic "
                         "relaxation but contact");
}

/// A run of no length has nothing but a relaxation to do.
void check_end_time(Build& build, double end_time) {
  if (end_time > 0 || build.model.relaxation || !build.deck.termination) return;
  if (build.deck.end_time_is_faulty) return;  // has been reported where it was read
  build.report.field_error(*build.deck.termination,
                           {"ENDTIM", build.deck.end_time_text, "a number above zero", "", "no end time"});
}

}  // namespace

RawCurve::Phase phase_of_load(const Build& build, Index curve) {
  const RawCurve* const raw = raw_curve(build, curve);
  return raw == nullptr ? RawCurve::Phase::Run : raw->phase;
}

void build_relaxation(Build& build, double end_time) {
  const RawCurve* const asking = curve_that_asks(build);
  const bool given = build.deck.relaxation.has_value();
  const int flag = given ? build.deck.relaxation->flag : 0;
  if (flag != turned_off && (flag != 0 || asking != nullptr)) {
    const Where where = given ? build.deck.relaxation->where : asking->where;
    model::DynamicRelaxation relaxation = relaxing_loads(build);
    if (given) relaxation.settings = build.deck.relaxation->settings;
    build.model.relaxation = std::move(relaxation);
    check_relaxation(where, build);
    warn_of_nothing_to_do(where, build);
  }
  leave_out_of_run(build);
  check_end_time(build, end_time);
}

}  // namespace crumple::deck
