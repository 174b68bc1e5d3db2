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
  Penalty,     ///< springs hold them where they are, gaps stay (OFFSET and TIEBREAK in LS-DYNA)
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

/// Nodes of the first side are joined to segments of the second (*CONTACT_TIED, *CONTACT_TIEBREAK): those
/// that are near enough at time zero.
struct TiedContact {
  UserId id = 0;
  std::string title;
  TieMethod method = TieMethod::Constraint;
  bool ties_rotations = false;  ///< of shells, too (SHELL_EDGE)
  std::array<ContactSide, 2> side;
  double tolerance = 0;  ///< distance up to which a node is tied [length]; 0: by thickness and segment
  std::optional<TieFailure> failure;
  double death_time = 1e20;  ///< DT: the tie ends [time]
};

}  // namespace crumple::model
