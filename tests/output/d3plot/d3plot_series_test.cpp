// SPDX-License-Identifier: BSD-3-Clause
#include "output/d3plot/d3plot_series.hpp"

#include <sys/resource.h>

#include <csignal>
#include <numbers>

#include "output/d3plot_reader.hpp"
#include "output/files/write_error.hpp"
#include "output/recorder.hpp"
#include "output/sample.hpp"

namespace crumple::output::d3plot_series_test {
namespace {

using Integers = std::vector<std::int32_t>;
using Reals = std::vector<float>;

class D3plotSeriesTest : public SampleTest {
 protected:
  void write_once() const {
    D3plotSeries series(folder_, view());
    series.write_state(view());
  }
  domain::ShellBlock& block_of(UserId id, Index& place) {
    for (domain::ShellBlock& block : domain_.shells)
      for (place = 0; place < block.elements; ++place)
        if (model_.shells[block.element[place]].id == id) return block;
    throw std::runtime_error("no such shell");
  }
  void set_stress(UserId id, Index layer, const std::array<double, 5>& stress) {
    Index place = 0;
    domain::ShellBlock& block = block_of(id, place);
    for (std::size_t i = 0; i < stress.size(); ++i)
      block.set_state(place, block.find("stress")->first + 5 * layer + static_cast<Index>(i), stress[i]);
  }
};

TEST_F(D3plotSeriesTest, ControlBlockIsTheOneThatOtherProgramsRead) {
  model_.title = "a title of more than forty characters, which is cut";
  write_once();
  const D3plotFile root(folder_ / "d3plot");
  EXPECT_EQ(root.text(0, 10), model_.title.substr(0, 40));
  EXPECT_EQ(root.integer(11), 1);
  EXPECT_EQ(root.text(13, 1), "R11");
  EXPECT_EQ(root.real(14), 960.0F);
  EXPECT_EQ(root.integers(15, 8), (Integers{4, 6, 6, 6 + 7 * 2, 0, 1, 1, 1}));
  EXPECT_EQ(root.integers(23, 5), (Integers{0, 0, 0, 0, 7}));
  EXPECT_EQ(root.integers(28, 6), (Integers{0, 0, 6, 3, 2, 33}));
  EXPECT_EQ(root.integers(34, 5), (Integers{0, 0, -10003, 0, 0}));
  EXPECT_EQ(root.integers(39, 4), (Integers{16 + 6 + 3 + 3 * 2, 0, 0, 21}));
  EXPECT_EQ(root.integers(43, 8), (Integers{1000, 1000, 1000, 1000, 0, 0, 0, 0}));
  EXPECT_EQ(root.integers(51, 13), (Integers{2, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST_F(D3plotSeriesTest, GeometryAndNumbersAreThoseOfTheDeck) {
  domain_.nodes.position[0].x += 1;
  write_once();
  const D3plotReader file(folder_);
  Reals expected;
  for (const auto& position : model_.nodes.position)
    for (const double x : position) expected.push_back(static_cast<float>(x));
  EXPECT_EQ(file.root.reals(file.node_section, 18), expected) << "at time zero";
  EXPECT_EQ(file.root.integers(file.shell_section, 15),
            (Integers{1, 2, 5, 4, 1, 2, 3, 6, 5, 1, 1, 2, 5, 5, 2}));
  EXPECT_EQ(file.root.integers(file.numbering_section, 16),
            (Integers{-1, 7, 7, 7, 10, 6, 0, 0, 3, 0, 10, 12, 14, 2, 0, 2}));
  EXPECT_EQ(file.numbers(0), (Integers{60, 50, 40, 30, 20, 10}));
  EXPECT_EQ(file.numbers(3), (Integers{99, 11, 5}));
  EXPECT_EQ(file.numbers(4), (Integers{3, 7}));
  EXPECT_EQ(file.numbers(5), (Integers{7, 3}));
  EXPECT_EQ(file.numbers(6), (Integers{2, 1}));
  const std::size_t titles = file.title_section;
  EXPECT_EQ(file.root.integers(titles, 3), (Integers{90001, 2, 7}));
  EXPECT_EQ(file.root.text(titles + 3, 18), model_.parts[0].title);
  EXPECT_EQ(file.root.integer(titles + 21), 3);
  EXPECT_EQ(file.root.text(titles + 22, 18), "second");
  EXPECT_EQ(file.root.integer(titles + 40), 90000);
  EXPECT_EQ(file.root.text(titles + 41, 18), model_.title);
  EXPECT_TRUE(file.root.ends(titles + 59));
}

TEST_F(D3plotSeriesTest, NodesAndEnergiesAreTheDomains) {
  const Index node = domain_.nodes.domain_node[4];
  domain_.nodes.position[node] += math::Vec3{0.25, 0.5, -1};
  domain_.nodes.velocity[node] = {1, 2, 3};
  domain_.nodes.acceleration[node] = {-4, 5, 1.0 / 3};
  domain_.energy.kinetic = 0.7;
  domain_.energy.internal = 1.1;
  domain_.energy.hourglass = 0.2;
  domain_.shells[0].internal_energy = 1.1;
  domain_.shells[0].hourglass_energy = 0.2;
  go_to(0.125, 9);
  write_once();
  const D3plotReader file(folder_);
  ASSERT_EQ(file.states.size(), 1U);
  const ReadState& state = file.states[0];
  EXPECT_EQ(state.time, 0.125F);
  EXPECT_EQ(ReadState::of(state.positions, 4, 3), (Reals{1.25F, 1.5F, -1}));
  EXPECT_EQ(ReadState::of(state.velocities, 4, 3), (Reals{1, 2, 3}));
  EXPECT_EQ(ReadState::of(state.accelerations, 4, 3), (Reals{-4, 5, 1.0F / 3}));
  EXPECT_EQ(Reals(state.globals.begin(), state.globals.begin() + 3), (Reals{0.7F, 1.1F, 2.0F}));
  const auto part = static_cast<std::size_t>(domain_.shells[0].part);
  const PartMasses masses(view());
  const PartMasses::Motion motion = masses.motion(domain_.nodes, 0);
  EXPECT_EQ(state.globals[6 + part], 1.1F);
  EXPECT_EQ(state.globals[6 + 2], static_cast<float>(motion.kinetic_energy));
  EXPECT_EQ(state.globals[6 + 4 + 2], static_cast<float>(motion.velocity.z));
  EXPECT_EQ(state.globals[6 + 10], static_cast<float>(motion.mass));
  EXPECT_EQ(state.globals[6 + 12 + part], 0.2F);
}

/// The squares lie in the plane of x and y with the axes of the model, so that their stresses are global.
TEST_F(D3plotSeriesTest, StressesOfTheLayersComeFromMiddleInnerAndOuterPoint) {
  set_stress(11, 0, {1, 2, 3, 4, 5});
  set_stress(11, 1, {6, 7, 8, 9, 10});
  set_stress(11, 2, {-11, 1.0 / 3, 13, 14, 15});
  Index place = 0;
  domain::ShellBlock& block = block_of(11, place);
  for (Index layer = 0; layer < 3; ++layer)
    block.set_state(place, block.find("plastic_strain")->first + layer, 0.125 * (layer + 1));
  block.set_state(place, block.find("active")->first, 0);
  write_once();
  const D3plotReader file(folder_);
  const Reals shell = ReadState::of(file.states.at(0).shells, 1, 33);
  EXPECT_EQ(ReadState::of(shell, 0, 7), (Reals{6, 7, 0, 8, 9, 10, 0.25F}));
  EXPECT_EQ(ReadState::of(shell, 1, 7), (Reals{1, 2, 0, 3, 4, 5, 0.125F}));
  EXPECT_EQ(ReadState::of(shell, 2, 7), (Reals{-11, 1.0F / 3, 0, 13, 14, 15, 0.375F}));
  EXPECT_EQ(ReadState::of(shell, 29, 1), (Reals{0.5F})) << "thickness";
  EXPECT_EQ(file.states[0].alive_shells, (Reals{1, 0, 2})) << "the number of the part, or 0";
}

/// Gauss's three points of a layer of thickness 0.5, at 0 and +- sqrt(3/5): a membrane stress of 8, a bending
/// stress of 3 at those points, a transverse shear of 6.
TEST_F(D3plotSeriesTest, ResultantsAreTheIntegralsOverTheThickness) {
  model_.shell_sections[0].shear_factor = 0.25;
  for (Index layer = 0; layer < 3; ++layer) set_stress(99, layer, {8, 3.0 * (layer - 1), 0, 0, 6});
  write_once();
  const Reals shell = ReadState::of(D3plotReader(folder_).states.at(0).shells, 0, 33);
  const Reals resultants(shell.begin() + 21, shell.begin() + 29);
  const double moment = 0.5 * 0.5 / 2 * 2 * (5.0 / 18) * std::sqrt(0.6) * 3;
  const Reals expected{0, static_cast<float>(moment), 0, 0.5F * 0.5F * 6, 0, 4, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(resultants[i], expected[i], 1e-6) << i;
}

/// A rotation of the whole plate turns the stresses and leaves what counts along the side of the element.
TEST_F(D3plotSeriesTest, StressesAreGlobalAndResultantsLocalWhenThePlateHasTurned) {
  for (const domain::ShellBlock& block : domain_.shells) ASSERT_EQ(block.find("frame"), nullptr);
  set_stress(99, 1, {1, 0, 0, 0, 0});
  const double c = std::cos(std::numbers::pi / 6);
  const double s = std::sin(std::numbers::pi / 6);
  for (math::Vec3& x : domain_.nodes.position) x = {c * x.x, x.y, s * x.x};
  write_once();
  const Reals shell = ReadState::of(D3plotReader(folder_).states.at(0).shells, 0, 33);
  const Reals expected{static_cast<float>(c * c), 0, static_cast<float>(s * s), 0, 0,
                       static_cast<float>(c * s)};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(shell[i], expected[i], 1e-7) << i;
  EXPECT_NEAR(shell[21 + 5], 0.5 * 4.0 / 9, 1e-7) << "Nx, of the middle point alone";
}

TEST_F(D3plotSeriesTest, AFamilyOfSmallFilesHoldsWholeStatesAndIsCompleteAfterEachOfThem) {
  constexpr std::size_t state_words = 1 + 20 + 54 + 3 * 34;
  D3plotSeries series(folder_, view(), 3 * state_words + 1);
  EXPECT_TRUE(D3plotReader(folder_).states.empty());
  for (int number = 0; number < 8; ++number) {
    go_to(0.5 * number, number);
    domain_.nodes.velocity[0] = {1.0 * number, 0, 0};
    series.write_state(view());
    const D3plotReader file(folder_);
    ASSERT_EQ(file.states.size(), static_cast<std::size_t>(number) + 1);
    for (std::size_t i = 0; i < file.states.size(); ++i) {
      EXPECT_EQ(file.states[i].time, 0.5F * static_cast<float>(i));
      EXPECT_EQ(file.states[i].velocities[3 * domain_.nodes.model_node[0]], static_cast<float>(i));
    }
  }
  EXPECT_EQ(D3plotReader(folder_).states_of_file, (std::vector<std::size_t>{3, 3, 2}));
}

TEST_F(D3plotSeriesTest, FilesAfterTheNinetyNinthHaveThreeDigits) {
  D3plotSeries series(folder_, view(), 1);
  for (int number = 0; number < 101; ++number) series.write_state(view());
  EXPECT_TRUE(std::filesystem::exists(folder_ / "d3plot99"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "d3plot101"));
  EXPECT_EQ(D3plotReader(folder_).states.size(), 101U) << "a state larger than the files has its own";
}

TEST_F(D3plotSeriesTest, RemovesTheFamilyOfAnEarlierRunAndNoOtherFile) {
  for (const char* name : {"d3plot", "d3plot07", "d3plot123", "d3plot.txt", "d3plot1", "d3plotab"})
    std::ofstream(folder_ / name) << "x";
  const D3plotSeries series(folder_, view());
  EXPECT_EQ(D3plotFile(folder_ / "d3plot").integer(16), 6);
  for (const char* name : {"d3plot07", "d3plot123"}) EXPECT_FALSE(std::filesystem::exists(folder_ / name));
  for (const char* name : {"d3plot.txt", "d3plot1", "d3plotab"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
}

TEST_F(D3plotSeriesTest, AVanishedFolderOrFileIsAnErrorThatNamesIt) {
  D3plotSeries series(folder_, view());
  series.write_state(view());
  std::filesystem::remove(folder_ / "d3plot01");
  try {
    series.write_state(view());
    FAIL() << "nothing was noticed";
  } catch (const WriteError& fault) {
    EXPECT_NE(std::string(fault.what()).find("d3plot01: No such file"), std::string::npos) << fault.what();
  }
  std::filesystem::remove_all(folder_);
  EXPECT_THROW(D3plotSeries(folder_, view()), WriteError);
}

TEST_F(D3plotSeriesTest, ALinkInPlaceOfAFileIsAnErrorThatNamesTheFile) {
  D3plotSeries series(folder_, view());
  series.write_state(view());
  std::filesystem::remove(folder_ / "d3plot01");
  std::filesystem::create_symlink(folder_ / "d3plot", folder_ / "d3plot01");
  try {
    series.write_state(view());
    FAIL() << "nothing was noticed";
  } catch (const WriteError& fault) {
    EXPECT_NE(std::string(fault.what()).find("d3plot01: it is a link"), std::string::npos) << fault.what();
  }
}

/// The end mark is replaced last: a state that was not written to its end is not seen.
TEST_F(D3plotSeriesTest, AStateThatDoesNotFitLeavesTheOthersReadable) {
  D3plotSeries series(folder_, view());
  series.write_state(view());
  series.write_state(view());
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{std::filesystem::file_size(folder_ / "d3plot01"), limit.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(series.write_state(view()), WriteError);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(D3plotReader(folder_).states.size(), 2U);
}

TEST_F(D3plotSeriesTest, NumbersBeyond32BitsAreRefused) {
  model_.nodes.id[2] = 5'000'000'000;
  EXPECT_THROW(D3plotSeries(folder_, view()), WriteError);
}

TEST_F(D3plotSeriesTest, TheRecorderWritesAStateForEachFrameIfAsked) {
  Recorder recorder(folder_, "run", view(), {.d3plot = true});
  recorder.write_due(view());
  go_to(0.5, 10);
  recorder.write_last(view());
  recorder.write_last(view());
  EXPECT_EQ(recorder.frames(), 2);
  EXPECT_EQ(D3plotReader(folder_).states.size(), 2U);
  EXPECT_EQ(recorder.files().at(1), folder_ / "d3plot");
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d3plot"));
  const Recorder other(folder_, "run", view());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d3plot"));
}

}  // namespace
}  // namespace crumple::output::d3plot_series_test
