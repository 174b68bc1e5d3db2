// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/index.hpp"
#include "model/model.hpp"

namespace crumple::domain {

/// Places of a model's items in the domain, chosen so that neighbours in space are neighbours in memory.
struct Numbering {
  std::vector<std::vector<Index>> shells_by_part;  ///< model shell indices along a space-filling curve
  std::vector<std::vector<Index>> solids_by_part;  ///< the same of the solids
  std::vector<std::vector<Index>> beams_by_part;
  std::vector<std::vector<Index>> discretes_by_part;
  std::vector<Index> model_node;   ///< model index of a domain node
  std::vector<Index> domain_node;  ///< domain index of a model node
};

/// Orders the elements of each part along the Morton curve of their centroids (G.M. Morton, 1966) and the
/// nodes as these elements first touch them, shells before solids; nodes without elements come last. O(N log
/// N).
Numbering number_for_locality(const model::Model& model);

}  // namespace crumple::domain
