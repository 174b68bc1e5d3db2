// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "app/arguments/command_line.hpp"
#include "app/console/console.hpp"
#include "deck/reader.hpp"
#include "domain/domain.hpp"

namespace crumple::app {

/// Reads the deck and tells all that is wrong with it on `console.err`. The model is absent if it cannot be
/// run. What the command line asks for is put into the model.
deck::ReadResult read_with_options(const Options& options, const Console& console);

/// The same from the texts of an earlier reading, with the cards of `changes`, if that is not empty, behind.
deck::ReadResult read_again(const Options& options, const std::filesystem::path& changes,
                            const std::vector<deck::RecordedText>& texts, const Console& console);

/// How to compute: the command line's choice, else the deck's, else the program's. Throws Error for a choice
/// of the deck that does not exist.
domain::Execution choose_execution(const Options& options, const model::Model& model);

}  // namespace crumple::app
