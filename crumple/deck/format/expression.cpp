// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/expression.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "deck/format/numbers.hpp"

namespace crumple::deck {

namespace {

using Arguments = std::span<const Number>;

/// Which of its arguments make the value of a function whole.
enum class Whole { Never, Always, IfArguments };

struct Function {
  std::string_view name;
  std::size_t least;  ///< number of arguments
  std::size_t most;
  Whole whole;
  double (*value)(Arguments);
};

constexpr std::size_t many = 100;

double smallest(Arguments a) {
  double value = a[0].value;
  for (const Number& number : a) value = std::min(value, number.value);
  return value;
}

double largest(Arguments a) {
  double value = a[0].value;
  for (const Number& number : a) value = std::max(value, number.value);
  return value;
}

constexpr Function functions[] = {
    {"ABS", 1, 1, Whole::IfArguments, [](Arguments a) { return std::fabs(a[0].value); }},
    {"ACOS", 1, 1, Whole::Never, [](Arguments a) { return std::acos(a[0].value); }},
    {"ACOSH", 1, 1, Whole::Never, [](Arguments a) { return std::acosh(a[0].value); }},
    {"AINT", 1, 1, Whole::Never, [](Arguments a) { return std::trunc(a[0].value); }},
    {"ANINT", 1, 1, Whole::Never, [](Arguments a) { return std::round(a[0].value); }},
    {"ASIN", 1, 1, Whole::Never, [](Arguments a) { return std::asin(a[0].value); }},
    {"ASINH", 1, 1, Whole::Never, [](Arguments a) { return std::asinh(a[0].value); }},
    {"ATAN", 1, 1, Whole::Never, [](Arguments a) { return std::atan(a[0].value); }},
    {"ATAN2", 2, 2, Whole::Never, [](Arguments a) { return std::atan2(a[0].value, a[1].value); }},
    {"ATANH", 1, 1, Whole::Never, [](Arguments a) { return std::atanh(a[0].value); }},
    {"COS", 1, 1, Whole::Never, [](Arguments a) { return std::cos(a[0].value); }},
    {"COSH", 1, 1, Whole::Never, [](Arguments a) { return std::cosh(a[0].value); }},
    {"CSC", 1, 1, Whole::Never, [](Arguments a) { return 1 / std::sin(a[0].value); }},
    {"CTN", 1, 1, Whole::Never, [](Arguments a) { return 1 / std::tan(a[0].value); }},
    {"EXP", 1, 1, Whole::Never, [](Arguments a) { return std::exp(a[0].value); }},
    {"FLOAT", 1, 1, Whole::Never, [](Arguments a) { return a[0].value; }},
    {"INT", 1, 1, Whole::Always, [](Arguments a) { return std::trunc(a[0].value); }},
    {"LOG", 1, 1, Whole::Never, [](Arguments a) { return std::log(a[0].value); }},
    {"LOG10", 1, 1, Whole::Never, [](Arguments a) { return std::log10(a[0].value); }},
    {"MAX", 2, many, Whole::IfArguments, largest},
    {"MIN", 2, many, Whole::IfArguments, smallest},
    {"MOD", 2, 2, Whole::IfArguments, [](Arguments a) { return std::fmod(a[0].value, a[1].value); }},
    {"NINT", 1, 1, Whole::Always, [](Arguments a) { return std::round(a[0].value); }},
    {"SEC", 1, 1, Whole::Never, [](Arguments a) { return 1 / std::cos(a[0].value); }},
    {"SIGN", 2, 2, Whole::IfArguments, [](Arguments a) { return std::copysign(a[0].value, a[1].value); }},
    {"SIN", 1, 1, Whole::Never, [](Arguments a) { return std::sin(a[0].value); }},
    {"SINH", 1, 1, Whole::Never, [](Arguments a) { return std::sinh(a[0].value); }},
    {"SQRT", 1, 1, Whole::Never, [](Arguments a) { return std::sqrt(a[0].value); }},
    {"TAN", 1, 1, Whole::Never, [](Arguments a) { return std::tan(a[0].value); }},
    {"TANH", 1, 1, Whole::Never, [](Arguments a) { return std::tanh(a[0].value); }},
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Reads an expression from left to right. After the first fault everything is zero.
class Parser {
 public:
  Parser(std::string_view text, const FindParameter& find, WholeNumbers whole)
      : text_(text), find_(find), whole_(whole) {}

  Evaluated run() {
    const Number number = sum();
    skip_blanks();
    if (at_ < text_.size())
      fail(fmt::format("\"{}\" stands where an operator or the end is expected", text_.substr(at_, 1)));
    return {number, fault_};
  }

 private:
  void fail(const std::string& fault) {
    if (fault_.empty()) fault_ = fault;
    at_ = text_.size();
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }

  /// Takes a mark if it comes next. A single asterisk is not the first of two.
  bool take(std::string_view mark) {
    skip_blanks();
    if (!text_.substr(at_).starts_with(mark)) return false;
    if (mark == "*" && text_.substr(at_).starts_with("**")) return false;
    at_ += mark.size();
    return true;
  }

  Number checked(double value, bool is_whole, std::string_view what) {
    if (std::isfinite(value)) return {value, is_whole};
    fail(fmt::format("{} has no finite value", what));
    return {};
  }

  Number sum() {
    Number left = product();
    while (true) {
      if (take("+"))
        left = add(left, product(), 1);
      else if (take("-"))
        left = add(left, product(), -1);
      else
        return left;
    }
  }

  Number add(Number left, Number right, double sign) {
    return checked(left.value + sign * right.value, left.is_whole && right.is_whole, "a sum");
  }

  Number product() {
    Number left = signed_power();
    while (true) {
      if (take("*")) {
        const Number right = signed_power();
        left = checked(left.value * right.value, left.is_whole && right.is_whole, "a product");
      } else if (take("/")) {
        left = quotient(left, signed_power());
      } else {
        return left;
      }
    }
  }

  Number quotient(Number left, Number right) {
    if (right.value == 0) {
      fail("there is a division by zero");
      return {};
    }
    const bool whole = left.is_whole && right.is_whole;
    const double value = left.value / right.value;
    if (whole && std::floor(value) != value)
      fail(fmt::format(
          "{0} / {1} are whole numbers and the quotient is not; write {0}. / {1} or int({0}. / {1})",
          left.value, right.value));
    return checked(value, whole, "a quotient");
  }

  /// A sign holds for a whole power: -2**2 is -4.
  Number signed_power() {
    // Each level is one more call; a deck with more of them is a fault, not a crash.
    constexpr int deepest = 200;
    if (++depth_ > deepest) fail("it is nested too deeply");
    Number result;
    if (take("-")) {
      result = signed_power();
      result.value = -result.value;
    } else if (take("+")) {
      result = signed_power();
    } else {
      result = power();
    }
    --depth_;
    return result;
  }

  Number power() {
    const Number base = atom();
    if (!take("**")) return base;
    const Number exponent = signed_power();
    const bool whole = base.is_whole && exponent.is_whole && exponent.value >= 0;
    return checked(std::pow(base.value, exponent.value), whole, "a power");
  }

  Number atom() {
    skip_blanks();
    if (take("(")) {
      const Number inner = sum();
      if (!take(")")) fail("a closing parenthesis is missing");
      return inner;
    }
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (is_digit(c) || c == '.') return literal();
    const bool marked = take("&");
    if (at_ < text_.size() && is_letter(text_[at_])) return name(marked);
    fail(at_ < text_.size() ? fmt::format("\"{}\" stands where a value is expected", text_.substr(at_, 1))
                            : std::string("a value is missing at its end"));
    return {};
  }

  void skip_digits() {
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  }

  Number literal() {
    const std::size_t begin = at_;
    skip_digits();
    bool is_whole = whole_ == WholeNumbers::Exact;
    if (at_ < text_.size() && text_[at_] == '.') {
      is_whole = false;
      ++at_;
      skip_digits();
    }
    if (at_ < text_.size() && std::string_view("eEdD").find(text_[at_]) != std::string_view::npos) {
      const std::size_t mark = at_++;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      const std::size_t digits = at_;
      skip_digits();
      if (at_ == digits)
        at_ = mark;
      else
        is_whole = false;
    }
    const std::string_view written = text_.substr(begin, at_ - begin);
    const std::optional<double> value = parse_real(written);
    if (!value) fail(fmt::format("\"{}\" is not a number", written));
    return {value.value_or(0), is_whole};
  }

  Number name(bool is_parameter) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string name = upper_case(text_.substr(begin, at_ - begin));
    if (!is_parameter && take("(")) return call(name);
    if (const std::optional<Number> value = find_(name)) return *value;
    fail(fmt::format("the parameter {} is not defined before this line", name));
    return {};
  }

  Number call(const std::string& name) {
    std::vector<Number> arguments;
    do arguments.push_back(sum());
    while (take(","));
    if (!take(")")) fail(fmt::format("the closing parenthesis of {} is missing", name));
    const auto function = std::find_if(std::begin(functions), std::end(functions),
                                       [&](const Function& f) { return f.name == name; });
    if (function == std::end(functions)) {
      fail(fmt::format("there is no function {}; known are {}", name, all_names()));
      return {};
    }
    if (arguments.size() < function->least || arguments.size() > function->most) {
      fail(fmt::format("{} has {} {}, expected {}{}", name, arguments.size(),
                       arguments.size() == 1 ? "argument" : "arguments", function->least,
                       function->most > function->least ? " or more" : ""));
      return {};
    }
    const bool all_whole =
        std::all_of(arguments.begin(), arguments.end(), [](const Number& n) { return n.is_whole; });
    const bool whole =
        whole_ == WholeNumbers::Exact &&
        (function->whole == Whole::Always || (function->whole == Whole::IfArguments && all_whole));
    return checked(function->value(arguments), whole, name);
  }

  static std::string all_names() {
    std::string names;
    for (const Function& function : functions)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", function.name);
    return names;
  }

  std::string_view text_;
  const FindParameter& find_;
  WholeNumbers whole_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::string fault_;
};

}  // namespace

Evaluated evaluate(std::string_view expression, const FindParameter& find, WholeNumbers whole) {
  return Parser(expression, find, whole).run();
}

}  // namespace crumple::deck
