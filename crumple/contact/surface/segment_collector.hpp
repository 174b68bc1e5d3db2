// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/surface/sides.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"
#include "model/solid_faces.hpp"

namespace crumple::contact {

/// Appends the segments of a contact to a surface: connectivity and all that is known per segment, but for
/// what follows from all of them together. Faces must come before all others.
///
/// Contact thickness of shells: the true thickness times SFST (SFMT), or SST (MST) where given. Where nodes
/// of a shell may touch segments on its own sides of the contact it is at most 0.4 of the shortest edge
/// (LS-DYNA's rule for single-surface contact); Surface::thickness_cut counts these. Faces of solids have
/// none. Penalty stiffness with bulk modulus K and area A of the reference geometry: SLSFAC SFS K A /
/// (largest diagonal) of shells, SLSFAC SFS K A^2 / V of faces of solids with the volume V (Hallquist,
/// LS-DYNA Theory Manual, chapter on contact). A face that a shell of the same sides covers is left to the
/// shell, and one between two solids is none, until the shell or the other solid has eroded.
class SegmentCollector {
 public:
  SegmentCollector(const model::Model& model, const domain::Domain& domain, const model::Contact& contact,
                   Surface& surface);

  void add_faces();
  void add_shells();
  /// 1 for segments whose normal must stay as it is, 0 for shells that may be reversed.
  const std::vector<std::uint8_t>& known_orientation() const { return known_orientation_; }
  /// Of all segments so far [length].
  double mean_edge() const { return edge_sum_ / edges_; }

 private:
  struct NewSegment;
  struct Measure;
  /// A shell that hides a face with the same nodes.
  struct Cover {
    std::array<Index, 4> key{};
    ElementPlace place;
    std::uint8_t sides = 0;
  };

  const model::ContactSide& side_of(std::uint8_t sides) const {
    return contact_.side[(sides & first_side) != 0 ? 0 : 1];
  }
  double stiffness_scale(std::uint8_t sides) const {
    return model_.control.contact_stiffness_scale * side_of(sides).stiffness_scale;
  }
  Measure measure(const std::array<Index, 4>& segment) const;
  void add(const NewSegment& segment, const Measure& size);
  double release_depth(const NewSegment& segment) const;
  double thickness_of(const model::ShellElement& shell, std::uint8_t sides, double shortest_edge);
  bool meets_itself(const model::ShellElement& shell, std::uint8_t sides) const;
  void add_shell(Index shell, const ElementPlace& place, double modulus);
  void add_face(const model::SolidFace& face, std::uint8_t sides, const ElementPlace& ahead);
  std::vector<Cover> covers() const;

  const model::Model& model_;
  const domain::Domain& domain_;
  const model::Contact& contact_;
  Sides sides_;
  Surface& surface_;
  std::vector<std::uint8_t> sides_of_node_;  ///< by node of the model
  std::vector<ElementPlace> solid_place_;    ///< by index in Model::solids
  std::vector<std::uint8_t> erodes_;         ///< 1 if elements of that block can fail
  std::vector<std::uint8_t> known_orientation_;
  double edge_sum_ = 0;
  double edges_ = 0;
};

}  // namespace crumple::contact
