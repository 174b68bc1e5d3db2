// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Concrete with a smooth cap: samples, the yield surface once more from its equations, and paths that hold
// the stress of the sides.

#include <algorithm>
#include <cmath>

#include "materials/solid_driver.hpp"

namespace crumple::materials::testing {

/// f'c of 30 MPa and aggregate of 19 mm, in t, mm, s.
inline model::Material concrete(double strength = 30) {
  model::Material material;
  material.id = 159;
  material.density = 2.4e-9;
  material.law = model::normal_strength_concrete(strength, 19, {});
  return material;
}
inline model::CapConcrete& concrete_law(model::Material& material) {
  return std::get<model::CapConcrete>(material.law);
}
/// Fracture energies that no path here reaches: nothing softens.
inline model::Material tough_concrete(double strength = 30) {
  model::Material material = concrete(strength);
  model::CapConcrete& law = concrete_law(material);
  law.compression_energy = law.tension_energy = law.shear_energy = 1e12;
  return material;
}
/// The cap is out of reach.
inline model::Material uncapped_concrete(double strength = 30) {
  model::Material material = tough_concrete(strength);
  concrete_law(material).cap_start = 1e5;
  return material;
}

/// The yield surface from its equations; I and q as in docs/theory/cscm_concrete.md.
struct ConcreteSurface {
  model::CapConcrete law;

  static double curve(const model::CapConcrete::Strength& of, double trace) {
    return of.constant - of.nonlinear * std::exp(-of.exponent * trace) + of.linear * trace;
  }
  double strength(double trace) const { return curve(law.compression, trace); }
  double extension_ratio(double trace) const {
    return trace > 0 ? std::min(curve(law.extension, trace), 1.0) : 0.5;
  }
  double torsion_ratio(double trace) const {
    return trace > 0 ? std::min(curve(law.torsion, trace), 1.0) : 1 / std::sqrt(3.0);
  }
  double end_of(double cap) const { return cap + law.cap_ratio * strength(cap); }
  /// Bound of q in triaxial compression.
  double bound(double trace, double cap) const {
    const double part = std::max(trace - cap, 0.0) / (end_of(cap) - cap);
    return strength(trace) * std::sqrt(std::max(1 - part * part, 0.0));
  }
  double crushed(double end) const {
    const double x = end - law.cap_start;
    return law.crush_volume * (1 - std::exp(-law.crush_linear * x - law.crush_quadratic * x * x));
  }
  double first_cap() const {
    double low = -10;
    double high = law.cap_start;
    for (int i = 0; i < 200; ++i)
      (end_of(0.5 * (low + high)) < law.cap_start ? low : high) = 0.5 * (low + high);
    return low;
  }
};

inline double trace_of(const Six& s) {
  return -(s[0] + s[1] + s[2]);
}
/// Root of J2.
inline double size_of(const Six& s) {
  return equivalent(s) / std::sqrt(3.0);
}

/// Strains the x axis while the stresses yy and zz are held at -pressure.
template <class Real>
void press_along_x(SolidDriver<Real>& point, double axial, double pressure, double step = 1) {
  const auto side = [&](double lateral) {
    SolidDriver<Real> trial = point;
    trial.apply({axial, lateral, lateral, 0, 0, 0}, step);
    return trial.stress()[1] + pressure;
  };
  // Concrete dilates several times as fast as it is strained.
  double a = -30 * std::fabs(axial);
  double b = 30 * std::fabs(axial);
  for (int i = 0; i < 55; ++i) {
    const double middle = 0.5 * (a + b);
    (side(middle) < 0 ? a : b) = middle;
  }
  const double lateral = 0.5 * (a + b);
  point.apply({axial, lateral, lateral, 0, 0, 0}, step);
}
/// The same from the sides to the pressure first.
template <class Real>
void press_all(SolidDriver<Real>& point, double pressure, double bulk) {
  for (int i = 0; i < 100; ++i) {
    const double third = -pressure / bulk / 300;
    point.apply({third, third, third, 0, 0, 0});
  }
}

}  // namespace crumple::materials::testing
