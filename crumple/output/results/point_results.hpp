// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "domain/element_block.hpp"
#include "model/model.hpp"

namespace crumple::output {

/// Effective plastic strain of a point [-]; zero of a law without. Layers of a shell have an item each.
inline double plastic_strain_of(const domain::ElementBlock& block, Index place, Index point) {
  for (const domain::StateItem& item : block.items) {
    if (item.name != "plastic_strain") continue;
    const Index at = item.point_of(point);
    if (at != no_index && at < item.count) return block.state(place, item.first + at);
  }
  return 0;
}

/// Items that hold a damage from 0 to 1 (of concrete of three surfaces to 2), of a law or added to it.
inline constexpr const char* damage_items[] = {"gissmo_damage", "damage", "cohesive_damage", "brittle_damage",
                                               "ductile_damage"};

inline bool has_damage(const domain::ElementBlock& block) {
  return std::ranges::any_of(damage_items, [&](const char* name) { return block.find(name) != nullptr; });
}

/// Largest damage of all points of an element [-]; zero of a material without.
inline double damage_of(const domain::ElementBlock& block, Index place) {
  double largest = 0;
  for (const char* const name : damage_items)
    if (const domain::StateItem* const item = block.find(name))
      for (Index i = 0; i < item->count; ++i)
        largest = std::max(largest, block.state(place, item->first + i));
  return largest;
}

/// The components of a point as they are kept [stress]; zero where none are.
template <std::size_t Count>
std::array<double, Count> stress_of(const domain::ElementBlock& block, Index place, Index point) {
  std::array<double, Count> stress{};
  if (const domain::StateItem* const item = block.find("stress"))
    for (std::size_t c = 0; c < Count; ++c)
      stress[c] = block.state(place, item->first + point * static_cast<Index>(Count) + static_cast<Index>(c));
  return stress;
}

/// Stresses of a point of an integrated beam: along it, and the shears with s and t.
inline constexpr std::size_t section_stresses = 3;

/// How binout calls the states of elout, and which is which, counted from one.
inline constexpr const char* stress_states = "elastic,plastic";
constexpr double stress_state_of(double plastic_strain) {
  return plastic_strain > 0 ? 2 : 1;
}

/// The word of the text file for it.
constexpr const char* stress_state_name(double state) {
  return state > 1 ? "plastic" : "elastic";
}

/// What LS-DYNA calls the material of an element: its part's id.
template <class Element>
double part_id_of(const model::Model& model, const Element& element) {
  return static_cast<double>(model.parts[element.part].id);
}

}  // namespace crumple::output
