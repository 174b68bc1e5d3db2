// SPDX-License-Identifier: BSD-3-Clause
#include "output/paraview/paraview_series.hpp"

#include <cstdlib>
#include <regex>

#include "output/sample.hpp"
#include "output/vtu_reader.hpp"

namespace crumple::output::paraview_series_test {
namespace {

class ParaviewSeriesTest : public SampleTest {
 protected:
  VtuReader frame(int number) const {
    char name[32];
    std::snprintf(name, sizeof(name), "vtu/run_%06d.vtu", number);
    return VtuReader(read(folder_ / name));
  }
};

TEST_F(ParaviewSeriesTest, TopologyAndIdsAreThoseOfTheDeck) {
  ParaviewSeries(folder_, "run", view()).write_frame(view());
  const VtuReader file = frame(0);
  using Ids = std::vector<std::int32_t>;
  EXPECT_EQ(file["node_id"].values<std::int32_t>(), (Ids{60, 50, 40, 30, 20, 10}));
  EXPECT_EQ(file["element_id"].values<std::int32_t>(), (Ids{99, 11, 5}));
  EXPECT_EQ(file["part"].values<std::int32_t>(), (Ids{7, 7, 3}));
  EXPECT_EQ(file["connectivity"].values<std::int32_t>(), (Ids{0, 1, 4, 3, 1, 2, 5, 4, 0, 1, 4}));
  EXPECT_EQ(file["offsets"].values<std::int32_t>(), (Ids{4, 8, 11}));
  EXPECT_EQ(file["types"].values<std::uint8_t>(), (std::vector<std::uint8_t>{9, 9, 5}));
}

TEST_F(ParaviewSeriesTest, FieldsFollowTheDecksOrderWhateverTheDomains) {
  const Index node = domain_.nodes.domain_node[4];  // the node of id 20
  domain_.nodes.position[node] += math::Vec3{0.25, 0.5, -1};
  domain_.nodes.velocity[node] = {1, 2, 3};
  domain_.contact_force[node] = {-4, 5, 6};
  for (domain::ShellBlock& block : domain_.shells)
    for (Index place = 0; place < block.elements; ++place) {
      const auto id = static_cast<double>(model_.shells[block.element[place]].id);
      block.set_state(place, block.find("stress")->first, id);
      block.set_state(place, block.find("plastic_strain")->first + 1, id / 1000);
      if (id == 11) block.set_state(place, block.find("active")->first, 0);
    }
  ParaviewSeries(folder_, "run", view()).write_frame(view());
  const VtuReader file = frame(0);
  const auto at = [&](const char* field) {
    const auto all = file[field].values<float>();
    EXPECT_EQ(all.size(), 18U);
    return std::vector<float>(all.begin() + 12, all.begin() + 15);
  };
  EXPECT_EQ(at("position"), (std::vector<float>{1.25F, 1.5F, -1}));
  EXPECT_EQ(at("displacement"), (std::vector<float>{0.25F, 0.5F, -1}));
  EXPECT_EQ(at("velocity"), (std::vector<float>{1, 2, 3}));
  EXPECT_EQ(at("contact_force"), (std::vector<float>{-4, 5, 6}));
  EXPECT_EQ(file["von_mises"].values<float>(), (std::vector<float>{99, 11, 5}));
  EXPECT_EQ(file["von_mises_mid"].values<float>(), (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(file["plastic_strain"].values<float>(), (std::vector<float>{0.099F, 0.011F, 0.005F}));
  EXPECT_EQ(file["thickness"].values<float>(), (std::vector<float>{0.5F, 0.5F, 0.5F}));
  EXPECT_EQ(file["alive"].values<std::uint8_t>(), (std::vector<std::uint8_t>{1, 0, 1}));
}

/// Even tension in the plane of the shells at their lowest points, after a quarter turn about y.
TEST_F(ParaviewSeriesTest, AllFieldsAreAlongGlobalAxesAndBySurface) {
  for (math::Vec3& x : domain_.nodes.position) x = {x.z, x.y, -x.x};
  for (domain::ShellBlock& block : domain_.shells)
    for (Index place = 0; place < block.elements; ++place) {
      for (const Index c : {0, 1}) block.set_state(place, block.find("stress")->first + c, 3);
      block.set_state(place, block.find("plastic_strain")->first, 0.25);
    }
  ParaviewSeries(folder_, "run", view(), Opening::New, true).write_frame(view());
  const VtuReader file = frame(0);
  const std::vector<float> inner = file["stress_inner"].values<float>();
  ASSERT_EQ(inner.size(), 18U);
  for (std::size_t i = 0; i < inner.size(); ++i)
    EXPECT_NEAR(inner[i], i % 6 == 1 || i % 6 == 2 ? 3 : 0, 1e-6) << i;
  EXPECT_EQ(file["stress_outer"].values<float>(), std::vector<float>(18, 0));
  EXPECT_EQ(file["plastic_strain_inner"].values<float>(), std::vector<float>(3, 0.25F));
  EXPECT_EQ(file["plastic_strain_outer"].values<float>(), std::vector<float>(3, 0));
  EXPECT_EQ(file["thickness_change"].values<float>(), std::vector<float>(3, 0));
  ParaviewSeries(folder_, "run", view()).write_frame(view());
  EXPECT_FALSE(frame(0).has("stress_inner")) << "only if asked for";
}

/// Shells with four points in plane: the greatest stress of all points, and of the mid-surface the mean.
TEST_F(ParaviewSeriesTest, StressIsTakenOverThePointsInPlane) {
  for (domain::ShellBlock& block : domain_.shells) {
    block.plane_points = block.find("stress")->count / 5;  // one point through the thickness
    ASSERT_GT(block.plane_points, 1);
    for (Index place = 0; place < block.elements; ++place)
      block.set_state(place, block.find("stress")->first + 5, 12.0 * block.plane_points);
  }
  ParaviewSeries(folder_, "run", view()).write_frame(view());
  const VtuReader file = frame(0);
  const auto planes = static_cast<float>(domain_.shells[0].plane_points);
  EXPECT_EQ(file["von_mises"].values<float>(), (std::vector<float>(3, 12 * planes)));
  EXPECT_EQ(file["von_mises_mid"].values<float>(), (std::vector<float>(3, 12)));
}

TEST_F(ParaviewSeriesTest, TheCollectionListsEveryFrameAtEveryMoment) {
  ParaviewSeries series(folder_, "run", view());
  for (int number = 0; number < 3; ++number) {
    go_to(0.1 * number, number);
    series.write_frame(view());
    const std::string text = read(series.collection());
    const std::regex entry("timestep=\"([^\"]+)\" part=\"0\" file=\"([^\"]+)\"");
    int listed = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), entry), end; at != end; ++at, ++listed) {
      EXPECT_DOUBLE_EQ(std::stod((*at)[1]), 0.1 * listed);
      EXPECT_TRUE(std::filesystem::exists(folder_ / std::string((*at)[2])));
    }
    EXPECT_EQ(listed, number + 1);
    EXPECT_NE(text.find("</VTKFile>"), std::string::npos);
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_F(ParaviewSeriesTest, ADeckMayBeCalledAnything) {
  ParaviewSeries series(folder_, "a\"b>c&d", view());
  series.write_frame(view());
  const std::string text = read(series.collection());
  EXPECT_NE(text.find("file=\"vtu/a&quot;b&gt;c&amp;d_000000.vtu\""), std::string::npos) << text;
}

TEST_F(ParaviewSeriesTest, RemovesFramesOfAnEarlierRunAndNoOther) {
  std::filesystem::create_directories(folder_ / "vtu");
  for (const char* name : {"run_000005.vtu", "other_000005.vtu", "run_notes.txt"})
    std::ofstream(folder_ / "vtu" / name) << "x";
  std::ofstream(folder_ / "run.pvd") << "x";
  const ParaviewSeries series(folder_, "run", view());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "vtu/run_000005.vtu"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run.pvd"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "vtu/other_000005.vtu"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "vtu/run_notes.txt"));
}

TEST_F(ParaviewSeriesTest, IdsBeyond32BitsAreKept) {
  model_.nodes.id[2] = 5'000'000'000;
  ParaviewSeries(folder_, "run", view()).write_frame(view());
  EXPECT_EQ(frame(0)["node_id"].values<std::int64_t>()[2], 5'000'000'000);
}

TEST_F(ParaviewSeriesTest, VtkItselfReadsTheSameValues) {
  if (std::system("/usr/bin/python3 -c 'import vtkmodules.vtkIOXML' 2>/dev/null") != 0)
    GTEST_SKIP() << "VTK's Python is not installed (Debian: python3-vtk9)";
  const Index node = domain_.nodes.domain_node[4];
  domain_.nodes.position[node] += math::Vec3{0.25, 0.5, -1};
  go_to(0.125, 9);
  ParaviewSeries(folder_, "run", view()).write_frame(view());
  EXPECT_EQ(std::system(("/usr/bin/python3 tests/output/read_with_vtk.py " + folder_.string()).c_str()), 0);
}

}  // namespace
}  // namespace crumple::output::paraview_series_test
