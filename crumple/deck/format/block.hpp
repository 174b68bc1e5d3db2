// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "deck/format/placement.hpp"
#include "deck/format/report.hpp"

namespace crumple::deck {

/// Width of the fields of fixed columns.
enum class ColumnFormat {
  Standard,  ///< mostly 8 x 10
  TenDigit,  ///< I10=Y: what is narrower than 10 columns has 10
  Long,      ///< LONG: what is narrower than 20 columns has 20
};

struct Line {
  std::string_view text;  ///< without line end
  std::int32_t number = 0;
};

/// A keyword with its data lines, comments taken out.
struct Block {
  std::string name;  ///< upper case, without asterisk, remarks and format marks
  Where where;       ///< of the keyword's line
  ColumnFormat format = ColumnFormat::Standard;
  std::vector<Line> lines;
  const Placement* placement = nullptr;  ///< of its file; null is as in the deck
};

}  // namespace crumple::deck
