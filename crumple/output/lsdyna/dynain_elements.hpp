// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "output/results/view.hpp"

namespace crumple::output {

/// *INITIAL_STRESS_SHELL of one element: its points in global axes, in fields of 16 columns.
void append_shell_stress(const View& view, const domain::ShellBlock& block, Index place, std::string& text);

/// *INITIAL_STRESS_SOLID of one element, likewise, with the volume of its mass.
void append_solid_stress(const View& view, const domain::SolidBlock& block, Index place, std::string& text);

/// Why elements of a block get no stresses, in words; empty if they get them.
std::string refusal_of_stress(const model::Model& model, const domain::ShellBlock& block);
std::string refusal_of_stress(const model::Model& model, const domain::SolidBlock& block);

}  // namespace crumple::output
