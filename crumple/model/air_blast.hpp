// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "base/index.hpp"

namespace crumple::model {

/// What the model's units are in those of the fits of an air blast (CFM, CFL, CFT, CFP).
struct BlastUnits {
  double pounds = 0;        ///< in the unit of mass
  double feet = 0;          ///< in that of length
  double milliseconds = 0;  ///< in that of time
  double psi = 0;           ///< in that of stress
};

/// A charge of TNT in air at sea level, whose wave loads the segments that name it (*LOAD_BLAST_ENHANCED).
struct AirBlast {
  enum class Burst {
    Surface,  ///< BLAST = 1: a hemisphere on the ground, which reflects the wave
    Air,      ///< BLAST = 2: a sphere far from the ground
  };
  UserId id = 0;
  Burst burst = Burst::Air;
  double mass = 0;                 ///< M: of TNT [mass]
  std::array<double, 3> centre{};  ///< XBO, YBO, ZBO [length]
  Index node = no_index;           ///< NIDBO, in Model::nodes: it is the centre until the detonation
  double detonation = 0;           ///< TBO: may lie before time zero [time]
  double death = 1e20;             ///< DEATH: no pressure from then on [time]
  bool negative_phase = true;      ///< NEGPHS = 0: suction after the positive phase
  BlastUnits units;
};

/// A segment that an air blast loads (*LOAD_BLAST_SEGMENT). Its normal points to the side of the charge.
struct BlastSegment {
  Index blast = no_index;                                             ///< in Model::air_blasts
  std::array<Index, 4> node{no_index, no_index, no_index, no_index};  ///< a triangle repeats its third node
  double scale = 1;                                                   ///< SCALEP: factor on the pressure
  Index shell = no_index;  ///< in Model::shells: the load ends when this shell erodes
};

/// Scaled distances between which the fits hold [ft/lb^(1/3)].
struct ScaledRange {
  double nearest = 0;
  double farthest = 0;
};

/// Where all fits of a kind of burst hold: Kingery and Bulmash (1984); LS-DYNA's manual has the same.
ScaledRange scaled_range(AirBlast::Burst burst);

/// Distance over the cube root of the charge's mass [ft/lb^(1/3)].
double scaled_distance(const AirBlast& blast, double distance);

}  // namespace crumple::model
