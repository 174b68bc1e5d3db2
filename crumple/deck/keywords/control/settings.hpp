// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "deck/format/raw_deck.hpp"
#include "deck/format/report.hpp"

namespace crumple::deck {

/// Reads the `key=value` pairs of a `$crumple` comment line: method, local_search, expansion, cells, domain,
/// precision, defaults.
/// `methods` lists the search methods there are; empty accepts any.
void read_settings(std::string_view text, const Where& where, const std::vector<std::string>& methods,
                   RawDeck& deck, Report& report);

/// What can only be judged when all settings are known: cells and domain come together.
void check_settings(RawDeck& deck, Report& report);

}  // namespace crumple::deck
