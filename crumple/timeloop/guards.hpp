// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::timeloop {

/// Kinetic energies of time n that only a run that has lost its stability has.
struct KineticRange {
  double least = 0;  ///< [energy]
  double most = 0;   ///< [energy]
};

/// The range that the energies of `domain` allow with steps of `step_scale` times the stable one:
/// docs/theory/energy.md.
KineticRange plausible_kinetic_energy(const domain::Domain& domain, double step_scale);

/// Upper bound of the strain energy that stresses at time zero have stored, which the energy ledger does not
/// count: the largest density of any element over the volume of all mass at the lowest density [energy]. A
/// body that springs back has nothing else. Zero without such stresses.
double initial_stress_energy(const model::Model& model, const domain::Domain& domain);

/// Throws a NumericalError if the energy is no number, or the kinetic energy out of that range; `stored` is
/// what initial_stress_energy() gives [energy].
void guard_kinetic_energy(const model::Model& model, const domain::Domain& domain, double stored);

/// Throws a NumericalError that names the contact, a node and a segment, if a contact has given much more
/// energy than it has taken.
void guard_contact_energy(const domain::Domain& domain);

}  // namespace crumple::timeloop
