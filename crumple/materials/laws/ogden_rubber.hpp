// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/principal_stretches.hpp"

namespace crumple::materials {

/// Nearly incompressible rubber of Ogden (docs/theory/rubber.md).
struct OgdenRubberLaw : TotalDeformationLaw {
  using Model = model::OgdenRubber;
  static constexpr const char* name = "Ogden rubber";

  static std::vector<double> constants(const model::Material& material);

  /// After Count: mu and alpha, term after term.
  enum Place { Bulk, PerDensity, Terms, Count };

  template <class Pack>
  struct SolidUpdate : TotalDeformation<Pack> {
    using Real = RealOf<Pack>;

    const double* c;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task) : c(task.constants) {}

    CRUMPLE_INLINE TotalStress<Pack> total(const Turn<Pack>& d) const {
      const PrincipalStretches<Pack> stretches = principal_stretches(d);
      const Pack zero(Real(0));
      const Pack third(Real(1.0 / 3.0));
      // Binary logarithms of the stretches without their volume.
      Pack log[3];
      for (int k = 0; k < 3; ++k) log[k] = Pack(Real(0.5)) * math::binary_log(stretches.square(k));
      const Pack mean_log = third * (log[0] + (log[1] + log[2]));
      Pack slope[3] = {zero, zero, zero};
      Pack bend[3] = {zero, zero, zero};
      const int terms = static_cast<int>(c[Terms]);
      for (int n = 0; n < terms; ++n) {
        const Pack mu(static_cast<Real>(c[Count + 2 * n]));
        const Pack alpha(static_cast<Real>(c[Count + 2 * n + 1]));
        for (int k = 0; k < 3; ++k) {
          const Pack part = mu * math::power_of_two(Pack(alpha * (log[k] - mean_log)));
          slope[k] = slope[k] + part;
          bend[k] = multiply_add(alpha, part, bend[k]);
        }
      }
      const Pack mean_slope = third * (slope[0] + (slope[1] + slope[2]));
      const Pack mean_bend = third * (bend[0] + (bend[1] + bend[2]));
      Pack dev[3];
      Pack curvature[3];
      // (2/3)^2 of the own and (1/3)^2 of both others.
      for (int k = 0; k < 3; ++k) {
        dev[k] = slope[k] - mean_slope;
        curvature[k] = third * (bend[k] + mean_bend);
      }
      return isochoric_stress(stretches, dev, curvature, static_cast<Real>(c[Bulk]),
                              static_cast<Real>(c[PerDensity]));
    }
  };
};

}  // namespace crumple::materials
