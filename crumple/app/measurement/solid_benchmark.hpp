// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/session/cycle_times.hpp"

namespace crumple::app {

/// A formulation of solids with a form of hourglass control.
struct NamedSolid {
  std::string name;
  model::SolidFormulation formulation = model::SolidFormulation::OnePointHexahedron;
  model::SolidHourglassForm form = model::SolidHourglassForm::FlanaganBelytschkoViscous;
};

/// Every formulation of solids, that with one point with three of its forms; names in lower case with
/// hyphens.
std::vector<NamedSolid> benchmark_solids();

/// A block of solids in motion, to measure the time of a cycle as ShellBenchmark does: a slightly distorted
/// cube of steel of which one fifth yields in every cycle.
struct SolidBenchmark {
  Index side = 10;  ///< hexahedra along each edge; six tetrahedra in the place of each
  NamedSolid solid;
  domain::Execution execution;
};

/// The block with its initial velocities.
model::Model solid_benchmark_model(const SolidBenchmark& benchmark);

/// Runs whole time steps for about `seconds`.
CycleTimes measure_solids(const SolidBenchmark& benchmark, double seconds);

}  // namespace crumple::app
