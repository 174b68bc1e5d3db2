// SPDX-License-Identifier: BSD-3-Clause
#include "contact/force_transducer.hpp"

#include "contact/surface/sides.hpp"
#include "model/solid_faces.hpp"

namespace crumple::contact {
namespace {

/// The sides that all nodes of each of the two points of a touch are on.
struct Ends {
  std::uint8_t first = first_side | second_side;
  std::uint8_t second = first_side | second_side;
};

}  // namespace

ForceTransducer::ForceTransducer(const model::Model& model, const domain::Domain& domain,
                                 const model::ForceTransducer& transducer)
    : side_of_node_(domain.nodes.count(), 0), has_second_(!transducer.side[1].empty()) {
  model::Contact contact;
  contact.side = transducer.side;
  const Sides sides(model, contact);
  const auto mark = [&](const auto& nodes, std::uint8_t side) {
    for (const Index node : nodes) side_of_node_[domain.nodes.domain_node[node]] |= side;
  };
  for (Index i = 0; i < static_cast<Index>(model.shells.size()); ++i)
    mark(model.shells[i].node, sides.of_shell(i));
  if (sides.may_have_faces())
    for (Index i = 0; i < static_cast<Index>(model.solids.size()); ++i)
      for (const auto& face : model::faces_of(model.solids[i])) mark(face, sides.of_face(i, face));
  mark(contact.side[0].nodes, first_side);
  mark(contact.side[1].nodes, second_side);
  for (std::size_t i = 0; i < side_of_node_.size(); ++i)
    if ((side_of_node_[i] & first_side) != 0) mass_ += domain.nodes.mass[i];
}

Vec3 ForceTransducer::measure(const std::vector<Interface>& contacts) const {
  Vec3 sum;
  for (const Interface& contact : contacts) sum += measure(contact);
  return sum;
}

Vec3 ForceTransducer::measure(const Interface& contact) const {
  const Surface& surface = contact.surface();
  Vec3 sum;
  for (const Touch& touch : contact.touches()) {
    Ends on;
    for (int i = 0; i < touch.nodes; ++i) {
      const std::uint8_t side = side_of_node_[surface.nodes[touch.place[i]]];
      if (touch.weight[i] > 0) on.first &= side;
      if (touch.weight[i] < 0) on.second &= side;
    }
    const auto from_second = [&](std::uint8_t other) { return !has_second_ || (other & second_side) != 0; };
    if ((on.first & first_side) != 0 && from_second(on.second)) sum += touch.force();
    if ((on.second & first_side) != 0 && from_second(on.first)) sum -= touch.force();
  }
  return sum;
}

}  // namespace crumple::contact
