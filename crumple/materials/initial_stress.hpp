// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "domain/element_block.hpp"
#include "model/material.hpp"

namespace crumple::materials {

/// What a point begins with. Tensors are as the block keeps them: of shells xx, yy, xy, yz, zx in lamina
/// axes, of solids six components in global axes.
struct PointStart {
  std::span<const double> stress;
  double plastic_strain = 0;                 ///< effective [-]; laws without one leave it
  std::span<const double> back_stress = {};  ///< centre of the yield surface; laws without one leave it
};

/// Sets stress and plastic strain of a point of an element at time zero, and what the law keeps beside them
/// that belongs to the stress. The law is one that model::refusal_of_initial_stress() admits; `history` is
/// its first item.
void set_initial_stress(const model::ConstitutiveLaw& law, const PointStart& start,
                        domain::ElementBlock& block, Index history, Index element, Index point);

}  // namespace crumple::materials
