// SPDX-License-Identifier: BSD-3-Clause
// ERODE of *CONTROL_TIMESTEP: solids whose step falls below DTMIN times the first one go, others end the run.
#include <algorithm>

#include "app/program_fixture.hpp"
#include "deck/small_deck.hpp"

namespace crumple::app::short_solids_test {
namespace {

/// Two cubes, one on the other, of which the upper one is pressed down to a tenth of its height by its upper
/// nodes: its step falls with its height, as there is no bulk viscosity. In t, mm, s.
deck::test::CubeDeck pressed(const std::string& erode) {
  deck::test::CubeDeck deck;
  deck.termination =
      "*CONTROL_TERMINATION\n1e-3,10000000,0.5\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,0," + erode + "\n";
  deck.material = "*MAT_PLASTIC_KINEMATIC\n1,1e-9,100.0,0.0,0.1,0.0\n";
  deck.nodes +=
      "       9             0.0             0.0             2.0\n"
      "      10             1.0             0.0             2.0\n"
      "      11             1.0             1.0             2.0\n"
      "      12             0.0             1.0             2.0\n";
  deck.shells += "      22       1       5       6       7       8       9      10      11      12\n";
  deck.more =
      "*SET_NODE_LIST\n1\n1,2,3,4,5,6,7,8\n*SET_NODE_LIST\n2\n9,10,11,12\n*BOUNDARY_SPC_SET\n1,0,1,1,1\n"
      "2,0,1,1\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,3,0,1,-900.0\n*DEFINE_CURVE\n1\n0,1\n1,1\n"
      "*DATABASE_GLSTAT\n1e-5\n*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n";
  return deck;
}

class ShortSolids : public ProgramTest {};

TEST_F(ShortSolids, EndTheRunWithoutErode) {
  const Result result = run({"run", write("deck.k", pressed("0").text()), "-o", path("out")});
  EXPECT_EQ(result.code, ExitCode::Numerical);
  EXPECT_NE(result.err.find("fell below DTMIN times the first step"), std::string::npos) << result.err;
}

TEST_F(ShortSolids, GoWithErodeAndTheRunGoesOn) {
  for (const char* precision : {"mixed", "double"}) {
    const Result result =
        run({"run", write("deck.k", pressed("1").text()), "-o", path(precision), "--precision", precision});
    ASSERT_EQ(result.code, ExitCode::Normal) << result.out << result.err;
    EXPECT_NE(result.out.find("termination time reached"), std::string::npos);
    // It goes at half of its height, at 0.5 / 900; its step is then that of the lower cube again.
    const auto rows = table(std::string(precision) + "/glstat.csv");
    const std::size_t column =
        static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), "eroded") - rows[0].begin());
    ASSERT_LT(column, rows[0].size());
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const double time = std::stod(rows[i][0]);
      const double eroded = std::stod(rows[i][column]);
      if (time < 0.54e-3) {
        EXPECT_EQ(eroded, 0) << time;
      } else if (time > 0.57e-3) {
        EXPECT_GT(eroded, 0) << time;
      }
    }
    EXPECT_LT(record(precision)["energy"]["error"], 1e-2);
  }
}

/// Without DTMIN a run goes on however short its steps, and says by what.
TEST_F(ShortSolids, AreNamedOnceWhereNothingEndsTheRun) {
  deck::test::CubeDeck deck = pressed("0");
  deck.termination = "*CONTROL_TERMINATION\n1.103e-3\n*CONTROL_TIMESTEP\n0,0.9\n";
  const Result result = run({"run", write("deck.k", deck.text()), "-o", path("out")});
  const std::string note = "note: the stable step has fallen from ";
  const std::size_t place = result.out.find(note);
  ASSERT_NE(place, std::string::npos) << result.out << result.err;
  EXPECT_NE(result.out.find("by solid 22 of part 1; DTMIN", place), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find(note, place + 1), std::string::npos);
  // At a hundredth of the height, 0.99 / 900.
  EXPECT_NE(result.out.find("at time 0.0011 ", place), std::string::npos) << result.out;
}

/// A shell on the cube is pressed as well: it stays, and its step ends the run.
TEST_F(ShortSolids, LeaveTheEndToOtherElements) {
  deck::test::CubeDeck deck = pressed("1");
  deck.part += "*PART\nskin\n2,2,1\n";
  deck.section += "*SECTION_SHELL\n2,2\n0.1\n";
  deck.shells += "*ELEMENT_SHELL\n31,2,5,6,10,9\n";
  const Result result = run({"run", write("deck.k", deck.text()), "-o", path("out")});
  EXPECT_EQ(result.code, ExitCode::Numerical);
  EXPECT_NE(result.err.find("fell below DTMIN times the first step"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace crumple::app::short_solids_test
