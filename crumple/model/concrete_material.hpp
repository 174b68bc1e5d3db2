// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace crumple::model {

/// Concrete with a smooth cap, three invariants, damage and rate effects (*MAT_CSCM, *MAT_CSCM_CONCRETE).
/// docs/theory/cscm_concrete.md; I is the negative trace of the stress, positive in compression.
struct CapConcrete {
  /// constant - nonlinear exp(-exponent I) + linear I
  struct Strength {
    double constant = 0;   ///< alpha: of compression [stress], of the ratios [-]
    double linear = 0;     ///< theta: of compression [-], of the ratios [1/stress]
    double nonlinear = 0;  ///< lambda, as alpha
    double exponent = 0;   ///< beta [1/stress]
  };
  /// Fluidity eta0 / rate^exponent [time], and the largest stress that rates add.
  struct Fluidity {
    double coefficient = 0;  ///< eta0 [time^(1 - exponent)]
    double exponent = 0;     ///< N [-]
    double limit = 0;        ///< OVERC, OVERT [stress]; 0 is none
  };

  double youngs_modulus = 0;      ///< E = 9 K G / (3 K + G) [stress]
  double poissons_ratio = 0;      ///< (3 K - 2 G) / (2 (3 K + G)) [-]
  double shear_modulus = 0;       ///< G [stress]
  double bulk_modulus = 0;        ///< K [stress]
  Strength compression{};         ///< root of J2 in triaxial compression
  Strength torsion{};             ///< its ratio in torsion, Q1
  Strength extension{};           ///< its ratio in triaxial extension, Q2
  double cap_ratio = 0;           ///< R, of the axes of the cap's ellipse [-]
  double cap_start = 0;           ///< X0: I of first crush under pressure alone [stress]
  double crush_volume = 0;        ///< W, largest plastic loss of volume [-]
  double crush_linear = 0;        ///< D1 [1/stress]
  double crush_quadratic = 0;     ///< D2 [1/stress^2]
  double ductile_shape = 0;       ///< B [-]
  double brittle_shape = 0;       ///< D [-]
  double compression_energy = 0;  ///< GFC [energy/area]
  double tension_energy = 0;      ///< GFT [energy/area]
  double shear_energy = 0;        ///< GFS [energy/area]
  double compression_power = 0;   ///< PWRC, of the transition from shear to compression [-]
  double tension_power = 0;       ///< PWRT, of the transition from shear to tension [-]
  double pressure_power = 0;      ///< PMOD: softening is slower where pressure keeps part of the strength [-]
  bool has_rate_effects = false;  ///< IRATE = 1; else what follows does not count
  Fluidity compression_rate{};
  Fluidity tension_rate{};
  double shear_fluidity = 0;        ///< SRATE, of shear over that of tension [-]
  double energy_power = 0;          ///< REPOW, of the strength's factor in fracture energies [-]
  double first_damage = 0;          ///< PRED, from the start [-]
  double kept_damage = 0;           ///< share of the brittle damage that stays under pressure (RECOV) [-]
  bool recovers_by_volume = false;  ///< the volumetric strain must be compressive as well
  bool erodes = false;              ///< points fail at a damage of 0.99 and at
  double erosion_strain = 0;        ///< this largest principal strain; 0: at any strain [-]
};

/// Units of *MAT_CSCM_CONCRETE, as multiples of MPa, mm and s.
struct ConcreteUnits {
  double stress = 1;
  double length = 1;
  double time = 1;
};

/// Concrete of normal strength by its unconfined compressive strength [MPa] and largest aggregate [mm], in
/// the given units: the fits of Y.D. Murray, FHWA-HRT-05-062 (2007), which hold from 20 to 58 MPa and from 8
/// to 32 mm.
CapConcrete normal_strength_concrete(double strength, double aggregate, const ConcreteUnits& units);

/// Sets Young's modulus and Poisson's ratio from G and K.
void set_elastic(CapConcrete& law);

/// Concrete between three fixed surfaces of strength: of yield, of the maximum and of the residual strength
/// (*MAT_CONCRETE_DAMAGE_REL3). docs/theory/three_surface_concrete.md; pressures are positive in compression.
struct ThreeSurfaceConcrete {
  /// constant + p / (first + second p), of sqrt(3 J2) in triaxial compression
  struct Surface {
    double constant = 0;  ///< a0 [stress]
    double first = 0;     ///< a1 [-]
    double second = 0;    ///< a2 [1/stress]
  };
  /// How many times as strong a strain rate makes the material; straight between the points, constant beyond.
  struct RateFactors {
    std::vector<double> rate;    ///< rising from zero [1/time]
    std::vector<double> factor;  ///< not below 1 [-]
  };

  double youngs_modulus = 0;  ///< of the first bulk modulus and Poisson's ratio [stress]
  double poissons_ratio = 0;
  double tensile_strength = 0;  ///< FT [stress]
  Surface maximum{};
  Surface yield{};
  Surface residual{};               ///< its constant is zero
  double compression_power = 0;     ///< B1 [-]
  double tension_power = 0;         ///< B2 [-]
  double opening_damage = 0;        ///< B3: damage per volumetric strain in triaxial tension [-]
  double dilatancy = 0;             ///< OMEGA: share of the normal plastic volume [-]
  double width = 0;                 ///< LOCWIDTH: smallest length over which damage spreads [length]
  std::vector<double> damage;       ///< lambda, rising from zero [-]
  std::vector<double> share;        ///< eta, from zero to one and back [-]
  std::vector<double> compression;  ///< -ln V, rising from zero [-]
  std::vector<double> pressure;     ///< of first loading [stress]
  std::vector<double> unloading;    ///< bulk moduli of unloading [stress]
  RateFactors tension_rates{};      ///< LCRATE, none without points
  RateFactors compression_rates{};  ///< both or none
};

/// Concrete by its unconfined compressive strength and Poisson's ratio alone, with `psi` pounds per square
/// inch in the unit of stress and `inches` in that of length (docs/theory/three_surface_concrete.md).
ThreeSurfaceConcrete three_surface_concrete(double strength, double poissons_ratio, double psi,
                                            double inches);

/// Factors of concrete by the same arguments, with `seconds` in the unit of time: CEB-FIP Model Code 1990 in
/// compression, L.J. Malvar & C.A. Ross, ACI Mater. J. 95 (1998) 735-739, in tension.
void set_rate_factors(ThreeSurfaceConcrete& law, double strength, double psi, double seconds);

/// Ten points of compaction that start with the bulk modulus, which Young's modulus and Poisson's ratio
/// follow.
void set_compaction(ThreeSurfaceConcrete& law, double bulk_modulus);

/// The strength in unconfined compression of a surface: where sqrt(3 J2) is three times the pressure; zero if
/// there is none.
double unconfined_strength(const ThreeSurfaceConcrete::Surface& surface);

}  // namespace crumple::model
