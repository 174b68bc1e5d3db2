// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "deck/format/report.hpp"
#include "model/model.hpp"

namespace crumple::deck {

// Sections, materials, equations of state and hourglass controls as cards give them: see raw_deck.hpp.

struct RawSection {
  model::ShellSection section;
  bool formulation_given = true;  ///< false: takes CONTROL_SHELL's THEORY
  bool thickness_good = true;     ///< false: could not be read, which has been reported
  std::size_t order = 0;          ///< among all sections of the deck
  Where where;
  UserId integration_rule = 0;  ///< QR below zero; 0: none
  Where rule_where{};
  std::vector<double> angles{};  ///< of the points with ICOMP = 1 [rad]
};

struct RawSolidSection {
  model::SolidSection section;
  std::size_t order = 0;  ///< among all sections of the deck
  Where where;
};

/// Points of cross sections of their own (*INTEGRATION_BEAM).
struct RawBeamRule {
  UserId id = 0;
  double relative_area = 0;                   ///< of the points, over the product of both thicknesses
  std::vector<model::SectionPoint> points{};  ///< from -1 to 1, with their share of the area
  std::vector<model::SectionPoint> shape{};   ///< points of a standard shape, in the place of those
  std::array<double, 2> least{};              ///< bounds of a standard shape along s and t
  std::array<double, 2> most{};
  std::array<double, 2> reference{};  ///< where the nodes of a standard shape lie, -1 to 1
  Where where;
};

struct RawBeamSection {
  model::BeamSection section;
  UserId rule = 0;                    ///< of RawBeamRule; 0: the section has its points
  std::array<double, 2> size{};       ///< of integrated beams, along s and t
  std::array<double, 2> reference{};  ///< where their nodes lie, -1 to 1
  UserId system = 0;                  ///< CID of discrete beams; 0 is none
  std::size_t order = 0;              ///< among all sections of the deck
  Where where;
};

struct RawDiscreteSection {
  model::DiscreteSection section;
  std::size_t order = 0;  ///< among all sections of the deck
  Where where;
};

struct RawSpringMaterial {
  model::SpringMaterial material;
  UserId curve = 0;
  UserId rate_curve = 0;
  std::string_view curve_field;
  std::string_view rate_field;
  Where where;
};

/// A curve of one direction of discrete beams, or of one component of honeycomb.
struct RawDirectionCurve {
  UserId id = 0;
  std::string_view field{};
  Where where{};
};

struct RawMaterial {
  model::Material material;
  UserId held_system = 0;  ///< of a rigid material: the coordinate system of what is held; 0 is global axes
  UserId hardening_curve = 0;    ///< a curve or a table; of foam that of its crush
  bool by_log_of_rates = false;  ///< a table of hardening is interpolated in the logarithm of its rates
  UserId rate_curve = 0;
  std::array<RawDirectionCurve, 6> direction_curves{};  ///< of discrete beams; of cables the first: stresses
  std::array<RawDirectionCurve, 6> damping_curves{};
  std::array<RawDirectionCurve, 6> damping_factors{};
  std::array<RawDirectionCurve, 6> unloading_curves{};
  std::array<RawDirectionCurve, 6> rate_factors{};  ///< of honeycomb
  /// Of honeycomb: aa, bb, cc, ab, bc, ca, factor over the rate. Of plasticity with damage: LCDM. Of
  /// concrete: LCRATE.
  std::array<UserId, 8> more_curves{};
  std::array<double, 2> gauge{};           ///< length and cross section of the specimen of a test
  std::array<UserId, 2> leakage_curves{};  ///< of fabric: FLC over time, FAC over pressure
  Where where;
  Where curve_where;
};

/// *MAT_ADD_EROSION.
struct RawErosion {
  UserId material = 0;
  model::ErosionCriteria criteria;
  bool damages = false;   ///< the same keyword adds damage
  double least_step = 0;  ///< DTMIN [time]
  Where where;
};

/// *MAT_ADD_DAMAGE_GISSMO, or *MAT_ADD_EROSION with IDAM = 1.
struct RawDamage {
  UserId material = 0;
  model::GissmoDamage damage;  ///< its numbers; the curves are looked up when the model is built
  UserId failure = 0;          ///< LCSDG: a curve or a table
  double critical = 0;         ///< ECRIT: below zero a curve or a table
  double fading = 0;           ///< FADEXP: below zero a curve
  UserId regularization = 0;   ///< LCREGD: a curve, below zero a table
  UserId rates = 0;            ///< LCSRS: a curve of either sign
  Where where;
  Where curves_where;  ///< of the card with LCSDG
  Where more_where;    ///< of that with LCSRS
};

struct RawEquationOfState {
  model::EquationOfState equation;
  Where where;
};

struct RawHourglass {
  UserId id = 0;
  model::HourglassControl control;
  Where where;
};

}  // namespace crumple::deck
