// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The elements: from the motion of the nodes to the forces of the stresses. Shells, solids, beams and
// discrete elements live in blocks, one formulation and one material each (domain/element_block.hpp); a block
// is computed in chunks, each by one thread, and a chunk of shells or solids tile by tile
// (shell/chunk.hpp, solid/solid_chunk.hpp):
//
//     gather      positions and velocities of the nodes, from their records
//     strains()   strain increments of all points, at the geometry in the middle of the step
//     material    stresses of time n (materials/list.hpp)
//     forces()    nodal forces at the geometry of time n, hourglass forces, energies, stable step
//     scatter     onto the nodes that only this thread has, else into slots of its own
//     erode       elements of which all points have failed
//
// Strains at the middle of the step are the method of T.J.R. Hughes & J. Winget, IJNME 15 (1980) 1862-1867: a
// rotation makes no strain. Forces are the transpose of the strains, so that momentum and energy balance to
// round-off. Slots are summed in the order of the elements, and energies in that of the groups: bitwise the
// same for any number of threads (domain/assembly.hpp).
//
// Order of calls: prepare_elements() once; in every step add_element_forces(), which does
//
//     average_dilatations()          tetrahedra with nodal pressure only
//     the kernel of each chunk       in parallel
//     gather_interface()             slots to nodes
//     sums over the groups           energies, eroded elements, smallest stable step
//
// Rooms: shell/ and solid/ have a file per formulation, with its source in docs/theory, a list of all of them
// (shell/list.hpp, solid/solid_list.hpp) and what a formulation must have (shell/formulation.hpp,
// solid/solid_formulation.hpp); line/ has beams, trusses and springs; common/ what they share. registry.cpp
// finds the formulation of a deck's ELFORM in the lists; kernels/ compiles each one once per instruction set.
// How to add one: docs/adding_an_element.md.

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
