// SPDX-License-Identifier: BSD-3-Clause
#include "output/results/line_results.hpp"

#include <algorithm>
#include <cmath>

#include "output/results/point_results.hpp"

namespace crumple::output {

LineResults::LineResults(const model::Model& model, const domain::BeamBlock& block)
    : block_(&block),
      stress_(block.find("stress")),
      plastic_strain_(block.find("plastic_strain")),
      active_(block.find("active")),
      resultant_(block.find("resultant")),
      length_(block.find("reference_length")),
      deformation_(block.find("deformation")),
      force_(nullptr),
      integrated_(block.formulation == model::BeamFormulation::Integrated),
      discrete_(block.formulation == model::BeamFormulation::Discrete),
      area_(model.beam_sections[model.parts[block.part].beam_section].area) {}

LineResults::LineResults(const domain::DiscreteBlock& block)
    : block_(&block),
      stress_(nullptr),
      plastic_strain_(nullptr),
      active_(nullptr),
      resultant_(nullptr),
      length_(nullptr),
      deformation_(nullptr),
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
  if (stress_ != nullptr && !integrated_)
    return which == Resultant::AxialForce ? area_ * item(place, stress_) : 0.0;
  if (discrete_) return discrete_resultant(place, which);
  // In the state: axial force, torsion, moments about s and t at the first and the second end.
  const auto state = [&](Index i) { return item(place, resultant_, i); };
  // The law of integrated beams has the present length.
  const double length = item(place, length_) + (integrated_ ? item(place, deformation_) : 0.0);
  switch (which) {
    case Resultant::AxialForce:
      return state(0);
    case Resultant::ShearS:
      return -(state(3) + state(5)) / length;
    case Resultant::ShearT:
      return (state(2) + state(4)) / length;
    case Resultant::Torsion:
      return state(1);
    default:
      return state(static_cast<Index>(which) - static_cast<Index>(Resultant::FirstMomentS) + 2);
  }
}

double LineResults::discrete_resultant(Index place, Resultant which) const {
  // In the state: forces along r, s, t, moments about them; the same moment acts on both ends.
  const auto state = [&](Index i) { return item(place, resultant_, i); };
  switch (which) {
    case Resultant::AxialForce:
      return state(0);
    case Resultant::ShearS:
      return state(1);
    case Resultant::ShearT:
      return state(2);
    case Resultant::Torsion:
      return state(3);
    case Resultant::FirstMomentS:
      return -state(4);
    case Resultant::FirstMomentT:
      return -state(5);
    default:
      return state(which == Resultant::SecondMomentS ? 4 : 5);
  }
}

double LineResults::plastic_strain(Index place) const {
  double largest = 0;
  for (Index point = 0; plastic_strain_ != nullptr && point < plastic_strain_->count; ++point)
    largest = std::max(largest, item(place, plastic_strain_, point));
  return largest;
}

double LineResults::von_mises(Index place) const {
  if (!integrated_) return std::fabs(item(place, stress_));
  double largest = 0;
  for (Index point = 0; point < block_->points; ++point) {
    const auto [axial, along_s, along_t] = stress_of<section_stresses>(*block_, place, point);
    largest = std::max(largest, axial * axial + 3 * (along_s * along_s + along_t * along_t));
  }
  return std::sqrt(largest);
}

bool LineResults::alive(Index place) const {
  return active_ == nullptr || item(place, active_) != 0;
}

}  // namespace crumple::output
