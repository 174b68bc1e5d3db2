// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace crumple::elements {

/// ElementBlock::element_constants and back: to_numbers(constants),
/// from_numbers<ShellConstants<Real>>(numbers). Of shells and solids.
template <class Constants>
std::vector<double> to_numbers(const Constants& constants);
template <class Constants>
Constants from_numbers(const std::vector<double>& numbers);

}  // namespace crumple::elements
