// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "deck/reader.hpp"
#include "output/run_record.hpp"

namespace crumple::app {

/// What of a deck does not take part in the run: keywords without effect, and keywords and values that
/// crumple lacks, which are refused or left out on request. Each once, with its number and first place.
std::vector<output::LeftOut> left_out_of(const deck::ReadResult& deck);

/// The same under one heading for each reason.
void print_left_out(std::ostream& out, const std::vector<output::LeftOut>& list);

}  // namespace crumple::app
