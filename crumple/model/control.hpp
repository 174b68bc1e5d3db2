// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "model/section.hpp"

namespace crumple::model {

/// How the run is done: what *CONTROL cards say. Defaults are LS-DYNA's.
struct Control {
  double end_time = 0;               ///< ENDTIM [time]
  long end_cycle = 0;                ///< ENDCYC; 0 is no limit
  double minimum_step_factor = 0;    ///< DTMIN, share of the first step: below it the run ends; 0 is off
  bool erodes_short_solids = false;  ///< ERODE: solids whose own step falls below that erode instead
  double end_energy_ratio = 0;    ///< ENDENG: percent change of the energy ratio that ends the run; 0 is off
  double end_mass_increase = 0;   ///< ENDMAS: percent change of the total mass that ends the run; 0 is off
  double initial_step = 0;        ///< DTINIT [time]; 0 lets the program choose
  double step_scale = 0.9;        ///< TSSFAC
  Index step_curve = no_index;    ///< LCTM, in Model::curves: no step is longer [time] at a time
  double mass_scaling_step = 0;   ///< DT2MS [time]; negative adds mass only where needed; 0 is off
  bool scales_mass_once = false;  ///< MS1ST: only at the start
  HourglassControl hourglass;     ///< for parts without their own
  double bulk_quadratic = 1.5;    ///< Q1 of *CONTROL_BULK_VISCOSITY [-]
  double bulk_linear = 0.06;      ///< Q2 [-]
  bool thickness_change = false;  ///< ISTUPD: shells become thinner as they stretch
  double contact_stiffness_scale = 0.1;  ///< SLSFAC
  bool report_distorted_shells = false;  ///< NFAIL1, NFAIL4: those with a negative Jacobian at the end
};

/// How a contact finds what touches among the candidates.
enum class LocalSearchKind {
  InsideOutside,  ///< nodes against segments, by mesh normals
  Pinballs,       ///< balls embedded in the segments against each other
};

/// Global search settings: LS-DYNA has no card for them, `$crumple` comment lines and options set them.
struct SearchSettings {
  std::string method = "production";  ///< one of the names of cellsearch
  LocalSearchKind local = LocalSearchKind::InsideOutside;
  double expansion = 0;                    ///< territory expansion c [length]; 0 lets the program choose
  bool has_cells = false;                  ///< cells and domain below are given
  std::array<Index, 3> cells{};            ///< Nx, Ny, Nz
  std::array<double, 3> domain_minimum{};  ///< [length]
  std::array<double, 3> domain_maximum{};  ///< [length]
};

/// What else `$crumple` comment lines say about the run. Options of the program come before them.
struct RunSettings {
  std::string precision;  ///< "mixed" or "double"; empty is the program's default
};

}  // namespace crumple::model
