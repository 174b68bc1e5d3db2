// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/total_deformation.hpp"

namespace crumple::materials {

/// Nearly incompressible rubber of Mooney & Rivlin (docs/theory/rubber.md).
struct MooneyRivlinLaw : TotalDeformationLaw {
  using Model = model::MooneyRivlin;
  static constexpr const char* name = "Mooney-Rivlin rubber";

  static std::vector<double> constants(const model::Material& material);

  enum Place { First, Second, Third, Fourth, PerDensity, Count };

  template <class Pack>
  struct SolidUpdate : TotalDeformation<Pack> {
    using Real = RealOf<Pack>;

    Real first, second;  ///< A, B
    Real third, fourth;  ///< C, D
    Real per_density;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task)
        : first(static_cast<Real>(task.constants[First])),
          second(static_cast<Real>(task.constants[Second])),
          third(static_cast<Real>(task.constants[Third])),
          fourth(static_cast<Real>(task.constants[Fourth])),
          per_density(static_cast<Real>(task.constants[PerDensity])) {}

    /// J sigma / 2 = (A + I1 B) b' - B b'^2 + I3 W3 I with b' = I + b, written in b: nothing cancels at rest.
    CRUMPLE_INLINE TotalStress<Pack> total(const Turn<Pack>& d) const {
      const Pack one(Real(1));
      const Pack two(Real(2));
      const SolidStress<Pack> b = left_cauchy_green(d);
      const Pack trace = b.xx + (b.yy + b.zz);
      const Pack excess = volume_excess(d);
      const Pack volume = one + excess;
      const Pack i3_excess = excess * (two + excess);
      const Pack i3 = one + i3_excess;
      const Pack over = one / (i3 * i3);
      // 1 - I3^-2
      const Pack lost = i3_excess * (one + i3) * over;
      Pack spherical = Pack(first + Real(2) * second) * lost;
      spherical = multiply_add(Pack(second), trace, spherical);
      spherical = multiply_add(Pack(Real(2) * fourth) * i3, i3_excess, spherical);
      const Pack linear = multiply_add(Pack(second), one + trace, Pack(first));
      const Pack factor = two / volume;
      const SolidStress<Pack> square = squared(b);
      const auto component = [&](const Pack& whole, const Pack& of_square) {
        return multiply_add(linear, whole, Pack(-(second * of_square)));
      };
      TotalStress<Pack> now;
      now.stress = {factor * (spherical + component(b.xx, square.xx)),
                    factor * (spherical + component(b.yy, square.yy)),
                    factor * (spherical + component(b.zz, square.zz)),
                    factor * component(b.xy, square.xy),
                    factor * component(b.yz, square.yz),
                    factor * component(b.zx, square.zx)};
      now.wave_square = per_density * stiffness(b, trace, i3, over);
      return now;
    }

    /// An upper bound of lambda_i^2 W_ii over all axes i: 2 A lambda_i^2 + 2 B (I2 - I3 / lambda_i^2) +
    /// 4 I3^2 h'' + 2 I3 h' with h = C (I3^-2 - 1) + D (I3 - 1)^2.
    CRUMPLE_INLINE Pack stiffness(const SolidStress<Pack>& b, const Pack& trace, const Pack& i3,
                                  const Pack& over) const {
      const Pack one(Real(1));
      const Pack two(Real(2));
      const Pack i1 = Pack(Real(3)) + trace;
      // I2 = (I1^2 - B : B) / 2 with B : B = 3 + 2 tr b + b : b.
      Pack shears = multiply_add(b.xy, b.xy, multiply_add(b.yz, b.yz, Pack(b.zx * b.zx)));
      shears = shears + shears;
      const Pack squares =
          multiply_add(b.xx, b.xx, multiply_add(b.yy, b.yy, multiply_add(b.zz, b.zz, shears)));
      const Pack i2 = Real(0.5) * (i1 * i1 - (Pack(Real(3)) + (two * trace + squares)));
      const Pack c_over = Pack(third) * over;
      const Pack largest = one + largest_bound(b);
      Pack sum = two * (Pack(first) * largest + Pack(second) * (i2 - i3 / largest));
      sum = sum + Pack(Real(20)) * c_over;
      return sum + Pack(Real(4) * fourth) * i3 * (Pack(Real(3)) * i3 - one);
    }

    CRUMPLE_INLINE static SolidStress<Pack> squared(const SolidStress<Pack>& b) {
      const auto dot = [](const Pack& x, const Pack& y, const Pack& z, const Pack& u, const Pack& v,
                          const Pack& w) { return multiply_add(x, u, multiply_add(y, v, Pack(z * w))); };
      return {dot(b.xx, b.xy, b.zx, b.xx, b.xy, b.zx), dot(b.xy, b.yy, b.yz, b.xy, b.yy, b.yz),
              dot(b.zx, b.yz, b.zz, b.zx, b.yz, b.zz), dot(b.xx, b.xy, b.zx, b.xy, b.yy, b.yz),
              dot(b.xy, b.yy, b.yz, b.zx, b.yz, b.zz), dot(b.zx, b.yz, b.zz, b.xx, b.xy, b.zx)};
    }
  };
};

}  // namespace crumple::materials
