// SPDX-License-Identifier: BSD-3-Clause
// LCRATE of concrete: factors on the strength over the strain rate.
#include <fmt/core.h>

#include <algorithm>
#include <variant>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

using RateFactors = model::ThreeSurfaceConcrete::RateFactors;

/// The points of a curve on one side of zero, with the rates positive, from that at zero on.
RateFactors side_of(const model::Curve& curve, double sign) {
  RateFactors found{{0}, {std::max(1.0, curve.at(0))}};
  const std::size_t count = curve.abscissa.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = sign > 0 ? k : count - 1 - k;
    if (!(sign * curve.abscissa[i] > 0)) continue;
    found.rate.push_back(sign * curve.abscissa[i]);
    found.factor.push_back(curve.ordinate[i]);
  }
  return found;
}

}  // namespace

void take_rate_factors(const RawMaterial& raw, model::ConstitutiveLaw& law, Build& build) {
  auto* const concrete = std::get_if<model::ThreeSurfaceConcrete>(&law);
  const UserId id = raw.more_curves[0];
  if (concrete == nullptr || id == 0) return;
  const Index index = find_points(build, {id, "LCRATE", raw.curve_where});
  if (index == no_index) return;
  const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
  concrete->compression_rates = side_of(curve, 1);
  concrete->tension_rates = side_of(curve, curve.abscissa.front() < 0 ? -1 : 1);
  constexpr std::size_t most = 48;
  const double least = *std::ranges::min_element(curve.ordinate);
  const std::size_t points =
      std::max(concrete->compression_rates.rate.size(), concrete->tension_rates.rate.size());
  const bool has_both = curve.abscissa.back() > 0;
  if (least >= 1 && points <= most && has_both) return;
  build.report.field_error(
      raw.curve_where,
      {"LCRATE", std::to_string(id),
       "a curve of factors of at least 1, with at most 47 points on each side of zero, some above it",
       fmt::format(
           "curve {} has the factor {:g} at least, and rates from {:g} to {:g}; those below zero are of "
           "tension",
           id, least, curve.abscissa.front(), curve.abscissa.back()),
       "rate"});
  concrete->compression_rates = concrete->tension_rates = {};
}

}  // namespace crumple::deck
