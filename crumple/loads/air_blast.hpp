// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pressures of air blasts on segments. Per segment and time: the distance of its centre from the charge and
// the angle of its normal, both at the present positions; the wave at that distance, from a table of the fits
// (kingery_bulmash.hpp); the pressure of its two pulses at the present time. Nothing but the forces of the
// last time, for their work, and the centre of a charge that a node carries is remembered. Theory page:
// docs/theory/air_blast.md.

#include <vector>

#include "domain/domain.hpp"
#include "loads/segment_pressure.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// The wave of a charge at one distance, in the model's units.
struct BlastWave {
  double arrival = 0;             ///< since the detonation [time]
  double duration = 0;            ///< of the positive phase [time]
  double incident_pressure = 0;   ///< peak [stress]
  double reflected_pressure = 0;  ///< peak on a segment that faces the charge [stress]
  double incident_decay = 0;      ///< of Friedlander's pulse [-]
  double reflected_decay = 0;     ///< likewise [-]
};

/// The waves of a charge by distance: straight between 4096 equal steps of the logarithm of the distance over
/// the range of the fits, within 2e-5 of them but for the steps where pieces of fits meet.
class BlastTable {
 public:
  explicit BlastTable(const model::AirBlast& blast);
  /// At a distance [length]; beyond the ends of the range that at the nearest end.
  BlastWave at(double distance) const;

 private:
  double least_ = 0;    ///< binary logarithm of the smallest distance
  double per_log_ = 0;  ///< steps per unit of it
  std::vector<BlastWave> waves_;
};

/// Pressure above that of the air on a segment at a time since the detonation, `cosine` being that of the
/// angle between its normal and the way to the charge: with Friedlander's pulses p_r(t) and p_i(t)
/// p_r cos^2 + p_i (1 + cos^2 - 2 cos) towards the charge, p_i away from it. The negative phase ends with
/// `vacuum`, the pressure of the air, or is left out. [stress]
double blast_pressure(const BlastWave& wave, double time, double cosine, bool negative_phase, double vacuum);

/// The pressures of all charges of a model. They push against the normals of the segments; the load on a
/// shell ends when that erodes.
class AirBlasts {
 public:
  /// The model must outlive the loads.
  AirBlasts(const model::Model& model, const domain::Domain& domain);

  /// Adds the forces at time n and, by the trapezoidal rule, their work since time n-1 to the ledger's
  /// external work. On entry nodes.velocity is v(n-1/2) and clock.step the step between.
  void add_forces(domain::Domain& domain);

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  struct Charge {
    BlastTable table;
    math::Vec3 centre;
    Index node = no_index;  ///< of the domain; the centre until the detonation
    double detonation = 0;
    double death = 0;
    double vacuum = 0;  ///< pressure of the air [stress]
    bool negative_phase = true;
    bool detonated = false;  ///< the centre stays where it is
  };
  struct Load {
    SegmentNodes node{};
    std::size_t charge = 0;
    double scale = 1;
    Index shell = no_index;  ///< in the model
    bool ended = false;      ///< its shell has eroded
    math::Vec3 previous{};   ///< force on each node at time n-1
  };
  static Charge charge_of(const model::AirBlast& blast, const domain::Domain& domain);
  void move_charges(const domain::Domain& domain);
  math::Vec3 force_on_nodes(const domain::Domain& domain, const Load& load) const;

  const model::Model* model_;
  std::vector<Charge> charges_;
  std::vector<Load> loads_;
  ErodedShells eroded_;  ///< when `ended` was set
};

}  // namespace crumple::loads
