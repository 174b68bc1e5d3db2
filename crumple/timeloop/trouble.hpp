// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::timeloop {

/// Throws a NumericalError that names the first node whose motion is no longer a finite number, with a shell
/// and part it belongs to, or, if there is none, `otherwise` and the fastest node.
[[noreturn]] void throw_trouble(const model::Model& model, const domain::Domain& domain,
                                const std::string& otherwise);

}  // namespace crumple::timeloop
