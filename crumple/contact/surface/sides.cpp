// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/sides.hpp"

#include <algorithm>

#include "model/solid_faces.hpp"

namespace crumple::contact {

Sides::Sides(const model::Model& model, const model::Contact& contact)
    : model_(&model), contact_(&contact), of_part_(model.parts.size(), 0), of_shell_(model.shells.size(), 0) {
  for (std::size_t i = 0; i < contact.side.size(); ++i) {
    const auto bit = i == 0 ? first_side : second_side;
    for (const Index part : contact.side[i].parts) of_part_[part] |= bit;
    for (const Index shell : contact.side[i].shells) of_shell_[shell] |= bit;
    for (const std::array<Index, 4>& nodes : contact.side[i].segments)
      named_.push_back({model::key_of(nodes), bit, nodes});
  }
  std::stable_sort(named_.begin(), named_.end(),
                   [](const Named& a, const Named& b) { return a.key < b.key; });
  may_have_faces_ =
      !named_.empty() || std::any_of(model.solids.begin(), model.solids.end(),
                                     [&](const auto& solid) { return of_part_[solid.part] != 0; });
}

std::pair<const Sides::Named*, const Sides::Named*> Sides::named(const Key& key) const {
  const auto before = [](const Named& a, const Key& b) { return a.key < b; };
  const auto first = std::lower_bound(named_.begin(), named_.end(), key, before);
  auto last = first;
  while (last != named_.end() && last->key == key) ++last;
  return {named_.data() + (first - named_.begin()), named_.data() + (last - named_.begin())};
}

std::uint8_t Sides::of_shell(Index shell) const {
  const model::ShellElement& element = model_->shells[shell];
  std::uint8_t sides = of_part_[element.part] | of_shell_[shell];
  if (named_.empty()) return sides;
  const auto [first, last] = named(model::key_of(element.node));
  for (const Named* segment = first; segment != last; ++segment) sides |= segment->side;
  return sides;
}

std::uint8_t Sides::of_face(Index solid, const std::array<Index, 4>& nodes) const {
  std::uint8_t sides = of_part_[model_->solids[solid].part];
  if (named_.empty()) return sides;
  const auto [first, last] = named(model::key_of(nodes));
  for (const Named* segment = first; segment != last; ++segment) sides |= segment->side;
  return sides;
}

std::vector<std::uint8_t> Sides::of_nodes() const {
  std::vector<std::uint8_t> found(model_->nodes.id.size(), 0);
  for (Index shell = 0; shell < static_cast<Index>(model_->shells.size()); ++shell) {
    const std::uint8_t sides = of_shell(shell);
    for (const Index node : model_->shells[shell].node) found[node] |= sides;
  }
  for (const model::SolidElement& solid : model_->solids)
    for (std::size_t k = 0; k < solid.node.size(); ++k) found[solid.node[k]] |= of_part_[solid.part];
  for (const Named& segment : named_)
    for (const Index node : segment.nodes) found[node] |= segment.side;
  for (std::size_t i = 0; i < contact_->side.size(); ++i)
    for (const Index node : contact_->side[i].nodes) found[node] |= i == 0 ? first_side : second_side;
  return found;
}

const std::array<Index, 4>* Sides::given(Index shell) const {
  if (named_.empty()) return nullptr;
  const auto [first, last] = named(model::key_of(model_->shells[shell].node));
  return first == last ? nullptr : &first->nodes;
}

std::uint8_t touched_by(model::ContactKind kind, std::uint8_t sides) {
  const bool first = (sides & first_side) != 0;
  const bool second = (sides & second_side) != 0;
  switch (kind) {
    case model::ContactKind::SingleSurface:
      return first ? first_side : 0;
    case model::ContactKind::SurfaceToSurface:
      return static_cast<std::uint8_t>((first ? second_side : 0) | (second ? first_side : 0));
    case model::ContactKind::NodesToSurface:
      return second ? first_side : 0;
  }
  return 0;
}

}  // namespace crumple::contact
