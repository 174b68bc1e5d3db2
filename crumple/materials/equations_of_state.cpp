// SPDX-License-Identifier: BSD-3-Clause
// What the rest of the solver asks of an equation of state, answered through the list.
#include "materials/equations_of_state.hpp"

#include <cmath>
#include <variant>

#include "materials/common/checks.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/eos/eos_point.hpp"
#include "materials/list.hpp"

namespace crumple::materials {
namespace {

using model::EquationOfState;
using model::Material;

double shear_modulus(const Material& material) {
  if (std::holds_alternative<model::NullMaterial>(material.law)) return 0;
  if (const auto* law = std::get_if<model::JohnsonCook>(&material.law))
    if (law->shear_modulus > 0) return law->shear_modulus;
  return elastic_constants(material).shear_modulus();
}

/// Pressure cut-off, 0 for none.
struct LeastPressure {
  template <class Law>
  double operator()(const Law& law) const {
    if constexpr (requires { law.least_pressure; })
      return law.least_pressure;
    else
      return 0;
  }
};

struct SpallOf {
  template <class Law>
  model::Spall operator()(const Law& law) const {
    if constexpr (requires { law.spall; })
      return law.spall;
    else
      return model::Spall::None;
  }
};

template <class... Equations>
std::vector<double> own_constants(const Material& material, const EquationOfState& equation, int& kind,
                                  LawList<Equations...> /*list*/) {
  std::vector<double> found;
  int place = 0;
  const auto try_one = [&]<class Equation>(Equation) {
    if (const auto* law = std::get_if<typename Equation::Model>(&equation.law)) {
      kind = place;
      found = Equation::constants(*law, material);
    }
    ++place;
  };
  (try_one(Equations{}), ...);
  return found;
}

}  // namespace

double eos_wave_speed(const Material& material, const EquationOfState& equation) {
  require(equation.initial_volume > 0, material,
          "the initial relative volume V0 of its equation of state must be above zero");
  const double bulk = model::initial_bulk_modulus(equation, material.density);
  require(bulk > 0, material,
          "its equation of state gives it no stiffness at time zero, from which steps could follow");
  const double density = material.density / equation.initial_volume;
  return std::sqrt((bulk + 4.0 / 3.0 * shear_modulus(material)) / density);
}

Index declare_eos_history(domain::ElementBlock& block) {
  const Index first = block.components;
  domain::add_item(block, "volume_change", "-", block.points);
  domain::add_item(block, "volume_rest", "-", block.points);
  domain::add_item(block, "internal_energy", "energy/volume", block.points);
  domain::add_item(block, "internal_energy_rest", "energy/volume", block.points);
  domain::add_item(block, "rubble", "-", block.points);
  return first;
}

std::vector<double> eos_constants(const Material& material, const EquationOfState& equation, Index history) {
  constexpr double unbounded = -1e30;
  constexpr double least_share = 0.01;
  const double least = std::visit(LeastPressure(), material.law);
  require(least <= 0, material, "the pressure cut-off must not be above zero");
  const model::Spall spall = least < 0 ? std::visit(SpallOf(), material.law) : model::Spall::None;
  const double speed = eos_wave_speed(material, equation);
  int kind = -1;
  const std::vector<double> own = own_constants(material, equation, kind, EquationsOfState{});
  std::vector<double> numbers(eos_place::own);
  numbers[eos_place::kind] = kind;
  numbers[eos_place::history] = history;
  numbers[eos_place::initial_excess] = equation.initial_volume - 1;
  numbers[eos_place::initial_energy] = equation.initial_energy;
  numbers[eos_place::per_density] = 1 / material.density;
  numbers[eos_place::shear] = 4.0 / 3.0 * shear_modulus(material);
  numbers[eos_place::least_square] = least_share * speed * speed;
  numbers[eos_place::least_pressure] = least < 0 ? least : unbounded;
  numbers[eos_place::spall] = static_cast<double>(spall);
  numbers.insert(numbers.end(), own.begin(), own.end());
  return numbers;
}

}  // namespace crumple::materials
