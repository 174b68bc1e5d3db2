// SPDX-License-Identifier: BSD-3-Clause
#include "loads/filling.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "math/power.hpp"

namespace crumple::loads {
namespace {

// Powers and logarithms are ours: those of the library differ between processors.
constexpr double natural_log = 0.69314718055994530942;  // of two

using Curves = std::vector<model::Curve>;

double at(const Curves& curves, Index curve, double x, double otherwise) {
  return curve == no_index ? otherwise : curves[static_cast<std::size_t>(curve)].at(x);
}

// Pressure by volume.

void settle(const model::PressureOfVolume& law, const Curves& curves, FillingState& state) {
  const double share = state.volume / state.initial_volume;
  if (law.curve == no_index) {
    state.pressure = law.coefficient / share;
    state.stiffness = state.pressure / state.volume;
    return;
  }
  // The steeper one of the slopes on both sides.
  constexpr double nearby = 1e-6;
  const model::Curve& curve = curves[static_cast<std::size_t>(law.curve)];
  state.pressure = curve.at(share);
  const double above = state.pressure - curve.at(share * (1 + nearby));
  const double below = curve.at(share * (1 - nearby)) - state.pressure;
  state.stiffness = std::max({above, below, 0.0}) / (nearby * state.volume);
}

// Ideal gas without exchange.

void settle(const model::AdiabaticGas& law, FillingState& state) {
  const double absolute =
      (law.pressure + law.ambient) * math::power(state.initial_volume / state.volume, law.exponent);
  state.pressure = law.scale * (absolute - law.ambient);
  state.stiffness = law.scale * law.exponent * absolute / state.volume;
  state.energy = absolute * state.volume / (law.exponent - 1);
}

// Liquid.

void settle(const model::LinearFluid& law, const Curves& curves, double time, FillingState& state) {
  const double bulk_modulus = at(curves, law.bulk_modulus_time, time, law.bulk_modulus);
  const double unloaded = state.mass / law.density;
  const double strain = natural_log * math::binary_log(state.volume / unloaded);
  state.pressure = -bulk_modulus * strain + at(curves, law.added_pressure, time, 0);
  state.stiffness = bulk_modulus / state.volume;
  state.energy = bulk_modulus * (state.volume * strain - state.volume + unloaded);
  const double limit = at(curves, law.limit_time, time, law.limit);
  if ((law.limit > 0 || law.limit_time != no_index) && state.pressure > limit) state.pressure = limit;
}

void advance(const model::LinearFluid& law, const Curves& curves, const FillingStep& step,
             FillingState& state) {
  const double middle = step.time - 0.5 * step.length;
  state.inflow = at(curves, law.inflow, middle, 0);
  state.outflow = at(curves, law.outflow, middle, 0) + at(curves, law.outflow_pressure, state.pressure, 0);
  state.mass += step.length * (state.inflow - state.outflow);
  state.volume = step.volume;
  settle(law, curves, step.time, state);
}

// Ideal gas with exchange.

double exponent_of(const model::InflatedGas& law) {
  return law.heat_at_pressure / law.heat_at_volume;
}

void settle(const model::InflatedGas& law, FillingState& state) {
  const double absolute = (exponent_of(law) - 1) * state.energy / state.volume;
  state.pressure = absolute - law.ambient;
  state.stiffness = exponent_of(law) * absolute / state.volume;
  state.temperature = state.energy / (state.mass * law.heat_at_volume);
  if (state.pressure >= law.opening_pressure) state.vents_open = 1;
}

/// What a fabric lets through: as an orifice of its effective area, or with the velocity of its curve.
double leakage_of(const PorousArea& porous, const Curves& curves, double time, double absolute,
                  double density, double orifice) {
  const model::PorousFabric& fabric = *porous.fabric;
  const double coefficient = at(curves, fabric.coefficient_time, time, fabric.coefficient);
  const double by_pressure = at(curves, fabric.area_pressure, absolute, fabric.area);
  const double through = fabric.by_velocity ? by_pressure * density : by_pressure * orifice;
  return std::max(0.0, coefficient * through * porous.area);
}

double outflow_of(const model::InflatedGas& law, const Curves& curves, const FillingStep& step, double time,
                  const FillingState& state) {
  if (law.outflow != no_index)
    return std::max(0.0, curves[static_cast<std::size_t>(law.outflow)].at(state.pressure));
  if (state.vents_open == 0 || !(state.pressure > 0)) return 0;
  const double absolute = state.pressure + law.ambient;
  const double density = state.mass / state.volume;
  const double orifice = orifice_flow(absolute, density, law.ambient, exponent_of(law));
  double sum = law.vent * orifice;
  for (const PorousArea& porous : step.porous)
    sum += leakage_of(porous, curves, time, absolute, density, orifice);
  return sum;
}

/// Mass and heat that come and go in a unit of time.
struct Exchange {
  double mass = 0;
  double heat = 0;
};

/// The gas after a step with a constant exchange. Its work is that of the mean of both pressures, so the
/// energy at the end follows from a linear equation.
FillingState after(const model::InflatedGas& law, FillingState state, const FillingStep& step,
                   const Exchange& exchange) {
  const double grown = step.volume - state.volume;
  const double absolute = state.pressure + law.ambient;
  state.mass += step.length * exchange.mass;
  state.energy = (state.energy + step.length * exchange.heat - 0.5 * absolute * grown) /
                 (1 + 0.5 * (exponent_of(law) - 1) * grown / step.volume);
  state.volume = step.volume;
  settle(law, state);
  return state;
}

/// Heun's method: the outflow is the mean of that at the start and that at the end, which a first step with
/// the former finds. Gas leaves with its enthalpy.
void advance(const model::InflatedGas& law, const Curves& curves, const FillingStep& step,
             FillingState& state) {
  const double middle = step.time - 0.5 * step.length;
  const double inflow = at(curves, law.inflow, middle, 0);
  const double inflow_temperature = at(curves, law.temperature_time, middle, law.temperature);
  const auto exchange = [&](double outflow, double temperature) {
    return Exchange{inflow - outflow,
                    law.heat_at_pressure * (inflow * inflow_temperature - outflow * temperature)};
  };
  const double first = outflow_of(law, curves, step, step.time - step.length, state);
  const FillingState predicted = after(law, state, step, exchange(first, state.temperature));
  const double second = outflow_of(law, curves, step, step.time, predicted);
  const double outflow = 0.5 * (first + second);
  const double temperature =
      outflow > 0 ? 0.5 * (first * state.temperature + second * predicted.temperature) / outflow : 0;
  state = after(law, state, step, exchange(outflow, temperature));
  state.inflow = inflow;
  state.outflow = outflow;
}

}  // namespace

double orifice_flow(double pressure, double density, double ambient, double exponent) {
  if (!(pressure > ambient) || !(density > 0)) return 0;
  const double critical = math::power(2 / (exponent + 1), exponent / (exponent - 1));
  const double ratio = std::max(ambient / pressure, critical);
  const double head = 1 - math::power(ratio, (exponent - 1) / exponent);
  return math::power(ratio, 1 / exponent) *
         std::sqrt(2 * exponent / (exponent - 1) * pressure * density * head);
}

FillingState Filling::initial(double volume) const {
  FillingState state;
  state.volume = state.initial_volume = volume;
  std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (!std::is_same_v<Law, model::PressureOfVolume>) state.mass = law.density * volume;
        if constexpr (std::is_same_v<Law, model::PressureOfVolume>)
          settle(law, *curves_, state);
        else if constexpr (std::is_same_v<Law, model::LinearFluid>)
          settle(law, *curves_, 0, state);
        else if constexpr (std::is_same_v<Law, model::AdiabaticGas>)
          settle(law, state);
        else {
          state.energy = law.ambient * volume / (exponent_of(law) - 1);
          settle(law, state);
        }
      },
      *filling_);
  return state;
}

void Filling::advance(FillingState& state, const FillingStep& step) const {
  std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (std::is_same_v<Law, model::LinearFluid> || std::is_same_v<Law, model::InflatedGas>) {
          loads::advance(law, *curves_, step, state);
        } else {
          state.volume = step.volume;
          if constexpr (std::is_same_v<Law, model::PressureOfVolume>)
            settle(law, *curves_, state);
          else
            settle(law, state);
        }
      },
      *filling_);
}

}  // namespace crumple::loads
