// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "deck/format/report.hpp"
#include "model/model.hpp"

namespace crumple::deck {

/// *DEFINE_FRICTION: friction by pairs of parts or part sets.
struct RawFrictionTable {
  struct Pair {
    std::array<UserId, 2> id{};
    std::array<bool, 2> is_set{};
    model::Friction friction;
    Where where;
  };
  UserId id = 0;
  model::Friction others;      ///< of all pairs that are not listed
  bool skips_missing = false;  ///< ICNEP
  std::vector<Pair> pairs;
  Where where;
};

/// Where the friction of a contact comes from.
enum class FrictionSource { Contact, Parts, Table };

}  // namespace crumple::deck
