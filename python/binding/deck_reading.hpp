// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/arguments/command_line.hpp"
#include "base/error.hpp"
#include "deck/reader.hpp"

namespace crumple::python {

/// What is wrong with the input, in the words of the console, place included.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(message) {}
};

/// A deck as it was read, with the options that it was read with. Never changes, so that several runs may
/// share it.
struct DeckReading {
  app::Options options;
  deck::ReadResult result;
  std::string console;              ///< all that `crumple run` prints about it, in lines
  std::vector<std::string> faults;  ///< lines of it that are no diagnostics of the reader
};

/// As `crumple run` reads a deck; it may be faulty, then it has no model. Throws InputError for what is no
/// parameter.
std::shared_ptr<const DeckReading> read_deck(app::Options options);

/// What refuses the start of a run of a deck that has a model, as the console says it; empty if nothing does.
std::string fault_at_start(const DeckReading& deck);

}  // namespace crumple::python
