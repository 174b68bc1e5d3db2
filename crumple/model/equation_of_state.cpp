// SPDX-License-Identifier: BSD-3-Clause
#include "model/equation_of_state.hpp"

namespace crumple::model {
namespace {

/// p = cold + thermal E with the slopes over the compression mu, at time zero.
struct Parts {
  double cold = 0;
  double thermal = 0;
  double cold_slope = 0;
  double thermal_slope = 0;
};

Parts parts(const Gruneisen& law, double density, double mu) {
  const double stiffness = density * law.sound_speed * law.sound_speed;
  Parts at{stiffness * mu, law.gamma + law.volume_correction * mu, stiffness, law.volume_correction};
  if (mu > 0) {
    const auto curve = [&](double x) {
      const double eta = x / (1 + x);
      const double below =
          1 - (law.slopes[0] - 1) * x - law.slopes[1] * x * eta - law.slopes[2] * x * eta * eta;
      return stiffness * x * (1 + (1 - law.gamma / 2) * x - law.volume_correction / 2 * x * x) /
             (below * below);
    };
    constexpr double apart = 1e-6;
    at.cold = curve(mu);
    at.cold_slope = (curve(mu + apart) - curve(mu - apart)) / (2 * apart);
  }
  return at;
}

Parts parts(const LinearPolynomial& law, double /*density*/, double mu) {
  const auto& c = law.coefficients;
  const double squares = mu > 0 ? 1 : 0;
  return {c[0] + mu * (c[1] + mu * (squares * c[2] + mu * c[3])), c[4] + mu * (c[5] + mu * squares * c[6]),
          c[1] + mu * (2 * squares * c[2] + 3 * mu * c[3]), c[5] + 2 * mu * squares * c[6]};
}

}  // namespace

double initial_bulk_modulus(const EquationOfState& equation, double density) {
  const double volume = equation.initial_volume;
  const double mu = 1 / volume - 1;
  const Parts at = std::visit([&](const auto& law) { return parts(law, density, mu); }, equation.law);
  const double energy = equation.initial_energy;
  const double pressure = at.cold + at.thermal * energy;
  const double over_compression =
      at.cold_slope + at.thermal_slope * energy + pressure * volume * volume * at.thermal;
  // rho dp/drho = (1 + mu) dp/dmu.
  return over_compression / volume;
}

}  // namespace crumple::model
