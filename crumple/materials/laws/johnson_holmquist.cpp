// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/johnson_holmquist.hpp"

#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {

void declare_brittle_history(domain::ElementBlock& block, const char* memory, bool fails) {
  declare_volume(block);
  declare_plastic_strain(block);
  domain::add_item(block, "damage", "-", block.points);
  domain::add_item(block, memory, "-", block.points);
  if (fails) domain::add_item(block, "failed", "-", block.points);
}

bool erodes(const model::BrittleErosion& erosion) {
  return erosion.at_tension || erosion.plastic_strain > 0;
}

}  // namespace crumple::materials
