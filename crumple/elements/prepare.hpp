// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::elements {

class LoneElements;

/// prepare_elements() for the blocks of one kind.
void prepare_shells(const model::Model& model, const LoneElements& lone, domain::Domain& domain);
void prepare_solids(const model::Model& model, const LoneElements& lone, domain::Domain& domain);
void prepare_beams(const model::Model& model, domain::Domain& domain);
/// One block of discrete beams: state, masses. Called by prepare_beams().
void prepare_discrete_beams(const model::Model& model, domain::Domain& domain, domain::BeamBlock& block);
/// After all others: the step of discrete beams depends on the masses of the nodes.
void set_discrete_beam_steps(const model::Model& model, domain::Domain& domain);
/// After all others: the step of springs depends on the masses of the nodes.
void prepare_discretes(const model::Model& model, domain::Domain& domain);

/// Adds the mass of an element of a part to a node, and to the mass of the part there if that is asked for.
void add_mass(domain::Domain& domain, Index part, Index node, double mass);

/// Factor on the mass that DT2MS asks for, given the stable step without it.
double mass_factor(double mass_scaling_step, double step);

/// Whether elements of a block get mass during the run where their step falls (elements/mass_scaling.hpp).
bool scales_mass(const model::Model& model, const domain::Domain& domain, const domain::ElementBlock& block);

/// Throws Error naming the part unless the condition holds.
void require(bool holds, const model::Part& part, const std::string& what);

}  // namespace crumple::elements
