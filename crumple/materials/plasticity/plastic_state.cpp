// SPDX-License-Identifier: BSD-3-Clause
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {

void declare_plastic_strain(domain::ElementBlock& block) {
  domain::add_item(block, "plastic_strain", "-", block.points);
  domain::add_item(block, "plastic_strain_rest", "-", block.points);
}

}  // namespace crumple::materials
