// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The state of a run in arrays that the kernels can walk through. The model says what the deck describes, in
// the deck's order; the domain holds what changes, in an order that is good for memory.
//
//     model::Model --> build() --> Domain
//                                  nodes      positions, velocities, masses, forces, one array for each field
//                                  blocks     the elements of a part and shape, in groups of 16 lanes:
//                                             state[group][component][lane]
//                                  assembly   which chunk of elements adds to which node or slot
//                                  reports    energies, contacts, walls, welds, ties, rigid bodies
//
// Numbering: the elements of each part follow the Morton curve of their centroids (G.M. Morton, 1966), nodes
// are numbered as these elements first touch them (numbering.hpp), so that neighbours in space are
// neighbours in memory. model_node and domain_node translate; everything that is printed or written uses the
// ids of the deck.
//
// Assembly: a node whose elements one thread computes gets their forces directly, one after the other. A node
// between threads has a slot for each corner of an element there; gather_interface() sums the slots in the
// same order, so that the sums have the same bits for any number of threads.
//
// State: the owner of an array that changes declares it once to a StateList (state_list.hpp), by name, unit
// and entity. The hash, restart files and StateSnapshot follow from the list.
//
// Order of calls: build() makes numbering, nodes, conditions, blocks and assembly. Ties and
// elements::prepare_elements() then add state, constants and masses; the time loop does the rest
// (timeloop/simulation.hpp).

#include <limits>
#include <vector>

#include "base/isa.hpp"
#include "base/precision.hpp"
#include "domain/assembly.hpp"
#include "domain/beam_block.hpp"
#include "domain/embedding.hpp"
#include "domain/energy_ledger.hpp"
#include "domain/node_fields.hpp"
#include "domain/reports.hpp"
#include "domain/rigid_body.hpp"
#include "domain/shell_block.hpp"
#include "domain/solid_block.hpp"
#include "domain/state_list.hpp"
#include "domain/tie.hpp"
#include "model/model.hpp"

namespace crumple::domain {

/// How the arithmetic is done. Never changes what the deck means.
struct Execution {
  Precision precision = Precision::Double;
  Isa isa = Isa::Baseline;
  int threads = 1;
  Index groups_per_chunk = 0;  ///< see Cut; no result depends on it
};

/// Time and step. Positions are at `time`, velocities half a step earlier.
struct Clock {
  double time = 0;  ///< time n [time]
  long cycle = 0;   ///< steps done
  double step = 0;  ///< from n-1 to n; 0 before the first step [time]
  /// No two nodes moved further relative to each other in that step, but for rounding; infinite if unknown
  /// [length].
  double way = std::numeric_limits<double>::infinity();
  double element_limit = 0;  ///< smallest stable element step at time n, without TSSFAC [time]
  double rigid_limit =
      1e30;              ///< step of the rigid elements where no others set one, else without limit [time]
  double kept_step = 0;  ///< elements get mass where their stable step is below it; 0: none do [time]
  ControllingElement controlling;
};

/// How much of the mass of its nodes is that of a part.
struct PartShare {
  std::vector<Index> nodes;   ///< domain nodes, ascending
  std::vector<double> share;  ///< of the mass of each node at the start [-]
};

/// All that changes during a run, apart from the history that a contact keeps for itself.
struct Domain {
  Execution execution;
  NodeFields nodes;
  std::vector<ShellBlock> shells;
  std::vector<SolidBlock> solids;
  std::vector<BeamBlock> beams;
  std::vector<DiscreteBlock> discretes;
  Assembly assembly;
  AlignedArray<double>
      contact_weight;                ///< of all touches at a node, while contact forces are made; else zero
  AlignedArray<Vec3> contact_force;  ///< on the nodes at time n, normal and friction [force]
  Clock clock;
  EnergyLedger energy;
  double added_mass = 0;               ///< by mass scaling [mass]
  std::vector<PartShare> part_shares;  ///< by part; empty unless a load, a damping or a mass asks for parts
  std::vector<ContactReport> contacts;
  std::vector<TransducerReport> transducers;
  std::vector<WallReport> walls;
  std::vector<ControlVolumeReport> control_volumes;  ///< in the order of the model
  std::vector<WeldReport> welds;
  std::vector<JointReport> joints;
  std::vector<JointStiffnessReport> joint_stiffnesses;
  std::vector<SupportReport> supports;  ///< of the nodes that are held, if output asks for their forces
  std::vector<Tie> ties;                ///< in the order of Model::tied_contacts
  std::vector<Embedding> embeddings;    ///< in the order of Model::embedded_beams
  std::vector<RigidBody> rigid_bodies;  ///< in the order of the model
  std::vector<Index> body_of_node;      ///< rigid body of each node, or no_index; empty without bodies
  StageTimes times;

  /// All blocks, shells, solids, beams, discrete elements: the order that Chunk::block counts in.
  std::vector<ElementBlock*> blocks();
  std::vector<const ElementBlock*> blocks() const;

  /// Declares the nodal fields, the element state, the walls, the rigid bodies and the ledger.
  void declare(StateList& list);
};

/// Number of elements over all blocks of a kind.
template <class Block>
Index element_count(const std::vector<Block>& blocks) {
  Index count = 0;
  for (const Block& block : blocks) count += block.elements;
  return count;
}

}  // namespace crumple::domain
