// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/laws/principal_stretches.hpp"

namespace crumple::materials {

/// Nearly incompressible rubber with a polynomial in the invariants (docs/theory/rubber.md).
struct PolynomialRubberLaw : TotalDeformationLaw {
  using Model = model::PolynomialRubber;
  static constexpr const char* name = "polynomial rubber";

  static std::vector<double> constants(const model::Material& material);

  enum Place { Bulk, PerDensity, C10, C01, C11, C20, C02, C30, Count };

  template <class Pack>
  struct SolidUpdate : TotalDeformation<Pack> {
    using Real = RealOf<Pack>;

    const double* c;

    CRUMPLE_INLINE explicit SolidUpdate(const SolidMaterialTask<Real>& task) : c(task.constants) {}

    CRUMPLE_INLINE Pack number(double factor, Place place) const {
      return Pack(static_cast<Real>(factor * c[place]));
    }

    /// In the squares e_k of the stretches without their volume: J1 = sum e, J2 = sum 1/e.
    CRUMPLE_INLINE TotalStress<Pack> total(const Turn<Pack>& d) const {
      const PrincipalStretches<Pack> stretches = principal_stretches(d);
      const Pack one(Real(1));
      const Pack three(Real(3));
      const Pack third(Real(1.0 / 3.0));
      const Pack mean_excess =
          third * (stretches.square_excess(0) + (stretches.square_excess(1) + stretches.square_excess(2)));
      const Pack scale =
          math::power(larger(Pack(one + stretches.volume_excess), Pack(Real(1e-6))), Pack(Real(-2.0 / 3.0)));
      const Pack mean = multiply_add(scale, mean_excess, scale);
      Pack off[3];  // e_k less its mean
      for (int k = 0; k < 3; ++k) off[k] = scale * (stretches.square_excess(k) - mean_excess);
      const Pack squares = multiply_add(off[0], off[0], multiply_add(off[1], off[1], Pack(off[2] * off[2])));
      const Pack mean_square = third * squares;
      const Pack second = three * (mean * mean) - Pack(Real(0.5)) * squares;
      const Pack x = three * (mean - one);  // J1 - 3
      const Pack y = second - three;        // J2 - 3
      const Pack by_first =
          number(1, C10) + (number(1, C11) * y + x * multiply_add(number(3, C30), x, number(2, C20)));
      const Pack by_second = number(1, C01) + multiply_add(number(1, C11), x, Pack(number(2, C02) * y));
      const Pack first_twice = multiply_add(number(6, C30), x, number(2, C20));
      Pack dev[3];
      Pack curvature[3];
      for (int k = 0; k < 3; ++k) {
        const Pack a = off[k] + off[k];
        const Pack half = multiply_add(mean, off[k], Pack(mean_square - off[k] * off[k]));
        const Pack b = half + half;
        dev[k] = multiply_add(by_first, a, Pack(by_second * b));
        // 1 / e_k = J2 - e_k (J1 - e_k)
        const Pack e = mean + off[k];
        const Pack inverse = second - e * (three * mean - e);
        const Pack linear = by_first * (e + mean) + by_second * multiply_add(third, second, inverse);
        const Pack mixed = multiply_add(number(2, C11), Pack(a * b), Pack(number(2, C02) * (b * b)));
        curvature[k] =
            multiply_add(Pack(Real(4.0 / 3.0)), linear, multiply_add(first_twice, Pack(a * a), mixed));
      }
      return isochoric_stress(stretches, dev, curvature, static_cast<Real>(c[Bulk]),
                              static_cast<Real>(c[PerDensity]));
    }
  };
};

}  // namespace crumple::materials
