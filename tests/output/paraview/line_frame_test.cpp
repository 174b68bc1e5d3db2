// SPDX-License-Identifier: BSD-3-Clause
// Frames of models with beams and springs.
#include "output/paraview/paraview_series.hpp"
#include "output/results/line_results.hpp"
#include "output/sample.hpp"
#include "output/vtu_reader.hpp"
#include "support/lines.hpp"

namespace crumple::output::line_frame_test {
namespace {

class LineFrameTest : public SampleTest {
 protected:
  /// Two beams, and a spring between their ends with a second one to the ground.
  static model::Model lines() {
    model::Model model = test::one_beam_part(test::elastic_steel(), test::rectangle(1, 1, 1));
    test::add_line(model, 2, {0, 1, 0}, [](double u) { return test::Point{4 * u, 0, 0}; });
    model.spring_materials.push_back({.id = 2, .title = "", .law = model::LinearSpring{1}});
    model.discrete_sections.push_back({.id = 2, .title = ""});
    model.parts.push_back({.id = 5, .title = "", .discrete_section = 0, .spring_material = 0});
    model.discretes.push_back({.id = 7, .part = 1, .node = {0, 2}});
    model.discretes.push_back({.id = 8, .part = 1, .node = {1, 1}, .grounded = true, .axis = {1, 0, 0}});
    return model;
  }
};

TEST_F(LineFrameTest, ShowsBeamsAndSpringsAsLinesWithTheirForces) {
  const model::Model model = lines();
  domain::Domain domain = domain::build(model, {});
  domain::BeamBlock& beams = domain.beams.at(0);
  domain::add_item(beams, "reference_length", "length", 1);
  domain::add_item(beams, "resultant", "force", 6);
  beams.allocate(Precision::Double);
  for (Index place = 0; place < 2; ++place) {
    beams.set_state(place, 0, 2);
    for (Index i = 0; i < 6; ++i) beams.set_state(place, 1 + i, 10 + i);
  }
  domain::DiscreteBlock& springs = domain.discretes.at(0);
  domain::add_item(springs, "force", "force", 1);
  springs.allocate(Precision::Double);
  for (Index place = 0; place < 2; ++place)
    springs.set_state(place, 0, static_cast<double>(model.discretes[springs.element[place]].id));
  const View view{model, domain, 0};
  ParaviewSeries(folder_, "run", view).write_frame(view);
  const VtuReader file(read(folder_ / "vtu/run_000000.vtu"));
  EXPECT_EQ(file["types"].values<std::uint8_t>(), (std::vector<std::uint8_t>{3, 3, 3, 1}));
  EXPECT_EQ(file["offsets"].values<std::int32_t>(), (std::vector<std::int32_t>{2, 4, 6, 7}));
  EXPECT_EQ(file["connectivity"].values<std::int32_t>(), (std::vector<std::int32_t>{0, 1, 1, 2, 0, 2, 1}));
  EXPECT_EQ(file["part"].values<std::int32_t>(), (std::vector<std::int32_t>{1, 1, 5, 5}));
  EXPECT_EQ(file["axial_force"].values<float>(), (std::vector<float>{10, 10, 7, 8}));
  EXPECT_EQ(file["torsion"].values<float>(), (std::vector<float>{11, 11, 0, 0}));
  EXPECT_EQ(file["first_moment_s"].values<float>(), (std::vector<float>{12, 12, 0, 0}));
  EXPECT_EQ(file["second_moment_t"].values<float>(), (std::vector<float>{15, 15, 0, 0}));
  EXPECT_EQ(file["shear_t"].values<float>(), (std::vector<float>{13, 13, 0, 0}));
  EXPECT_EQ(file["shear_s"].values<float>(), (std::vector<float>{-14, -14, 0, 0}));
}

}  // namespace
}  // namespace crumple::output::line_frame_test
