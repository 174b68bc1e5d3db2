// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::model {

/// Tractions over the separation of the two faces of a cohesive solid: linear up to the strength, from there
/// falling linearly to zero, in any mixture of opening and sliding (*MAT_COHESIVE_MIXED_MODE), or to zero at
/// once (*MAT_COHESIVE_ELASTIC). docs/theory/cohesive_solids.md.
struct Cohesive {
  enum class Failure {
    PowerLaw,          ///< mixed modes by (G_I/G_Ic)^exponent + (G_II/G_IIc)^exponent = 1
    BenzeggaghKenane,  ///< mixed modes by G = G_Ic + (G_IIc - G_Ic) (G_II/G)^exponent
    Brittle,           ///< no energy: gone where one of the strengths is reached
  };

  double youngs_modulus = 0;   ///< EN, of the normal traction over the opening [stress/length]
  double poissons_ratio = 0;   ///< not used
  double shear_stiffness = 0;  ///< ET, of the tangential traction over the sliding [stress/length]
  Failure failure = Failure::PowerLaw;
  double normal_strength = 0;     ///< T [stress]; of brittle failure 0 is none
  double shear_strength = 0;      ///< S [stress]; likewise
  double normal_energy = 0;       ///< G_Ic, not of brittle failure [energy/area]
  double shear_energy = 0;        ///< G_IIc, likewise [energy/area]
  double exponent = 1;            ///< of the criterion of mixed modes, above zero [-]
  double stiffness_exponent = 1;  ///< GAMMA of Benzeggagh & Kenane [-]
  bool mass_by_area = false;      ///< the density is per area of the middle surface, else per volume
  int failed_points = 0;          ///< INTFAIL: the element goes when so many points have failed; 0: it stays
  bool at_corners = false;        ///< the points are at the corners (Newton & Cotes), else those of Gauss
};

}  // namespace crumple::model
