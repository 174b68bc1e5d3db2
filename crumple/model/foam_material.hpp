// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace crumple::model {

/// A function by points, its abscissae ascending.
struct PointCurve {
  std::vector<double> abscissa;
  std::vector<double> ordinate;
};

/// Crushable foam whose yield surface is an ellipse in pressure and von Mises stress
/// (*MAT_BILKHU/DUBOIS_FOAM). Curves are over -ln V from 0 on, V the relative volume; their last slopes go
/// on.
struct BilkhuDuboisFoam {
  double youngs_modulus = 0;    ///< E [stress]
  double poissons_ratio = 0;    ///< nu, of elastic and plastic strains [-]
  PointCurve pressure;          ///< LCPY: at yield under pressure from all sides [stress]
  PointCurve uniaxial;          ///< LCUYS: at yield in uniaxial compression [stress]
  double tension_pressure = 0;  ///< PC: strength under tension from all sides; 0 is none of its own [stress]
  double tension_pressure_share = 0;  ///< VPC: the same as a share of `pressure`; goes before PC [-]
  double tension_stress = 0;          ///< TSC: strength in uniaxial tension; 0 is none of its own [stress]
  double tension_stress_share = 0;    ///< VTSC: the same as a share of `uniaxial`; goes before TSC [-]
  PointCurve rate_factor;             ///< on both curves over the rate of -ln V [1/time]; or empty
  double damping = 0;                 ///< VC: least coefficient of the linear viscosity [-]
};

/// Value of a curve whose last slope goes on.
double value_at(const PointCurve& curve, double x);

/// A volumetric strain at which no ellipse goes through both strengths in compression, the yield pressure
/// being no more than a third of the uniaxial yield stress; below zero if there is none.
double no_ellipse(const BilkhuDuboisFoam& law);

}  // namespace crumple::model
