// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/session/cycle_times.hpp"

namespace crumple::app {

/// A sheet of shells in motion, to measure the time of a cycle without contact. It is slightly curved; one
/// fifth of it, side by side, is stretched so that a plastic material yields there in every cycle, the rest
/// stays elastic. The step is a small fraction of the stable one, so that the motion hardly changes while it
/// is measured.
struct ShellBenchmark {
  Index side = 32;  ///< elements along each edge; triangles have half the rows
  model::ShellFormulation formulation = model::ShellFormulation::BelytschkoTsay;
  model::ConstitutiveLaw law;
  int thickness_points = 3;
  domain::Execution execution;
};

/// A constitutive law with the constants of a plain steel [N, mm, s].
struct NamedLaw {
  std::string name;
  model::ConstitutiveLaw law;
};
struct NamedFormulation {
  std::string name;
  model::ShellFormulation formulation;
};

/// Every law and formulation that the registries hold, their names in lower case with hyphens.
std::vector<NamedLaw> benchmark_laws();
std::vector<NamedFormulation> benchmark_formulations();

/// The sheet with its initial velocities. Where it is to yield it does so after cycles_to_yield steps.
model::Model shell_benchmark_model(const ShellBenchmark& benchmark);

/// Runs whole time steps for about `seconds`. Throws Error if the formulation refuses the material.
CycleTimes measure_shells(const ShellBenchmark& benchmark, double seconds);

}  // namespace crumple::app
