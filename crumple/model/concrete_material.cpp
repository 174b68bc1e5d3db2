// SPDX-License-Identifier: BSD-3-Clause
#include "model/concrete_material.hpp"
#include "model/elastic_moduli.hpp"

#include <cmath>

namespace crumple::model {
namespace {

/// A quadratic of the strength.
struct StrengthFit {
  double square, linear, constant;

  double at(double strength) const { return (square * strength + linear) * strength + constant; }
};

/// Base value of the fracture energy [N/mm]: through 0.025, 0.030 and 0.058 at 8, 16 and 32 mm (CEB-FIP Model
/// Code 1990, table 2.1.4).
constexpr StrengthFit base_energy{4.6875e-5, -5e-4, 0.026};

CapConcrete::Strength scaled_strength(const CapConcrete::Strength& of, double stress) {
  return {of.constant / stress, of.linear, of.nonlinear / stress, of.exponent * stress};
}
CapConcrete::Strength scaled_ratio(const CapConcrete::Strength& of, double stress) {
  return {of.constant, of.linear * stress, of.nonlinear, of.exponent * stress};
}
CapConcrete::Fluidity scaled_fluidity(const CapConcrete::Fluidity& of, const ConcreteUnits& units) {
  return {of.coefficient / std::pow(units.time, 1 - of.exponent), of.exponent, of.limit / units.stress};
}

/// In MPa, mm, s.
CapConcrete metric_concrete(double strength, double aggregate) {
  CapConcrete law;
  constexpr double modulus = 18275;  // E of 10 MPa
  constexpr double poisson = 0.15;
  const double youngs = modulus * std::cbrt(strength / 10);
  law.shear_modulus = youngs / (2 * (1 + poisson));
  law.bulk_modulus = youngs / (3 * (1 - 2 * poisson));
  const auto fit = [&](const StrengthFit& of) { return of.at(strength); };
  law.compression = {fit({-0.003, 0.3169747, 7.7047}), fit({1.3216e-5, 2.3548e-3, 0.2140058}), 10.5,
                     1.929e-2};
  law.torsion = {0.74735, fit({-4.0856e-7, -1.2132e-6, 1.5593e-3}), 0.17,
                 fit({-1.9972e-5, 2.2655e-4, 8.1748e-2})};
  law.extension = {0.66, fit({-4.8697e-7, -1.8883e-6, 1.8822e-3}), 0.16,
                   fit({-1.9972e-5, 2.2655e-4, 8.2748e-2})};
  law.cap_ratio = 5;
  law.cap_start = fit({8.769178e-3, -7.3302306e-2, 84.85});
  law.crush_volume = 0.05;
  law.crush_linear = 2.5e-4;
  law.crush_quadratic = 3.49e-7;
  law.ductile_shape = 100;
  law.brittle_shape = 0.1;
  law.tension_energy = base_energy.at(aggregate) * std::pow(strength / 10, 0.7);
  law.compression_energy = 100 * law.tension_energy;
  law.shear_energy = law.tension_energy;
  law.compression_power = 5;
  law.tension_power = 1;
  const double psi = strength / 0.00689475729;
  const double limit = fit({1.309663e-2, -0.3927659, 21.45});
  law.compression_rate = {StrengthFit{1.2772337e-11, -1.0613722e-7, 3.203497e-4}.at(psi), 0.78, limit};
  law.tension_rate = {StrengthFit{8.0614774e-13, -9.77736719e-10, 5.0752351e-5}.at(psi), 0.48, limit};
  law.shear_fluidity = 1;
  law.energy_power = 1;
  return law;
}

}  // namespace

CapConcrete normal_strength_concrete(double strength, double aggregate, const ConcreteUnits& units) {
  CapConcrete law = metric_concrete(strength, aggregate);
  const double energy = units.stress * units.length;
  law.shear_modulus /= units.stress;
  law.bulk_modulus /= units.stress;
  law.compression = scaled_strength(law.compression, units.stress);
  law.torsion = scaled_ratio(law.torsion, units.stress);
  law.extension = scaled_ratio(law.extension, units.stress);
  law.cap_start /= units.stress;
  law.crush_linear *= units.stress;
  law.crush_quadratic *= units.stress * units.stress;
  law.compression_energy /= energy;
  law.tension_energy /= energy;
  law.shear_energy /= energy;
  law.compression_rate = scaled_fluidity(law.compression_rate, units);
  law.tension_rate = scaled_fluidity(law.tension_rate, units);
  set_elastic(law);
  return law;
}

void set_elastic(CapConcrete& law) {
  if (law.shear_modulus > 0 && law.bulk_modulus > 0) set_moduli(law, law.bulk_modulus, law.shear_modulus);
}

void set_compaction(ThreeSurfaceConcrete& law, double bulk_modulus) {
  // Over the pressure at the first of the strains, and over the bulk modulus.
  law.compression = {0, 0.0015, 0.0043, 0.0101, 0.0305, 0.0513, 0.0726, 0.0943, 0.174, 0.208};
  law.pressure = {0, 1, 2.18, 3.5, 6.65, 10.03, 14.23, 21.77, 127.1, 194.4};
  law.unloading = {1, 1, 1.014, 1.065, 1.267, 1.47, 1.672, 1.825, 4.106, 5};
  for (double& p : law.pressure) p *= law.compression[1] * bulk_modulus;
  for (double& k : law.unloading) k *= bulk_modulus;
  law.youngs_modulus = 3 * bulk_modulus * (1 - 2 * law.poissons_ratio);
}

ThreeSurfaceConcrete three_surface_concrete(double strength, double poissons_ratio, double psi,
                                            double inches) {
  ThreeSurfaceConcrete law;
  law.poissons_ratio = poissons_ratio;
  const double in_psi = strength * psi;
  law.tensile_strength = 1.58 * std::cbrt(in_psi * in_psi) / psi;
  law.maximum = {0.2956 * strength, 0.4463, 0.0808 / strength};
  law.yield = {0.2232 * strength, 0.625, 0.2577 / strength};
  law.residual = {0, 0.4417, 0.1184 / strength};
  law.compression_power = 1.6;
  law.tension_power = 1.35;
  law.opening_damage = 1.15;
  law.dilatancy = 0.5;
  law.width = 1 / inches;
  law.damage = {0, 8e-6, 24e-6, 40e-6, 56e-6, 72e-6, 88e-6, 3.2e-4, 5.2e-4, 5.7e-4, 1, 10, 1e10};
  law.share = {0, 0.85, 0.97, 0.99, 1, 0.99, 0.97, 0.5, 0.1, 0, 0, 0, 0};
  set_compaction(law, 57000 * std::sqrt(in_psi) / psi / (3 * (1 - 2 * poissons_ratio)));
  return law;
}

void set_rate_factors(ThreeSurfaceConcrete& law, double strength, double psi, double seconds) {
  constexpr double psi_in_mpa = 145.0377;
  const double mpa = strength * psi / psi_in_mpa;
  // Both rise with a power of the rate, and with its third root from a knee on, where they meet.
  const auto factors = [&](double still, double power, double knee) {
    ThreeSurfaceConcrete::RateFactors found{{0, still}, {1, 1}};
    constexpr int per_decade = 4;
    constexpr double fastest = 1000;  // 1/s
    const int points = static_cast<int>(std::lround(per_decade * std::log10(fastest / still)));
    for (int i = 1; i <= points; ++i) {
      const double rate = still * std::pow(10.0, static_cast<double>(i) / per_decade);
      const double slow = std::pow(std::fmin(rate, knee) / still, power);
      found.rate.push_back(rate);
      found.factor.push_back(rate <= knee ? slow : slow * std::cbrt(rate / knee));
    }
    for (double& rate : found.rate) rate *= seconds;
    return found;
  };
  law.tension_rates = factors(1e-6, 1 / (1 + 8 * mpa / 10), 1);
  law.compression_rates = factors(30e-6, 1.026 / (5 + 9 * mpa / 10), 30);
}

double unconfined_strength(const ThreeSurfaceConcrete::Surface& surface) {
  // 3 p = a0 + p / (a1 + a2 p), as a quadratic of p.
  const double square = 3 * surface.second;
  const double linear = 3 * surface.first - surface.constant * surface.second - 1;
  const double constant = -surface.constant * surface.first;
  if (!(square > 0)) return linear > 0 ? -3 * constant / linear : 0;
  return 1.5 * (std::sqrt(linear * linear - 4 * square * constant) - linear) / square;
}

}  // namespace crumple::model
