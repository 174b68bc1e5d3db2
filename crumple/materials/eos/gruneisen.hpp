// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/eos/eos_point.hpp"
#include "model/equation_of_state.hpp"
#include "model/material.hpp"

namespace crumple::materials {

/// Mie & Gruneisen about the Hugoniot of a cubic shock velocity (docs/theory/equations_of_state.md).
struct GruneisenEquation {
  using Model = model::Gruneisen;
  static constexpr const char* name = "Gruneisen";

  enum Place { Stiffness, S1, S2, S3, Gamma, Correction, Count };

  static std::vector<double> constants(const Model& law, const model::Material& material);

  template <class Pack>
  CRUMPLE_INLINE static EosPoint<Pack> at(const double* constants, const Pack& mu) {
    using Real = RealOf<Pack>;
    const auto number = [&](Place place) { return Pack(static_cast<Real>(constants[place])); };
    const Pack one(Real(1));
    const Pack zero(Real(0));
    const Pack half(Real(0.5));
    const Pack stiffness = number(Stiffness);
    const Pack gamma = number(Gamma);
    const Pack correction = number(Correction);
    // Zero in tension, where the pressure of zero energy is linear.
    const Pack x = larger(mu, zero);
    const Pack fill = one / (one + x);
    const Pack eta = x * fill;
    const Pack eta_slope = fill * fill;
    const Pack s1 = number(S1) - one;
    const Pack s2 = number(S2);
    const Pack s3 = number(S3);
    const Pack whole = one - x * multiply_add(eta, multiply_add(s3, eta, s2), s1);
    const Pack whole_slope =
        -(s1 + (multiply_add(s2, multiply_add(x, eta_slope, eta),
                             Pack(s3 * eta * multiply_add(Pack(Real(2) * x), eta_slope, eta)))));
    // The shock velocity has no bound where this vanishes: no state lies beyond.
    const Pack least(Real(0.05));
    const auto inside = whole > least;
    const Pack below = select<Pack>(inside, whole, least);
    const Pack below_slope = select<Pack>(inside, whole_slope, zero);
    const Pack linear = one - half * gamma;
    const Pack above = multiply_add(x, multiply_add(Pack(-half * correction), x, linear), one);
    const Pack above_slope = linear - correction * x;
    const Pack over = one / below;
    const Pack square = over * over;
    const Pack shape = above * square;
    const Pack shape_slope = square * multiply_add(Pack(Real(-2) * above * over), below_slope, above_slope);
    return {stiffness * (mu * shape), multiply_add(correction, mu, gamma),
            stiffness * multiply_add(x, shape_slope, shape), correction};
  }
};

}  // namespace crumple::materials
