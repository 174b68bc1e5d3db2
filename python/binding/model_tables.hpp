// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pytypes.h>

#include <string>

#include "binding/deck_reading.hpp"

namespace crumple::python {

/// The model that a deck describes, as tables for Python. All throw InputError with the console's text if the
/// deck has no model.
const model::Model& model_of(const DeckReading& deck);

/// Ids of the nodes, in the order of the deck.
pybind11::array node_ids(const DeckReading& deck);

/// A dictionary of arrays with an entry per element: id, part (id), nodes (places in node_ids(), from 0).
/// `kind`: "shell", "solid", "beam" or "discrete"; throws pybind11::value_error for others.
pybind11::dict element_table(const DeckReading& deck, const std::string& kind);

/// A dictionary for each part: id, title, kind, rigid, elements (how many).
pybind11::list part_table(const DeckReading& deck);

/// A dictionary for each diagnostic: severity, file, line, keyword, card, field, message, count, text.
pybind11::list diagnostics_of(const DeckReading& deck);

/// Name -> (value, "deck" or "command line").
pybind11::dict parameters_of(const DeckReading& deck);

}  // namespace crumple::python
