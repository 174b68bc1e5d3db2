// SPDX-License-Identifier: BSD-3-Clause
// Contacts of two sides: who may touch whom.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/bodies.hpp"
#include "contact/force_transducer.hpp"
#include "contact/surface/segment_shape.hpp"
#include "contact/surface/surface.hpp"
#include "support/verified.hpp"

namespace crumple::sides_test {
namespace {

using model::ContactKind;
using test::Bodies;
using test::Vec3;

constexpr double thickness = 0.1;

/// A square sheet of side 1 (part 0, 2 x 1 shells), a small one above the middle of its first shell (part 1)
/// and the same below (part 2). Nodes of the small ones are above and below the large one, its own are not
/// above or below them.
class Layers {
 public:
  explicit Layers(double apart = 0.5) : bodies_(thickness) {
    sheet_ = bodies_.sheet(2, 1, [](double u, double v) { return Vec3{u, v, 0}; });
    for (const double height : {apart, -apart}) {
      bodies_.part();
      small_.push_back(bodies_.sheet(1, 1, [&](double u, double v) {
        return Vec3{0.1 + 0.3 * u, 0.35 + 0.3 * v, height};
      }));
    }
    bodies_.contact.kind = ContactKind::SurfaceToSurface;
    bodies_.contact.side[0].parts = {1};
    bodies_.contact.side[1].parts = {0};
  }

  Bodies& bodies() { return bodies_; }
  model::Contact& contact() { return bodies_.contact; }
  std::vector<Index> nodes_of(int small) const {
    const Index first = small_[small - 1];
    return {first, first + 1, first + 2, first + 3};
  }

  void start() {
    made_ = bodies_.build();
    touching_.emplace(bodies_.attach(*made_));
    touching_->verify_search_every(1);
    test::add_forces(*touching_, *made_);
  }
  /// Moves a small sheet.
  void move(int small, const Vec3& by) {
    std::vector<Vec3> x(made_->nodes.position.begin(), made_->nodes.position.end());
    for (const Index node : nodes_of(small)) x[test::at(*made_, node)] += by;
    test::move_to(*touching_, *made_, x, 0.1);
  }
  /// On a small sheet.
  Vec3 force(int small) const {
    Vec3 sum;
    for (const Index node : nodes_of(small)) sum += made_->contact_force[test::at(*made_, node)];
    return sum;
  }
  domain::Domain& made() { return *made_; }
  const contact::Interface& touching() const { return *touching_; }

 private:
  Bodies bodies_;
  Index sheet_ = 0;
  std::vector<Index> small_;
  std::optional<domain::Domain> made_;
  std::optional<contact::Interface> touching_;
};

TEST(Sides, OnlyTheTwoSidesTouch) {
  Layers layers;
  layers.start();
  layers.move(1, {0, 0, -0.42});
  layers.move(2, {0, 0, 0.42});
  EXPECT_GT(layers.force(1).z, 0);
  EXPECT_EQ(norm(layers.force(2)), 0);
  EXPECT_EQ(layers.made().contacts[0].force.z, layers.force(1).z);
  EXPECT_NEAR(norm(test::total_force(layers.made())), 0, 1e-14 * layers.force(1).z);
}

TEST(Sides, NoSideTouchesItself) {
  for (const ContactKind kind :
       {ContactKind::SingleSurface, ContactKind::SurfaceToSurface, ContactKind::NodesToSurface}) {
    Layers layers;
    layers.contact().kind = kind;
    layers.contact().side[0].parts = {1, 2};
    layers.start();
    layers.move(1, {3, 0.05, -0.46});
    layers.move(2, {3, 0, 0.46});
    if (kind == ContactKind::SingleSurface)
      EXPECT_GT(layers.force(1).z, 0);
    else
      EXPECT_EQ(norm(layers.force(1)), 0);
  }
}

TEST(Sides, NodesToSurfaceHasADirection) {
  Layers layers;
  layers.contact().kind = ContactKind::NodesToSurface;
  layers.start();
  layers.move(1, {0, 0, -0.42});
  const double force = layers.force(1).z;
  EXPECT_GT(force, 0);

  // The nodes of the large sheet are not above the small one.
  Layers reversed;
  reversed.contact().kind = ContactKind::NodesToSurface;
  std::swap(reversed.contact().side[0], reversed.contact().side[1]);
  reversed.start();
  reversed.move(1, {0, 0, -0.42});
  EXPECT_EQ(norm(reversed.force(1)), 0);

  // Surface to surface is both.
  reversed.contact().kind = ContactKind::SurfaceToSurface;
  reversed.start();
  reversed.move(1, {0, 0, -0.42});
  EXPECT_EQ(reversed.force(1).z, force);
}

TEST(Sides, NodesTouchWithoutSegmentsOfTheirOwn) {
  Layers layers;
  layers.contact().kind = ContactKind::NodesToSurface;
  layers.contact().side[0].parts.clear();
  layers.contact().side[0].nodes = layers.nodes_of(1);
  layers.start();
  layers.move(1, {0, 0, -0.39});
  EXPECT_EQ(norm(layers.force(1)), 0) << "0.11 apart, the thickness of their shells is 0.1";
  layers.move(1, {0, 0, -0.02});
  EXPECT_GT(layers.force(1).z, 0);
  EXPECT_EQ(layers.touching().surface().segments(), 2) << "of the sheet alone";
}

TEST(Sides, SegmentsOneByOne) {
  Layers layers;
  const auto segment = [&](std::size_t shell) { return layers.bodies().model.shells[shell].node; };
  layers.contact().side[1].parts.clear();
  layers.contact().side[1].segments = {segment(1)};
  layers.start();
  layers.move(1, {0, 0, -0.42});
  EXPECT_EQ(norm(layers.force(1)), 0) << "over the first shell";
  layers.contact().side[1].segments = {segment(0)};
  layers.start();
  layers.move(1, {0, 0, -0.42});
  EXPECT_GT(layers.force(1).z, 0);
  layers.contact().side[1].segments.clear();
  layers.contact().side[1].shells = {0};
  layers.start();
  layers.move(1, {0, 0, -0.42});
  EXPECT_GT(layers.force(1).z, 0);
}

// Where the surface goes on as something that the node may not touch, the contact ends like at a free edge.
TEST(Sides, TheSurfaceEndsWhereTheSideEnds) {
  Layers layers;
  layers.contact().side[1].parts.clear();
  layers.contact().side[1].shells = {0};
  layers.start();
  // Two nodes 0.02 beyond the edge between the shells, 0.06 above it.
  layers.move(1, {0.42, 0, -0.44});
  const double distance = std::hypot(0.02, 0.06);
  const Vec3 force = layers.force(1);
  EXPECT_GT(force.z, 0);
  test::verified("node beyond the edge where a side ends: penetration", "distance to the edge")
      .near(layers.made().contacts[0].penetration, thickness - distance, 1e-12);
  EXPECT_GT(force.x, 0);
}

TEST(Sides, ShellsWithAnOutsidePushThere) {
  for (const bool oriented : {false, true}) {
    Layers layers;
    layers.contact().oriented = oriented;
    layers.start();
    // Through in small steps: both kinds remember the side that the node came from.
    for (int step = 0; step < 26; ++step) layers.move(1, {0, 0, -0.02});
    EXPECT_GT(layers.force(1).z, 0) << oriented;
  }
  for (const bool oriented : {false, true}) {
    Layers layers(0.2);
    layers.contact().oriented = oriented;
    layers.contact().kind = ContactKind::NodesToSurface;
    layers.contact().side[0].parts.clear();
    layers.contact().side[0].nodes = layers.nodes_of(2);        // without an outside of their own
    const auto outside = layers.bodies().model.shells[0].node;  // upwards
    layers.contact().side[1].parts.clear();
    layers.contact().side[1].segments = {outside};
    layers.start();
    layers.move(2, {0, 0, 0.12});
    if (oriented) {
      EXPECT_EQ(norm(layers.force(2)), 0) << "what is behind from the start may stay there";
      layers.move(2, {0, 0, -0.04});
      EXPECT_GT(layers.force(2).z, 0) << "but not go back";
    } else {
      EXPECT_LT(layers.force(2).z, 0);
    }
  }
}

TEST(Sides, PartsWithAnOutsideFaceTheOtherSide) {
  for (const bool reversed : {false, true})
    for (const int small : {1, 2}) {
      Layers layers;
      layers.contact().oriented = true;
      layers.contact().side[0].parts = {small};
      if (reversed)
        for (model::ShellElement& shell : layers.bodies().model.shells)
          std::swap(shell.node[1], shell.node[3]);
      layers.start();
      const contact::Surface& surface = layers.touching().surface();
      const Vec3* x = layers.made().nodes.position.data();
      for (Index s = 0; s < surface.segments(); ++s) {
        const contact::SegmentShape shape = contact::shape_of(surface, {x, nullptr, 0}, s);
        const bool large = surface.segment_side[s] == 2;
        const double outwards = (small == 1) == large ? 1 : -1;
        EXPECT_GT(outwards * contact::area_normal(shape).z, 0) << small << reversed << s;
      }
    }
}

TEST(Sides, OrientedShellsHaveThicknessOnRequest) {
  for (const bool thick : {false, true}) {
    Layers layers;
    layers.contact().oriented = true;
    layers.contact().shell_thickness = thick;
    layers.start();
    layers.move(1, {0, 0, -0.42});
    EXPECT_EQ(layers.force(1).z > 0, thick);
  }
}

TEST(Sides, TransducersMeasureWhatContactsDo) {
  Layers layers;
  layers.contact() = model::self_contact(1, "all", {0, 1, 2});
  layers.start();
  layers.move(1, {0, 0, -0.42});
  layers.move(2, {0, 0, 0.44});
  ASSERT_GT(layers.force(1).z, 0);
  ASSERT_LT(layers.force(2).z, 0);
  const auto measure = [&](std::vector<Index> first, std::vector<Index> second) {
    model::ForceTransducer transducer;
    transducer.side[0].parts = std::move(first);
    transducer.side[1].parts = std::move(second);
    const contact::ForceTransducer measuring(layers.bodies().model, layers.made(), transducer);
    return measuring.measure(layers.touching());
  };
  const double round_off = 1e-12 * layers.force(1).z;
  EXPECT_NEAR(measure({1}, {}).z, layers.force(1).z, round_off);
  EXPECT_NEAR(measure({2}, {}).z, layers.force(2).z, round_off);
  test::verified("force transducer of a sheet between two others: force over the one above",
                 "third law of motion")
      .near(measure({0}, {}).z / layers.force(1).z, -1 - layers.force(2).z / layers.force(1).z, 1e-12);
  EXPECT_NEAR(measure({0}, {2}).z, -layers.force(2).z, round_off);
  EXPECT_NEAR(measure({1}, {0}).z, layers.force(1).z, round_off);
  EXPECT_EQ(measure({1}, {2}).z, 0);
}

}  // namespace
}  // namespace crumple::sides_test
