// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "deck/reader.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::app {

/// What was read: files, unit system if it could be guessed, keywords left out.
void print_reading(std::ostream& out, const deck::ReadResult& deck);

/// Nodes, parts with their material, thickness and mass, what holds, stops and drives them, and size.
void print_model(std::ostream& out, const model::Model& model, const domain::Domain& domain);

/// Nodes that tied contacts were to hold and do not, or not against turning.
void warn_of_ties(std::ostream& err, const model::Model& model, const domain::Domain& domain);

}  // namespace crumple::app
