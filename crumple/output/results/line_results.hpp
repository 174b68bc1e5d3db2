// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "domain/beam_block.hpp"
#include "model/model.hpp"

namespace crumple::output {

/// Places in LineResults::resultants.
enum class Resultant : std::size_t {
  AxialForce,  ///< positive in tension; of springs their force
  ShearS,      ///< force on the second end along s [force]
  ShearT,
  Torsion,       ///< [force * length]; of torsional springs their moment
  FirstMomentS,  ///< on the first end about s [force * length]
  FirstMomentT,
  SecondMomentS,
  SecondMomentT,
  Count,
};

/// What output shows of the beams or discrete elements of one block; zero what a block does not have. The
/// block must outlive this.
class LineResults {
 public:
  LineResults(const model::Model& model, const domain::BeamBlock& block);
  explicit LineResults(const domain::DiscreteBlock& block);

  double resultant(Index place, Resultant which) const;
  /// Effective plastic strain of a truss, of an integrated beam the largest of its points [-].
  double plastic_strain(Index place) const;
  /// Amount of the stress of a truss, of an integrated beam the largest equivalent one of its points
  /// [stress].
  double von_mises(Index place) const;
  /// False once the element has failed.
  bool alive(Index place) const;

 private:
  double discrete_resultant(Index place, Resultant which) const;
  double item(Index place, const domain::StateItem* item, Index which = 0) const;

  const domain::ElementBlock* block_;
  const domain::StateItem* stress_;
  const domain::StateItem* plastic_strain_;
  const domain::StateItem* active_;
  const domain::StateItem* resultant_;  ///< of beams
  const domain::StateItem* length_;     ///< at time zero
  const domain::StateItem* deformation_;
  const domain::StateItem* force_;  ///< of discrete elements
  bool torsional_ = false;
  bool integrated_ = false;
  bool discrete_ = false;
  double area_ = 0;
};

}  // namespace crumple::output
