// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/three_surface_concrete.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "materials/common/checks.hpp"
#include "materials/common/corner_volume.hpp"

namespace crumple::materials {
namespace {

constexpr std::size_t most_compaction_rows = 10;
constexpr std::size_t most_damage_rows = 13;

/// Rows of a PointTable: constant behind the last one, unless `goes_on`.
void put_table(std::vector<double>& numbers, int place, const std::vector<double>& x,
               const std::vector<double>& y, bool goes_on) {
  const std::size_t rows = x.size();
  for (std::size_t k = 0; k < rows; ++k) {
    const std::size_t from = std::min(k, rows - 2);
    const double slope = k + 1 < rows || goes_on ? (y[from + 1] - y[from]) / (x[from + 1] - x[from]) : 0;
    double* const row = numbers.data() + place + 3 * k;
    row[0] = x[k];
    row[1] = y[k];
    row[2] = slope;
  }
}

bool rises(const std::vector<double>& x) {
  return x.size() >= 2 && x[0] == 0 &&
         std::adjacent_find(x.begin(), x.end(), std::greater_equal<>()) == x.end();
}

void check_strength_of(const model::Material& material, const model::ThreeSurfaceConcrete& law) {
  require(law.tensile_strength > 0, material, "the tensile strength must be above zero");
  for (const auto* surface : {&law.maximum, &law.yield, &law.residual})
    require(surface->first > 0 && surface->second >= 0, material,
            "A1 of each surface must be above zero and A2 not negative");
  require(law.maximum.constant > 0 && law.yield.constant > 0, material, "A0 and A0Y must be above zero");
  require(model::unconfined_strength(law.maximum) > 3 * law.tensile_strength, material,
          "the compressive strength must be above three times the tensile strength");
  require(model::unconfined_strength(law.yield) > 1.35 * law.tensile_strength, material,
          "yield in compression must be above 1.35 times the tensile strength");
  require(law.opening_damage >= 0 && law.dilatancy >= 0 && law.dilatancy <= 1, material,
          "B3 must not be negative and OMEGA be between 0 and 1");
  require(law.width > 0, material, "LOCWIDTH must be above zero");
}

void check_tables_of(const model::Material& material, const model::ThreeSurfaceConcrete& law) {
  require(rises(law.damage) && law.damage.size() <= most_damage_rows && law.share.size() == law.damage.size(),
          material, "lambda must rise from zero, over 13 points at most");
  const double most = *std::max_element(law.share.begin(), law.share.end());
  const double least = *std::min_element(law.share.begin(), law.share.end());
  require(law.share[0] < 1 && most == 1 && least >= 0, material,
          "eta must be from 0 to 1, reach 1 and start below");
  const std::size_t points = law.compression.size();
  require(rises(law.compression) && points <= most_compaction_rows && law.pressure.size() == points &&
              law.unloading.size() == points,
          material, "compaction needs 2 to 10 points that rise from zero");
  require(law.pressure[0] == 0, material, "compaction must start without pressure");
  for (std::size_t k = 0; k + 1 < points; ++k) {
    const double slope =
        (law.pressure[k + 1] - law.pressure[k]) / (law.compression[k + 1] - law.compression[k]);
    require(slope > 0 && slope <= (1 + 1e-6) * std::max(law.unloading[k], law.unloading[k + 1]), material,
            "pressure must rise with compaction, more slowly than it falls at unloading");
  }
}

/// psi at five pressures (Malvar and others, 1997).
void put_meridians(std::vector<double>& numbers, const model::ThreeSurfaceConcrete& law) {
  const double strength = model::unconfined_strength(law.maximum);
  constexpr double biaxial = 1.15;
  const double p = 2.0 / 3 * biaxial * strength;
  const double there = law.maximum.constant + p / (law.maximum.first + law.maximum.second * p);
  put_table(numbers, SurfacesMeridians, {0, strength / 3, p, 3 * strength, 8.45 * strength},
            {0.5, 0.5 + 1.5 * law.tensile_strength / strength, biaxial * strength / there, 0.753, 1}, false);
}

void put_damage(std::vector<double>& numbers, const model::ThreeSurfaceConcrete& law) {
  std::vector<double> damage = law.damage;
  std::vector<double> share = law.share;
  const auto peak = std::max_element(share.begin(), share.end()) - share.begin();
  // The last value stays.
  damage.push_back(std::max(1e10, 10 * damage.back()));
  share.push_back(share.back());
  numbers[SurfacesRows] = static_cast<double>(damage.size());
  numbers[SurfacesPeak] = static_cast<double>(peak);
  numbers[SurfacesPeakDamage] = damage[static_cast<std::size_t>(peak)];
  put_table(numbers, SurfacesDamage, damage, share, false);
}

void put_rates(std::vector<double>& numbers, int rows, int place,
               const model::ThreeSurfaceConcrete::RateFactors& of) {
  numbers[rows] = static_cast<double>(of.rate.size());
  if (!of.rate.empty()) put_table(numbers, place, of.rate, of.factor, false);
}

void check_rates_of(const model::Material& material, const model::ThreeSurfaceConcrete& law) {
  require(law.tension_rates.rate.empty() == law.compression_rates.rate.empty(), material,
          "rate factors are needed in tension and in compression, or in neither");
  for (const auto* of : {&law.tension_rates, &law.compression_rates}) {
    if (of->rate.empty()) continue;
    require(rises(of->rate) && of->rate.size() <= most_rate_rows && of->factor.size() == of->rate.size(),
            material, "rate factors need 2 to 48 rates that rise from zero");
    require(*std::min_element(of->factor.begin(), of->factor.end()) >= 1, material,
            "rate factors must not be below 1");
  }
}

}  // namespace

void ThreeSurfaceConcreteLaw::declare_history(const model::ConstitutiveLaw& /*law*/,
                                              domain::ElementBlock& block, Index /*tensor*/) {
  declare_volume(block);
  domain::add_item(block, "dilation", "-", block.points);
  domain::add_item(block, "largest_compression", "-", block.points);
  domain::add_item(block, "concrete_damage", "-", block.points);
  domain::add_item(block, "softening_speed", "-", block.points);
  domain::add_item(block, "damage", "-", block.points);
}

void ThreeSurfaceConcreteLaw::prepare_solid_element(const model::ConstitutiveLaw& law,
                                                    const SolidCorners& corners, UserId /*solid*/,
                                                    domain::ElementBlock& block, Index history, Index place) {
  const double length = std::cbrt(corner_volume(corners));
  const double speed = std::max(1.0, length / std::get<Model>(law).width);
  for (int p = 0; p < block.points; ++p)
    block.set_state(place, history + Softening * block.points + p, speed);
}

std::vector<double> ThreeSurfaceConcreteLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  check_strength_of(material, law);
  check_tables_of(material, law);
  check_rates_of(material, law);
  std::vector<double> numbers(SurfacesCount);
  const auto put = [&](int place, const Model::Surface& of) {
    numbers[place] = of.constant;
    numbers[place + 1] = of.first;
    numbers[place + 2] = of.second;
  };
  put(SurfacesMaximum, law.maximum);
  put(SurfacesYield, law.yield);
  put(SurfacesResidual, {0, law.residual.first, law.residual.second});
  numbers[SurfacesUnconfined] = model::unconfined_strength(law.maximum) / 3;
  numbers[SurfacesFirst] = model::unconfined_strength(law.yield) / 3;
  numbers[SurfacesTension] = law.tensile_strength;
  numbers[SurfacesCompressionPower] = law.compression_power;
  numbers[SurfacesTensionPower] = law.tension_power;
  numbers[SurfacesOpening] = law.opening_damage;
  numbers[SurfacesDilatancy] = law.dilatancy;
  numbers[SurfacesShear] = 1.5 * (1 - 2 * law.poissons_ratio) / (1 + law.poissons_ratio);
  numbers[SurfacesPerDensity] = 1 / material.density;
  numbers[SurfacesPoints] = static_cast<double>(law.compression.size());
  put_meridians(numbers, law);
  put_table(numbers, SurfacesCompaction, law.compression, law.pressure, true);
  put_table(numbers, SurfacesUnloading, law.compression, law.unloading, false);
  put_damage(numbers, law);
  put_rates(numbers, SurfacesTensionRows, SurfacesTensionRates, law.tension_rates);
  put_rates(numbers, SurfacesPressRows, SurfacesPressRates, law.compression_rates);
  return numbers;
}

}  // namespace crumple::materials
