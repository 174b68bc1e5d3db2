// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "model/contact.hpp"
#include "model/model.hpp"

namespace crumple::contact {

constexpr std::uint8_t first_side = 1;
constexpr std::uint8_t second_side = 2;

/// Which sides of a contact the elements of a model are on, as bits.
class Sides {
 public:
  Sides(const model::Model& model, const model::Contact& contact);

  /// Of a shell, in Model::shells.
  std::uint8_t of_shell(Index shell) const;
  /// Of a face of a solid, in Model::solids, that has these nodes.
  std::uint8_t of_face(Index solid, const std::array<Index, 4>& nodes) const;
  /// The order of nodes that the contact gives to a shell on its own; nullptr if it has none.
  const std::array<Index, 4>* given(Index shell) const;
  /// By node of the model: those of its shells and solids, and those on which it is named.
  std::vector<std::uint8_t> of_nodes() const;
  /// True if any face of a solid can be on a side.
  bool may_have_faces() const { return may_have_faces_; }

 private:
  using Key = std::array<Index, 4>;
  struct Named {
    Key key{};
    std::uint8_t side = 0;
    Key nodes{};
  };

  std::pair<const Named*, const Named*> named(const Key& key) const;

  const model::Model* model_;
  const model::Contact* contact_;
  std::vector<std::uint8_t> of_part_;
  std::vector<std::uint8_t> of_shell_;
  std::vector<Named> named_;  ///< by key
  bool may_have_faces_ = false;
};

/// Sides of the nodes that may touch a segment on these sides.
std::uint8_t touched_by(model::ContactKind kind, std::uint8_t sides);

}  // namespace crumple::contact
