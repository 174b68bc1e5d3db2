// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/aligned_array.hpp"
#include "base/index.hpp"
#include "base/lanes.hpp"
#include "base/precision.hpp"
#include "model/damage.hpp"
#include "model/erosion.hpp"

namespace crumple::domain {

/// One named item of an element's state: `count` numbers that start at component `first` of the state array.
struct StateItem {
  std::string name;  ///< as output, restart and tests know it: "stress", "plastic_strain", "thickness"
  std::string unit;  ///< dimension, in words: "stress", "-", "length"
  Index first = 0;
  Index count = 0;
  // Of an item that only some layers of a shell have; 0 layers: it is not divided by layers.
  Index first_layer = 0;
  Index layers = 0;
  Index all_layers = 0;  ///< of the shell

  /// Which of the item's points a point of the element is; no_index if the item has none for it.
  Index point_of(Index point) const {
    if (layers == 0) return point;
    const Index layer = point % all_layers - first_layer;
    return layer < 0 || layer >= layers ? no_index : point / all_layers * layers + layer;
  }
};

/// Of an element whose mass may grow with its stable step.
struct ScaledMass {
  double mass = 0;     ///< of all its nodes together, scaled [mass]
  double inertia = 0;  ///< rotary, likewise [mass * length^2]
};

/// What the elements of one group have got since the start, in double [energy]. They are neighbours wherever
/// a block is cut, so that sums over groups do not depend on threads.
struct GroupEnergy {
  double internal = 0;
  double hourglass = 0;
  double damping = 0;  ///< taken by damping in proportion to stiffness
  double eroded = 0;  ///< internal and hourglass energy of elements that have failed, no longer in the others
};

/// What blocks of all kinds of elements have. Elements are held in groups of `lanes`; the last group is
/// filled with copies of the last element whose `active` state is zero and whose forces go to a slot nobody
/// reads.
struct ElementBlock {
  Index part = no_index;       ///< model::Part
  Index corners = 4;           ///< nodes of an element
  Index points = 1;            ///< integration points of an element
  Index elements = 0;          ///< real elements, without the fill
  std::vector<Index> element;  ///< index in the model's elements of this kind, by place in the block
  AlignedArray<Index> node;    ///< [group][corner][lanes] domain nodes to gather from
  AlignedArray<Index> target;  ///< [group][corner][lanes] place in NodeFields::force to add to (see Assembly)
  std::vector<StateItem> items;            ///< what the state holds
  Index components = 0;                    ///< numbers per element in the state
  AlignedArray<float> float_state;         ///< [group][component][lanes] in mixed precision, else empty
  AlignedArray<double> double_state;       ///< the same in double precision, else empty
  std::vector<double> element_constants;   ///< laid out and read by the element kind
  std::vector<double> material_constants;  ///< laid out and read by the material kind
  std::vector<GroupEnergy> energy;         ///< by group
  // Sums over the groups [energy].
  double internal_energy = 0;
  double hourglass_energy = 0;
  double damping_energy = 0;
  double eroded_energy = 0;
  Index eroded = 0;                               ///< elements that have failed
  std::optional<model::ErosionCriteria> erosion;  ///< its item "erosion" is [point][failed, strain, impulse]
  std::optional<model::GissmoDamage> damage;      ///< its items: elements/common/damage_growth.hpp
  double least_step = 0;  ///< elements go whose own stable step is shorter [time]; 0: none
  /// By place in the block, where mass is scaled during the run (elements/mass_scaling.hpp), else empty.
  std::vector<ScaledMass> scaled;
  /// By group, where mass is scaled during the run, else empty: shortest stable step of its elements,
  /// negative where some have just failed [time].
  std::vector<double> group_step;
  bool rigid = false;             ///< its elements have mass and a surface, but no forces
  bool corner_by_corner = false;  ///< the forces of a group go to the nodes so, else element by element

  Index groups() const { return (elements + lanes - 1) / lanes; }

  /// The item of that name, or nullptr.
  const StateItem* find(const std::string& name) const;

  /// Place in the state array of component `component` of element `place`.
  std::size_t offset(Index place, Index component) const {
    return (static_cast<std::size_t>(place / lanes) * components + component) * lanes + place % lanes;
  }
  /// One number of the state, whatever the precision.
  double state(Index place, Index component) const {
    const std::size_t at = offset(place, component);
    return float_state.empty() ? double_state[at] : static_cast<double>(float_state[at]);
  }
  void set_state(Index place, Index component, double value) {
    const std::size_t at = offset(place, component);
    if (float_state.empty())
      double_state[at] = value;
    else
      float_state[at] = static_cast<float>(value);
  }
  /// Makes room for the state and the energies of all groups, all zero.
  void allocate(Precision precision);
  /// Adds to the internal energy of element `place`.
  void add_internal_energy(Index place, double amount) {
    energy[static_cast<std::size_t>(place / lanes)].internal += amount;
    internal_energy += amount;
  }
  /// Domain node `corner` of element `place`.
  Index node_of(Index place, Index corner) const {
    return node[(static_cast<std::size_t>(place / lanes) * corners + corner) * lanes + place % lanes];
  }
};

template <class Real>
AlignedArray<Real>& state_of(ElementBlock& block);
template <>
inline AlignedArray<float>& state_of<float>(ElementBlock& block) {
  return block.float_state;
}
template <>
inline AlignedArray<double>& state_of<double>(ElementBlock& block) {
  return block.double_state;
}

/// Adds an item of `count` numbers to the layout of a block under construction; returns its first component.
Index add_item(ElementBlock& block, const std::string& name, const std::string& unit, Index count);

}  // namespace crumple::domain
