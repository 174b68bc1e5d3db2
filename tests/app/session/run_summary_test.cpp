// SPDX-License-Identifier: BSD-3-Clause
// What a run says of its model and its end: ties that hold less than asked for, elements that have failed.

#include <sstream>
#include <string>

#include "app/program_fixture.hpp"
#include "app/session/run_summary.hpp"
#include "output/checks.hpp"

namespace crumple::app::run_summary_test {
namespace {

class RunSummary : public ProgramTest {};

/// The edge of a shell on the face of a solid.
TEST_F(RunSummary, WarnsOfEdgesThatHangAsOnHinges) {
  const std::string parts =
      "*KEYWORD\n"
      "*CONTROL_TERMINATION\n"
      "1e-4\n"
      "*SECTION_SOLID\n"
      "1,1\n"
      "*SECTION_SHELL\n"
      "2,2\n"
      "0.05\n"
      "*MAT_ELASTIC\n"
      "1,7.85e-6,210,0.3\n"
      "*PART\n"
      "block\n"
      "1,1,1\n"
      "*PART\n"
      "strip\n"
      "2,2,1\n"
      "*NODE\n"
      "1,0,0,0\n"
      "2,1,0,0\n"
      "3,1,1,0\n"
      "4,0,1,0\n"
      "5,0,0,1\n"
      "6,1,0,1\n"
      "7,1,1,1\n"
      "8,0,1,1\n"
      "11,1,0.2,0.5\n"
      "12,1,0.8,0.5\n"
      "13,2,0.8,0.5\n"
      "14,2,0.2,0.5\n"
      "*ELEMENT_SOLID\n"
      "1,1,1,2,3,4,5,6,7,8\n"
      "*ELEMENT_SHELL\n"
      "2,2,11,12,13,14\n"
      "*SET_NODE_LIST\n"
      "1\n"
      "11,12\n";
  const auto warnings = [&](const std::string& form) {
    const Result check = run(
        {"check", write("edge.k", parts + "*CONTACT_TIED_SHELL_EDGE_TO_" + form + "\n1,1,4,3\n\n\n*END\n")});
    EXPECT_EQ(check.code, ExitCode::Normal) << check.err;
    return check.err;
  };
  const std::string hinge = "2 nodes are free to turn, as on a hinge";
  EXPECT_NE(warnings("SURFACE").find(hinge), std::string::npos);
  EXPECT_NE(warnings("SURFACE_BEAM_OFFSET").find(hinge), std::string::npos);
  EXPECT_EQ(warnings("SOLID").find("free to turn"), std::string::npos);
}

/// One of two welds is pulled beyond its strength: the summary has its number.
TEST_F(RunSummary, NamesWeldsThatHaveFailed) {
  const std::string deck = write("welds.k",
                                 "*KEYWORD\n"
                                 "*CONTROL_TERMINATION\n"
                                 "0.01\n"
                                 "*SECTION_BEAM\n"
                                 "3,9,1.0,0,1\n"
                                 "6,6,0,0\n"
                                 "*MAT_SPOTWELD\n"
                                 "4,7.85e-6,210,0.3,4,1,0,0\n"
                                 "0,2,1.5,1.5,0,0,0\n"
                                 "*PART\n"
                                 "weld\n"
                                 "3,3,4\n"
                                 "*NODE\n"
                                 "1,0,0,0\n"
                                 "2,2,0,0\n"
                                 "3,0,2,0\n"
                                 "4,2,2,0\n"
                                 "*ELEMENT_BEAM\n"
                                 "71,3,1,2\n"
                                 "73,3,3,4\n"
                                 "*BOUNDARY_SPC_NODE\n"
                                 "1,0,1,1,1,1,1,1\n"
                                 "3,0,1,1,1,1,1,1\n"
                                 "4,0,1,1,1,1,1,1\n"
                                 "2,0,0,1,1,1,1,1\n"
                                 "*DEFINE_CURVE\n"
                                 "1\n"
                                 "0,1\n"
                                 "1,1\n"
                                 "*BOUNDARY_PRESCRIBED_MOTION_NODE\n"
                                 "2,1,0,1,0.5\n"
                                 "*END\n");
  const Result result = run({"run", deck, "-o", path("out")});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  const std::size_t table = result.out.find("Eroded elements");
  ASSERT_NE(table, std::string::npos) << result.out;
  EXPECT_NE(result.out.find("1 of 2 beams, with the energy", table), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("    beams 71\n", table), std::string::npos) << result.out;
}

/// 1.0002 rounds to the limit.
TEST_F(RunSummary, ShowsWithEnoughDigitsWhatIsBeyondALimit) {
  output::Check check;
  check.name = "deepest";
  check.value = 1.0002;
  check.limit = 1;
  check.pass = false;
  std::ostringstream warning;
  print_failed_checks(warning, {check});
  EXPECT_EQ(warning.str(), "warning: check failed: deepest is 1.0002, limit 1\n");
  check.value = 1.23456;
  warning.str("");
  print_failed_checks(warning, {check});
  EXPECT_EQ(warning.str(), "warning: check failed: deepest is 1.235, limit 1\n");
}

}  // namespace
}  // namespace crumple::app::run_summary_test
