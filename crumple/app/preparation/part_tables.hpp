// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::app {

/// Two tables with a row for each part: what it is made of, and what its results depend on besides. Of many
/// parts only the first are listed.
void print_parts(std::ostream& out, const model::Model& model, const domain::Domain& domain);

/// Form and coefficients of the hourglass control as far as the formulation has one, such as "viscous QM
/// 0.1".
std::string hourglass_words(const model::Model& model, const model::Part& part);

/// How a law depends on the strain rate, such as "Cowper-Symonds, VP 0"; "none" if it does not.
std::string rate_words(const model::ConstitutiveLaw& law);

}  // namespace crumple::app
