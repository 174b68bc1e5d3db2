// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/results/view.hpp"

namespace crumple::output {

/// One line of the table by which users of crash codes accept or refuse a run.
struct Check {
  std::string name;
  double value = 0;                    ///< [-]
  double limit = 0;                    ///< ours: the value passes if it is not above
  bool pass = true;                    ///< never for a value that is not a number
  std::string source;                  ///< where the check and the source's limit are from
  std::optional<double> source_limit;  ///< none if the check is our own
};

/// What the checks need from the course of a run, beside the state at its end.
class PeakValues {
 public:
  /// Takes in the present state. Costs a pass over the nodes: for now and then, not for every step.
  void observe(const View& view);
  /// Takes in the energies alone, in every step: an impact lasts a few.
  void observe(const domain::EnergyLedger& energy);

  /// Declares the peaks so far, for a restart.
  void declare(domain::StateList& list) {
    list.keep("peak_values", "by item", domain::Entity::Run, run_);
    list.keep_list("peak_internal_energy", "energy", domain::Entity::Run, 1, largest_part_internal_);
  }

  double fastest() const { return run_.fastest; }
  /// The fastest that the model says to move or that forces move what they act on, or that the energy
  /// supplied so far makes all of it move.
  double reference_speed() const { return run_.reference_speed; }
  UserId fastest_node() const { return run_.fastest_node; }
  /// The largest size of the energy of the start and the work of loads together, by which the balance is
  /// judged [energy].
  double largest_supplied_energy() const { return run_.largest_supplied; }
  /// By which energies are judged: where bodies rebound little internal energy is left [energy].
  double largest_internal_energy() const { return run_.largest_internal; }
  /// The same of a part.
  double largest_internal_energy(Index part) const { return largest_part_internal_[part]; }
  double largest_absorbed_energy() const { return run_.largest_absorbed; }
  double lowest_contact_energy() const { return run_.lowest_contact; }

 private:
  struct Run {
    double fastest = 0;           ///< largest speed of a node [length/time]
    double reference_speed = 0;   ///< see reference_speed() [length/time]
    double largest_supplied = 0;  ///< see largest_supplied_energy()
    double largest_internal = 0;  ///< [energy]
    double largest_absorbed = 0;  ///< by elements and contact, or taken by damping [energy]
    double lowest_contact = 0;    ///< at most zero [energy]
    UserId fastest_node = 0;
    bool has_reference = false;
  };

  Run run_;
  std::vector<double> largest_part_internal_;  ///< as far as observed, by part [energy]
};

/// |unbalanced energy| over the largest energy that the run has absorbed or damped, but no less than a
/// hundredth of the largest energy around; zero where the balance is kept to round-off [-].
double energy_error(const View& view, const PeakValues& peaks);

/// What of the hourglass energy is strain energy, its stress being that of the material: the checks leave it
/// out [energy].
double material_hourglass_energy(const View& view);

/// The table for the present state, the end of a run, which the peaks have observed.
std::vector<Check> acceptance_checks(const View& view, const PeakValues& peaks);

/// Which shells have a negative Jacobian now, where the deck asks for them with NFAIL1 or NFAIL4: one
/// sentence for each part.
std::vector<std::string> distortion_warnings(const View& view);

/// What the user should know about the energies: one sentence per excess, naming the part or interface.
std::vector<std::string> energy_warnings(const View& view, const PeakValues& peaks);

}  // namespace crumple::output
