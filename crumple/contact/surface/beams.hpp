// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/index.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// A beam of a contact, as a round bar.
struct ContactBeam {
  std::array<Index, 2> nodes{};  ///< of the domain, the lower first
  ElementPlace place;
  std::uint8_t side = 0;  ///< first_side, second_side or both
  double radius = 0;      ///< of the circle with the area of the cross section [length]
  double stiffness = 0;   ///< penalty stiffness [force/length]
  double area = 0;        ///< length times diameter, undeformed [length^2]
  UserId id = 0;
  Index part = no_index;  ///< of the model
};

/// True if a contact has edges and beams: not if its forces are multipliers, which know nodes alone.
inline bool edges_take_part(const model::Contact& contact) {
  return contact.edges != model::ContactEdges::None && contact.enforcement == model::Enforcement::Penalty;
}

/// The beams of the parts of the contact; none of contacts by multipliers and by the masses of segments.
/// Their nodes touch segments, and they touch edges where these take part. The penalty stiffness is SLSFAC
/// SFS SFM K 2 r with the bulk modulus K: the K A / length of a shell on the projected area
/// (docs/theory/contact.md).
std::vector<ContactBeam> collect_beams(const model::Model& model, const domain::Domain& domain,
                                       const model::Contact& contact);

}  // namespace crumple::contact
