// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/guards.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "domain/round_off_energy.hpp"
#include "materials/common/shell_material.hpp"
#include "timeloop/trouble.hpp"

namespace crumple::timeloop {
namespace {

/// Kinetic energy over all energy supplied that can only come from a run that has lost its stability.
constexpr double runaway_ratio = 100.0;

/// A contact that has given more than this share of the internal energy, or of what was supplied where little
/// has been absorbed yet, has made what the result shows.
constexpr double contact_share = 0.1;

double supplied_energy(const domain::EnergyLedger& energy) {
  return std::fabs(energy.initial_total) + std::fabs(energy.external_work);
}

/// Largest density of strain energy that a stress at time zero can have: (1 + nu) sigma.sigma / (2 E)
/// [stress].
double largest_density(const model::Material& material, const model::InitialStress& given) {
  const materials::ElasticConstants elastic = materials::elastic_constants(material);
  double largest = 0;
  for (const model::InitialPointStress& point : given.points) {
    const auto& s = point.stress;
    largest = std::max(
        largest, s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  }
  return elastic.youngs_modulus > 0 ? 0.5 * (1 + elastic.poissons_ratio) * largest / elastic.youngs_modulus
                                    : 0;
}

/// How far below zero v(n-1/2).v(n+1/2) may be, over the energy that there is. An oscillator with the step
/// s 2 / omega keeps T + U, and T > -s^2 U: so T > -s^2 / (1 - s^2) (T + U). Twice that.
/// Elements alone are nearer to their limit than TSSFAC says (elements/lone_elements.hpp). With short steps
/// the bound stays beyond T = -1/2 m v^2 of nodes whose prescribed motion is turned round, which is no more
/// than was supplied.
double negative_ratio(double step_scale) {
  constexpr double lone = 1.07;
  constexpr double turned_round = 0.7;
  constexpr double nearest_to_unstable = 0.995;
  const double s = std::clamp(lone * step_scale, turned_round, nearest_to_unstable);
  return 2 * s * s / (1 - s * s);
}

std::string where_contact_gives(const domain::ContactReport& contact) {
  std::string text = "; its deepest node so far is " + std::to_string(contact.worst_node) + " with " +
                     std::to_string(contact.worst_penetration);
  const domain::WithheldForces& withheld = contact.withheld;
  if (withheld.count > 0)
    text += ", the largest force withheld that of node " + std::to_string(withheld.node) + " on segment " +
            std::to_string(withheld.segment) + " in cycle " + std::to_string(withheld.cycle);
  return text;
}

}  // namespace

double initial_stress_energy(const model::Model& model, const domain::Domain& domain) {
  double density = 0;
  const auto include = [&](const auto& elements, const std::vector<model::InitialStress>& stresses) {
    for (const model::InitialStress& given : stresses) {
      const auto& part = model.parts[elements[given.element].part];
      if (part.material != no_index)
        density = std::max(density, largest_density(model.materials[part.material], given));
    }
  };
  include(model.shells, model.shell_stresses);
  include(model.solids, model.solid_stresses);
  if (density == 0) return 0;
  double lightest = std::numeric_limits<double>::max();
  for (const model::Material& material : model.materials)
    if (material.density > 0) lightest = std::min(lightest, material.density);
  double mass = 0;
  for (const double m : domain.nodes.mass) mass += m;
  return density * mass / lightest;
}

KineticRange plausible_kinetic_energy(const domain::Domain& domain, double step_scale) {
  const domain::EnergyLedger& energy = domain.energy;
  const double supplied = supplied_energy(energy);
  const double absorbed = std::max(0.0, energy.internal + energy.hourglass) + std::max(0.0, energy.eroded);
  const double negative = negative_ratio(step_scale);
  KineticRange range{-negative * supplied, runaway_ratio * supplied + absorbed};
  if (energy.kinetic >= range.least && energy.kinetic <= range.most) return range;
  const double floor = domain::round_off_energy(domain);
  return {range.least - negative * floor, range.most + runaway_ratio * floor};
}

void guard_kinetic_energy(const model::Model& model, const domain::Domain& domain, double stored) {
  const domain::EnergyLedger& energy = domain.energy;
  if (!std::isfinite(energy.total())) throw_trouble(model, domain, "The energy grows without bound");
  if (domain.clock.cycle == 0) return;
  const KineticRange range = plausible_kinetic_energy(domain, model.control.step_scale);
  if (energy.kinetic > range.most + runaway_ratio * stored)
    throw_trouble(model, domain, "The energy grows without bound");
  // A load that takes back its work leaves nothing supplied for a moment: without strain nothing is unstable.
  const bool strained = energy.internal + energy.hourglass > supplied_energy(energy);
  if (strained && energy.kinetic < range.least)
    throw_trouble(
        model, domain,
        "The step is unstable (velocities change their sign from step to step, and grow): a smaller "
        "TSSFAC may help");
}

void guard_contact_energy(const domain::Domain& domain) {
  const domain::EnergyLedger& energy = domain.energy;
  for (const domain::ContactReport& contact : domain.contacts) {
    if (contact.energy >= 0) continue;
    const double most = contact_share * std::max(energy.internal, supplied_energy(energy));
    if (contact.energy >= -most || contact.energy >= -round_off_energy(domain)) continue;
    const double share = energy.internal > 0 ? 100 * contact.energy / energy.internal : -100;
    throw NumericalError("Contact " + std::to_string(contact.id) + " makes energy: it has given " +
                         std::to_string(-contact.energy) + " more than it took, " + std::to_string(share) +
                         " % of the internal energy (limit -10 %)" + where_contact_gives(contact) +
                         ", at cycle " + std::to_string(domain.clock.cycle) + ", time " +
                         std::to_string(domain.clock.time) + ". --allow-negative-contact-energy goes on.");
  }
}

}  // namespace crumple::timeloop
