// SPDX-License-Identifier: BSD-3-Clause
// *PARAMETER_EXPRESSION.
#include "deck/format/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::expression_test {
namespace {

/// With the parameters LENGTH = 2.5 (real) and COUNT = 7 (whole).
Evaluated evaluated(const std::string& text) {
  return evaluate(text, [](std::string_view name) -> std::optional<Number> {
    if (name == "LENGTH") return Number{2.5, false};
    if (name == "COUNT") return Number{7, true};
    return std::nullopt;
  });
}

double value(const std::string& text) {
  const Evaluated result = evaluated(text);
  EXPECT_EQ(result.fault, "") << text;
  return result.number.value;
}

std::string fault(const std::string& text) {
  return evaluated(text).fault;
}

TEST(Expression, PrecedenceIsFortrans) {
  EXPECT_EQ(value("1+2*3"), 7);
  EXPECT_EQ(value("(1+2)*3"), 9);
  EXPECT_EQ(value("10-4-3"), 3);
  EXPECT_EQ(value("12/3/2"), 2);
  EXPECT_EQ(value("2**3**2"), 512);
  EXPECT_EQ(value("-2**2"), -4);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("2.**-1"), 0.5);
  EXPECT_EQ(value(" 2 * ( 3 + 4 ) "), 14);
  EXPECT_EQ(value("+5"), 5);
  EXPECT_EQ(value("2**.5*2"), std::pow(2, 0.5) * 2);
}

TEST(Expression, Numbers) {
  EXPECT_EQ(value("1.5e3"), 1500);
  EXPECT_EQ(value("1.5d-3"), 1.5e-3);
  EXPECT_EQ(value(".25"), 0.25);
  EXPECT_EQ(value("1e3+1"), 1001);
  EXPECT_EQ(value("2.+3"), 5);
}

TEST(Expression, ParametersWithAndWithoutMark) {
  EXPECT_EQ(value("&length*2"), 5);
  EXPECT_EQ(value("Length*2+count"), 12);
  EXPECT_EQ(value("-&length"), -2.5);
  EXPECT_EQ(value("3-&COUNT"), -4);
}

TEST(Expression, WholeNumbersStayWholeAsLongAsAllAre) {
  EXPECT_TRUE(evaluated("2*count+1").number.is_whole);
  EXPECT_TRUE(evaluated("int(2.7)+max(1,2)").number.is_whole);
  EXPECT_FALSE(evaluated("2.*count").number.is_whole);
  EXPECT_FALSE(evaluated("float(2)").number.is_whole);
  EXPECT_FALSE(evaluated("2**(-1)").number.is_whole);
}

TEST(Expression, Functions) {
  EXPECT_EQ(value("abs(-3.5)"), 3.5);
  EXPECT_EQ(value("int(-2.7)"), -2);
  EXPECT_EQ(value("aint(2.7)"), 2);
  EXPECT_EQ(value("nint(2.5)"), 3);
  EXPECT_EQ(value("anint(-2.5)"), -3);
  EXPECT_EQ(value("min(3,1.5,2)"), 1.5);
  EXPECT_EQ(value("MAX(3,1.5,2)"), 3);
  EXPECT_EQ(value("mod(-7,3)"), -1);
  EXPECT_EQ(value("sign(3,-0.5)"), -3);
  EXPECT_EQ(value("sqrt(16.)"), 4);
  EXPECT_EQ(value("log10(1000.)"), 3);
  EXPECT_DOUBLE_EQ(value("log(exp(2.5))"), 2.5);
  EXPECT_DOUBLE_EQ(value("4*atan(1.)"), 3.14159265358979324);
  EXPECT_DOUBLE_EQ(value("atan2(-1.,-1.)"), -3 * 3.14159265358979324 / 4);
  EXPECT_NEAR(value("sin(3.14159265358979324)"), 0, 1e-15);
  EXPECT_DOUBLE_EQ(value("cos(acos(.3))"), 0.3);
  EXPECT_DOUBLE_EQ(value("tan(.4)*ctn(.4)"), 1);
  EXPECT_DOUBLE_EQ(value("sec(.4)*cos(.4)+csc(.4)*sin(.4)"), 2);
  EXPECT_DOUBLE_EQ(value("cosh(.7)**2-sinh(.7)**2"), 1);
  EXPECT_DOUBLE_EQ(value("tanh(atanh(.2))+asinh(sinh(.3))+acosh(cosh(.4))+sin(asin(.5))"), 1.4);
}

TEST(Expression, FaultsSayWhatIsWrong) {
  EXPECT_EQ(fault("5/2"), "5 / 2 are whole numbers and the quotient is not; write 5. / 2 or int(5. / 2)");
  EXPECT_EQ(fault("count/2"), "7 / 2 are whole numbers and the quotient is not; write 7. / 2 or int(7. / 2)");
  EXPECT_EQ(fault("6/2"), "");
  EXPECT_EQ(fault("1./(2.-2)"), "there is a division by zero");
  EXPECT_EQ(fault("(1+2"), "a closing parenthesis is missing");
  EXPECT_EQ(fault("1+2)"), "\")\" stands where an operator or the end is expected");
  EXPECT_EQ(fault("1+"), "a value is missing at its end");
  EXPECT_EQ(fault(""), "a value is missing at its end");
  EXPECT_EQ(fault("2*/3"), "\"/\" stands where a value is expected");
  EXPECT_EQ(fault("2 3"), "\"3\" stands where an operator or the end is expected");
  EXPECT_EQ(fault("width*2"), "the parameter WIDTH is not defined before this line");
  EXPECT_EQ(fault("&sin(2)"), "the parameter SIN is not defined before this line");
  EXPECT_EQ(fault("sqrt(-1.)"), "SQRT has no finite value");
  EXPECT_EQ(fault("sqrt(1,2)"), "SQRT has 2 arguments, expected 1");
  EXPECT_EQ(fault("max(1)"), "MAX has 1 argument, expected 2 or more");
  EXPECT_EQ(fault("exp(1000)"), "EXP has no finite value");
  EXPECT_EQ(fault("10.**400"), "a power has no finite value");
  EXPECT_EQ(fault("1.2.3"), "\".\" stands where an operator or the end is expected");
  EXPECT_EQ(fault(".").find("\".\" is not a number"), 0U);
  EXPECT_EQ(fault("gamma(2)").find("there is no function GAMMA; known are ABS, ACOS"), 0U);
}

TEST(Expression, DeepNestingIsAFaultAndNoCrash) {
  EXPECT_EQ(fault(std::string(100000, '(')), "it is nested too deeply");
  EXPECT_EQ(fault(std::string(100000, '-') + "1"), "it is nested too deeply");
  EXPECT_EQ(value(std::string(50, '(') + "1" + std::string(50, ')')), 1);
}

TEST(ParameterExpression, DefinesWhatFieldsTake) {
  SmallDeck deck;
  deck.keyword +=
      "*PARAMETER\nR side           2.0I n                3\n"
      "*PARAMETER_EXPRESSION\n"
      "R thick   side/20.\n"
      "R modulus max(100.0,&side*\n"
      "          103.5)\n"
      "I points  n+2\n"
      "rminus,-3.e-1\n";
  deck.section = "*SECTION_SHELL\n         1         2             &points\n    &thick\n";
  deck.material = "*MAT_ELASTIC\n1,7.83E-6,&modulus,-&minus\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.shell_sections.at(0).thickness[0], 0.1);
  EXPECT_EQ(model.shell_sections.at(0).thickness_points, 5);
  EXPECT_EQ(std::get<model::Elastic>(model.materials.at(0).law).youngs_modulus, 207.0);
  EXPECT_EQ(std::get<model::Elastic>(model.materials.at(0).law).poissons_ratio, 0.3);
}

TEST(Parameter, TheCommandLineGoesBeforeTheDeck) {
  SmallDeck deck;
  deck.section = "*PARAMETER\nr    thick       0.5\n*SECTION_SHELL\n         1         2\n    &thick\n";
  ReadOptions options;
  options.parameters = {{"Thick", "0.75"}};
  const ReadResult result = read_deck_text(deck.text(), options);
  ASSERT_TRUE(result.model.has_value()) << listed(result.diagnostics);
  EXPECT_EQ(result.model->shell_sections[0].thickness[0], 0.75);
  EXPECT_NE(listed(result.diagnostics).find("parameter THICK is \"0.75\" by the command line, not \"0.5\""),
            std::string::npos)
      << listed(result.diagnostics);
}

/// The errors of a deck of which SECTION uses parameters, with those of the command line.
std::string errors_with(const std::string& section,
                        std::vector<std::pair<std::string, std::string>> parameters) {
  SmallDeck deck;
  deck.section = section;
  ReadOptions options;
  options.parameters = std::move(parameters);
  const ReadResult result = read_deck_text(deck.text(), options);
  EXPECT_EQ(result.model.has_value(), error_count(result.diagnostics) == 0);
  std::string errors;
  for (const Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.severity == Severity::Error) errors += diagnostic.message + "\n";
  return errors;
}

TEST(Parameter, OfTheCommandLineMustBeInTheDeck) {
  const std::string section = "*PARAMETER\nr thick, 0.5, r width, 3\n*SECTION_SHELL\n1,2\n&thick\n";
  EXPECT_EQ(errors_with(section, {{"thickk", "0.75"}}),
            "parameter THICKK of the command line is not in the deck; did you mean THICK?\n");
  EXPECT_EQ(errors_with(section, {{"velocity", "1"}}),
            "parameter VELOCITY of the command line is not in the deck; it has others\n");
  EXPECT_EQ(errors_with("*SECTION_SHELL\n1,2\n1.0\n", {{"velocity", "1"}}),
            "parameter VELOCITY of the command line is not in the deck; it has no parameters\n");
  // The deck refers to what it does not define, and the command line mistypes it.
  EXPECT_NE(errors_with("*SECTION_SHELL\n1,2\n&thick\n", {{"thik", "1"}}).find("did you mean THICK?"),
            std::string::npos);
}

TEST(Parameter, OfTheCommandLineMustBeUsed) {
  const std::string section = "*PARAMETER\nr thick, 0.5, r width, 3\n*SECTION_SHELL\n1,2\n&thick\n";
  EXPECT_EQ(errors_with(section, {{"width", "0.75"}}),
            "parameter WIDTH of the command line has no effect: the deck sets it, but never uses &WIDTH\n");
  // By another parameter, in an expression, in what is left out.
  for (const std::string use :
       {"*PARAMETER\nr other, -&width\n", "*PARAMETER_EXPRESSION\nr other, 2*width\n"})
    EXPECT_EQ(errors_with(section + use, {{"width", "0.75"}}), "") << use;
  EXPECT_EQ(errors_with(section + "*DATABASE_BINARY_D3PART\n&width\n", {{"width", "0.75"}}), "");
}

TEST(Parameter, HashesTellDecksWithOtherParametersApart) {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL\n1,2\n&thick\n";
  const auto hash = [&](const std::string& value) {
    ReadOptions options;
    options.parameters = {{"thick", value}};
    const ReadResult result = read_deck_text(deck.text(), options);
    EXPECT_EQ(result.parameters.size(), 1U);
    EXPECT_NE(hash_with_parameters(result), result.text_hash);
    return hash_with_parameters(result);
  };
  EXPECT_EQ(hash("0.5"), hash("0.5"));
  EXPECT_NE(hash("0.5"), hash("0.6"));
}

TEST(Parameter, TheCommandLineIsEnough) {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL\n         1         2\n    &thick\n";
  ReadOptions options;
  options.parameters = {{"thick", "0.75"}};
  EXPECT_EQ(read_clean(deck.text(), options).shell_sections[0].thickness[0], 0.75);
}

}  // namespace
}  // namespace crumple::deck::test::expression_test
