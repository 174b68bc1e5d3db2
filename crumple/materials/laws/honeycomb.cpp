// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/honeycomb.hpp"

#include <algorithm>
#include <variant>

#include "materials/common/checks.hpp"
#include "materials/plasticity/hardening_table.hpp"

namespace crumple::materials {

namespace {

using math::Vec3;

void check_crush(const model::Material& material, const model::Honeycomb::Crush& curve) {
  require(!curve.crush.empty() && curve.stress.size() == curve.crush.size(), material,
          "the yield stresses must have points");
  for (std::size_t k = 0; k < curve.crush.size(); ++k) {
    require(curve.stress[k] >= 0, material, "the yield stresses must not be negative");
    if (k > 0)
      require(curve.crush[k] > curve.crush[k - 1], material,
              "the volumes or strains of the yield stresses must ascend or descend");
  }
}

/// Appends a table of factors; its first number and its points stand at `place`.
void append_factors(const model::Material& material, const model::Honeycomb::RateFactor& rates, int place,
                    std::vector<double>& numbers) {
  for (const double factor : rates.factor)
    require(factor > 0, material, "the factors over the strain rate must be above zero");
  numbers[place] = static_cast<double>(numbers.size());
  numbers[place + 1] = static_cast<double>(rates.rate.size());
  append_table(rates.rate, rates.factor, false, numbers);
}

/// Directions of a, and of a vector in the plane of a and b (`d`).
struct Directions {
  Vec3 a, d;
};
Directions directions(const model::Honeycomb& law, const SolidCorners& corner) {
  const Vec3 given{law.a[0], law.a[1], law.a[2]};
  switch (law.axes) {
    case model::Honeycomb::Axes::Nodes:
      return {corner[1] - corner[0], corner[3] - corner[0]};
    case model::Honeycomb::Axes::Point: {
      Vec3 middle;
      for (const Vec3& x : corner) middle += 0.125 * x;
      return {middle - given, {0, 0, 1}};
    }
    case model::Honeycomb::Axes::Vectors:
      return {given, {law.d[0], law.d[1], law.d[2]}};
  }
  return {};
}

}  // namespace

void HoneycombLaw::declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block,
                                   Index /*tensor*/) {
  domain::add_item(block, "material_axes", "-", 6 * block.points);
  domain::add_item(block, "material_axes_rest", "-", 6 * block.points);
  declare_volume(block);
  if (!follows_strains(law)) return;
  domain::add_item(block, "material_strain", "-", 6 * block.points);
  domain::add_item(block, "material_strain_rest", "-", 6 * block.points);
  if (!can_fail(law)) return;
  domain::add_item(block, "failed", "-", block.points);
}

void HoneycombLaw::prepare_solid_element(const model::ConstitutiveLaw& law, const SolidCorners& corners,
                                         UserId solid, domain::ElementBlock& block, Index history,
                                         Index place) {
  const Directions along = directions(std::get<Model>(law), corners);
  const Vec3 across = cross(along.a, along.d);
  if (!(norm(across) > 1e-6 * norm(along.a) * norm(along.d))) fail_solid_axes(solid);
  const Vec3 a = normalised(along.a);
  const Vec3 b = cross(normalised(across), a);
  for (int p = 0; p < block.points; ++p)
    for (int k = 0; k < 3; ++k) {
      block.set_state(place, history + 6 * p + k, a[k]);
      block.set_state(place, history + 6 * p + 3 + k, b[k]);
    }
}

std::vector<double> HoneycombLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require(law.yield_stress > 0, material, "the yield stress of the compacted honeycomb must be above zero");
  require(law.compacted_volume > 0 && law.compacted_volume < 1, material,
          "the relative volume of compaction must be above 0 and below 1");
  require(law.failure_tension >= 0 && law.failure_shear >= 0, material,
          "the failure strains must not be negative");
  std::vector<double> numbers(Count);
  const double nu = law.poissons_ratio;
  const double shear = 0.5 * law.youngs_modulus / (1 + nu);
  const double confined = law.youngs_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  numbers[Youngs] = law.youngs_modulus;
  numbers[Poisson] = nu;
  numbers[Yield] = law.yield_stress;
  numbers[CompactedVolume] = law.compacted_volume;
  numbers[StiffnessJump] = std::max(0.0, confined - std::max(law.youngs_modulus, 2 * shear));
  numbers[PerDensity] = 1 / material.density;
  numbers[Tension] = law.failure_tension;
  numbers[Shear] = law.failure_shear;
  for (std::size_t k = 0; k < 6; ++k) {
    require(law.moduli[k] > 0, material, "the moduli of the uncompacted honeycomb must be above zero");
    check_crush(material, law.crush[k]);
    numbers[Moduli + k] = law.moduli[k];
    numbers[Tables + 2 * k] = static_cast<double>(numbers.size());
    numbers[Tables + 2 * k + 1] = static_cast<double>(law.crush[k].crush.size());
    append_table(law.crush[k].crush, law.crush[k].stress, true, numbers);
  }
  const bool own = std::any_of(law.own_rates.begin(), law.own_rates.end(),
                               [](const auto& rates) { return !rates.rate.empty(); });
  numbers[OwnRates] = own ? 1 : 0;
  numbers[Over] = static_cast<double>(law.over);
  for (std::size_t k = 0; k < 6; ++k)
    append_factors(material, own ? law.own_rates[k] : law.rates, RateTables + 2 * static_cast<int>(k),
                   numbers);
  return numbers;
}

}  // namespace crumple::materials
