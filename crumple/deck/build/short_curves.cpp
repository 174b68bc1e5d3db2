// SPDX-License-Identifier: BSD-3-Clause
// Curves over time that end before the run does.
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// Up to which abscissa each curve of a load or motion is used, or 0 where it is not. Those of motions begin
/// with the birth. A displacement that has come to its end usually is to stay there.
class CurveEnds {
 public:
  CurveEnds(std::size_t curves, double end) : last_(curves, 0.0), end_(end) {}
  void add(Index curve, double birth = 0, double death = 1e28) {
    if (curve == no_index) return;
    double& last = last_[static_cast<std::size_t>(curve)];
    last = std::max(last, std::min(death, end_) - birth);
  }
  double last(std::size_t curve) const { return last_[curve]; }

 private:
  std::vector<double> last_;
  double end_;
};

CurveEnds ends_of(const model::Model& model, double end_time) {
  CurveEnds ends(model.curves.size(), end_time);
  for (const auto& load : model.nodal_loads) ends.add(load.curve);
  for (const auto& load : model.pressure_loads) ends.add(load.curve, load.arrival);
  for (const auto& load : model.body_loads) ends.add(load.curve);
  for (const auto& load : model.rigid_body_loads) ends.add(load.curve);
  for (const auto& motion : model.prescribed_motions)
    if (motion.kind != model::PrescribedMotion::Kind::Displacement)
      ends.add(motion.curve, motion.birth, motion.death);
  return ends;
}

}  // namespace

void check_short_curves(Build& build, double end_time) {
  constexpr double same_time = 1e-6;
  const model::Model& model = build.model;
  const CurveEnds ends = ends_of(model, end_time);
  for (std::size_t i = 0; i < std::min(model.curves.size(), build.deck.curves.size()); ++i) {
    const model::Curve& curve = model.curves[i];
    const RawCurve& raw = build.deck.curves[i];
    if (!raw.function.empty() || curve.abscissa.size() < 2) continue;
    if (curve.ordinate.back() == 0 || !(curve.abscissa.back() < ends.last(i) - same_time * end_time))
      continue;
    build.report.warning(
        raw.where, "short curve " + std::to_string(raw.curve.id),
        fmt::format("curve {} ends at the time {:g}, and is used until {:g}: it keeps its last "
                    "value {:g} from there on; add the points that are meant",
                    raw.curve.id, curve.abscissa.back(), ends.last(i), curve.ordinate.back()));
  }
}

}  // namespace crumple::deck
