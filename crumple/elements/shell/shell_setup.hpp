// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "elements/shell/shell_geometry.hpp"

namespace crumple::elements {

/// Present positions of an element's nodes.
ShellCorners corners_of(const domain::Domain& domain, const std::array<Index, 4>& node);

}  // namespace crumple::elements
