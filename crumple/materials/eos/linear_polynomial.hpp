// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/eos/eos_point.hpp"
#include "model/equation_of_state.hpp"
#include "model/material.hpp"

namespace crumple::materials {

/// A polynomial of the compression, linear in the energy (docs/theory/equations_of_state.md).
struct LinearPolynomialEquation {
  using Model = model::LinearPolynomial;
  static constexpr const char* name = "linear polynomial";

  static std::vector<double> constants(const Model& law, const model::Material& /*material*/) {
    return {law.coefficients.begin(), law.coefficients.end()};
  }

  template <class Pack>
  CRUMPLE_INLINE static EosPoint<Pack> at(const double* constants, const Pack& mu) {
    using Real = RealOf<Pack>;
    const auto c = [&](int k) { return Pack(static_cast<Real>(constants[k])); };
    // C2 and C6 act in compression only.
    const Pack x = larger(mu, Pack(Real(0)));
    const Pack two_x = Pack(Real(2)) * x;
    const Pack square = mu * mu;
    return {multiply_add(mu, multiply_add(c(3), square, multiply_add(c(2), x, c(1))), c(0)),
            multiply_add(mu, multiply_add(c(6), x, c(5)), c(4)),
            multiply_add(Pack(Real(3) * c(3)), square, multiply_add(c(2), two_x, c(1))),
            multiply_add(c(6), two_x, c(5))};
  }
};

}  // namespace crumple::materials
