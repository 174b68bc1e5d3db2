// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/material.hpp"

namespace crumple::materials {

/// Throws Error "Material <id>: <what>." unless `holds`.
void require(bool holds, const model::Material& material, const std::string& what);

/// Young's modulus above zero, Poisson's ratio above -1 and below 1/2.
void require_elastic(const model::Material& material, double youngs_modulus, double poissons_ratio);

/// Cowper-Symonds: rate and exponent both above zero, or the rate zero (no rate effect).
void require_cowper_symonds(const model::Material& material, double rate, double exponent);

/// Throws: the axis that a shell's material is to follow is normal to the shell.
[[noreturn]] void fail_axis(UserId shell);

/// Throws: the axes that a solid's material is to follow do not span a plane.
[[noreturn]] void fail_solid_axes(UserId solid);

/// Failure strain above zero, or zero (no failure).
void require_failure_strain(const model::Material& material, double failure_strain);

}  // namespace crumple::materials
