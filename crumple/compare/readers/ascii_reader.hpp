// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Names of LS-DYNA's text files that can be read: glstat, matsum, rwforc, rcforc, nodout.
std::span<const std::string_view> ascii_files();

/// Curves of such a text, with our names of its quantities. What is not understood is left out; a text of
/// another kind gives no curves.
/// @param name which of the files it is
std::vector<Curve> read_ascii(std::string_view text, std::string_view name);

}  // namespace crumple::compare
