// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "base/index.hpp"

namespace crumple::model {

/// Nodes that move as one rigid body until the weld fails (*CONSTRAINED_SPOTWELD,
/// *CONSTRAINED_GENERALIZED_WELD_SPOT). It fails when (N/S_n)^n + (S/S_s)^m reaches 1 with the tension N
/// along the line between its two nodes and the shear S across it, when the plastic strain at one of its
/// nodes exceeds a limit, or at a time.
struct SpotWeld {
  UserId id = 0;
  std::vector<Index> nodes;    ///< at least two
  double normal_strength = 0;  ///< S_n [force]; 0: tension does not count
  double shear_strength = 0;   ///< S_s [force]; 0: shear does not count
  double normal_exponent = 1;  ///< n [-]
  double shear_exponent = 1;   ///< m [-]
  double failure_strain = 0;   ///< effective plastic strain; 0 is none
  double failure_time = 1e20;  ///< [time]
};

/// A massless link of constant length between two nodes, which may turn (*CONSTRAINED_RIVET).
struct Rivet {
  UserId id = 0;
  std::array<Index, 2> node{no_index, no_index};
  double failure_time = 1e20;  ///< [time]
};

/// Nodes whose velocities along some global axes are the same (*CONSTRAINED_NODE_SET).
struct ConstrainedNodeSet {
  std::vector<Index> nodes;
  std::array<bool, 3> direction{};  ///< x, y, z
  double failure_time = 1e20;       ///< [time]
};

/// A linear equation between components of velocities, sum of c_i v_i = 0 (*CONSTRAINED_LINEAR_GLOBAL,
/// *CONSTRAINED_ADAPTIVITY).
struct LinearEquation {
  struct Term {
    Index node = no_index;
    int component = 0;  ///< 0 to 2: translation along x, y, z; 3 to 5: rotation about them
    double factor = 0;  ///< c_i [-, or length of rotations beside translations]
  };
  UserId id = 0;
  std::vector<Term> terms;
};

/// A node that moves and turns as the rigid motion which fits that of others best
/// (*CONSTRAINED_INTERPOLATION).
struct Interpolation {
  struct Independent {
    Index node = no_index;
    double weight = 1;           ///< of its translations [-]
    double rotation_weight = 0;  ///< of its rotations [-]
  };
  UserId id = 0;
  Index dependent = no_index;
  std::array<bool, 6> follows{true, true, true, true, true, true};  ///< along, then about x, y, z
  std::vector<Independent> independent;
};

/// Beams inside solids, as reinforcement in concrete: their nodes move with the solids that they lie in
/// (*CONSTRAINED_BEAM_IN_SOLID, *CONSTRAINED_LAGRANGE_IN_SOLID).
struct EmbeddedBeams {
  UserId id = 0;
  std::vector<Index> beams;    ///< in Model::beams, ascending
  std::vector<Index> solids;   ///< that may hold their nodes, in Model::solids, ascending
  double end_time = 1e20;      ///< the nodes are free from then on [time]
  bool between_nodes = false;  ///< the deck asks for points between the nodes of a beam, too
};

}  // namespace crumple::model
