// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "model/curve.hpp"

namespace crumple::model {

/// Curves over one variable for ascending values of another: interpolated between both, the nearest end's
/// beyond the ends.
struct CurveFamily {
  std::vector<double> value;  ///< of each curve; one curve holds for every value
  std::vector<Curve> curve;

  bool empty() const { return curve.empty(); }
  double at(double of, double x) const;
};

/// The same ordinate everywhere.
CurveFamily constant_family(double ordinate);

/// Damage that grows with the plastic strain and depends on the state of stress (*MAT_ADD_DAMAGE_GISSMO):
/// docs/theory/gissmo.md.
struct GissmoDamage {
  bool acts = true;            ///< DTYP: it lowers the stress and makes points fail, else it is only added up
  double exponent = 1;         ///< DMGEXP [-]
  CurveFamily failure_strain;  ///< LCSDG: plastic strain [-] over triaxiality, for values of Lode's parameter
  CurveFamily critical_strain;   ///< ECRIT likewise; empty: critical_damage counts
  double critical_damage = 0;    ///< DCRIT [-]
  CurveFamily fading_exponent;   ///< FADEXP [-] over the size of the element [length]
  CurveFamily size_factor;       ///< LCREGD [-] over that size, for values of triaxiality; empty: 1
  double shear_reduction = 0;    ///< SHRF: share of the regularization that is missing in pure shear [-]
  double biaxial_reduction = 0;  ///< BIAXF: and in equal tension along two axes [-]
  std::optional<Curve> rate_factor{};  ///< LCSRS [-] over the plastic strain rate [1/time] or its logarithm
  bool logarithmic_rates = false;      ///< natural ones
  bool rates_scale_critical = true;    ///< LCSRS above zero: the factor holds for the critical strain, too
  double points = 1;  ///< NUMFIP: failed points at which the element goes; below zero percent of its layers
};

}  // namespace crumple::model
