// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/tied_contact.hpp"

namespace crumple::contact {

/// Stiffnesses of a tie per area, before damage [stress/length].
struct CohesiveStiffness {
  double normal = 0;
  double shear = 0;
};

/// Traction over separation of a tie that softens: linear up to the strength, from there falling linearly to
/// zero. With the opening d_n and the sliding d_s the mode is given by the ray to (max(d_n, 0), d_s); on a
/// ray
///
///     onset   d_0:  (K_n d_n / S_n)^2 + (K_s d_s / S_s)^2 = 1
///     failure d_f:  the area below the traction is the energy that the criterion of mixed modes gives
///     damage   D = d_f (d - d_0) / (d (d_f - d_0)), which never falls; traction (1 - D) K d
///
/// P.P. Camanho, C.G. Davila & M.F. de Moura, Journal of Composite Materials 37 (2003) 1415-1438; as
/// *MAT_COHESIVE_MIXED_MODE of LS-DYNA's Keyword User's Manual, Volume II. docs/theory/cohesive_ties.md.
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
  /// (K_n d_n / S_n)^2 + (K_s d_s / S_s)^2 of the squares of the two distances; above 1 there is damage.
  double used(double across, double along, const CohesiveStiffness& stiffness) const;

  model::TieFailure failure_;
  model::TieSoftening softening_;
};

}  // namespace crumple::contact
