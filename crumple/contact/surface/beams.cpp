// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/beams.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/surface/bulk_modulus.hpp"
#include "contact/surface/sides.hpp"

namespace crumple::contact {
namespace {

/// The sides of the contact that a part is on.
std::uint8_t sides_of(const model::Contact& contact, Index part) {
  std::uint8_t sides = 0;
  for (std::size_t i = 0; i < contact.side.size(); ++i)
    if (std::binary_search(contact.side[i].parts.begin(), contact.side[i].parts.end(), part))
      sides |= i == 0 ? first_side : second_side;
  return sides;
}

}  // namespace

std::vector<ContactBeam> collect_beams(const model::Model& model, const domain::Domain& domain,
                                       const model::Contact& contact) {
  std::vector<ContactBeam> found;
  if (contact.enforcement != model::Enforcement::Penalty) return found;
  const auto before = static_cast<Index>(domain.shells.size() + domain.solids.size());
  for (std::size_t b = 0; b < domain.beams.size(); ++b) {
    const domain::BeamBlock& block = domain.beams[b];
    const std::uint8_t sides = sides_of(contact, block.part);
    if (sides == 0) continue;
    const model::ContactSide& side = contact.side[(sides & first_side) != 0 ? 0 : 1];
    const model::Part& part = model.parts[block.part];
    const double radius = std::sqrt(model.beam_sections[part.beam_section].area / std::numbers::pi);
    const double scale = model.control.contact_stiffness_scale * side.stiffness_scale;
    for (Index at = 0; at < block.elements; ++at) {
      const auto [one, other] = block.nodes_of(at);
      if (one == other) continue;
      ContactBeam beam;
      beam.nodes = {std::min(one, other), std::max(one, other)};
      beam.place = {before + static_cast<Index>(b), at};
      beam.side = sides;
      beam.radius = radius;
      beam.stiffness = scale * bulk_modulus(model, part) * 2 * radius;
      beam.area = 2 * radius * norm(domain.nodes.reference[one] - domain.nodes.reference[other]);
      beam.id = model.beams[block.element[at]].id;
      beam.part = block.part;
      found.push_back(beam);
    }
  }
  return found;
}

}  // namespace crumple::contact
