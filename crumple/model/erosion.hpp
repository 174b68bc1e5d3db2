// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace crumple::model {

/// When points of a material fail, whatever its constitutive law (*MAT_ADD_EROSION). Each criterion counts
/// only where it is given; docs/theory/erosion.md has the measures of stress and strain.
struct ErosionCriteria {
  std::optional<double> largest_pressure{};           ///< MXPRES [stress]
  std::optional<double> smallest_pressure{};          ///< MNPRES, below zero in tension [stress]
  std::optional<double> largest_principal_stress{};   ///< SIGP1 [stress]
  std::optional<double> largest_equivalent_stress{};  ///< SIGVM, of von Mises [stress]
  std::optional<double> largest_principal_strain{};   ///< MXEPS [-]
  std::optional<double> smallest_principal_strain{};  ///< MNEPS [-]
  std::optional<double> effective_strain{};           ///< EFFEPS above zero [-]
  std::optional<double> effective_plastic_strain{};   ///< EFFEPS below zero, as a number above it [-]
  std::optional<double> volumetric_strain{};  ///< VOLEPS: above zero of growth, below of shrinkage [-]
  std::optional<double> shear_strain{};       ///< EPSSH: half the difference of principal strains [-]
  std::optional<double> threshold_stress{};   ///< SIGTH of the impulse criterion [stress]
  std::optional<double> impulse{};            ///< IMPULSE [stress^2 time]
  std::optional<double> time{};               ///< FAILTM [time]
  int conditions = 1;                         ///< NCS: how many of them a point must meet to fail
  int points = 1;  ///< NUMFIP: failed points at which the element goes; below zero percent of its points

  /// True if there is a criterion at all.
  bool any() const;
};

}  // namespace crumple::model
