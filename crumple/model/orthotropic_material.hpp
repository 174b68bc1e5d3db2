// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace crumple::model {

/// Linear orthotropic elasticity (*MAT_ORTHOTROPIC_ELASTIC) with axes a, b in the shell and c along its
/// normal.
struct OrthotropicElastic {
  /// What the axis a follows at time zero, in the plane of the shell.
  enum class Axes {
    Side,         ///< the side from the first to the second node
    Vector,       ///< `direction`, projected
    CrossNormal,  ///< the cross product of `direction` with the normal
  };

  /// Of the isotropic law that stands in for step size, hourglass control, rotary inertia and contact: not
  /// slower nor softer in shear than this one, see orthotropic_stand_in().
  double youngs_modulus = 0;  ///< [stress]
  double poissons_ratio = 0;  ///< [-]
  double modulus_a = 0;       ///< E_a [stress]
  double modulus_b = 0;       ///< E_b [stress]
  double modulus_c = 0;       ///< E_c [stress]
  double poisson_ba = 0;      ///< nu_ba: -strain a over strain b under stress b [-]
  double poisson_ca = 0;      ///< nu_ca [-]
  double poisson_cb = 0;      ///< nu_cb [-]
  double shear_ab = 0;        ///< G_ab [stress]
  double shear_bc = 0;        ///< G_bc [stress]
  double shear_ca = 0;        ///< G_ca [stress]
  Axes axes = Axes::Side;
  std::array<double, 3> direction{};  ///< of any length
  double angle = 0;  ///< from what a follows to a, about the normal [rad]; an element's own goes before it
};

/// Unidirectional layers that fail by modes: fibres and matrix, each in tension and compression
/// (*MAT_ENHANCED_COMPOSITE_DAMAGE, *MAT_COMPOSITE_DAMAGE). Strengths and limits of zero are none.
struct CompositeDamage : OrthotropicElastic {
  enum class Matrix {
    Chang,       ///< tension and compression apart, Chang & Chang 1987 (CRIT = 54)
    TsaiWu,      ///< one quadratic form for both, Tsai & Wu 1971 (CRIT = 55)
    ChangShear,  ///< as Chang with the shear energy of the nonlinear law (*MAT_COMPOSITE_DAMAGE)
  };
  Matrix matrix = Matrix::Chang;
  double tension_a = 0;            ///< XT, along the fibres [stress]
  double compression_a = 0;        ///< XC, a positive number [stress]
  double tension_b = 0;            ///< YT, across [stress]
  double compression_b = 0;        ///< YC, a positive number [stress]
  double shear_strength = 0;       ///< SC in the plane [stress]
  double shear_softening = 0;      ///< alpha: shear strain = tau / G + alpha tau^3 [1/stress^3]
  double shear_in_fibre_mode = 0;  ///< beta of the tensile fibre mode [-]
  double fibre_tension_left = 0;   ///< factor on XT where the matrix has failed in compression; 0 is 1 [-]
  double fibre_compression_by_matrix = 0;  ///< then XC is this times YC; 0: it stays [-]
  double failure_tension = 0;              ///< strain along the fibres at which a point goes [-]
  double failure_compression = 0;          ///< below zero [-]
  double failure_matrix = 0;               ///< strain across, either sign [-]
  double failure_shear = 0;                ///< of the tensor, either sign [-]
  double failure_effective = 0;            ///< sqrt(4/3 (a^2 + ab + b^2 + shear^2)) [-]
  bool goes_by_fibre_tension = false;      ///< a point goes as soon as its fibres fail in tension
};

/// Plies or whole laminates that lose stiffness by damage, and so go through a largest stress in each mode
/// (*MAT_LAMINATED_COMPOSITE_FABRIC).
struct LaminatedFabric : OrthotropicElastic {
  /// What damage depends on.
  enum class Surface {
    Facets,  ///< each direction and the shear for itself (FS = -1)
    Across,  ///< across and in shear on both together, along a for itself (FS = 0)
    Smooth,  ///< along and across, each with the shear (FS = 1)
  };
  struct Mode {
    double strength = 0;  ///< largest stress, a positive number [stress]
    double strain = 0;    ///< at that, a positive number; of shear the engineering strain [-]
    double left = 0;      ///< SLIM: the stress does not fall below this share of the strength [-]
  };

  Surface surface = Surface::Across;
  Mode tension_a;
  Mode compression_a;
  Mode tension_b;
  Mode compression_b;
  Mode shear;
  double first_shear_stress = 0;  ///< TAU1, of facets: from there a line to the strength [stress]
  double first_shear_strain = 0;  ///< GAMMA1 there [-]; 0 is none
  double erosion_strain = 0;      ///< ERODS: effective strain at which a point goes [-]; 0 is none
};

/// Sets the isotropic stand-in: its plate waves are as fast as the fastest in any direction in the plane, its
/// shear modulus is not below those of the transverse shears.
void set_stand_in(OrthotropicElastic& law);

/// Sheet metal whose yield differs with the direction, isotropic in its elasticity and hardening
/// (*MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC, *MAT_3-PARAMETER_BARLAT). R is the plastic strain of a
/// test strip over its width, divided by that over its thickness.
struct SheetPlasticity {
  double youngs_modulus = 0;  ///< E [stress]
  double poissons_ratio = 0;  ///< nu [-]
  bool is_normal = false;     ///< Hill 1948 with the same R in every direction, r00; else Barlat & Lian 1989
  double yield_exponent = 2;  ///< m of Barlat & Lian [-]
  double r00 = 1;             ///< R along the axis a [-]
  double r45 = 1;             ///< at 45 degrees to it
  double r90 = 1;             ///< across
  OrthotropicElastic axes;    ///< where a is: its axes, direction and angle alone
  std::vector<double> plastic_strain{};  ///< effective, ascending from 0; or empty: the power below
  std::vector<double> yield_stress{};    ///< along a, at those strains [stress]; last slope 0 beyond
  double strength = 0;                   ///< k of k (e_y + p)^n [stress]
  double hardening_exponent = 0;         ///< n [-]
  double yield_strain = 0;               ///< e_y [-]
  double cowper_symonds_rate = 0;        ///< C [1/time]; 0 switches the rate effect off
  double cowper_symonds_exponent = 0;    ///< p [-]
};

}  // namespace crumple::model
