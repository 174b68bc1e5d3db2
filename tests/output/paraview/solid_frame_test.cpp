// SPDX-License-Identifier: BSD-3-Clause
// Frames of models with solids.
#include "output/paraview/paraview_series.hpp"
#include "output/results/point_results.hpp"
#include "output/sample.hpp"
#include "output/vtu_reader.hpp"
#include "support/meshes.hpp"

namespace crumple::output::solid_frame_test {
namespace {

class SolidFrameTest : public SampleTest {
 protected:
  /// A shell on a cube, and in it what a cube degenerates to.
  static model::Model solids() {
    model::Model model = test::one_solid_part(test::elastic_steel());
    test::add_box(model, 0, 1, 1, 1, [](double u, double v, double w) { return test::Point{u, v, w}; });
    const Index part = 0;
    model.solids.push_back({.id = 2, .part = part, .node = {0, 1, 3, 2, 4, 4, 6, 6}});
    model.solids.push_back({.id = 3, .part = part, .node = {0, 1, 3, 2, 4, 4, 4, 4}});
    model.solids.push_back({.id = 4, .part = part, .node = {0, 1, 3, 3, 4, 4, 4, 4}});
    model.shell_sections.push_back(test::shell_section(0.1, 3));
    model.parts.push_back({.id = 2, .title = "skin", .section = 0, .material = 0});
    model.shells.push_back({.id = 1, .part = 1, .node = {0, 1, 3, 2}});
    return model;
  }
};

TEST_F(SolidFrameTest, ShowsShellsThenSolidsAsTheShapesTheyAre) {
  const model::Model model = solids();
  domain::Domain domain = domain::build(model, {});
  domain::SolidBlock& block = domain.solids.at(0);
  domain::add_item(block, "stress", "stress", 6);
  domain::add_item(block, "plastic_strain", "-", 1);
  block.allocate(Precision::Double);
  for (Index place = 0; place < block.elements; ++place) {
    const double id = static_cast<double>(model.solids[block.element[place]].id);
    block.set_state(place, 0, -3 * id);
    block.set_state(place, 6, id / 8);
  }
  const View view{model, domain, 0};
  ParaviewSeries(folder_, "run", view).write_frame(view);
  const std::string text = read(folder_ / "vtu/run_000000.vtu");
  EXPECT_NE(text.find("NumberOfCells=\"5\""), std::string::npos);
  const VtuReader file(text);
  EXPECT_EQ(file["types"].values<std::uint8_t>(), (std::vector<std::uint8_t>{9, 12, 13, 14, 10}));
  EXPECT_EQ(file["offsets"].values<std::int32_t>(), (std::vector<std::int32_t>{4, 12, 18, 23, 27}));
  EXPECT_EQ(file["connectivity"].values<std::int32_t>(),
            (std::vector<std::int32_t>{0, 1, 3, 2, 0, 1, 3, 2, 4, 5, 7, 6, 0, 1,
                                       4, 2, 3, 6, 0, 1, 3, 2, 4, 0, 1, 3, 4}));
  EXPECT_EQ(file["von_mises"].values<float>(), (std::vector<float>{0, 3, 6, 9, 12}));
  EXPECT_EQ(file["pressure"].values<float>(), (std::vector<float>{0, 1, 2, 3, 4}));
  EXPECT_EQ(file["plastic_strain"].values<float>(), (std::vector<float>{0, 0.125F, 0.25F, 0.375F, 0.5F}));
  EXPECT_EQ(file["alive"].values<std::uint8_t>(), (std::vector<std::uint8_t>(5, 1)));
}

TEST_F(SolidFrameTest, ShowsTheLargestDamageOfLawsThatHaveSomeAndOfGissmo) {
  for (const char* const item : damage_items) {
    SCOPED_TRACE(item);
    const model::Model model = solids();
    domain::Domain domain = domain::build(model, {});
    domain::SolidBlock& block = domain.solids.at(0);
    domain::add_item(block, item, "-", 2);
    block.allocate(Precision::Double);
    for (Index place = 0; place < block.elements; ++place)
      block.set_state(place, place % 2, static_cast<double>(model.solids[block.element[place]].id) / 8);
    const View view{model, domain, 0};
    ParaviewSeries(folder_, "run", view).write_frame(view);
    const VtuReader file(read(folder_ / "vtu/run_000000.vtu"));
    EXPECT_EQ(file["damage"].values<float>(), (std::vector<float>{0, 0.125F, 0.25F, 0.375F, 0.5F}));
  }
}

TEST_F(SolidFrameTest, HasStressTensorsIfAskedFor) {
  const model::Model model = solids();
  domain::Domain domain = domain::build(model, {});
  domain::SolidBlock& block = domain.solids.at(0);
  domain::add_item(block, "stress", "stress", 6);
  block.allocate(Precision::Double);
  for (Index c = 0; c < 6; ++c) block.set_state(0, c, c + 1);
  const View view{model, domain, 0};
  ParaviewSeries(folder_, "run", view, Opening::New, true).write_frame(view);
  const VtuReader file(read(folder_ / "vtu/run_000000.vtu"));
  EXPECT_EQ(file["stress"].components, 6);
  const std::vector<float> stress = file["stress"].values<float>();
  ASSERT_EQ(stress.size(), 30U);
  EXPECT_EQ(std::vector<float>(stress.begin(), stress.begin() + 6), std::vector<float>(6, 0)) << "the shell";
  const auto solid = stress.begin() + 6 * (1 + block.element[0]);
  EXPECT_EQ(std::vector<float>(solid, solid + 6), (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST_F(SolidFrameTest, ShowsTetrahedraWithTenNodesAsQuadraticOnes) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.solid_sections[0].formulation = model::SolidFormulation::QuadraticTetrahedron;
  test::add_box(model, 0, 1, 1, 1, [](double u, double v, double w) { return test::Point{u, v, w}; });
  model.solids[0].node = {0, 1, 3, 3, 4, 4, 4, 4};
  test::add_middle_nodes(model);
  domain::Domain domain = domain::build(model, {});
  domain::SolidBlock& block = domain.solids.at(0);
  EXPECT_EQ(block.corners, 10);
  block.points = 4;
  domain::add_item(block, "stress", "stress", 24);
  block.allocate(Precision::Double);
  const View view{model, domain, 0};
  ParaviewSeries(folder_, "run", view).write_frame(view);
  const VtuReader file(read(folder_ / "vtu/run_000000.vtu"));
  EXPECT_EQ(file["types"].values<std::uint8_t>(), (std::vector<std::uint8_t>{24}));
  EXPECT_EQ(file["offsets"].values<std::int32_t>(), (std::vector<std::int32_t>{10}));
  // The corners, then 0-1, 1-2, 2-0, 0-3, 1-3, 2-3 of them.
  EXPECT_EQ(file["connectivity"].values<std::int32_t>(),
            (std::vector<std::int32_t>{0, 1, 3, 4, 8, 9, 10, 11, 12, 13}));
}

}  // namespace
}  // namespace crumple::output::solid_frame_test
