// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "model/solid_nodes.hpp"
#include "model/stiffness_damping.hpp"

namespace crumple::model {

/// Nodes in the order of the deck. Both arrays have one entry per node.
struct Nodes {
  std::vector<UserId> id;
  std::vector<std::array<double, 3>> position;  ///< x, y, z [length]

  Index count() const { return static_cast<Index>(id.size()); }
};

struct ShellElement {
  UserId id = 0;
  Index part = no_index;
  std::array<Index, 4> node{no_index, no_index, no_index, no_index};  ///< a triangle repeats one, see below
  std::array<double, 4> thickness{};  ///< at the nodes [length]; all zero takes the section's
  double material_angle = 0;          ///< of an orthotropic law [rad]; zero takes the material's
  Index layup = no_index;             ///< in Model::layups; no_index takes the part's
  Index layer_angles = no_index;      ///< first of its layers' angles in Model::layer_angles; or the layup's
};

/// Nodes 1 to 4 around one face, 5 to 8 around the opposite one, 5 above 1. Wedges repeat 5
/// as 6 and 7 as 8, pyramids 5 as 6 to 8, tetrahedra 3 as 4 and 5 as 6 to 8; other hexahedra with equal
/// neighbours are possible. Tetrahedra may have six nodes more.
struct SolidElement {
  UserId id = 0;
  Index part = no_index;
  SolidNodes node;
};

/// True if a solid has the four nodes of a tetrahedron in the order above: entries 0, 1, 2 and 4.
bool is_tetrahedron(const SolidElement& solid);

/// A beam or truss between two nodes. Its axis s lies in the plane of both and the orientation node, or of
/// the axis and the orientation vector.
struct BeamElement {
  UserId id = 0;
  Index part = no_index;
  std::array<Index, 2> node{no_index, no_index};
  Index orientation_node = no_index;    ///< no_index: the vector below, or if that is zero any direction
  std::array<double, 3> orientation{};  ///< of any length; zero is none
};

/// A spring or damper between two nodes, or between a node and a fixed point.
struct DiscreteElement {
  UserId id = 0;
  Index part = no_index;
  std::array<Index, 2> node{no_index, no_index};  ///< equal where the second end is held, see `grounded`
  bool grounded = false;                          ///< the second end does not move
  std::array<double, 3> axis{};  ///< unit vector along which it acts; zero: from the first node to the second
  double scale = 1;              ///< on the force [-]
  double offset = 0;             ///< deformation at time zero [length or rad]
};

enum class ElementKind { Shell, Solid, Beam, Discrete };

/// Place of the entry that the next one around the element repeats, or -1: the element is a triangle, in
/// decks one that repeats its third node (2).
int repeated_entry(const std::array<Index, 4>& node);

/// What holds the faces of squeezed solids apart (*CONTACT_INTERIOR), docs/theory/interior_contact.md.
struct InteriorContact {
  double relative_volume = 0.1;  ///< below which the pressure acts [-]
  double scale = 1;              ///< factor on the modulus [-]
  double modulus = 0;            ///< [stress]; 0 is that of confined compression of the material
};

struct Part {
  UserId id = 0;
  std::string title;
  // One of four, the others are no_index: a part has elements of one kind.
  Index section = no_index;           ///< in Model::shell_sections
  Index solid_section = no_index;     ///< in Model::solid_sections
  Index beam_section = no_index;      ///< in Model::beam_sections
  Index discrete_section = no_index;  ///< in Model::discrete_sections
  Index layup = no_index;             ///< in Model::layups, of shells; no_index: one material
  Index material = no_index;          ///< in Model::materials; no_index for a part of springs
  Index spring_material = no_index;   ///< in Model::spring_materials, for a part of springs
  Index hourglass = no_index;  ///< in Model::hourglass_controls; no_index takes Model::control.hourglass
  Index equation_of_state = no_index;         ///< in Model::equations_of_state; no_index is none
  std::optional<InteriorContact> interior{};  ///< of solids
  std::optional<StiffnessDamping> damping{};  ///< of shells, solids and beams
  double contact_thickness = 0;        ///< OPTT of *PART_CONTACT, of shells [length]; 0: see the contact
  double contact_thickness_scale = 1;  ///< SFT: factor on the true thickness of shells in contact [-]
};

/// The kind of elements that a part's section is for.
ElementKind kind_of(const Part& part);

/// A mass at a node, without extent (*ELEMENT_MASS) or with the same rotary inertia about all axes
/// (*ELEMENT_INERTIA).
struct LumpedMass {
  UserId id = 0;
  Index node = no_index;
  double mass = 0;     ///< [mass]
  double inertia = 0;  ///< [mass * length^2]
};

struct NodeSet {
  UserId id = 0;
  std::string title;
  std::vector<Index> nodes;
};

struct PartSet {
  UserId id = 0;
  std::string title;
  std::vector<Index> parts;
};

struct ShellSet {
  UserId id = 0;
  std::string title;
  std::vector<Index> shells;
};

/// Pieces of surface. No two of a set have the same nodes.
struct SegmentSet {
  UserId id = 0;
  std::string title;
  std::vector<std::array<Index, 4>> segments;  ///< a triangle repeats its third node
};

}  // namespace crumple::model
