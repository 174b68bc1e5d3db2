// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/mixed_mode.hpp"
#include "model/tied_contact.hpp"

namespace crumple::contact {

/// Stiffnesses of a tie per area, before damage [stress/length].
struct CohesiveStiffness {
  double normal = 0;
  double shear = 0;
};

/// Traction over separation of a tie that softens, in any mode: the law of materials/common/mixed_mode.hpp
/// with the strengths and energies of a contact. docs/theory/cohesive_ties.md.
class CohesiveLaw {
 public:
  CohesiveLaw(const model::TieFailure& failure, const model::TieSoftening& softening)
      : failure_(failure), softening_(softening) {}

  /// Where damage begins and where it is complete on a ray, from the place of time zero [length].
  struct Range {
    double onset = 0;
    double failure = 0;
  };
  /// `opening` and `sliding` give the direction of the ray, not both zero; an opening below zero counts as
  /// zero. The largest number stands for an onset that never comes.
  Range range(double opening, double sliding, const CohesiveStiffness& stiffness) const;

  /// Damage at an opening and sliding [length], where it has been `before`; 1 is broken.
  double damage(double opening, double sliding, const CohesiveStiffness& stiffness, double before) const;

  /// The mode, tension, shear or a mixture (rays a degree apart), in which ties would store more up to their
  /// strength than they may take in all, so that they could not soften; empty if there is none.
  const char* brittle_mode(const CohesiveStiffness& stiffness) const;

 private:
  materials::MixedMode<double> numbers(const CohesiveStiffness& stiffness) const;

  model::TieFailure failure_;
  model::TieSoftening softening_;
};

}  // namespace crumple::contact
