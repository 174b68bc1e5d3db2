// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace crumple::deck {

/// A value of an expression. Whole numbers and real ones are told apart as in Fortran: 2 is whole, 2. is not.
struct Number {
  double value = 0;
  bool is_whole = false;
};

/// The value of a parameter by its name (upper case); nothing if there is none.
using FindParameter = std::function<std::optional<Number>(std::string_view name)>;

/// What an expression gives.
struct Evaluated {
  Number number;
  std::string fault;  ///< what is wrong with the expression, a clause of a sentence; empty if nothing is
};

/// What a number without a decimal point is.
enum class WholeNumbers {
  Exact,   ///< whole, as Fortran has it
  AsReal,  ///< like any other number
};

/// Evaluates an expression of *PARAMETER_EXPRESSION: + - * / ** with Fortran's precedence, parentheses,
/// parameters as `name` or `&name`, and the functions of LS-DYNA's manual, angles in radians. A quotient of
/// whole numbers that is not whole is a fault, since it might be meant truncated or not.
Evaluated evaluate(std::string_view expression, const FindParameter& find,
                   WholeNumbers whole = WholeNumbers::Exact);

}  // namespace crumple::deck
