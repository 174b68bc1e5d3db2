// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "domain/domain.hpp"
#include "domain/energy_residual.hpp"
#include "model/model.hpp"

namespace crumple::elements {

/// Finds where the energy balance of elements goes wrong. Their energy comes from stresses and strains, the
/// kinetic energy of the nodes from the forces that follow from these: what elements gain must be what their
/// forces take from the nodes. Per chunk of elements (neighbours of one part, up to
/// lanes * Execution::groups_per_chunk, which must be given)
///
///     residual = gain of internal and hourglass energy + sum over its nodes and steps of
///                (f(n) + f(n+1)) / 2 . (x(n+1) - x(n)) and the same of moments,
///
/// f the chunk's own force on the node. The sum over all chunks is what elements add to the imbalance of the
/// whole model. A pass over the nodes of all elements in every step: for whoever asks for it.
class EnergyTrace {
 public:
  /// `domain` has its assembly.
  explicit EnergyTrace(const domain::Domain& domain);

  /// To be called in every step, the first at time zero, when the elements have put their forces where the
  /// chunks' targets are and before those of different chunks are added up.
  void observe(const domain::Domain& domain);

  /// Residuals of the parts, in the order of the model.
  std::vector<domain::EnergyResidual> parts(const model::Model& model, const domain::Domain& domain) const;
  /// The `count` chunks with the largest residuals, the worst first.
  std::vector<domain::ElementResidual> worst(const model::Model& model, const domain::Domain& domain,
                                             std::size_t count) const;

  /// Declares residuals and the forces of time n, for a restart.
  void declare(domain::StateList& list);

 private:
  struct Entry {
    Index target = no_index;  ///< in NodeFields::force
    Index node = no_index;
  };
  struct Work {
    math::Vec3 force;
    math::Vec3 moment;
  };
  std::vector<Index> first_;      ///< entry of each chunk, and one past the last
  std::vector<Entry> entries_;    ///< targets of each chunk, each once
  std::vector<Work> previous_;    ///< forces of time n - 1, by entry
  std::vector<double> energy_;    ///< of each chunk at time n - 1 [energy]
  std::vector<double> residual_;  ///< by chunk [energy]
};

}  // namespace crumple::elements
