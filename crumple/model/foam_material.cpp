// SPDX-License-Identifier: BSD-3-Clause
#include "model/foam_material.hpp"

#include <cstddef>

namespace crumple::model {

double value_at(const PointCurve& curve, double x) {
  if (curve.abscissa.size() == 1) return curve.ordinate[0];
  std::size_t k = 0;
  while (k + 2 < curve.abscissa.size() && x > curve.abscissa[k + 1]) ++k;
  const double slope =
      (curve.ordinate[k + 1] - curve.ordinate[k]) / (curve.abscissa[k + 1] - curve.abscissa[k]);
  return curve.ordinate[k] + slope * (x - curve.abscissa[k]);
}

double no_ellipse(const BilkhuDuboisFoam& law) {
  // Between points both curves are straight. What goes on beyond them ends at a volume of e^-20, where
  // nothing is.
  constexpr double far = 20;
  std::vector<double> places = law.pressure.abscissa;
  places.insert(places.end(), law.uniaxial.abscissa.begin(), law.uniaxial.abscissa.end());
  places.push_back(far);
  for (const double x : places)
    if (!(3 * value_at(law.pressure, x) > value_at(law.uniaxial, x))) return x;
  return -1;
}

}  // namespace crumple::model
