// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/total_deformation.hpp"
#include "math/power.hpp"

namespace crumple::materials {

/// Compressible rubber of Blatz & Ko, solid form (docs/theory/rubber.md).
struct BlatzKoLaw : TotalDeformationLaw {
  using Model = model::BlatzKo;
  static constexpr const char* name = "Blatz-Ko rubber";

  static std::vector<double> constants(const model::Material& material);

  enum Place { Shear, VolumeExponent, PerDensity, Count };

  template <class Pack>
  struct SolidUpdate : TotalDeformation<Pack> {
    using Real = RealOf<Pack>;

    Real shear, exponent, per_density;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : shear(static_cast<Real>(task.constants[Shear])),
          exponent(static_cast<Real>(task.constants[VolumeExponent])),
          per_density(static_cast<Real>(task.constants[PerDensity])) {}

    /// sigma = G (B / J - J^-k I) with k = 1 / (1 - 2 nu).
    CRUMPLE_INLINE TotalStress<Pack> total(const Turn<Pack>& d) const {
      const Pack one(Real(1));
      const SolidStress<Pack> b = left_cauchy_green(d);
      const Pack volume = one + volume_excess(d);
      const Pack over = one / volume;
      const Pack resistance = math::power(over, Pack(exponent));
      const Pack spherical = Pack(shear) * (over - resistance);
      const Pack factor = Pack(shear) * over;
      TotalStress<Pack> now;
      now.stress = {multiply_add(factor, b.xx, spherical),
                    multiply_add(factor, b.yy, spherical),
                    multiply_add(factor, b.zz, spherical),
                    factor * b.xy,
                    factor * b.yz,
                    factor * b.zx};
      // lambda_i d sigma_i / d lambda_i = G (lambda_i^2 / J + k J^-k), over the present density.
      const Pack stiffness =
          multiply_add(factor, one + largest_bound(b), Pack(Pack(shear * exponent) * resistance));
      now.wave_square = Pack(per_density) * volume * stiffness;
      return now;
    }
  };
};

}  // namespace crumple::materials
