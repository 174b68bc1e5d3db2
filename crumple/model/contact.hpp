// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/index.hpp"

namespace crumple::model {

/// One side of a contact. All shells and all outer faces of the solids of the parts take part, and what is
/// named one by one.
struct ContactSide {
  std::vector<Index> parts;   ///< ascending
  std::vector<Index> shells;  ///< in Model::shells, ascending
  std::vector<std::array<Index, 4>>
      segments;                ///< each is a shell or a face of a solid, in any order of nodes
  std::vector<Index> nodes;    ///< nodes that touch without being part of a segment, ascending
  double stiffness_scale = 1;  ///< SFS or SFM: factor on the penalty stiffness [-]
  double thickness_scale = 1;  ///< SFST or SFMT: factor on the true thickness of shells [-]
  double contact_thickness =
      0;  ///< SST or MST: thickness of shells instead of the true one [length]; 0 is none

  bool node_forces = false;  ///< SPR or MPR: LS-DYNA's files show the forces on its nodes

  bool empty() const { return parts.empty() && shells.empty() && segments.empty() && nodes.empty(); }
};

/// Which nodes may touch which segments.
enum class ContactKind {
  SingleSurface,     ///< all nodes of the first side all its segments; there is no second side
  SurfaceToSurface,  ///< nodes of each side the segments of the other
  NodesToSurface,    ///< nodes of the first side the segments of the second
};

/// How nodes are kept out of segments.
enum class Enforcement {
  Penalty,      ///< by forces that grow with the penetration
  Multipliers,  ///< by the forces that leave no penetration at the end of the step, and no slip where it
                ///< sticks
};

/// Which edges of shells touch each other and the beams of the contact, besides what the kind says.
enum class ContactEdges {
  None,  ///< no edges, no beams
  Free,  ///< those where the surface ends
  All,   ///< folds inside of the surface as well
};

/// Coulomb friction with a coefficient that falls with the speed v of sliding: mu = FD + (FS - FD) exp(-DC
/// v).
struct Friction {
  double at_rest = 0;       ///< FS [-]
  double when_sliding = 0;  ///< FD [-]
  double decay = 0;         ///< DC [time/length]
  double stress = 0;        ///< VC VSF: friction over the segment's area stays below it [stress]; 0: none

  bool acts() const { return at_rest > 0 || when_sliding > 0; }
};

/// Friction that depends on which two parts touch (FS = -1 and -2 of *CONTACT). Parts that rub alike are of
/// one group.
struct PartFriction {
  std::vector<Index> group;       ///< by part, below `groups`; empty: friction is the same everywhere
  Index groups = 0;               ///< how many
  std::vector<Friction> between;  ///< groups x groups, symmetric

  bool empty() const { return group.empty(); }
  /// Between two parts of the model, neither no_index.
  const Friction& of(Index one, Index other) const {
    return between[static_cast<std::size_t>(group[static_cast<std::size_t>(one)]) *
                       static_cast<std::size_t>(groups) +
                   static_cast<std::size_t>(group[static_cast<std::size_t>(other)])];
  }
};

/// Contact of shells and solids with themselves or each other (*CONTACT). The first side is SURFA of
/// LS-DYNA's cards (slave in old manuals), the second SURFB.
struct Contact {
  UserId id = 0;
  std::string title;
  ContactKind kind = ContactKind::SingleSurface;
  Enforcement enforcement = Enforcement::Penalty;
  bool oriented =
      false;  ///< shells have an outside, too: the side of their normal; nodes behind are pushed there
  bool symmetry_planes = false;  ///< faces of solids whose nodes are held along their normal do not touch
  bool shell_thickness = true;   ///< deformable shells have their thickness, else none
  bool rigid_shell_thickness = true;  ///< the same of shells of rigid parts
  std::array<ContactSide, 2> side;
  ContactEdges edges = ContactEdges::None;
  double static_friction = 0;   ///< FS
  double dynamic_friction = 0;  ///< FD
  double friction_decay = 0;    ///< DC: mu = FD + (FS - FD) exp(-DC |v|) [time/length]
  double friction_stress = 0;   ///< VC VSF: friction over the segment's area stays below it [stress]; 0: none
  PartFriction part_friction;   ///< instead of these four, where both parts are known
  double viscous_damping = 0;   ///< VDC, fraction of critical [-]; 0.2 is 20 %
  double soft_scale = 0;        ///< SOFSCL with SOFT = 1: least stiffness by mass and step [-]; 0 is none
  bool mass_stiffness = false;  ///< SOFT = 2: stiffness by mass and step, whatever the material
  /// PENMAX: nodes that overlap more are let go, until they come back. Over the thickness of shells and the
  /// height of solids [-], of oriented contacts [length]; 0: never.
  double release_depth = 0;
  double solid_thickness = 0;  ///< SLDTHK: thickness of the faces of solids [length]
  double solid_modulus = 0;    ///< SLDSTF: for their stiffness, instead of the bulk modulus [stress]; 0: that
  double birth_time = 0;       ///< BT [time]
  double death_time = 1e20;    ///< DT [time]

  /// Friction between two parts; no_index is a node without elements, or an unknown part.
  Friction friction_between(Index one, Index other) const {
    if (part_friction.empty() || one == no_index || other == no_index)
      return {static_friction, dynamic_friction, friction_decay, friction_stress};
    return part_friction.of(one, other);
  }
};

/// Measures what the contacts of the model do to a surface, and changes nothing (*CONTACT_FORCE_TRANSDUCER).
struct ForceTransducer {
  UserId id = 0;
  std::string title;
  std::array<ContactSide, 2> side;  ///< forces on the first; if the second is not empty, only from that one
};

/// Contact of some parts with themselves and each other, all else by default.
inline Contact self_contact(UserId id, std::string title, std::vector<Index> parts) {
  Contact contact;
  contact.id = id;
  contact.title = std::move(title);
  contact.side[0].parts = std::move(parts);
  return contact;
}

}  // namespace crumple::model
