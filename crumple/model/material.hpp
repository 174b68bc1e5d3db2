// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/index.hpp"
#include "model/cohesive_material.hpp"
#include "model/compression_tension.hpp"
#include "model/concrete_material.hpp"
#include "model/damage.hpp"
#include "model/erosion.hpp"
#include "model/failing_solid.hpp"
#include "model/foam_material.hpp"
#include "model/holmquist_material.hpp"
#include "model/hydro_material.hpp"
#include "model/orthotropic_material.hpp"
#include "model/spall.hpp"

namespace crumple::model {

/// Linear isotropic elasticity (LS-DYNA's *MAT_ELASTIC).
struct Elastic {
  double youngs_modulus = 0;  ///< E [stress]
  double poissons_ratio = 0;  ///< nu [-]
};

/// J2 plasticity with linear hardening, mixed isotropic and kinematic (*MAT_PLASTIC_KINEMATIC).
struct PlasticKinematic {
  double youngs_modulus = 0;           ///< E [stress]
  double poissons_ratio = 0;           ///< nu [-]
  double yield_stress = 0;             ///< sigma_0, at zero plastic strain and rate [stress]
  double tangent_modulus = 0;          ///< E_t, slope of the uniaxial stress over total strain [stress]
  double isotropic_fraction = 0;       ///< beta: 0 is kinematic, 1 is isotropic hardening
  double cowper_symonds_rate = 0;      ///< C [1/time]; 0 switches the rate effect off
  double cowper_symonds_exponent = 0;  ///< p [-]
  double failure_strain = 0;           ///< effective plastic strain at failure; 0 is none
  bool viscoplastic = false;  ///< VP = 1; the rate is the plastic strain's in any case, but in trusses
};

/// A hardening curve at one strain rate.
struct HardeningAtRate {
  double rate = 0;                     ///< [1/time], or its natural logarithm
  std::vector<double> plastic_strain;  ///< ascending from 0
  std::vector<double> yield_stress;    ///< [stress]
};

/// J2 plasticity with tabulated isotropic hardening (*MAT_PIECEWISE_LINEAR_PLASTICITY).
struct PiecewiseLinearPlasticity {
  double youngs_modulus = 0;           ///< E [stress]
  double poissons_ratio = 0;           ///< nu [-]
  std::vector<double> plastic_strain;  ///< effective plastic strain, ascending from 0
  std::vector<double> yield_stress;    ///< yield stress at those strains [stress]; last slope 0 beyond
  double cowper_symonds_rate = 0;      ///< C [1/time]; 0 switches the rate effect off
  double cowper_symonds_exponent = 0;  ///< p [-]
  double failure_strain = 0;           ///< effective plastic strain at failure; 0 is none
  bool viscoplastic = false;           ///< see PlasticKinematic
  double viscoplastic_base = 0;        ///< what the Cowper-Symonds term multiplies then; 0: the yield stress
  std::vector<double> factor_rate{};   ///< a curve of factors over strain rates, ascending; or empty
  std::vector<double> rate_factor{};   ///< [-]
  std::vector<HardeningAtRate> by_rate{};  ///< curves by ascending rate, in place of the one above; or empty
  bool logarithmic_rates = false;          ///< by_rate is interpolated in the logarithm of the rate
  /// Of shells (*MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY): a point fails at these strains as well, and the
  /// element when so many of its points through the thickness have failed.
  double failure_thinning = 0;  ///< minus the strain across; 0 is none
  double failure_major = 0;     ///< major strain in the plane; 0 is none
  int failed_points = 0;        ///< 0: all of them
  double failed_share = 0;      ///< of the points, in place of their number; 0: the number counts
  /// Share of the stress that is lost over the effective plastic strain, ascending from 0, straight between
  /// these points and constant beyond (*MAT_PLASTICITY_WITH_DAMAGE); empty: nothing is lost.
  std::vector<double> damage_strain{};
  std::vector<double> damage{};  ///< 0 to 1
};

/// True if the stress of points fades with their plastic strain.
bool has_damage(const PiecewiseLinearPlasticity& law);

/// True if shells without such damage fail by more than the plastic strain of all points.
bool has_strain_limits(const PiecewiseLinearPlasticity& law);

/// J2 plasticity with a power of the plastic strain, k (e_y + p)^n (*MAT_POWER_LAW_PLASTICITY).
struct PowerLawPlasticity {
  double youngs_modulus = 0;           ///< E [stress]
  double poissons_ratio = 0;           ///< nu [-]
  double strength = 0;                 ///< k [stress]
  double exponent = 0;                 ///< n [-]
  double yield_strain = 0;             ///< e_y, elastic strain at first yield [-]
  double cowper_symonds_rate = 0;      ///< C [1/time]; 0 switches the rate effect off
  double cowper_symonds_exponent = 0;  ///< p [-]
  double failure_strain = 0;           ///< effective plastic strain at failure; 0 is none
  bool viscoplastic = false;           ///< see PlasticKinematic
};

/// (A + B p^n) (1 + C ln(rate / reference)) (1 - T*^m) after Johnson & Cook, with their failure criterion
/// (*MAT_JOHNSON_COOK, *MAT_SIMPLIFIED_JOHNSON_COOK).
struct JohnsonCook {
  double youngs_modulus = 0;         ///< E [stress]
  double poissons_ratio = 0;         ///< nu [-]
  double yield_stress = 0;           ///< A [stress]
  double hardening = 0;              ///< B [stress]
  double exponent = 0;               ///< n [-]
  double rate_coefficient = 0;       ///< C [-]
  double reference_rate = 1;         ///< strain rate up to which there is no rate effect [1/time]
  double largest_hardened = 0;       ///< upper bound of A + B p^n [stress]; 0 is none
  double saturation_stress = 0;      ///< upper bound of the yield stress with its rate effect; 0 is none
  double thermal_exponent = 0;       ///< m [-]; 0 switches thermal softening off
  double melting_rise = 0;           ///< melting less initial temperature [temperature]
  double heat_capacity = 0;          ///< per mass [energy/(mass temperature)]; 0 switches heating off
  double failure_strain = 0;         ///< effective plastic strain at failure; 0 is none
  std::array<double, 5> damage{};    ///< D1 to D5 of the fracture strain [-]; all zero is none
  double least_fracture_strain = 0;  ///< lower bound of D1 + D2 exp(D3 s) [-]
  bool viscoplastic = false;         ///< see PlasticKinematic
  double shear_modulus = 0;   ///< G where an equation of state gives the pressure; 0: of E and nu [stress]
  double least_pressure = 0;  ///< pressure cut-off of solids, below zero; 0 is none [stress]
  Spall spall = Spall::None;  ///< what happens to solids at the cut-off
  bool simplified = false;    ///< stems from *MAT_SIMPLIFIED_JOHNSON_COOK: for its name alone
};

/// How fabric lets gas through: an effective area of FLC(t) FAC(P) times its own.
struct FabricLeakage {
  double coefficient = 0;             ///< FLC [-]
  Index coefficient_time = no_index;  ///< in Model::curves: time, FLC; instead of the constant
  double area = 0;                    ///< FAC [-]; with venting 7 the curve below alone counts
  Index area_pressure = no_index;     ///< in Model::curves: absolute pressure, FAC; with venting 7 a velocity
  int venting = 0;  ///< FVOPT: 0 as the airbag says, 1 an orifice, 7 a velocity by the curve
};

/// Woven fabric of airbags (*MAT_FABRIC, FORM 0 and 1), of membranes only: a linear orthotropic sheet, that
/// may wrinkle instead of bearing pressure, with an isotropic liner and damping.
struct Fabric {
  /// Of the isotropic law that stands in for step size, hourglass control and contact, see set_stand_in().
  double youngs_modulus = 0;  ///< [stress]
  double poissons_ratio = 0;  ///< [-]
  OrthotropicElastic sheet;   ///< moduli in its plane and axes
  bool wrinkles = false;      ///< CSE: no pressure in the fabric, in any direction
  double liner_modulus = 0;   ///< EL [stress]
  double liner_ratio = 0;     ///< PRL [-]
  double liner_share = 0;     ///< LRATIO: thickness of the liner over that of all [-]
  FabricLeakage leakage;
  double damping = 0;  ///< DAMP: viscous stress over the stress of the same strain in one step, elastic [-]
};

/// Sets the isotropic stand-in: as fast as the fastest wave of fabric and liner in the plane, and so much
/// faster that the stable step allows for the damping.
void set_stand_in(Fabric& law);

/// Of shells mass and a surface for contact; of solids a fluid with an equation of state (*MAT_NULL).
struct NullMaterial {
  double youngs_modulus = 0;   ///< E of the contact stiffness of shells [stress]
  double poissons_ratio = 0;   ///< nu of the contact stiffness of shells [-]
  double least_pressure = 0;   ///< pressure cut-off of the fluid, below zero; 0 is none [stress]
  double viscosity = 0;        ///< dynamic [stress time]
  double largest_volume = 0;   ///< relative volume above which solids erode; 0 is none [-]
  double smallest_volume = 0;  ///< relative volume below which solids erode; 0 is none [-]
};

/// Compressible rubber of Blatz & Ko (*MAT_BLATZ-KO_RUBBER).
struct BlatzKo {
  double youngs_modulus = 0;  ///< E = 2 G (1 + nu) at rest [stress]
  double poissons_ratio = 0;  ///< nu [-]
};

/// Nearly incompressible rubber of Mooney & Rivlin (*MAT_MOONEY-RIVLIN_RUBBER).
struct MooneyRivlin {
  double youngs_modulus = 0;  ///< E = 4 (A + B) (1 + nu) at rest [stress]
  double poissons_ratio = 0;  ///< nu at rest [-]
  double first = 0;           ///< A, factor of the first invariant [stress]
  double second = 0;          ///< B, factor of the second invariant [stress]
};

/// Foam that is crushed for good, without lateral strain (*MAT_CRUSHABLE_FOAM).
struct CrushableFoam {
  double youngs_modulus = 0;         ///< E of loading below the yield stress and of unloading [stress]
  double poissons_ratio = 0;         ///< nu of contact stiffness and wave speed [-]
  std::vector<double> crush;         ///< 1 - relative volume, ascending
  std::vector<double> yield_stress;  ///< principal stress there [stress]; the last slope goes on beyond
  double tensile_stress = 0;         ///< largest principal stress in tension [stress]
  double damping = 0;                ///< coefficient of the linear viscosity [-]
};

/// A curve of foam in compression at a strain rate.
struct FoamAtRate {
  double rate = 0;                  ///< [1/time]
  std::vector<double> compression;  ///< as of LowDensityFoam
  std::vector<double> stress;
};

/// Foam of low density that springs back: principal nominal stresses by the principal stretches, one by one
/// (*MAT_LOW_DENSITY_FOAM, *MAT_FU_CHANG_FOAM).
struct LowDensityFoam {
  double youngs_modulus = 0;         ///< E in tension, and at rest for wave speed and contact [stress]
  double poissons_ratio = 0;         ///< of contact stiffness [-]
  std::vector<double> compression;   ///< 1 - stretch, ascending from 0
  std::vector<double> stress;        ///< nominal, from 0 [stress]; the last slope goes on beyond
  double tensile_stress = 0;         ///< largest nominal stress in tension; 0 is no bound [stress]
  bool tears = false;                ///< at that bound the point loses its strength in tension for good
  double unloading_factor = 1;       ///< HU: share of the stress that unloading keeps at the least [-]
  double unloading_shape = 1;        ///< exponent of the stored energy in unloading [-]
  double damping = 0;                ///< coefficient of the linear viscosity [-]
  double contact_modulus = 0;        ///< KCON: Young's modulus of contact; 0: steepest slope, or E [stress]
  double slowest = 0;                ///< rate up to which the curve above holds [1/time]
  std::vector<FoamAtRate> faster{};  ///< curves of loading at higher rates, ascending
  bool engineering_rate = false;     ///< the rate is that of the stretch, else of its logarithm
};

/// Honeycomb: six uncoupled components in the material axes a, b, c until it is compacted, then elastic and
/// perfectly plastic (*MAT_HONEYCOMB, *MAT_MODIFIED_HONEYCOMB).
struct Honeycomb {
  /// What the material axes follow at time zero.
  enum class Axes {
    Nodes,    ///< a from node 1 to 2, b in the plane of nodes 1, 2 and 4
    Point,    ///< a from `a`, a point, to the middle of the element, c = a x z
    Vectors,  ///< a along `a`, c = a x `d`
  };
  /// What the yield stress of a component depends on.
  enum class Abscissa {
    Volume,         ///< the crushed volume 1 - V
    Strain,         ///< its own logarithmic strain, compression above zero; of shear the size of gamma
    NominalStrain,  ///< the same with the change of length over the first length along a, b and c
  };
  /// Yield stress of a component, on straight lines that go on at both ends.
  struct Crush {
    std::vector<double> crush;   ///< 1 - relative volume, or strain, ascending [-]
    std::vector<double> stress;  ///< [stress]
  };
  /// Factor on the yield stresses before compaction; without rows there is none.
  struct RateFactor {
    std::vector<double> rate;    ///< ascending [1/time]
    std::vector<double> factor;  ///< above zero [-]
  };

  double youngs_modulus = 0;              ///< E once compacted [stress]
  double poissons_ratio = 0;              ///< nu once compacted [-]
  double yield_stress = 0;                ///< once compacted [stress]
  double compacted_volume = 0;            ///< relative volume V_f from which on it is compacted [-]
  std::array<double, 6> moduli{};         ///< uncompacted E_aa, E_bb, E_cc, G_ab, G_bc, G_ca [stress]
  Abscissa over = Abscissa::Volume;       ///< of `crush`
  std::array<Crush, 6> crush{};           ///< of aa, bb, cc, ab, bc, ca
  RateFactor rates{};                     ///< over the norm of the deviatoric strain rate, for all of them
  std::array<RateFactor, 6> own_rates{};  ///< or of each over the size of its own strain rate
  double viscosity = 0.05;          ///< coefficient of the linear bulk viscosity, in the place of Q1 and Q2
  bool standard_viscosity = false;  ///< Q1 and Q2 instead
  Axes axes = Axes::Nodes;
  std::array<double, 3> a{};
  std::array<double, 3> d{};
  double failure_tension = 0;  ///< largest strain along a, b or c at failure [-]; 0 is none
  double failure_shear = 0;    ///< largest engineering shear strain between them at failure [-]; 0 is none
};

/// Largest stiffness of waves in the uncompacted honeycomb over that of confined compression of the compacted
/// one, at most 1.
double stiffness_share(const Honeycomb& law);

/// Soil, concrete or foam whose pressure follows from the volume, and whose yield stress from the pressure
/// (*MAT_SOIL_AND_FOAM).
struct SoilAndFoam {
  double youngs_modulus = 0;        ///< of the moduli G and the larger of KUN and the first slope [stress]
  double poissons_ratio = 0;        ///< the same [-]
  double shear_modulus = 0;         ///< G [stress]
  double unloading_modulus = 0;     ///< bulk modulus KUN of unloading [stress]
  std::array<double, 3> yield{};    ///< a0, a1, a2: half the deviator's square is at most a0 + a1 p + a2 p^2
  double least_pressure = 0;        ///< PC, not above zero [stress]
  bool crushes = true;              ///< unloads with KUN; else along the curve
  std::vector<double> compression;  ///< -ln V, ascending from 0
  std::vector<double> pressure;     ///< from 0 [stress]; the last slope goes on
};

/// Foam that stiffens with compression, and a viscosity that does as well (*MAT_VISCOUS_FOAM).
struct ViscousFoam {
  double youngs_modulus = 0;      ///< the larger of E1 and E2: for step and contact [stress]
  double poissons_ratio = 0;      ///< nu [-]
  double elastic_modulus = 0;     ///< E1 at rest [stress]
  double elastic_exponent = 0;    ///< n1: the modulus is E1 V^-n1 [-]
  double viscosity = 0;           ///< V2 [stress time]
  double viscosity_exponent = 0;  ///< n2: the viscosity is V2 |1 - V|^n2 [-]
};

/// Rubber or foam by its uniaxial test (*MAT_SIMPLIFIED_RUBBER/FOAM).
struct SimplifiedRubber {
  double youngs_modulus = 0;    ///< largest slope of the test's curve, or of the moduli below [stress]
  double poissons_ratio = 0;    ///< of a foam; of rubber that at rest [-]
  bool is_foam = false;         ///< compressible with constant Poisson's ratio, else nearly incompressible
  double bulk_modulus = 0;      ///< KM, of rubber [stress]
  double damping = 0.1;         ///< MU: least coefficient of the linear bulk viscosity [-]
  std::vector<double> stretch;  ///< of the test, ascending through 1
  std::vector<double> stress;   ///< nominal, through 0 at 1 [stress]; the outer slopes go on
};

/// A part of a modulus that relaxes.
struct Relaxation {
  double modulus = 0;  ///< [stress]
  double decay = 0;    ///< [1/time]; 0: it stays
};

/// Nearly incompressible rubber of Ogden (*MAT_OGDEN_RUBBER).
struct OgdenRubber {
  double youngs_modulus = 0;           ///< E = 2 G (1 + nu) at rest, G = sum of mu alpha / 2 [stress]
  double poissons_ratio = 0;           ///< nu at rest [-]
  std::array<double, 8> modulus{};     ///< mu [stress]; zero is no term
  std::array<double, 8> exponent{};    ///< alpha [-]
  std::vector<Relaxation> relaxing{};  ///< shear moduli of a stress beside that, which relaxes
};

/// Nearly incompressible rubber whose energy is a polynomial in the invariants (*MAT_HYPERELASTIC_RUBBER).
struct PolynomialRubber {
  double youngs_modulus = 0;  ///< E = 4 (C10 + C01) (1 + nu) at rest [stress]
  double poissons_ratio = 0;  ///< nu at rest [-]
  double c10 = 0;             ///< [stress], as all that follow
  double c01 = 0;
  double c11 = 0;
  double c20 = 0;
  double c02 = 0;
  double c30 = 0;
  std::vector<Relaxation> relaxing{};  ///< as of OgdenRubber
};

/// Linear viscoelasticity by Prony series (*MAT_VISCOELASTIC, *MAT_GENERAL_VISCOELASTIC).
struct Viscoelastic {
  double youngs_modulus = 0;      ///< E before anything has relaxed [stress]
  double poissons_ratio = 0;      ///< nu before anything has relaxed [-]
  std::vector<Relaxation> shear;  ///< parts of the shear modulus
  std::vector<Relaxation> bulk;   ///< parts of the bulk modulus
};

/// Sets modulus and Poisson's ratio from the sums of the moduli.
void set_instantaneous(Viscoelastic& law);

/// Beams whose ends are elastic-perfectly plastic under axial force and bending moments
/// (*MAT_RESULTANT_PLASTICITY).
struct ResultantPlasticity {
  double youngs_modulus = 0;  ///< E [stress]
  double poissons_ratio = 0;  ///< nu [-]
  double yield_stress = 0;    ///< [stress]
};

/// A spot weld, elastic-plastic with linear isotropic hardening (*MAT_SPOTWELD). It fails when (N / N_f)^2 +
/// (S_s / S_sf)^2 + (S_t / S_tf)^2 + (T / T_f)^2 + (M_s / M_sf)^2 + (M_t / M_tf)^2 reaches 1, with the
/// tension N, the shear forces S, the torsion T and the moments M; pressure does not count, and a strength of
/// zero leaves its term out. It fails also by plastic strain, and at a time.
struct SpotWeldLaw {
  double youngs_modulus = 0;      ///< E [stress]
  double poissons_ratio = 0;      ///< nu [-]
  double yield_stress = 0;        ///< [stress]
  double hardening = 0;           ///< slope of the stress over the plastic strain [stress]
  double least_step = 0;          ///< stable step that mass is added for, of the weld alone; 0 is none [time]
  double failure_time = 1e20;     ///< [time]
  double failure_strain = 0;      ///< effective plastic strain at failure; 0 is none
  double tension_strength = 0;    ///< N_f [force]
  double shear_strength_s = 0;    ///< S_sf [force]
  double shear_strength_t = 0;    ///< S_tf [force]
  double torsion_strength = 0;    ///< T_f [force length]
  double bending_strength_s = 0;  ///< M_sf [force length]
  double bending_strength_t = 0;  ///< M_tf [force length]
};

/// The force of a discrete beam along one of its axes, or the moment about it: the sum of all that is given.
struct DiscreteBeamDirection {
  double stiffness = 0;              ///< [force/length], of moments [force length/rad]
  double damping = 0;                ///< [force time/length]
  double preload = 0;                ///< [force]
  Index curve = no_index;            ///< in Model::curves: force over displacement
  Index damping_curve = no_index;    ///< in Model::curves: force over velocity
  Index damping_factor = no_index;   ///< in Model::curves: factor on that force over displacement
  Index unloading_curve = no_index;  ///< in Model::curves: force over displacement
  double unloading_stiffness = 0;    ///< at least the steepest slope of both curves [force/length]
  double tensile_limit = 0;          ///< displacement at which the beam fails; 0 is none [length]
  double compressive_limit = 0;      ///< amount of the negative displacement at which it fails; 0 is none
};

/// Discrete beams: springs and dampers in the directions of their axes, or along the line of the nodes
/// (*MAT_LINEAR_ELASTIC_DISCRETE_BEAM and others).
struct DiscreteBeamLaw {
  enum class Kind {
    Axes,   ///< three forces and three moments in axes that turn with the nodes
    Line,   ///< a force between the nodes
    Cable,  ///< the same, never a pressure
  };
  /// What the force of `curve` does when the displacement goes back.
  enum class Unloading {
    None,       ///< follows the curve
    Curve,      ///< the unloading curve, shifted along the displacement
    Stiffness,  ///< the unloading stiffness down to the unloading curve
    Quadratic,  ///< a parabola from the largest displacement to a share of it
  };

  double youngs_modulus = 0;  ///< of cables E [stress]; else not used
  double poissons_ratio = 0;  ///< not used
  Kind kind = Kind::Axes;
  std::array<DiscreteBeamDirection, 6> direction{};  ///< r, s, t, moments about r, s, t; of a line the first
  Index stress_curve = no_index;  ///< of cables: stress over strain in the place of E, in Model::curves
  double ramp_time = 0;           ///< the preload rises over this time; 0: it is there at once [time]
  Unloading unloading = Unloading::None;
  double permanent_share = 0;  ///< OFFSET: of the largest displacement, that stays with Unloading::Quadratic
  /// Failure counts tension and compression of all directions together, else those of either sign.
  bool joint_failure = false;
};

/// The constitutive law and its constants. A new law is one more alternative here.
using ConstitutiveLaw =
    std::variant<Elastic, PlasticKinematic, PiecewiseLinearPlasticity, PowerLawPlasticity, JohnsonCook,
                 OrthotropicElastic, CompositeDamage, NullMaterial, ResultantPlasticity, SpotWeldLaw, BlatzKo,
                 MooneyRivlin, CrushableFoam, LowDensityFoam, OgdenRubber, PolynomialRubber, Viscoelastic,
                 DiscreteBeamLaw, Honeycomb, SoilAndFoam, ViscousFoam, SimplifiedRubber, Fabric,
                 BilkhuDuboisFoam, SheetPlasticity, LaminatedFabric, Cohesive, CapConcrete,
                 ThreeSurfaceConcrete, HolmquistCeramic, HolmquistConcrete, HydroPlasticity, FailingSolid,
                 CompressionTension>;

/// Which elements a law is for, and whether an equation of state gives its pressure in solids.
struct LawUse {
  bool shells = true;
  bool solids = true;
  bool takes_equation_of_state = false;
  bool needs_equation_of_state = false;  ///< in solids
  bool only_membranes = false;           ///< of the shells
  bool only_cohesive = false;            ///< of the solids, which take no other law
};
LawUse use_of(const ConstitutiveLaw& law);

/// True of laws of solids that neither flow nor relax, with an isotropic stiffness: linear elasticity,
/// rubbers.
bool is_elastic(const ConstitutiveLaw& law);

/// True of laws of solids that are crushed, as foams and honeycombs: their stress becomes a large part of
/// their modulus, and the solids a fraction of their height.
bool is_crushable(const ConstitutiveLaw& law);

/// True of laws of shells and solids that keep an effective plastic strain.
bool has_plastic_strain(const ConstitutiveLaw& law);

/// What the parts of a rigid material may not do (CMO = 1 or -1 of *MAT_RIGID).
struct RigidMaterial {
  std::array<bool, 3> fixed_translation{};  ///< of the centre of mass along the held axes of the body
  std::array<bool, 3> fixed_rotation{};     ///< about them
};

struct Material {
  UserId id = 0;
  std::string title;
  double density = 0;  ///< rho [mass/volume]
  ConstitutiveLaw law;
  /// Present: parts of this material are rigid bodies, and the law serves the stiffness of contact alone.
  std::optional<RigidMaterial> rigid{};
  std::optional<ErosionCriteria> erosion{};  ///< beside what the law itself has of failure
  std::optional<GissmoDamage> damage{};      ///< likewise; the law has a plastic strain then
  double least_step = 0;                     ///< elements go whose own stable step is shorter [time]; 0: none
};

/// True if elements may go that the law itself would keep.
inline bool may_erode(const Material& material) {
  return material.erosion || (material.damage && material.damage->acts) || material.least_step > 0;
}

}  // namespace crumple::model
