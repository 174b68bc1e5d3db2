// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "domain/domain.hpp"
#include "loads/closed_surface.hpp"
#include "loads/filling.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// Airbags, tyres and tanks: the pressure of what is in a closed surface acts on its nodes, as pressure times
/// the gradient of the volume. Its work is external work (docs/theory/airbags.md).
class ControlVolumes {
 public:
  /// Adds the reports to the domain. The model must outlive the volumes.
  ControlVolumes(const model::Model& model, domain::Domain& domain);

  /// Goes on to time n, adds the forces of the pressure and, by the trapezoidal rule, their work since time
  /// n-1 to the ledger's external work. On entry nodes.velocity is v(n-1/2) and clock.step the step between.
  /// Throws NumericalError if a surface has turned inside out.
  void add_forces(domain::Domain& domain);

  /// The part of a step that is stable without the volumes which is stable with them at time n [-].
  double stable_share(double step) const;

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  struct Volume {
    const model::ControlVolume* description;
    ClosedSurface surface;
    Filling filling;
    FillingState state{};
    std::vector<math::Vec3> force{};  ///< on the surface's nodes at time n-1
    std::vector<std::vector<std::array<Index, 4>>>
        porous{};                           ///< segments of each porous fabric, domain nodes
    std::vector<PorousArea> porous_area{};  ///< of each of them
  };
  static void report(const Volume& volume, domain::ControlVolumeReport& into);
  void push_nodes(domain::Domain& domain, Volume& volume, double pressure);
  double flexibility_of_bodies(const domain::Domain& domain, const Volume& volume);

  std::vector<Volume> volumes_;
  std::vector<std::array<double, 2>> sums_;  ///< by the pieces of nodes; kept for its room alone
  std::vector<math::Vec3> on_body_;          ///< by rigid body; kept for its room alone
  std::vector<math::Vec3> turning_body_;     ///< likewise
  double frequency_squared_ = 0;             ///< of what the stiffest filling does with its nodes [1/time^2]
};

}  // namespace crumple::loads
