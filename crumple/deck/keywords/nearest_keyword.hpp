// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace crumple::deck {

/// What may stand in for a keyword that is not supported.
struct NearestKeyword {
  std::string_view keyword;  ///< without asterisk; empty if none is near
  std::string change;        ///< what would be different; empty if the name may only be mistyped
};

/// The supported keyword nearest to one that is not (upper case, without asterisk).
NearestKeyword nearest_keyword(std::string_view name);

/// The same as the end of a message: "; did you mean *PART?".
std::string advice_on(std::string_view name);

}  // namespace crumple::deck
