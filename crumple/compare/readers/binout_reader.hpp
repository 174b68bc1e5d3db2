// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "compare/curves/curve.hpp"
#include "compare/readers/lsda_file.hpp"

namespace crumple::compare {

/// Curves of the files of one binout (`binout0000`, `binout0001`, ...), with our names of LS-DYNA's
/// quantities: the variables of the states `/glstat/d000001`, ... of every folder. A later file wins where
/// two have the same state. Variables whose size fits no list of items are left out.
std::vector<Curve> read_binout(const std::vector<LsdaFile>& files);

}  // namespace crumple::compare
