// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/element_block.hpp"
#include "domain/node_fields.hpp"

namespace crumple::elements {

struct DamageGrowth;
struct ErosionCheck;
struct ShortSteps;
struct StiffnessDamping;

/// One chunk of one block, but for what is different for shells and solids.
template <class Real>
struct ElementTask {
  const domain::NodeRecord<Real>* nodes = nullptr;
  domain::NodeForce* force = nullptr;
  const Index* node = nullptr;    ///< of the first group
  const Index* target = nullptr;  ///< of the first group
  Real* state = nullptr;          ///< of the first group
  Index components = 0;
  Index groups = 0;
  domain::GroupEnergy* energy = nullptr;  ///< of the first group
  double* group_step = nullptr;           ///< of the first group, where mass is scaled; else nullptr
  Real step = 0;                          ///< from n-1 to n [time]
  bool from_memory = false;  ///< the model is larger than the caches: ask for everything a tile ahead
  const double* material_constants = nullptr;
  const ErosionCheck* erosion = nullptr;      ///< what makes points fail whatever their law; nullptr: nothing
  const DamageGrowth* damage = nullptr;       ///< what lowers the stresses of points; nullptr: nothing
  const ShortSteps* short_steps = nullptr;    ///< which steps make elements go; nullptr: none
  const StiffnessDamping* damping = nullptr;  ///< nullptr: none
};

}  // namespace crumple::elements
