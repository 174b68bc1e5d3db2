// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::elements {

class EnergyTrace;

/// Gives every block its state, constants and kernels, and adds the mass and rotary inertia of the elements
/// to the nodes, with the mass that DT2MS asks for. Throws Error for a formulation, material or integration
/// rule that no kind in the registry computes, naming the part.
void prepare_elements(const model::Model& model, domain::Domain& domain);

/// Brings the elements from time n-1 to n: on entry the node records hold x(n) and v(n-1/2), `clock.step` is
/// the step between (zero before the first step: forces of the present stress, no strain). On exit the state
/// is that of time n, the nodal forces are added to nodes.force (interface slots gathered), the blocks'
/// energies are summed and clock.element_limit is the smallest stable step. Bitwise the same for any number
/// of threads. `trace`, if there is one, looks on.
void add_element_forces(domain::Domain& domain, EnergyTrace* trace = nullptr);

/// The element whose stable step is the smallest at time n.
domain::ControllingElement controlling_element(const model::Model& model, const domain::Domain& domain);

/// Smallest stable step of a block's elements at the current geometry, at rest and without TSSFAC [time].
double stable_step(const domain::Domain& domain, const domain::ShellBlock& block);
double stable_step(const domain::Domain& domain, const domain::SolidBlock& block);
double stable_step(const domain::Domain& domain, const domain::BeamBlock& block);
double stable_step(const domain::Domain& domain, const domain::DiscreteBlock& block);

/// Present volume of a solid as its forces see it; not above zero if it has turned inside out [length^3].
double solid_volume(const domain::Domain& domain, const domain::SolidBlock& block, Index place);

}  // namespace crumple::elements
