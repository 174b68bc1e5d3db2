// SPDX-License-Identifier: BSD-3-Clause
// d3plot files of models with solids, beams, springs and rigid walls.
#include "output/d3plot/d3plot_series.hpp"
#include "output/d3plot_reader.hpp"
#include "output/sample.hpp"
#include "support/lines.hpp"

namespace crumple::output::d3plot_elements_test {
namespace {

using Integers = std::vector<std::int32_t>;
using Reals = std::vector<float>;

class D3plotElementsTest : public SampleTest {
 protected:
  /// A cube and what it degenerates to; two beams, one with an orientation node, and a spring to the ground.
  static model::Model elements() {
    model::Model model = test::one_solid_part(test::elastic_steel());
    model.parts[0].id = 30;
    test::add_box(model, 0, 1, 1, 1, [](double u, double v, double w) { return test::Point{u, v, w}; });
    model.solids.push_back({.id = 2, .part = 0, .node = {0, 1, 3, 2, 4, 4, 6, 6}});
    model.solids.push_back({.id = 3, .part = 0, .node = {0, 1, 3, 2, 4, 4, 4, 4}});
    model.solids.push_back({.id = 4, .part = 0, .node = {0, 1, 3, 3, 4, 4, 4, 4}});
    model.beam_sections.push_back(test::rectangle(1, 1, 1));
    model.parts.push_back({.id = 20, .title = "beams", .beam_section = 0, .material = 0});
    model.beams.push_back({.id = 8, .part = 1, .node = {0, 1}, .orientation_node = 3});
    model.beams.push_back({.id = 9, .part = 1, .node = {1, 3}, .orientation = {0, 0, 1}});
    model.spring_materials.push_back({.id = 2, .title = "", .law = model::LinearSpring{1}});
    model.discrete_sections.push_back({.id = 2, .title = ""});
    model.parts.push_back({.id = 10, .title = "spring", .discrete_section = 0, .spring_material = 0});
    model.discretes.push_back({.id = 8, .part = 2, .node = {1, 1}, .grounded = true, .axis = {1, 0, 0}});
    return model;
  }
  D3plotElementsTest() : SampleTest(elements()) {
    domain::SolidBlock& solids = domain_.solids.at(0);
    domain::add_item(solids, "stress", "stress", 6);
    domain::add_item(solids, "plastic_strain", "-", 1);
    domain::add_item(solids, "active", "-", 1);
    solids.allocate(Precision::Double);
    for (Index place = 0; place < solids.elements; ++place)
      for (Index i = 0; i < 8; ++i) solids.set_state(place, i, i + 0.1 * (solids.element[place] + 1));
    solids.set_state(place_of(solids, 2), 7, 0);
    domain::BeamBlock& beams = domain_.beams.at(0);
    domain::add_item(beams, "reference_length", "length", 1);
    domain::add_item(beams, "resultant", "force", 6);
    beams.allocate(Precision::Double);
    for (Index place = 0; place < 2; ++place) {
      beams.set_state(place, 0, 2);
      for (Index i = 0; i < 6; ++i) beams.set_state(place, 1 + i, 10 + i * i);
    }
    domain::DiscreteBlock& springs = domain_.discretes.at(0);
    domain::add_item(springs, "force", "force", 1);
    springs.allocate(Precision::Double);
    springs.set_state(0, 0, 7);
  }
  static Index place_of(const domain::ElementBlock& block, Index element) {
    Index place = 0;
    while (block.element[place] != element) ++place;
    return place;
  }
};

TEST_F(D3plotElementsTest, GeometryHasSolidsThenBeamsAndSprings) {
  const D3plotSeries series(folder_, view());
  const D3plotReader file(folder_);
  EXPECT_EQ(file.root.integers(23, 2), (Integers{4, 1}));
  EXPECT_EQ(file.root.integers(28, 2), (Integers{3, 2})) << "springs are beams";
  EXPECT_EQ(file.root.integers(file.solid_section, 9), (Integers{1, 2, 4, 3, 5, 6, 8, 7, 1}));
  EXPECT_EQ(file.root.integers(file.solid_section + 9, 9), (Integers{1, 2, 4, 3, 5, 5, 7, 7, 1}));
  EXPECT_EQ(file.root.integers(file.solid_section + 18, 9), (Integers{1, 2, 4, 3, 5, 5, 5, 5, 1}));
  EXPECT_EQ(file.root.integers(file.solid_section + 27, 9), (Integers{1, 2, 4, 5, 5, 5, 5, 5, 1}))
      << "LS-DYNA's form of a tetrahedron";
  EXPECT_EQ(file.root.integers(file.beam_section, 18),
            (Integers{1, 2, 4, 0, 0, 2, 2, 4, 0, 0, 0, 2, 2, 2, 0, 0, 0, 3}));
  EXPECT_EQ(file.numbers(1), (Integers{1, 2, 3, 4}));
  EXPECT_EQ(file.numbers(2), (Integers{8, 9, 8}));
  EXPECT_EQ(file.numbers(4), (Integers{10, 20, 30}));
  EXPECT_EQ(file.numbers(6), (Integers{3, 2, 1}));
}

TEST_F(D3plotElementsTest, StateHasTheirStressesAndResultants) {
  D3plotSeries series(folder_, view());
  series.write_state(view());
  const D3plotReader file(folder_);
  const ReadState& state = file.states.at(0);
  for (std::size_t i = 0; i < 7; ++i)
    EXPECT_EQ(state.solids[7 + i], static_cast<float>(static_cast<double>(i) + 0.1 * 2)) << i;
  // Kept are axial force 10, torsion 11, moments about s and t of the first end 14 and 19, of the second 26
  // and 35, over a length of 2.
  EXPECT_EQ(ReadState::of(state.beams, 0, 6), (Reals{10, -27, 20, 6, 8, 11}));
  EXPECT_EQ(ReadState::of(state.beams, 2, 6), (Reals{7, 0, 0, 0, 0, 0}));
  EXPECT_EQ(state.alive_solids, (Reals{1, 1, 0, 1}));
  EXPECT_EQ(state.alive_beams, (Reals{2, 2, 3}));
}

TEST_F(D3plotElementsTest, WallsHaveTheirMeanForceAndTheirPlace) {
  model_.rigid_walls.resize(2);
  model_.rigid_walls[0].point = {1, 2, 3};
  model_.rigid_walls[1].point = {4, 5, 6};
  domain_.walls.assign(2, {});
  domain_.walls[1].displacement_now = {0, 0, 0.5};
  D3plotSeries series(folder_, view());
  series.write_state(view());
  go_to(0.25, 3);
  domain_.walls[0].normal_impulse = 2;
  series.write_state(view());
  go_to(0.5, 6);
  domain_.walls[0].normal_impulse = 3;
  series.write_state(view());
  const D3plotReader file(folder_);
  EXPECT_EQ(file.root.integer(18), 6 + 7 * 3 + 4 * 2);
  const auto walls = [&](std::size_t state) {
    const Reals& globals = file.states.at(state).globals;
    return Reals(globals.end() - 8, globals.end());
  };
  EXPECT_EQ(walls(0), (Reals{0, 0, 1, 2, 3, 4, 5, 6.5F}));
  EXPECT_EQ(walls(1), (Reals{8, 0, 1, 2, 3, 4, 5, 6.5F}));
  EXPECT_EQ(walls(2)[0], 4);
}

}  // namespace
}  // namespace crumple::output::d3plot_elements_test
