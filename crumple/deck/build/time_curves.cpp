// SPDX-License-Identifier: BSD-3-Clause
// What LS-DYNA makes of curves because a load or motion goes by them over time: OFFA delays it.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "deck/build/build.hpp"
#include "deck/build/timed_lists.hpp"

namespace crumple::deck {

namespace {

/// The curves of the deck that loads and motions go by, by the places in Model::curves.
std::vector<char> curves_over_time(Build& build) {
  std::vector<char> used(build.model.curves.size(), 0);
  for_each_timed_list(build.model, [&](const auto& list) {
    for (const auto& item : list)
      if (item.curve != no_index) used[static_cast<std::size_t>(item.curve)] = 1;
  });
  used.resize(std::min(used.size(), build.deck.curves.size()));
  return used;
}

/// The share of the delay up to which the ordinate is zero: LS-DYNA adds points with ordinate zero at the
/// abscissae 0 and 0.999 of the offset (S. Bala, "Curve offset in LS-DYNA", d3view.com, April 2008).
constexpr double share_at_rest = 0.999;

bool is_delayed(const RawCurve& raw, const model::Curve& curve) {
  return raw.delay > 0 && !curve.abscissa.empty() && curve.abscissa.front() > share_at_rest * raw.delay;
}

/// Gives delayed curves that begin with zero to what goes by them over time; others that use them keep them
/// as they are.
void delay_curves(const std::vector<char>& used, Build& build) {
  std::map<Index, Index> delayed;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const RawCurve& raw = build.deck.curves[i];
    if (used[i] == 0 || !is_delayed(raw, build.model.curves[i])) continue;
    model::Curve curve = build.model.curves[i];
    const std::array<double, 2> at_rest{0, share_at_rest * raw.delay};
    curve.abscissa.insert(curve.abscissa.begin(), at_rest.begin(), at_rest.end());
    curve.ordinate.insert(curve.ordinate.begin(), 2, 0.0);
    delayed[static_cast<Index>(i)] = static_cast<Index>(build.model.curves.size());
    build.model.curves.push_back(std::move(curve));
  }
  if (delayed.empty()) return;
  for_each_timed_list(build.model, [&](auto& list) {
    for (auto& item : list)
      if (const auto found = delayed.find(item.curve); found != delayed.end()) item.curve = found->second;
  });
}

/// Warns of curves whose first value holds from time zero on, though their points begin later.
void check_late_curves(const std::vector<char>& used, Build& build) {
  for (std::size_t i = 0; i < used.size(); ++i) {
    const RawCurve& raw = build.deck.curves[i];
    const model::Curve& curve = build.model.curves[i];
    if (used[i] == 0 || !raw.function.empty() || curve.abscissa.size() < 2 || is_delayed(raw, curve))
      continue;
    if (curve.abscissa.front() > 0 && curve.ordinate.front() != 0)
      build.report.warning(
          raw.where, "late curve " + std::to_string(raw.curve.id),
          fmt::format("curve {} begins at the time {:g}, and a load or motion goes by it from zero on: until "
                      "then its first value {:g} holds; add the point that is meant at zero",
                      raw.curve.id, curve.abscissa.front(), curve.ordinate.front()));
  }
}

/// Warns of displacements that do not begin at zero: the motion is that of their change.
void check_first_displacements(const std::vector<char>& used, Build& build) {
  std::vector<char> displaces(used.size(), 0);
  for (const model::PrescribedMotion& motion : build.model.prescribed_motions)
    if (motion.kind == model::PrescribedMotion::Kind::Displacement && motion.scale != 0 &&
        static_cast<std::size_t>(motion.curve) < displaces.size())
      displaces[static_cast<std::size_t>(motion.curve)] = 1;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const model::Curve& curve = build.model.curves[i];
    if (displaces[i] == 0 || curve.abscissa.size() < 2 || curve.at(0) == 0) continue;
    build.report.warning(
        build.deck.curves[i].where, "first displacement " + std::to_string(build.deck.curves[i].curve.id),
        fmt::format("curve {} is a displacement, and is {:g} at its start, where the displacement is zero: "
                    "nodes and bodies move by its changes since then; begin it with zero",
                    build.deck.curves[i].curve.id, curve.at(0)));
  }
}

}  // namespace

void finish_time_curves(Build& build) {
  const std::vector<char> used = curves_over_time(build);
  check_late_curves(used, build);
  delay_curves(used, build);
  check_first_displacements(used, build);
}

}  // namespace crumple::deck
