// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::model {

/// How points of brittle materials go (FS of the laws of Johnson & Holmquist).
struct BrittleErosion {
  bool at_tension = false;    ///< a point fails when its pressure would go below what it bears in tension
  bool by_damage = false;     ///< that limit is the one of the damaged material, else of the intact one
  double plastic_strain = 0;  ///< a point fails at this effective plastic strain [-]; 0: never
};

/// What the laws of Johnson & Holmquist for ceramics and for concrete both have.
struct BrittleSolid {
  double youngs_modulus = 0;    ///< of the body at rest [stress]
  double poissons_ratio = 0;    ///< the same [-]
  double shear_modulus = 0;     ///< G [stress]
  double rate_coefficient = 0;  ///< C [-]
  double reference_rate = 1;    ///< EPS0 [1/time]
  double tension = 0;           ///< T: largest hydrostatic tension [stress]
  double fracture_factor = 0;   ///< D1 [-]
  double fracture_power = 0;    ///< D2 [-]
  double bulk_modulus = 0;      ///< K1 [stress]
  double bulk_quadratic = 0;    ///< K2 [stress]
  double bulk_cubic = 0;        ///< K3 [stress]
  BrittleErosion erosion;
};

/// Ceramics and glass whose strength goes from an intact to a fractured one
/// (*MAT_JOHNSON_HOLMQUIST_CERAMICS). docs/theory/johnson_holmquist.md.
struct HolmquistCeramic : BrittleSolid {
  double intact_factor = 0;      ///< A [-]
  double intact_power = 0;       ///< N [-]
  double fractured_factor = 0;   ///< B [-]
  double fractured_power = 0;    ///< M [-]
  double largest_fractured = 0;  ///< SFMAX, of the normalized fractured strength [-]; 0: no limit
  double elastic_limit = 0;      ///< HEL: Hugoniot elastic limit, a stress along the wave [stress]
  double limit_pressure = 0;     ///< PHEL: the pressure there [stress]
  double bulking = 0;            ///< BETA: share of the lost elastic energy that becomes pressure [-]
};

/// Concrete that crushes in three regions of pressure (*MAT_JOHNSON_HOLMQUIST_CONCRETE); K1 to K3 are those
/// of the compacted concrete. docs/theory/johnson_holmquist.md.
struct HolmquistConcrete : BrittleSolid {
  double cohesion = 0;          ///< A [-]
  double pressure_factor = 0;   ///< B [-]
  double pressure_power = 0;    ///< N [-]
  double strength = 0;          ///< FC: unconfined compressive strength [stress]
  double least_fracture = 0;    ///< EFMIN: least plastic strain to fracture [-]
  double largest_strength = 0;  ///< SFMAX, normalized [-]; 0: no limit
  double crush_pressure = 0;    ///< PC [stress]
  double crush_volume = 0;      ///< UC, as mu [-]
  double lock_pressure = 0;     ///< PL [stress]
  double lock_volume = 0;       ///< UL, as mu of the compacted concrete without pressure [-]
};

/// Set Young's modulus and Poisson's ratio of the body at rest, of G and K1 or PC/UC.
void set_elastic(HolmquistCeramic& law);
void set_elastic(HolmquistConcrete& law);

}  // namespace crumple::model
