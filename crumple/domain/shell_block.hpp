// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/aligned_array.hpp"
#include "base/index.hpp"
#include "base/pack.hpp"
#include "base/precision.hpp"
#include "model/section.hpp"

namespace crumple::domain {

/// One named item of an element's state: `count` numbers that start at component `first` of the state array.
struct StateItem {
  std::string name;  ///< as output, restart and tests know it: "stress", "plastic_strain", "thickness"
  std::string unit;  ///< dimension, in words: "stress", "-", "length"
  Index first = 0;
  Index count = 0;
};

/// The quadrilaterals or the triangles of one part: one formulation, material and integration rule, so that a
/// kernel meets no choice inside. A triangle's fourth node repeats its third. Elements are held in groups of
/// `lanes`; the last group is filled with copies of the last element whose `active` state is zero and whose
/// forces go to a slot nobody reads.
struct ShellBlock {
  Index part = no_index;  ///< model::Part
  model::ShellFormulation formulation = model::ShellFormulation::BelytschkoTsay;
  Index thickness_points = 0;    ///< integration points through the thickness
  Index plane_points = 1;        ///< in plane; over each of them are thickness_points
  Index elements = 0;            ///< real elements, without the fill
  std::vector<Index> element;    ///< model::Model::shells index, by place in the block
  AlignedArray<Index> node;      ///< [group][4][lanes] domain nodes to gather from
  AlignedArray<Index> target;    ///< [group][4][lanes] place in NodeFields::force to add to (see Assembly)
  std::vector<StateItem> items;  ///< what the state holds; stress is [plane][thickness][xx, yy, xy, yz, zx]
  Index components = 0;          ///< numbers per element in the state
  AlignedArray<float> float_state;         ///< [group][component][lanes] in mixed precision, else empty
  AlignedArray<double> double_state;       ///< the same in double precision, else empty
  std::vector<double> element_constants;   ///< laid out and read by the element kind
  std::vector<double> material_constants;  ///< laid out and read by the material kind
  double internal_energy = 0;              ///< accumulated, of the whole block [energy]
  double hourglass_energy = 0;             ///< accumulated, of the whole block [energy]
  double eroded_energy = 0;                ///< part of both that elements had when they failed [energy]
  Index eroded = 0;                        ///< elements that have failed

  /// Integration points of an element.
  Index points() const { return plane_points * thickness_points; }
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
  /// The domain nodes of element `place`.
  std::array<Index, 4> nodes_of(Index place) const;
};

template <class Real>
AlignedArray<Real>& state_of(ShellBlock& block);
template <>
inline AlignedArray<float>& state_of<float>(ShellBlock& block) {
  return block.float_state;
}
template <>
inline AlignedArray<double>& state_of<double>(ShellBlock& block) {
  return block.double_state;
}

/// Adds an item of `count` numbers to the layout of a block under construction; returns its first component.
Index add_item(ShellBlock& block, const std::string& name, const std::string& unit, Index count);

}  // namespace crumple::domain
