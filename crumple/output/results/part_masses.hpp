// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "base/index.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// Mass of the elements of every part, shared out to their nodes in equal portions. From the geometry at time
/// zero; mass scaling is not in it.
class PartMasses {
 public:
  explicit PartMasses(const View& view);

  struct Motion {
    double mass = 0;            ///< [mass]
    double kinetic_energy = 0;  ///< [energy]
    math::Vec3 velocity;        ///< of the centre of mass [length/time]
  };
  /// Of a part, by its index in the model.
  Motion motion(const domain::NodeFields& nodes, Index part) const;

  /// The same, but of the whole body where the part leads a rigid body whose inertia is given.
  Motion motion_with_body(const domain::Domain& domain, Index part) const;

  /// [mass]
  double mass(Index part) const;

 private:
  /// By part: domain node, ascending, and the part's mass there.
  std::vector<std::vector<std::pair<Index, double>>> shares_;
};

/// Mass of one shell: density times mid-surface area at time zero times mean thickness [mass].
double shell_mass(const View& view, const model::ShellElement& shell);

}  // namespace crumple::output
