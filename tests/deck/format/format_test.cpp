// SPDX-License-Identifier: BSD-3-Clause
// Every form in which the same deck may be written gives the same model.
#include "deck/small_deck.hpp"

namespace crumple::deck::test::format_test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// The numbers of the small deck, whatever form it was read from.
void expect_small_deck(const model::Model& model) {
  ASSERT_EQ(model.nodes.count(), 6);
  EXPECT_EQ(model.nodes.id, (std::vector<UserId>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(model.nodes.position[5], (std::array<double, 3>{2, 1, 0}));
  ASSERT_EQ(model.shells.size(), 2U);
  EXPECT_EQ(model.shells[1].id, 12);
  EXPECT_EQ(model.shells[1].part, 0);
  EXPECT_EQ(model.shells[1].node, (std::array<Index, 4>{1, 4, 5, 2}));
  ASSERT_EQ(model.parts.size(), 1U);
  EXPECT_EQ(model.parts[0].title, "plate");
  ASSERT_EQ(model.shell_sections.size(), 1U);
  EXPECT_EQ(model.shell_sections[0].thickness, (std::array<double, 4>{0.1, 0.1, 0.1, 0.1}));
  ASSERT_EQ(model.materials.size(), 1U);
  EXPECT_EQ(model.materials[0].density, 7.83e-6);
  EXPECT_EQ(std::get<model::Elastic>(model.materials[0].law).youngs_modulus, 207.0);
  EXPECT_EQ(model.control.end_time, 2.5);
}

TEST(Format, FixedColumns) {
  expect_small_deck(read_clean(SmallDeck().text()));
}

TEST(Format, CommaSeparated) {
  expect_small_deck(read_clean(
      "*KEYWORD\n*CONTROL_TERMINATION\n2.5,0\n*NODE\n1,0,0,0\n2,1.,0,0\n3,1,1,0\n 4 , 0 , 1 , 0 "
      "\n5,2,0,0,0,0\n6,2,1\n"
      "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,1,2,5,6,3\n*PART\nplate\n1,1,1\n*SECTION_SHELL\n1,2,,\n0.1,,,\n"
      "*MAT_ELASTIC\n1,7.83E-6,207,0.3\n*END\n"));
}

TEST(Format, CommasAndColumnsInOneKeyword) {
  SmallDeck deck;
  deck.nodes = replaced(deck.nodes, "       2             1.0             0.0             0.0", "2,1.0,0,0");
  expect_small_deck(read_clean(deck.text()));
}

TEST(Format, TenDigitIds) {
  SmallDeck deck;
  deck.keyword = "*KEYWORD I10=Y\n";
  deck.nodes = replaced(deck.nodes, "\n       ", "\n         ");
  deck.shells =
      "*ELEMENT_SHELL\n"
      "        11         1         1         2         3         4\n"
      "        12         1         2         5         6         3\n";
  expect_small_deck(read_clean(deck.text()));
}

TEST(Format, TenDigitMarkOfOneKeyword) {
  SmallDeck deck;
  deck.nodes = replaced(replaced(deck.nodes, "\n       ", "\n         "), "*NODE", "*NODE %");
  expect_small_deck(read_clean(deck.text()));
}

const std::string long_nodes =
    "                   1                 0.0                 0.0                 0.0\n"
    "                   2                 1.0                 0.0                 0.0\n"
    "                   3                 1.0                 1.0                 0.0\n"
    "                   4                 0.0                 1.0                 0.0\n"
    "                   5                 2.0                 0.0                 0.0\n"
    "                   6                 2.0                 1.0                 0.0\n";

TEST(Format, LongMarkOfOneKeyword) {
  for (const char* name : {"*NODE+\n", "*NODE +\n"}) {
    SmallDeck deck;
    deck.nodes = name + long_nodes;
    expect_small_deck(read_clean(deck.text()));
  }
}

TEST(Format, LongForAllAndStandardForOne) {
  for (const char* option : {"LONG=Y", "LONG=K", "long=y"}) {
    SmallDeck deck;
    deck.keyword = std::string("*KEYWORD ") + option + "\n";
    deck.nodes = "*NODE\n" + long_nodes;
    deck.termination = "*CONTROL_TERMINATION\n                 2.5                   0\n";
    deck.shells = replaced(deck.shells, "*ELEMENT_SHELL", "*ELEMENT_SHELL-");
    deck.part = replaced(deck.part, "*PART", "*PART -");
    deck.section = "*SECTION_SHELL\n                   1                   2\n                 0.1\n";
    deck.material =
        "*MAT_ELASTIC\n                   1             7.83E-6               207.0                 0.3\n";
    expect_small_deck(read_clean(deck.text()));
  }
}

TEST(Format, LongSIsStandard) {
  SmallDeck deck;
  deck.keyword = "*KEYWORD LONG=S\n";
  expect_small_deck(read_clean(deck.text()));
}

TEST(Format, LineEnds) {
  const std::string text = SmallDeck().text();
  expect_small_deck(read_clean(replaced(text, "\n", "\r\n")));
  expect_small_deck(read_clean(replaced(text, "\n", "\r")));
  expect_small_deck(read_clean(replaced(text, "\n", "   \n")));
}

TEST(Format, NoFinalNewlineAndNoEnd) {
  SmallDeck deck;
  deck.end.clear();
  deck.material.pop_back();
  expect_small_deck(read_clean(deck.text()));
}

TEST(Format, ByteOrderMarkAndControlZ) {
  expect_small_deck(read_clean("\xef\xbb\xbf" + SmallDeck().text() + "\x1a"));
}

TEST(Format, Tabs) {
  SmallDeck deck;
  deck.nodes = replaced(deck.nodes, "             ", "\t     ");
  expect_small_deck(read_clean(deck.text()));
  deck.shells = "*ELEMENT_SHELL\n\t11,\t1,1,2,3,4\n12,1,2,5,6,\t3\n";
  expect_small_deck(read_clean(deck.text()));
}

TEST(Format, KeywordCaseAndRemarks) {
  SmallDeck deck;
  deck.keyword = "*keyword  $ written by hand\n$ a comment\n$# another\n";
  deck.nodes = replaced(deck.nodes, "*NODE", "*Node   ");
  deck.shells = replaced(deck.shells, "*ELEMENT_SHELL", "*element_SHELL (four nodes format)");
  expect_small_deck(read_clean(deck.text()));
}

TEST(Format, CommentsAndBlankLinesAmongData) {
  SmallDeck deck;
  deck.nodes = replaced(deck.nodes, "       3  ", "$ here\n\n       3  ") + "\n\n";
  expect_small_deck(read_clean(deck.text()));
}

TEST(Format, FortranNumbers) {
  SmallDeck deck;
  deck.material = "*MAT_ELASTIC\n         1   7.83d-6    2.07+2      .3D0\n";
  expect_small_deck(read_clean(deck.text()));
}

TEST(Format, IntegersWithDecimalPoint) {
  SmallDeck deck;
  deck.part = "*PART\nplate\n1.,1.0,1.0E0,0.000E+00\n";
  expect_small_deck(read_clean(deck.text()));
}

TEST(Format, TextBehindEndIsNotRead) {
  expect_small_deck(read_clean(SmallDeck().text() + "*NONSENSE\nnothing\n"));
}

TEST(Format, RemarksBehindColumn80) {
  SmallDeck deck;
  deck.section =
      "*SECTION_SHELL\n         1         2                                                            here\n"
      "       0.1\n";
  expect_small_deck(read_clean(deck.text()));
}

TEST(Include, BesideAndNested) {
  SmallDeck deck;
  const std::map<std::string, std::string> files = {
      {"mesh.k", "*KEYWORD\n*INCLUDE\nnodes.k\n" + deck.shells + "*END\nnot read\n"},
      {"nodes.k", deck.nodes}};
  deck.nodes = "*INCLUDE\n$ the mesh\nmesh.k\n";
  deck.shells.clear();
  const ReadResult result = read_deck_text(deck.text(), {}, files);
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  expect_small_deck(*result.model);
  EXPECT_EQ(result.files.size(), 3U);
}

TEST(Include, SeveralNamesAndContinuedName) {
  SmallDeck deck;
  const std::map<std::string, std::string> files = {{"nodes.k", deck.nodes}, {"a/long/name.k", deck.shells}};
  deck.nodes = "*INCLUDE\nnodes.k\na/long +\n/name.k\n";
  deck.shells.clear();
  expect_small_deck(read_clean(deck.text(), {}, files));
}

TEST(Include, FormatOfTheIncludedFileEndsWithIt) {
  SmallDeck deck;
  const std::map<std::string, std::string> files = {{"nodes.k", "*KEYWORD LONG=Y\n*NODE\n" + long_nodes}};
  deck.nodes = "*INCLUDE\nnodes.k\n";
  expect_small_deck(read_clean(deck.text(), {}, files));
}

TEST(Include, RelativeToTheIncludingFileOnDisk) {
  const ReadResult result = read_deck("tests/deck/good/include.k");
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  expect_small_deck(*result.model);
}

TEST(Hash, DependsOnTheTextAlone) {
  const std::string text = SmallDeck().text();
  const auto hash = [](const std::string& t) { return read_deck_text(t).text_hash; };
  EXPECT_EQ(hash(text), hash(text));
  EXPECT_NE(hash(text), hash(text + "\n"));
  // FNV-1a of "a", from the reference of Fowler, Noll and Vo.
  EXPECT_EQ(hash("a"), 0xaf63dc4c8601ec8cULL);
}

/// Some programs leave padding behind the end, which is not read.
TEST(End, BytesBehindItAreNotRead) {
  for (const std::string line : {"\n", "\r\n", "  \n"}) {
    SmallDeck deck;
    deck.end = "*end" + line + std::string("\0\1*END\n\x7f", 8);
    expect_small_deck(read_clean(deck.text()));
  }
  SmallDeck deck;
  deck.end = std::string("$ *END\n\0\n*END\n", 14);
  EXPECT_NE(listed(read_deck_text(deck.text()).diagnostics).find("this is not a text file"),
            std::string::npos);
}

TEST(Parameter, ReplacesFieldsOfAnyKind) {
  SmallDeck deck;
  deck.keyword +=
      "*PARAMETER\n"
      "R thick          0.1I count            5\n"
      "rMinus,-0.3,i sec,1\n"
      "R copy        &thick\n";
  deck.section = "*SECTION_SHELL\n      &SEC         2              &count\n     &copy    &THICK\n";
  deck.material = "*MAT_ELASTIC\n1,7.83E-6,207,-&minus\n";
  const model::Model model = read_clean(deck.text());
  expect_small_deck(model);
  EXPECT_EQ(model.shell_sections.at(0).thickness_points, 5);
  EXPECT_EQ(std::get<model::Elastic>(model.materials.at(0).law).poissons_ratio, 0.3);
}

TEST(Parameter, WholeRealMayStandForAnInteger) {
  SmallDeck deck;
  deck.keyword += "*PARAMETER\nRcount,3.0\n";
  deck.section = "*SECTION_SHELL\n         1         2              &count\n       0.1\n";
  EXPECT_EQ(read_clean(deck.text()).shell_sections.at(0).thickness_points, 3);
}

TEST(Parameter, MayHaveArithmeticBehindIt) {
  SmallDeck deck;
  deck.keyword += "*PARAMETER\nR thick,0.3\nI count,7\n";
  deck.section = "*SECTION_SHELL\n         1         2            &count-4\n&thick*0.5\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.shell_sections.at(0).thickness_points, 3);
  EXPECT_DOUBLE_EQ(model.shell_sections.at(0).thickness[0], 0.15);
  deck.section = "*SECTION_SHELL\n         1         2            &count-4\n&thin*0.5\n";
  expect_one(deck, "read \"&thin*0.5\", expected a parameter that is defined");
}

/// The section takes its thickness from `&thick` of the deck after the included file.
std::string with_parameters(const std::string& before) {
  SmallDeck deck;
  deck.keyword += before;
  deck.section = "*SECTION_SHELL\n         1         2\n    &thick\n";
  return deck.text();
}

double thickness_of(const std::string& before, const std::map<std::string, std::string>& files = {}) {
  const ReadResult result = read_deck_text(with_parameters(before), {}, files);
  EXPECT_TRUE(result.model) << listed(result.diagnostics);
  return result.model ? result.model->shell_sections.at(0).thickness[0] : 0;
}

TEST(Parameter, GlobalOnesGoBeyondTheirFile) {
  EXPECT_EQ(thickness_of("*INCLUDE\na.k\n", {{"a.k", "*PARAMETER\nR thick,0.5\n"}}), 0.5);
}

TEST(Parameter, LocalOnesEndWithTheirFile) {
  const std::map<std::string, std::string> files = {
      {"a.k",
       "*PARAMETER_LOCAL\nR thick,0.5\n*PARAMETER_EXPRESSION_LOCAL\nR half,&thick / 2\n*INCLUDE\nb.k\n"},
      {"b.k", "*PARAMETER\nR seen,&half\n"}};
  EXPECT_EQ(thickness_of("*PARAMETER\nR thick,0.2\n*INCLUDE\na.k\n", files), 0.2);
  EXPECT_EQ(thickness_of("*INCLUDE\na.k\n*PARAMETER\nR thick,&seen\n", files), 0.25);
  const ReadResult result = read_deck_text(with_parameters("*INCLUDE\na.k\n"), {}, files);
  EXPECT_NE(listed(result.diagnostics).find("expected a parameter that is defined"), std::string::npos);
}

TEST(Parameter, DuplicationSaysWhichValueHolds) {
  const std::string twice = "*PARAMETER\nR thick,0.2\n*PARAMETER\nR thick,0.4\n";
  EXPECT_EQ(thickness_of("*PARAMETER_DUPLICATION\n2\n" + twice), 0.4);
  EXPECT_EQ(thickness_of("*PARAMETER_DUPLICATION\n4\n" + twice), 0.4);
  EXPECT_EQ(thickness_of("*PARAMETER_DUPLICATION\n1\n" + twice), 0.2);
  EXPECT_EQ(thickness_of("*PARAMETER_DUPLICATION\n5\n" + twice), 0.2);
  EXPECT_EQ(thickness_of(twice), 0.2);
  EXPECT_FALSE(read_deck_text(with_parameters("*PARAMETER_DUPLICATION\n3\n" + twice)).model);
  EXPECT_EQ(thickness_of("*PARAMETER_DUPLICATION\n2\n*PARAMETER_DUPLICATION\n5\n" + twice), 0.4);
  const auto warned = [&](const std::string& flag) {
    const std::string before = flag.empty() ? "" : "*PARAMETER_DUPLICATION\n" + flag + "\n";
    const ReadResult result = read_deck_text(with_parameters(before + twice));
    return listed(result.diagnostics).find("is taken") != std::string::npos;
  };
  EXPECT_TRUE(warned(""));
  EXPECT_TRUE(warned("1"));
  EXPECT_TRUE(warned("2"));
  EXPECT_FALSE(warned("4"));
  EXPECT_FALSE(warned("5"));
}

TEST(Parameter, TheCommandLineGoesBeforeLocalOnes) {
  ReadOptions options;
  options.parameters = {{"thick", "0.7"}};
  const ReadResult result =
      read_deck_text(with_parameters("*PARAMETER_LOCAL\nR thick,0.2\n*PARAMETER_DUPLICATION\n4\n"), options);
  ASSERT_TRUE(result.model);
  EXPECT_EQ(result.model->shell_sections.at(0).thickness[0], 0.7);
}

}  // namespace
}  // namespace crumple::deck::test::format_test
