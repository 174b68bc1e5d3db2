// SPDX-License-Identifier: BSD-3-Clause
#include "elements/common/short_steps.hpp"

namespace crumple::elements {

ShortSteps short_steps(const domain::ElementBlock& block) {
  if (!(block.least_step > 0)) return {};
  return {block.least_step, block.find("short_step")->first};
}

void declare_short_steps(domain::ElementBlock& block) {
  if (block.least_step > 0) domain::add_item(block, "short_step", "-", 1);
}

template <class Real>
void end_short_elements(const ShortSteps& steps, const PointTile<Real>& tile) {
  for (Index group = 0; group < tile.groups; ++group)
    for (Index lane = 0; lane < lanes; ++lane) {
      const TilePoints<Real> points(tile, group, lane);
      if (points.state(steps.item) == Real(0)) continue;
      for (int p = 0; p < points.count(); ++p) points.lower_stress(p, 0);
      points.end();
    }
}

template <class Real>
void mark_short_elements(const ShortSteps& steps, const PointTile<Real>& tile, const Real* limit) {
  for (Index group = 0; group < tile.groups; ++group)
    for (Index lane = 0; lane < lanes; ++lane) {
      const TilePoints<Real> points(tile, group, lane);
      if (double(limit[points.place()]) < steps.least) points.state(steps.item) = Real(1);
    }
}

template void end_short_elements(const ShortSteps& steps, const PointTile<float>& tile);
template void end_short_elements(const ShortSteps& steps, const PointTile<double>& tile);
template void mark_short_elements(const ShortSteps& steps, const PointTile<float>& tile, const float* limit);
template void mark_short_elements(const ShortSteps& steps, const PointTile<double>& tile,
                                  const double* limit);

}  // namespace crumple::elements
