// SPDX-License-Identifier: BSD-3-Clause
#include "output/checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "domain/round_off_energy.hpp"
#include "output/driven_speed.hpp"
#include "output/results/part_masses.hpp"

namespace crumple::output {

namespace {

constexpr const char* w179 = "NCHRP W179";
constexpr const char* euro_ncap = "NCHRP W179, Euro NCAP 1.0.2";

/// Energies below this share of the largest one around are round-off, and their ratios mean nothing.
constexpr double negligible = 1e-9;

/// Contact is judged against the internal energy, but against no less than this share of the largest energy
/// around: until bodies that have just met deform, their springs hold more than they do.
constexpr double least_internal = 0.1;

/// Errors are judged against the energy absorbed, but against no less than this share of the largest energy
/// around: rigid bodies absorb nothing, and a balance is kept to the digits of what moves.
constexpr double least_absorbed = 0.01;

double ratio_of(double part, double whole, double least) {
  if (std::fabs(part) <= least) return 0;
  return whole != 0 ? part / whole : HUGE_VAL;
}

/// What elements and contact have absorbed, and what damping has taken out of the motion [energy].
double absorbed_or_damped(const domain::EnergyLedger& energy) {
  return energy.absorbed() + std::max(0.0, energy.damping);
}

/// Largest energy of the ledger [energy].
double energy_scale(const domain::EnergyLedger& energy) {
  return std::max({std::fabs(energy.kinetic), std::fabs(energy.internal), std::fabs(energy.initial_total),
                   std::fabs(energy.external_work)});
}

/// Energies that are round-off: of the largest one around, or of a model at rest [energy].
double smallest_energy(const View& view, double scale) {
  return std::max(negligible * scale, domain::round_off_energy(view.domain));
}

/// What contact energies are judged against [energy].
double internal_for_contact(const PeakValues& peaks, double scale) {
  return std::max(peaks.largest_internal_energy(), least_internal * scale);
}

/// Of the contact springs, less what penalties and ties hold and will give back.
double unreturned_energy(const domain::Domain& domain) {
  double sum = domain.energy.contact_springs();
  for (const domain::ContactReport& contact : domain.contacts) sum -= contact.stored_energy;
  for (const domain::Tie& tie : domain.ties) sum -= tie.energy - tie.dissipated;
  return sum;
}

struct PartEnergy {
  double internal = 0;
  double hourglass = 0;
};

std::vector<PartEnergy> energy_by_part(const View& view) {
  std::vector<PartEnergy> parts(view.model.parts.size());
  for (const domain::ElementBlock* block : view.domain.blocks()) {
    parts[block->part].internal += block->internal_energy;
    parts[block->part].hourglass += block->hourglass_energy;
  }
  return parts;
}

/// The part with the most hourglass energy, as W179 looks at it.
Index worst_part(const std::vector<PartEnergy>& parts) {
  return static_cast<Index>(
      std::max_element(parts.begin(), parts.end(),
                       [](const PartEnergy& a, const PartEnergy& b) { return a.hourglass < b.hourglass; }) -
      parts.begin());
}

double total_mass(const domain::Domain& domain) {
  double sum = 0;
  for (const double mass : domain.nodes.mass) sum += mass;
  return sum;
}

Check make_check(std::string name, double value, double limit, std::string source,
                 std::optional<double> source_limit = {}) {
  return {std::move(name), value, limit, value <= limit, std::move(source), source_limit};
}

/// How fast all mass would be if what was supplied so far were its kinetic energy.
double supplied_speed(const domain::Domain& domain) {
  const double supplied = domain.energy.initial_total + domain.energy.external_work;
  const double mass = total_mass(domain);
  return supplied > 0 && mass > 0 ? std::sqrt(2 * supplied / mass) : 0;
}

/// Whether the hourglass stress of a part is that of its material: its energy is strain energy then, as in an
/// element with more points, and no limit on artificial energy applies.
bool resists_as_material(const View& view, std::size_t part) {
  const model::Part& of = view.model.parts[part];
  if (model::hourglass_of(view.model, of).form != model::HourglassForm::Material) return false;
  const model::ElementKind kind = model::kind_of(of);
  return kind == model::ElementKind::Shell ||
         (kind == model::ElementKind::Solid && model::is_elastic(view.model.materials[of.material].law));
}

/// Whether a part does so and stays elastic.
bool bends_elastically(const View& view, std::size_t part) {
  const Index material = view.model.parts[part].material;  // springs and laminates have none
  return material != no_index && resists_as_material(view, part) &&
         model::is_elastic(view.model.materials[material].law);
}

/// By part, with the hourglass energy that is artificial; and all of that.
std::pair<std::vector<PartEnergy>, double> artificial_energies(const View& view) {
  std::vector<PartEnergy> parts = energy_by_part(view);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (resists_as_material(view, i)) parts[i].hourglass = 0;
  return {std::move(parts), view.domain.energy.hourglass - material_hourglass_energy(view)};
}

}  // namespace

double material_hourglass_energy(const View& view) {
  const std::vector<PartEnergy> parts = energy_by_part(view);
  double sum = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (resists_as_material(view, i)) sum += parts[i].hourglass;
  return sum;
}

void PeakValues::observe(const View& view) {
  const domain::NodeFields& nodes = view.domain.nodes;
  double fastest = 0;
  Index fastest_node = no_index;
  for (Index node = 0; node < nodes.count(); ++node) {
    const double speed = math::norm(nodes.velocity[node]);
    if (speed > fastest) {
      fastest = speed;
      fastest_node = node;
    }
  }
  observe(view.domain.energy);
  const std::vector<PartEnergy> parts = energy_by_part(view);
  largest_part_internal_.resize(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    largest_part_internal_[i] = std::max(largest_part_internal_[i], parts[i].internal);
  // The first velocities are half a step on: those of a model at rest are loads times that, not a start.
  const bool starts_at_rest = view.domain.clock.cycle == 0 && view.domain.energy.kinetic == 0;
  if (!run_.has_reference && !starts_at_rest) run_.reference_speed = fastest;
  run_.has_reference = true;
  run_.reference_speed = std::max({run_.reference_speed, driven_speed(view), supplied_speed(view.domain)});
  if (fastest > run_.fastest) {
    run_.fastest = fastest;
    run_.fastest_node = view.model.nodes.id[nodes.model_node[fastest_node]];
  }
}

void PeakValues::observe(const domain::EnergyLedger& energy) {
  run_.largest_supplied =
      std::max(run_.largest_supplied, std::fabs(energy.initial_total + energy.external_work));
  run_.largest_internal = std::max(run_.largest_internal, energy.internal);
  run_.largest_absorbed = std::max(run_.largest_absorbed, absorbed_or_damped(energy));
  run_.lowest_contact = std::min(run_.lowest_contact, energy.contact_springs());
}

double energy_error(const View& view, const PeakValues& peaks) {
  const domain::EnergyLedger& energy = view.domain.energy;
  if (std::fabs(energy.imbalance()) <= domain::round_off_energy(view.domain)) return 0;
  // What a motion has supplied and taken back again is no longer in the energies of the end.
  const double scale = least_absorbed * peaks.largest_supplied_energy();
  return energy.error(std::max(peaks.largest_absorbed_energy(), scale), least_absorbed);
}

std::vector<Check> acceptance_checks(const View& view, const PeakValues& peaks) {
  const domain::EnergyLedger& energy = view.domain.energy;
  const double scale = std::max(energy_scale(energy), peaks.largest_supplied_energy());
  // A model at rest gets its energy from the work of its loads, and may have returned it by now.
  const double before = peaks.largest_supplied_energy();
  const auto [parts, hourglass] = artificial_energies(view);
  const double round_off = domain::round_off_energy(view.domain);
  const double least = std::max(negligible * scale, round_off);
  // The energies above the table have all of it: what is left out here must show.
  const std::string name = material_hourglass_energy(view) == 0 ? "hourglass" : "artificial hourglass";
  std::vector<Check> checks;
  checks.push_back(make_check("total energy change / initial energy",
                              std::fabs(ratio_of(energy.imbalance(), before, least)), 0.01, w179, 0.10));
  checks.push_back(make_check("energy error / absorbed energy", energy_error(view, peaks), 0.01, "crumple"));
  checks.push_back(make_check(name + " / initial total energy", ratio_of(std::fabs(hourglass), before, least),
                              0.05, euro_ncap, 0.05));
  checks.push_back(make_check(name + " / internal energy",
                              ratio_of(std::fabs(hourglass), peaks.largest_internal_energy(), least), 0.10,
                              euro_ncap, 0.10));
  if (!parts.empty()) {
    const PartEnergy& worst = parts[worst_part(parts)];
    checks.push_back(make_check(
        fmt::format("{} / internal energy, part {}", name, view.model.parts[worst_part(parts)].id),
        ratio_of(std::fabs(worst.hourglass), peaks.largest_internal_energy(worst_part(parts)), least), 0.10,
        w179, 0.10));
  }
  checks.push_back(make_check(
      "added mass / mass",
      std::fabs(view.domain.added_mass) / std::max(total_mass(view.domain) - view.domain.added_mass, 1e-300),
      0.05, w179, 0.05));
  if (!view.domain.contacts.empty()) {
    const double internal = internal_for_contact(peaks, scale);
    checks.push_back(make_check("negative contact energy / internal energy",
                                ratio_of(-peaks.lowest_contact_energy(), internal, least), 0.01,
                                "practice: not negative", 0.0));
    checks.push_back(make_check("contact energy without friction / internal energy",
                                ratio_of(unreturned_energy(view.domain), internal, least), 0.10, "practice",
                                0.10));
  }
  for (const domain::ContactReport& contact : view.domain.contacts) {
    checks.push_back(make_check(fmt::format("nodes lost by contact {}", contact.id),
                                static_cast<double>(contact.lost_nodes.count), 0, "crumple"));
    checks.push_back(make_check(fmt::format("edges lost by contact {}", contact.id),
                                static_cast<double>(contact.lost_edges.count), 0, "crumple"));
    checks.push_back(make_check(fmt::format("deepest penetration / thickness, contact {}", contact.id),
                                contact.deepest.share, 1, "crumple"));
    if (!contact.inspection.made) continue;
    checks.push_back(make_check(fmt::format("mid-surface intersections of the run, contact {}", contact.id),
                                contact.worst_intersections.count, 0, "crumple"));
    checks.push_back(make_check(fmt::format("nodes in solids without contact, contact {}", contact.id),
                                contact.inspection.nodes_in_solids, 0, "crumple"));
    checks.push_back(make_check(fmt::format("nodes on or beyond a mid-surface, contact {}", contact.id),
                                contact.inspection.nodes_beyond, 0, "crumple"));
  }
  // Where nothing has been set in motion there is no speed to compare with.
  if (peaks.reference_speed() > 0)
    checks.push_back(make_check(fmt::format("fastest node (node {}) / fastest driven", peaks.fastest_node()),
                                peaks.fastest() / peaks.reference_speed(), 10, "crumple: no shooting nodes"));
  return checks;
}

std::vector<std::string> energy_warnings(const View& view, const PeakValues& peaks) {
  const domain::EnergyLedger& energy = view.domain.energy;
  const double scale = std::max(energy_scale(energy), peaks.largest_supplied_energy());
  const double least = smallest_energy(view, scale);
  std::vector<std::string> warnings;
  const double internal = peaks.largest_internal_energy();
  const double artificial = artificial_energies(view).second;
  if (ratio_of(artificial, internal, least) > 0.1)
    warnings.push_back(fmt::format("Hourglass energy is {:.1f} % of the internal energy (limit 10 %).",
                                   100 * artificial / internal));
  const std::vector<PartEnergy> parts = energy_by_part(view);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double own = peaks.largest_internal_energy(static_cast<Index>(i));
    // Parts that absorb next to nothing are left out: their ratio says nothing about the result. So are those
    // that stay elastic and whose hourglass stress is that of the material: it is their bending.
    if (bends_elastically(view, i)) continue;
    if (own > 0.01 * internal && ratio_of(parts[i].hourglass, own, least) > 0.1)
      warnings.push_back(fmt::format("Hourglass energy of part {} is {:.1f} % of its internal energy{}.",
                                     view.model.parts[i].id, 100 * parts[i].hourglass / own,
                                     resists_as_material(view, i)
                                         ? ": its elements are too large for how they bend, and stiffen it"
                                         : " (limit 10 %)"));
  }
  const double judged = internal_for_contact(peaks, scale);
  for (const domain::ContactReport& contact : view.domain.contacts)
    if (ratio_of(contact.energy - contact.damping_energy, judged, least) < -0.01)
      warnings.push_back(fmt::format(
          "Energy of contact {} is negative: {:.2f} % of {} (limit 1 %).", contact.id,
          100 * (contact.energy - contact.damping_energy) / judged,
          judged > internal ? "a tenth of the largest energy around" : "the largest internal energy"));
  return warnings;
}

}  // namespace crumple::output
