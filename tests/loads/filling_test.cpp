// SPDX-License-Identifier: BSD-3-Clause
#include "loads/filling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/verified.hpp"

namespace crumple::filling_test {
namespace {

using loads::Filling;
using loads::FillingState;

// Air in SI units.
constexpr double heat_v = 717.5;
constexpr double heat_p = 1004.5;
constexpr double exponent = 1.4;
constexpr double gas_constant = heat_p - heat_v;
constexpr double ambient = 1e5;
constexpr double density = 1.2;

model::InflatedGas air() {
  return {.heat_at_volume = heat_v,
          .heat_at_pressure = heat_p,
          .temperature = 600,
          .ambient = ambient,
          .density = density};
}

TEST(Filling, PressureOfVolumeFollowsTheLawOrTheCurve) {
  std::vector<model::Curve> curves{{.id = 1, .abscissa = {0.5, 1, 2}, .ordinate = {5, 2, 1}}};
  const model::VolumeFilling by_law = model::PressureOfVolume{.coefficient = 3};
  const model::VolumeFilling by_curve = model::PressureOfVolume{.curve = 0};
  FillingState state = Filling(by_law, curves).initial(4);
  EXPECT_EQ(state.pressure, 3);
  Filling(by_law, curves).advance(state, {1, 1, 2});
  EXPECT_EQ(state.pressure, 6);
  EXPECT_NEAR(state.stiffness, 3, 1e-15);  // p / V
  state = Filling(by_curve, curves).initial(4);
  EXPECT_EQ(state.pressure, 2);
  EXPECT_NEAR(state.stiffness, 6.0 / 4, 1e-8);  // the steeper side: 6 over the relative volume
  Filling(by_curve, curves).advance(state, {1, 1, 6});
  EXPECT_EQ(state.pressure, 1.5);
}

TEST(Filling, AdiabaticGasKeepsPVGamma) {
  const std::vector<model::Curve> none;
  const model::VolumeFilling law = model::AdiabaticGas{
      .scale = 2, .exponent = exponent, .pressure = 2e5, .ambient = ambient, .density = density};
  FillingState state = Filling(law, none).initial(0.5);
  EXPECT_NEAR(state.pressure, 4e5, 1e-9);
  EXPECT_NEAR(state.mass, 0.6, 1e-15);
  Filling(law, none).advance(state, {1, 1, 0.25});
  test::verified("adiabatic gas at half its volume: pressure", "p V^gamma")
      .within(state.pressure, 2 * (3e5 * std::pow(2, exponent) - ambient), 1e-14);
  test::verified("adiabatic gas at half its volume: internal energy", "p V / (gamma - 1)")
      .within(state.energy, 3e5 * std::pow(2, exponent) * 0.25 / 0.4, 1e-14);
}

// Without exchange the laws of both gases are the same; the integrated one has the error of the trapezoidal
// rule, of the second order in the change of volume.
TEST(Filling, InflatedGasWithoutExchangeIsAdiabatic) {
  const std::vector<model::Curve> none;
  const model::VolumeFilling law = air();
  double error[2] = {};
  for (const int fine : {0, 1}) {
    const int steps = fine == 0 ? 100 : 200;
    FillingState state = Filling(law, none).initial(1);
    for (int i = 1; i <= steps; ++i) Filling(law, none).advance(state, {0, 1e-3, 1 - 0.5 * i / steps});
    error[fine] = std::fabs((state.pressure + ambient) / (ambient * std::pow(2, exponent)) - 1);
  }
  test::verified("gas compressed to half its volume in 200 steps, relative error", "p V^gamma")
      .below(error[1], 5e-6);
  EXPECT_NEAR(error[0] / error[1], 4, 0.1);
}

// What flows into a rigid vessel brings its enthalpy.
TEST(Filling, InflatedGasTakesTheEnthalpyOfWhatFlowsIn) {
  const std::vector<model::Curve> curves{{.id = 1, .abscissa = {0, 2}, .ordinate = {0, 4}}};
  model::InflatedGas gas = air();
  gas.inflow = 0;
  const model::VolumeFilling law = gas;
  FillingState state = Filling(law, curves).initial(1);
  for (int i = 1; i <= 100; ++i) Filling(law, curves).advance(state, {0.01 * i, 0.01, 1});
  const double mass = 2.0;  // the integral of 2 t to 1, twice
  test::verified("inflation of a rigid vessel: mass", "integral of the inflow")
      .within(state.mass, density + mass / 2, 1e-13);
  test::verified("inflation of a rigid vessel: pressure", "first law of thermodynamics")
      .within(state.pressure, 0.4 * heat_p * 600 * mass / 2, 1e-12);
}

// Orifices stay closed until the pressure has once reached that which opens them.
TEST(Filling, OrificesOpenAtTheirPressureAndStayOpen) {
  const std::vector<model::Curve> curves{{.id = 1, .abscissa = {0, 1, 1.001}, .ordinate = {1, 1, 0}},
                                         {.id = 2, .abscissa = {0, 1}, .ordinate = {300, 900}}};
  model::InflatedGas gas = air();
  gas.inflow = 0;
  gas.temperature_time = 1;
  gas.vent = 1e-3;
  gas.opening_pressure = 1e5;
  const model::VolumeFilling law = gas;
  FillingState state = Filling(law, curves).initial(1);
  double opened_at = 0;
  for (int i = 1; i <= 40000; ++i) {
    Filling(law, curves).advance(state, {1e-4 * i, 1e-4, 1});
    if (opened_at == 0 && state.outflow > 0) {
      opened_at = 1e-4 * i;
      EXPECT_GE(state.pressure, 0.99e5);
    }
  }
  // P rises by 0.4 CP times the integral of 300 + 600 t.
  const double expected = (-300 + std::sqrt(300.0 * 300 + 4 * 300 * 1e5 / (0.4 * heat_p))) / 600;
  EXPECT_NEAR(opened_at, expected, 3e-4);
  EXPECT_GT(state.outflow, 0);
  EXPECT_LT(state.pressure, 1e5);
}

TEST(OrificeFlow, IsThatOfTheIsentropicNozzle) {
  // Choked: speed of sound at the throat; the ambient pressure makes no difference.
  const double pressure = 5e5;
  const double rho = 4;
  const double sound = std::sqrt(exponent * pressure / rho);
  const double choked = rho * sound * std::pow(2 / (exponent + 1), (exponent + 1) / (2 * (exponent - 1)));
  test::verified("choked flow through an orifice", "closed form")
      .within(loads::orifice_flow(pressure, rho, 1e5, exponent), choked, 1e-14);
  EXPECT_EQ(loads::orifice_flow(pressure, rho, 1e5, exponent),
            loads::orifice_flow(pressure, rho, 0, exponent));
  // Subsonic: the enthalpy becomes kinetic energy, on the isentrope.
  const double outside = 4e5;
  const double throat = rho * std::pow(outside / pressure, 1 / exponent);
  const double speed = std::sqrt(2 * exponent / (exponent - 1) * (pressure / rho - outside / throat));
  test::verified("subsonic flow through an orifice", "Saint-Venant and Wantzel")
      .within(loads::orifice_flow(pressure, rho, outside, exponent), throat * speed, 1e-12);
  EXPECT_EQ(loads::orifice_flow(1e5, rho, 1e5, exponent), 0);
  EXPECT_EQ(loads::orifice_flow(0.9e5, rho, 1e5, exponent), 0);
}

// A rigid vessel empties through a choked orifice: the gas that stays expands on the isentrope, so that with
// x = (p/p0)^((gamma-1)/(2 gamma)) the balance of mass is d(1/x)/dt = (gamma-1)/2 k, where k is the flow at
// the start over the mass.
TEST(Filling, VesselEmptiesAsTheClosedFormOfIsentropicBlowDownSays) {
  const std::vector<model::Curve> none;
  model::InflatedGas gas = air();
  gas.vent = 0.7 * 2e-3;
  gas.ambient = 1;  // choked all the time
  const model::VolumeFilling law = gas;
  const double volume = 0.05;
  const double start = 8e5;
  const double rho = 6;
  const double rate = gas.vent / volume * std::sqrt(exponent * start / rho) *
                      std::pow(2 / (exponent + 1), (exponent + 1) / (2 * (exponent - 1)));
  const double end = 2 / rate;
  const double exact = std::pow(1 + 0.5 * (exponent - 1) * rate * end, -2 * exponent / (exponent - 1));
  double error[2] = {};
  for (const int fine : {0, 1}) {
    const int steps = fine == 0 ? 200 : 400;
    FillingState state = Filling(law, none).initial(volume);
    state.mass = rho * volume;
    state.energy = start * volume / (exponent - 1);
    state.pressure = start - gas.ambient;
    state.temperature = start / (rho * gas_constant);
    for (int i = 1; i <= steps; ++i) Filling(law, none).advance(state, {0, end / steps, volume});
    error[fine] = std::fabs((state.pressure + gas.ambient) / (start * exact) - 1);
    // On the isentrope.
    EXPECT_NEAR(std::pow(state.mass / (rho * volume), exponent) / exact, 1, 1e-4);
  }
  test::verified("emptying of a rigid vessel, choked: pressure, relative error", "closed form of blow-down")
      .below(error[1], 1e-4);
  EXPECT_NEAR(error[0] / error[1], 4, 0.3);
}

/// A gas as it is at the start.
struct Charge {
  double pressure = 0;  ///< absolute [pressure]
  double density = 0;   ///< [mass/volume]
};

/// A vessel out of which a gas flows through a fabric; absolute pressure after a time, in so many steps.
double pressure_after(const model::InflatedGas& gas, const std::vector<model::Curve>& curves,
                      const loads::PorousArea& fabric, const Charge& start, double end, int steps) {
  const model::VolumeFilling law = gas;
  const double volume = 0.05;
  FillingState state = Filling(law, curves).initial(volume);
  state.mass = start.density * volume;
  state.energy = start.pressure * volume / (exponent - 1);
  state.pressure = start.pressure - gas.ambient;
  state.temperature = start.pressure / (start.density * gas_constant);
  for (int i = 1; i <= steps; ++i)
    Filling(law, curves).advance(state, {i * end / steps, end / steps, volume, {&fabric, 1}});
  return state.pressure + gas.ambient;
}

// Fabric of FLC FAC A lets out what an orifice of that area does, constant or by curves.
TEST(Filling, PorousFabricIsAnOrificeOfItsEffectiveArea) {
  const std::vector<model::Curve> curves{{.id = 1, .abscissa = {0, 10}, .ordinate = {0.5, 0.5}},
                                         {.id = 2, .abscissa = {0, 1e7}, .ordinate = {0.02, 0.02}}};
  model::InflatedGas gas = air();
  gas.ambient = 1;  // choked all the time
  const double start = 8e5;
  const double rho = 6;
  const double area = 0.14;
  const double rate = 0.5 * 0.02 * area / 0.05 * std::sqrt(exponent * start / rho) *
                      std::pow(2 / (exponent + 1), (exponent + 1) / (2 * (exponent - 1)));
  const double end = 2 / rate;
  const double exact =
      start * std::pow(1 + 0.5 * (exponent - 1) * rate * end, -2 * exponent / (exponent - 1));
  const model::PorousFabric constant{.segments = {}, .coefficient = 0.5, .area = 0.02};
  const model::PorousFabric by_curves{.segments = {}, .coefficient_time = 0, .area_pressure = 1};
  test::verified("vessel that empties through porous fabric, choked: pressure", "closed form of blow-down")
      .within(pressure_after(gas, curves, {&constant, area}, {start, rho}, end, 400), exact, 1e-4);
  EXPECT_EQ(pressure_after(gas, curves, {&by_curves, area}, {start, rho}, end, 400),
            pressure_after(gas, curves, {&constant, area}, {start, rho}, end, 400));
  // Nothing passes before the pressure that opens it, nor into a vessel below the ambient pressure.
  gas.opening_pressure = 1e6;
  EXPECT_NEAR(pressure_after(gas, curves, {&constant, area}, {start, rho}, end, 10), start, 1e-6 * start);
  gas.opening_pressure = 0;
  gas.ambient = 1e6;
  EXPECT_NEAR(pressure_after(gas, curves, {&constant, area}, {start, rho}, end, 10), start, 1e-6 * start);
}

// By a curve of velocity v the volume FLC v A leaves in a unit of time: the density falls exponentially, and
// the pressure on the isentrope, P = P0 exp(-gamma FLC v A t / V).
TEST(Filling, PorousFabricLetsThroughTheVolumeOfItsCurve) {
  const std::vector<model::Curve> curves{{.id = 1, .abscissa = {0, 1e7}, .ordinate = {3, 3}}};
  const model::PorousFabric fabric{
      .segments = {}, .coefficient = 0.5, .area_pressure = 0, .by_velocity = true};
  model::InflatedGas gas = air();
  gas.ambient = 1;
  const double area = 0.02;
  const double rate = 0.5 * 3 * area / 0.05;
  const double end = 1 / rate;
  double error[2] = {};
  for (const int fine : {0, 1})
    error[fine] =
        std::fabs(pressure_after(gas, curves, {&fabric, area}, {8e5, 6}, end, fine == 0 ? 200 : 400) /
                      (8e5 * std::exp(-exponent)) -
                  1);
  test::verified("vessel that empties through fabric by a velocity: pressure, relative error",
                 "P0 exp(-gamma Q t / V)")
      .below(error[1], 1e-5);
  EXPECT_NEAR(error[0] / error[1], 4, 0.3);
}

// The energy of the liquid is the work that compresses it.
TEST(Filling, LinearFluidFollowsItsLogarithm) {
  const std::vector<model::Curve> curves{{.id = 1, .abscissa = {0, 1}, .ordinate = {3, 3}},
                                         {.id = 2, .abscissa = {0, 1}, .ordinate = {1, 1}},
                                         {.id = 3, .abscissa = {0, 1}, .ordinate = {7, 7}}};
  model::LinearFluid fluid{.bulk_modulus = 1000, .density = 2};
  const model::VolumeFilling plain = fluid;
  FillingState state = Filling(plain, curves).initial(10);
  Filling(plain, curves).advance(state, {1, 1, 9});
  test::verified("liquid in nine tenths of its volume: pressure", "K ln(V0/V)")
      .within(state.pressure, 1000 * std::log(10.0 / 9), 1e-14);
  test::verified("liquid in nine tenths of its volume: energy", "integral of p dV")
      .within(state.energy, 1000 * (9 * std::log(0.9) + 1), 1e-12);
  fluid.inflow = 0;
  fluid.outflow = 1;
  fluid.added_pressure = 2;
  const model::VolumeFilling fed = fluid;
  state = Filling(fed, curves).initial(10);
  for (int i = 1; i <= 10; ++i) Filling(fed, curves).advance(state, {0.1 * i, 0.1, 10});
  EXPECT_NEAR(state.mass, 20 + 3 - 1, 1e-12);
  EXPECT_NEAR(state.pressure, 1000 * std::log(11.0 / 10) + 7, 1e-10);
  fluid.limit = 50;
  const model::VolumeFilling limited = fluid;
  Filling(limited, curves).advance(state, {1, 0, 10});
  EXPECT_EQ(state.pressure, 50);
}

}  // namespace
}  // namespace crumple::filling_test
