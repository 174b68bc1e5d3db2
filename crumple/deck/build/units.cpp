// SPDX-License-Identifier: BSD-3-Clause
#include "deck/build/units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <variant>

namespace crumple::deck {

namespace {

/// A system of units by its units in kg, m and s.
struct System {
  std::string_view name;
  double mass;
  double length;
  double time;

  double density() const { return mass / (length * length * length); }
  double stress() const { return mass / (length * time * time); }
};

// Those of the table "Consistent units" at dynasupport.com and two more, the most used ones first.
constexpr std::array<System, 17> systems{{
    {"t, mm, s", 1000, 1e-3, 1},
    {"kg, mm, ms", 1, 1e-3, 1e-3},
    {"kg, m, s", 1, 1, 1},
    {"g, mm, ms", 1e-3, 1e-3, 1e-3},
    {"g, cm, us", 1e-3, 1e-2, 1e-6},
    {"lbf s^2/in, in, s", 175.126835, 0.0254, 1},
    {"slug, ft, s", 14.593903, 0.3048, 1},
    {"g, cm, s", 1e-3, 1e-2, 1},
    {"g, cm, ms", 1e-3, 1e-2, 1e-3},
    {"g, mm, s", 1e-3, 1e-3, 1},
    {"kg, cm, s", 1, 1e-2, 1},
    {"kg, cm, ms", 1, 1e-2, 1e-3},
    {"kg, cm, us", 1, 1e-2, 1e-6},
    {"kg, mm, s", 1, 1e-3, 1},
    {"kgf s^2/mm, mm, s", 9806.65, 1e-3, 1},
    {"t, m, s", 1000, 1, 1},
    {"g, mm, us", 1e-3, 1e-3, 1e-6},
}};

constexpr double steel_density = 7830;     // kg/m^3
constexpr double steel_modulus = 2.07e11;  // Pa

double modulus_of(const model::Material& material) {
  return std::visit([](const auto& law) { return law.youngs_modulus; }, material.law);
}

/// From magnesium to steel, whose ratios of modulus to density are nearly the same.
bool is_metal(const model::Material& material, const System& system) {
  const double lightness = material.density * system.density() / steel_density;
  const double stiffness = modulus_of(material) * system.stress() / steel_modulus;
  return lightness > 0.2 && lightness < 1.5 && stiffness > 0.15 && stiffness < 1.5;
}

bool is_plastic(const model::ConstitutiveLaw& law) {
  return !std::holds_alternative<model::Elastic>(law) &&
         !std::holds_alternative<model::OrthotropicElastic>(law) &&
         !std::holds_alternative<model::CompositeDamage>(law) &&
         !std::holds_alternative<model::LaminatedFabric>(law) &&
         !std::holds_alternative<model::Fabric>(law) && !std::holds_alternative<model::NullMaterial>(law) &&
         !std::holds_alternative<model::BlatzKo>(law) && !std::holds_alternative<model::MooneyRivlin>(law) &&
         !std::holds_alternative<model::CrushableFoam>(law) &&
         !std::holds_alternative<model::BilkhuDuboisFoam>(law) &&
         !std::holds_alternative<model::LowDensityFoam>(law) &&
         !std::holds_alternative<model::OgdenRubber>(law) &&
         !std::holds_alternative<model::PolynomialRubber>(law) &&
         !std::holds_alternative<model::Viscoelastic>(law) &&
         !std::holds_alternative<model::Honeycomb>(law) && !std::holds_alternative<model::SoilAndFoam>(law) &&
         !std::holds_alternative<model::ViscousFoam>(law) &&
         !std::holds_alternative<model::SimplifiedRubber>(law) &&
         !std::holds_alternative<model::CapConcrete>(law) &&
         !std::holds_alternative<model::ThreeSurfaceConcrete>(law) &&
         !std::holds_alternative<model::HolmquistCeramic>(law) &&
         !std::holds_alternative<model::HolmquistConcrete>(law) &&
         !std::holds_alternative<model::HydroPlasticity>(law);
}

/// Its stiffness is no stress, and of cohesive solids the density may be one per area.
bool has_no_modulus(const model::ConstitutiveLaw& law) {
  return std::holds_alternative<model::DiscreteBeamLaw>(law) || std::holds_alternative<model::Cohesive>(law);
}

/// What decks write for "elastic" where a law asks for a yield stress.
bool never_yields(const model::ConstitutiveLaw& law) {
  constexpr double none = 1e15;
  return std::visit(
      [](const auto& each) {
        if constexpr (requires { each.yield_stress.front(); })
          return !each.yield_stress.empty() && each.yield_stress.front() >= none;
        else if constexpr (requires { each.yield_stress >= none; })
          return each.yield_stress >= none;
        return false;
      },
      law);
}

/// Something has this density and modulus in the system. `any` admits whatever is solid, gels included; else
/// it must be something that yields: soft plastics and foams, or metals. Densities may be a hundred times too
/// high, as they are made to save steps or to stand for what is not modelled.
bool is_possible(const model::Material& material, const System& system, bool any) {
  const double density = material.density * system.density();
  const double modulus = modulus_of(material) * system.stress();
  const double wave_speed = std::sqrt(modulus / density);
  constexpr double heavy = 2350;  // kg/m^3, about where plastics and rubber end
  constexpr double porous = 500;  // kg/m^3; below it foams, of which none is as stiff as a metal by weight
  const double slowest = any ? (density < heavy ? 1 : 10) : (density < heavy ? 50 : 200);
  const double fastest = any || density > porous ? 3e4 : 3e3;
  return density > 8 && density < 8e5 && modulus < 1.2e12 && wave_speed > slowest && wave_speed < fastest;
}

/// The system in which the given quantity of steel comes nearest to `value`.
template <class Quantity>
const System& nearest(double value, const Quantity& of_steel) {
  const auto distance = [&](const System& system) { return std::fabs(std::log(value / of_steel(system))); };
  // Of those that are equally near the most used one.
  const System* found = &systems.front();
  for (const System& system : systems)
    if (distance(system) < distance(*found) - 0.01) found = &system;
  return *found;
}

std::string doubt(double density, double modulus) {
  const auto density_in = [](const System& system) { return steel_density / system.density(); };
  const auto modulus_in = [](const System& system) { return steel_modulus / system.stress(); };
  const System& by_density = nearest(density, density_in);
  const System& by_modulus = nearest(modulus, modulus_in);
  if (&by_density == &by_modulus)
    return fmt::format(
        "the density {:g} and the modulus {:g} go together in no usual system of units; steel has the "
        "density "
        "{:.3g} where its modulus is {:.3g} ({})",
        density, modulus, density_in(by_density), modulus_in(by_density), by_density.name);
  return fmt::format(
      "the density {:g} and the modulus {:g} go together in no usual system of units; steel has the density "
      "{:.3g} where its modulus is {:.3g} ({}), and {:.3g} where it is {:.3g} ({})",
      density, modulus, density_in(by_density), modulus_in(by_density), by_density.name,
      density_in(by_modulus), modulus_in(by_modulus), by_modulus.name);
}

}  // namespace

std::string guess_units(const model::Model& model) {
  std::string_view found;
  for (const model::Material& material : model.materials) {
    if (has_no_modulus(material.law)) continue;
    const auto fits = std::find_if(systems.begin(), systems.end(),
                                   [&](const System& system) { return is_metal(material, system); });
    if (fits == systems.end() || (!found.empty() && fits->name != found)) return {};
    found = fits->name;
  }
  return std::string(found);
}

std::vector<std::string> unit_doubts(const model::Model& model) {
  std::vector<std::string> doubts;
  for (const model::Material& material : model.materials) {
    std::string& told = doubts.emplace_back();
    const double modulus = modulus_of(material);
    if (std::holds_alternative<model::NullMaterial>(material.law) || has_no_modulus(material.law)) continue;
    // Of a rigid body the density is whatever gives it its mass.
    if (material.rigid || !(material.density > 0 && modulus > 0)) continue;
    const bool fits = std::any_of(systems.begin(), systems.end(), [&](const System& system) {
      // Beside a metal that tells the system, trim of any softness may be modelled as plastic.
      const bool certain = std::any_of(model.materials.begin(), model.materials.end(),
                                       [&](const model::Material& other) { return is_metal(other, system); });
      return is_possible(material, system,
                         certain || !is_plastic(material.law) || never_yields(material.law));
    });
    if (!fits) told = doubt(material.density, modulus);
  }
  return doubts;
}

}  // namespace crumple::deck
