// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace crumple::deck {

struct ReadOptions {
  /// Keywords and field values that are not supported become warnings (they are left out) instead of errors.
  bool allow_unsupported = false;
  /// Adds single-surface contact over all parts to a deck that has no *CONTACT.
  bool automatic_contact = false;
  /// What the deck leaves open about elements is as in LS-DYNA: constant thickness, viscous hourglass
  /// control.
  bool ls_dyna_defaults = false;
  /// The end of the run, in place of that of the deck, for functions of time.
  std::optional<double> end_time;
  /// Parameters with their values, which go before those of the deck.
  std::vector<std::pair<std::string, std::string>> parameters;
  /// Names that `$crumple method=` may have; empty accepts any.
  std::vector<std::string> search_methods;
  /// Keeps the texts in the result, for a restart file.
  bool keep_texts = false;
};

}  // namespace crumple::deck
