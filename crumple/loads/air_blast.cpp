// SPDX-License-Identifier: BSD-3-Clause
#include "loads/air_blast.hpp"

#include <algorithm>
#include <cmath>

#include "loads/kingery_bulmash.hpp"
#include "math/cube_root.hpp"
#include "math/power.hpp"

namespace crumple::loads {
namespace {

constexpr int table_steps = 4096;
constexpr double standard_atmosphere = 14.6959;  ///< [psi]

/// A wave in the units of the model: `cube_root` is that of the charge's mass in pounds.
BlastWave wave_in(const model::BlastUnits& units, double cube_root, const ScaledWave& scaled) {
  const auto decay = [&](double pressure, double impulse) {
    return friedlander_decay(pressure * scaled.duration / impulse);
  };
  return {.arrival = scaled.arrival * cube_root / units.milliseconds,
          .duration = scaled.duration * cube_root / units.milliseconds,
          .incident_pressure = scaled.incident_pressure / units.psi,
          .reflected_pressure = scaled.reflected_pressure / units.psi,
          .incident_decay = decay(scaled.incident_pressure, scaled.incident_impulse),
          .reflected_decay = decay(scaled.reflected_pressure, scaled.reflected_impulse)};
}

/// Friedlander's pulse over its peak, at a time over the duration of the positive phase. A decay that is not
/// above zero leaves no suction that would end: there is none then.
double pulse(double decay, double time) {
  constexpr double binary_log_of_e = 1.4426950408889634;
  if (time > 1 && decay <= 0) return 0;
  return (1 - time) * math::power_of_two(-binary_log_of_e * decay * time);
}

}  // namespace

BlastTable::BlastTable(const model::AirBlast& blast) {
  const double cube_root = math::cube_root(blast.mass * blast.units.pounds);
  const model::ScaledRange range = model::scaled_range(blast.burst);
  const double first = math::binary_log(range.nearest);
  const double step = (math::binary_log(range.farthest) - first) / table_steps;
  least_ = first + math::binary_log(cube_root / blast.units.feet);
  per_log_ = 1 / step;
  for (int k = 0; k <= table_steps; ++k)
    waves_.push_back(
        wave_in(blast.units, cube_root, scaled_wave(blast.burst, math::power_of_two(first + step * k))));
}

BlastWave BlastTable::at(double distance) const {
  const double place = (math::binary_log(std::max(distance, 1e-300)) - least_) * per_log_;
  const double inside = std::clamp(place, 0.0, static_cast<double>(table_steps));
  const auto below = std::min(static_cast<std::size_t>(inside), static_cast<std::size_t>(table_steps - 1));
  const double share = inside - static_cast<double>(below);
  const BlastWave& a = waves_[below];
  const BlastWave& b = waves_[below + 1];
  const auto between = [&](double BlastWave::*value) { return a.*value + share * (b.*value - a.*value); };
  return {.arrival = between(&BlastWave::arrival),
          .duration = between(&BlastWave::duration),
          .incident_pressure = between(&BlastWave::incident_pressure),
          .reflected_pressure = between(&BlastWave::reflected_pressure),
          .incident_decay = between(&BlastWave::incident_decay),
          .reflected_decay = between(&BlastWave::reflected_decay)};
}

double blast_pressure(const BlastWave& wave, double time, double cosine, bool negative_phase, double vacuum) {
  const double t = (time - wave.arrival) / wave.duration;
  if (t < 0 || (t > 1 && !negative_phase)) return 0;
  const double incident = wave.incident_pressure * pulse(wave.incident_decay, t);
  if (cosine <= 0) return std::max(incident, -vacuum);
  const double reflected = wave.reflected_pressure * pulse(wave.reflected_decay, t);
  const double square = cosine * cosine;
  return std::max(reflected * square + incident * (1 + square - 2 * cosine), -vacuum);
}

AirBlasts::Charge AirBlasts::charge_of(const model::AirBlast& blast, const domain::Domain& domain) {
  return {.table = BlastTable(blast),
          .centre = {blast.centre[0], blast.centre[1], blast.centre[2]},
          .node = blast.node == no_index ? no_index : domain.nodes.domain_node[blast.node],
          .detonation = blast.detonation,
          .death = blast.death,
          .vacuum = standard_atmosphere / blast.units.psi,
          .negative_phase = blast.negative_phase};
}

AirBlasts::AirBlasts(const model::Model& model, const domain::Domain& domain) : model_(&model) {
  for (const model::AirBlast& blast : model.air_blasts) charges_.push_back(charge_of(blast, domain));
  for (const model::BlastSegment& segment : model.blast_segments)
    loads_.push_back({.node = domain_nodes(domain, segment.node),
                      .charge = static_cast<std::size_t>(segment.blast),
                      .scale = segment.scale,
                      .shell = segment.shell});
}

void AirBlasts::move_charges(const domain::Domain& domain) {
  for (Charge& charge : charges_) {
    if (charge.detonated || charge.node == no_index) continue;
    charge.centre = domain.nodes.position[charge.node];
    charge.detonated = domain.clock.time >= charge.detonation;
  }
}

math::Vec3 AirBlasts::force_on_nodes(const domain::Domain& domain, const Load& load) const {
  const Charge& charge = charges_[load.charge];
  const double time = domain.clock.time;
  if (load.ended || time < charge.detonation || time >= charge.death) return {};
  const math::Vec3 way = charge.centre - centre(domain, load.node);
  const math::Vec3 area = vector_area(domain, load.node);
  const double distance = norm(way);
  const double product = distance * norm(area);
  if (!(product > 0)) return {};
  const double pressure = blast_pressure(charge.table.at(distance), time - charge.detonation,
                                         dot(way, area) / product, charge.negative_phase, charge.vacuum);
  return (-load.scale * pressure / static_cast<double>(corners(load.node))) * area;
}

void AirBlasts::add_forces(domain::Domain& domain) {
  if (loads_.empty()) return;
  move_charges(domain);
  if (eroded_.have_changed(domain, *model_))
    for (Load& load : loads_) load.ended = load.shell != no_index && eroded_.gone(load.shell);
  for (Load& load : loads_) add_equal_forces(domain, load.node, force_on_nodes(domain, load), load.previous);
}

void AirBlasts::declare(domain::StateList& list) {
  for (Charge& charge : charges_) {
    list.keep("air_blast_centre", "length", domain::Entity::Run, charge.centre);
    list.keep("air_blast_detonated", "-", domain::Entity::Run, charge.detonated);
  }
  for (Load& load : loads_) {
    list.keep("air_blast_load", "force", domain::Entity::Node, load.previous);
    list.keep("air_blast_load_ended", "-", domain::Entity::Run, load.ended);
  }
  list.keep("air_blasts_eroded", "-", domain::Entity::Run, eroded_.count());
}

}  // namespace crumple::loads
