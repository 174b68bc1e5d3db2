// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/domain.hpp"

namespace crumple::output {

/// The orthonormal axes in which a shell's stresses are kept, as its formulation has them
/// (docs/theory/belytschko_tsay.md). All zero if the element has collapsed.
struct ShellAxes {
  math::Vec3 e1, e2, e3;
};

/// Of element `place` at time n, where the stresses belong to.
ShellAxes shell_axes(const domain::ShellBlock& block, const domain::NodeFields& nodes, Index place);

/// xx, yy, zz, xy, yz, zx.
using Tensor = std::array<double, 6>;

/// Components along global axes of a tensor that has xx, yy, xy, yz, zx along those of a shell, and no zz.
Tensor in_global_axes(const ShellAxes& axes, const std::array<double, 5>& local);

}  // namespace crumple::output
