// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/index.hpp"
#include "model/contact.hpp"

namespace crumple::model {

/// How the nodes of the first side are held on the segments of the second.
enum class TieMethod {
  Constraint,  ///< they are moved onto their segment and follow its nodes exactly
  Offset,      ///< gaps stay; they follow as far as nothing else holds them or their segment, else springs
  Penalty,     ///< springs hold them where they are, gaps stay (TIEBREAK in LS-DYNA)
};

/// When the tie of a node breaks: (N/S_n)^n + (S/S_s)^s reaches 1 with the tension N and the shear S on the
/// node; pressure does not count. A strength of zero leaves its part out.
struct TieFailure {
  double normal_strength = 0;  ///< S_n: NFLS or NFLF [stress or force]
  double shear_strength = 0;   ///< S_s: SFLS or SFLF [stress or force]
  double normal_exponent = 2;  ///< [-]
  double shear_exponent = 2;   ///< [-]
  bool by_stress = true;       ///< N and S are over the area of the node, else forces
};

/// How a tie lets go once it has reached its strength: instead of breaking at once it is damaged, and does
/// work. Damage does not heal, and pressure is borne as before (docs/theory/cohesive_ties.md).
struct TieSoftening {
  enum class Law {
    PowerLaw,          ///< mixed modes by (G_I/G_Ic)^exponent + (G_II/G_IIc)^exponent = 1
    BenzeggaghKenane,  ///< mixed modes by G = G_Ic + (G_IIc - G_Ic) (G_II/G)^exponent
    CriticalOpening,   ///< the stress falls evenly to zero at a distance, whatever the mode
  };
  Law law = Law::PowerLaw;
  double normal_energy = 0;     ///< G_Ic: ERATEN, of the first two laws [energy/area]
  double shear_energy = 0;      ///< G_IIc: ERATES, likewise [energy/area]
  double exponent = 1;          ///< likewise, above zero [-]
  double critical_opening = 0;  ///< CCRIT of the third law [length]
  double shear_ratio = 1;       ///< CT2CN: stiffness in shear over that in tension [-]
  double stiffness = 0;         ///< CN [stress/length]; 0: that of ties
};

/// Nodes of the first side are joined to segments of the second (*CONTACT_TIED, *CONTACT_TIEBREAK): those
/// that are near enough at time zero.
struct TiedContact {
  UserId id = 0;
  std::string title;
  TieMethod method = TieMethod::Constraint;
  bool ties_rotations = false;  ///< of shells, too (SHELL_EDGE)
  bool turns_on_faces = false;  ///< with ties_rotations: on faces of solids, too (SHELL_EDGE_TO_SOLID)
  std::array<ContactSide, 2> side;
  double tolerance = 0;  ///< distance up to which a node is tied [length]; 0: by thickness and segment
  std::optional<TieFailure> failure;
  std::optional<TieSoftening> softening{};  ///< with failure by stress alone; absent: ties break at once
  double death_time = 1e20;                 ///< DT: the tie ends [time]
};

}  // namespace crumple::model
