// SPDX-License-Identifier: BSD-3-Clause
#include "output/results/line_results.hpp"

#include <cmath>

namespace crumple::output {

LineResults::LineResults(const model::Model& model, const domain::BeamBlock& block)
    : block_(&block),
      stress_(block.find("stress")),
      plastic_strain_(block.find("plastic_strain")),
      active_(block.find("active")),
      resultant_(block.find("resultant")),
      length_(block.find("reference_length")),
      force_(nullptr),
      area_(model.beam_sections[model.parts[block.part].beam_section].area) {}

LineResults::LineResults(const domain::DiscreteBlock& block)
    : block_(&block),
      stress_(nullptr),
      plastic_strain_(nullptr),
      active_(nullptr),
      resultant_(nullptr),
      length_(nullptr),
      force_(block.find("force")),
      torsional_(block.torsional) {}

double LineResults::item(Index place, const domain::StateItem* item, Index which) const {
  return item == nullptr ? 0.0 : block_->state(place, item->first + which);
}

double LineResults::resultant(Index place, Resultant which) const {
  if (force_ != nullptr) {
    const Resultant its = torsional_ ? Resultant::Torsion : Resultant::AxialForce;
    return which == its ? item(place, force_) : 0.0;
  }
  if (stress_ != nullptr) return which == Resultant::AxialForce ? area_ * item(place, stress_) : 0.0;
  // In the state: axial force, torsion, moments about s and t at the first and the second end.
  const auto state = [&](Index i) { return item(place, resultant_, i); };
  switch (which) {
    case Resultant::AxialForce:
      return state(0);
    case Resultant::ShearS:
      return -(state(3) + state(5)) / item(place, length_);
    case Resultant::ShearT:
      return (state(2) + state(4)) / item(place, length_);
    case Resultant::Torsion:
      return state(1);
    default:
      return state(static_cast<Index>(which) - static_cast<Index>(Resultant::FirstMomentS) + 2);
  }
}

double LineResults::plastic_strain(Index place) const {
  return item(place, plastic_strain_);
}

double LineResults::von_mises(Index place) const {
  return std::fabs(item(place, stress_));
}

bool LineResults::alive(Index place) const {
  return active_ == nullptr || item(place, active_) != 0;
}

}  // namespace crumple::output
