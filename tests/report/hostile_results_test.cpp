// SPDX-License-Identifier: BSD-3-Clause
// Results that somebody else has made or changed, to the survey of a run, which reads all of their frames.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "output/paraview/vtu_file.hpp"
#include "report/payload.hpp"
#include "report/run_survey.hpp"

namespace crumple::report::hostile_results_test {
namespace {

namespace fs = std::filesystem;

/// One triangle, or what is put in its place.
struct Triangle {
  int points = 3;
  int cells = 1;
  int position_components = 3;
  std::vector<float> position{0, 0, 0, 1, 0, 0, 0, 2, 0};
  std::vector<std::int32_t> connectivity{0, 1, 2};
  std::vector<std::int32_t> offsets{3};
  std::vector<std::uint8_t> types{5};
  int velocity_components = 3;
  std::vector<float> velocity{1, 0, 0, 0, 1, 0, 0, 0, 1};
  int alive_components = 1;
  std::vector<std::uint8_t> alive{1};

  std::string text() const {
    output::VtuPacker packer;
    const auto position_array = packer.array<float>("position", position_components, position);
    const auto connectivity_array = packer.array<std::int32_t>("connectivity", 1, connectivity);
    const auto offset_array = packer.array<std::int32_t>("offsets", 1, offsets);
    const auto type_array = packer.array<std::uint8_t>("types", 1, types);
    const auto velocity_array = packer.array<float>("velocity", velocity_components, velocity);
    const std::vector<std::int32_t> id(static_cast<std::size_t>(points), 7);
    const auto node_id = packer.array<std::int32_t>("node_id", 1, id);
    const auto alive_array = packer.array<std::uint8_t>("alive", alive_components, alive);
    const std::vector<std::int32_t> one(static_cast<std::size_t>(cells), 1);
    const auto part = packer.array<std::int32_t>("part", 1, one);
    const auto element = packer.array<std::int32_t>("element_id", 1, one);
    output::VtuGrid grid;
    grid.points = points;
    grid.cells = cells;
    grid.positions = {&position_array};
    grid.topology = {&connectivity_array, &offset_array, &type_array};
    grid.point_data = {&node_id, &velocity_array};
    grid.cell_data = {&part, &element, &alive_array};
    return output::vtu_text(grid);
  }
};

class HostileResults : public testing::Test {
 public:
  ~HostileResults() override { fs::remove_all(folder_); }

 protected:
  HostileResults() { fs::create_directories(folder_); }

  /// What is said to a run of two frames; empty if it is read.
  std::string complaint(const std::string& first, const std::string& second) const {
    std::ofstream(folder_ / "a.vtu", std::ios::binary) << first;
    std::ofstream(folder_ / "b.vtu", std::ios::binary) << second;
    ResultFolder results;
    results.folder = folder_;
    results.frames = {{0.0, folder_ / "a.vtu", {}}, {1.0, folder_ / "b.vtu", {}}};
    const Progress quiet = [](const std::string&, std::size_t, std::size_t) {};
    try {
      const RunSurvey survey = survey_run(results, quiet);
      EXPECT_FALSE(make_payload(results, survey, quiet).empty());
    } catch (const Error& fault) {
      return fault.what();
    }
    return {};
  }
  /// The same for a change of the second frame, and then of both.
  void expect_refused(const Triangle& changed, const std::string& reason) const {
    EXPECT_NE(complaint(Triangle().text(), changed.text()).find(reason), std::string::npos)
        << complaint(Triangle().text(), changed.text());
    EXPECT_NE(complaint(changed.text(), changed.text()), "");
  }

  fs::path folder_ = fs::temp_directory_path() / ("crumple_hostile_" + std::to_string(getpid()));
};

TEST_F(HostileResults, AreReadAsTheyAreOtherwise) {
  EXPECT_EQ(complaint(Triangle().text(), Triangle().text()), "");
}

TEST_F(HostileResults, WithPositionsOfOneComponent) {
  Triangle changed;
  changed.position_components = 1;
  changed.position = {0, 1, 2};
  expect_refused(changed, "position has 1 components, expected 3");
}

TEST_F(HostileResults, WithLaterFieldsOfAnotherForm) {
  Triangle changed;
  changed.velocity_components = 1;
  changed.velocity = {0, 1, 2};
  EXPECT_NE(complaint(Triangle().text(), changed.text()).find("velocity has 1 components"),
            std::string::npos);
  changed = {};
  changed.alive_components = 3;
  changed.alive = {1, 1, 1};
  EXPECT_NE(complaint(Triangle().text(), changed.text()).find("alive has more than one"), std::string::npos);
}

TEST_F(HostileResults, WithNodesAndCellsThatDoNotExist) {
  for (const std::int32_t node : {-1, 3, 2147483647}) {
    Triangle changed;
    changed.connectivity = {0, 1, node};
    EXPECT_NE(complaint(changed.text(), changed.text()).find("which does not exist"), std::string::npos);
  }
  Triangle changed;
  changed.offsets = {3, 6};
  EXPECT_NE(complaint(changed.text(), changed.text()).find("offsets has 2 numbers for 1"), std::string::npos);
  changed = {};
  changed.offsets = {-3};
  EXPECT_NE(complaint(changed.text(), changed.text()), "");
  changed = {};
  changed.types = {200};
  EXPECT_NE(complaint(changed.text(), changed.text()), "");
}

TEST_F(HostileResults, WithMorePointsThanTheFileCanHold) {
  std::string text = Triangle().text();
  const std::string points = "NumberOfPoints=\"3\"";
  text.replace(text.find(points), points.size(), "NumberOfPoints=\"2000000000\"");
  EXPECT_NE(complaint(text, text).find("too short for its points"), std::string::npos);
}

TEST_F(HostileResults, WithDevicesAndPipesInPlaceOfFrames) {
  ResultFolder results;
  results.frames = {{0.0, "/dev/zero", {}}};
  const Progress quiet = [](const std::string&, std::size_t, std::size_t) {};
  EXPECT_THROW(survey_run(results, quiet), Error);
}

/// For each mark of three million, the end of a tag used to be looked for behind all of them.
TEST_F(HostileResults, TakeLinearTime) {
  const std::string text = Triangle().text();
  const std::size_t head = text.find('>');
  EXPECT_EQ(complaint(std::string(3000000, '<') + text.substr(head), text), "");
}

}  // namespace
}  // namespace crumple::report::hostile_results_test
