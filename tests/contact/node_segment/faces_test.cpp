// SPDX-License-Identifier: BSD-3-Clause
// Faces of solids in contact: the outside is one side, there is no thickness.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "contact/bodies.hpp"
#include "contact/surface/surface.hpp"
#include "support/largest.hpp"
#include "support/meshes.hpp"
#include "support/verified.hpp"

namespace crumple::faces_test {
namespace {

using math::Vec3;

/// A block of one element, 2 x 2 x `height`, on the plane z = 0, and a small one above, below or inside of
/// it, 0.2 wide, whose lowest nodes are at z = `bottom`.
class Blocks {
 public:
  Blocks(double height, double bottom, const model::Contact& contact = {}) {
    bodies_.contact = contact;
    bodies_.take_two_parts_of_solids();
    test::add_box(bodies_.model, 0, 1, 1, 1, [&](double u, double v, double w) {
      return test::Point{2 * u - 1, 2 * v - 1, height * w};
    });
    small_ = test::add_box(bodies_.model, 1, 1, 1, 1, [&](double u, double v, double w) {
      return test::Point{0.2 * u, 0.2 * v + 0.1, bottom + 0.2 * w};
    });
    made_ = bodies_.build();
    touching_.emplace(bodies_.attach(made_));
    test::add_forces(*touching_, made_);
  }

  /// Moves the small block.
  void move(const Vec3& by) {
    std::vector<Vec3> x(made_.nodes.position.begin(), made_.nodes.position.end());
    for (Index i = 0; i < 8; ++i) x[test::at(made_, small_ + i)] += by;
    test::move_to(*touching_, made_, x, 0.1);
  }

  /// Lets the small block down by 0.02, slowly: where it is heading deep the penalty grows.
  void press() {
    for (int i = 0; i < 200; ++i) move({0, 0, -1e-4});
    move({0, 0, 0});
  }

  /// On the small block.
  Vec3 force() const {
    Vec3 sum;
    for (Index i = 0; i < 8; ++i) sum += made_.contact_force[test::at(made_, small_ + i)];
    return sum;
  }
  const domain::Domain& domain() const { return made_; }
  const contact::Interface& touching() const { return *touching_; }

 private:
  test::Bodies bodies_;
  Index small_ = 0;
  domain::Domain made_;
  std::optional<contact::Interface> touching_;
};

TEST(Faces, OuterFacesAreSegmentsWithTheirStiffness) {
  const Blocks blocks(0.5, 3);
  const contact::Surface& surface = blocks.touching().surface();
  ASSERT_EQ(surface.segments(), 12);
  for (Index s = 0; s < surface.segments(); ++s) {
    EXPECT_TRUE(surface.is_face(s));
    EXPECT_EQ(surface.half_thickness[s], 0);
  }
  // SLSFAC K A^2 / V, K = E / (3 (1 - 2 nu)).
  const double modulus = 1000 / 1.5;
  test::verified("face of a block: stiffness", "SLSFAC K A^2 / V")
      .near(surface.stiffness[0], 0.1 * modulus * 4 / 0.5, 1e-9);
  EXPECT_NEAR(surface.height[0], 0.5, 1e-12);
}

// SLDTHK and SLDSTF.
TEST(Faces, MayHaveAThicknessAndAStiffnessOfTheirOwn) {
  model::Contact contact;
  contact.solid_thickness = 0.04;
  contact.solid_modulus = 30;
  Blocks blocks(0.5, 0.6, contact);
  const contact::Surface& surface = blocks.touching().surface();
  EXPECT_NEAR(surface.stiffness[0], 0.1 * 30 * 4 / 0.5, 1e-12);
  EXPECT_NEAR(surface.half_thickness[0], 0.02, 1e-15);
  blocks.move({0, 0, -0.05});
  EXPECT_EQ(norm(blocks.force()), 0);
  // In front of each other, 0.03 apart.
  blocks.press();
  const double stiffness = std::min(surface.stiffness[0], surface.stiffness[6]);
  test::verified("face with SLDTHK and SLDSTF: force over exact", "stiffness times depth")
      .near(blocks.force().z / (stiffness * 0.01), 1, 1e-9);
}

TEST(Faces, PushOutWhatWentThrough) {
  Blocks blocks(0.5, 0.6);
  blocks.move({0, 0, -0.09});
  EXPECT_EQ(norm(blocks.force()), 0) << "there is no thickness";
  blocks.press();
  const double depth = 0.01;
  // Four nodes, each with a quarter of the stiffness of the only face that looks down.
  const contact::Surface& surface = blocks.touching().surface();
  const double stiffness = std::min(surface.stiffness[0], surface.stiffness[6]);
  test::verified("block pressed into a block: force over exact", "stiffness times depth")
      .near(blocks.force().z / (stiffness * depth), 1, 1e-9);
  test::verified("block pressed into a block: sum of forces", "conservation of momentum")
      .below(norm(test::total_force(blocks.domain())), 1e-12);
  test::verified("block pressed into a block: sum of moments", "conservation")
      .below(norm(test::total_moment(blocks.domain())), 1e-12);
  blocks.move({0.01, 0.02, -0.2});
  EXPECT_GT(blocks.force().z, 20 * stiffness * depth) << "and goes on, without a middle that it would pass";
  blocks.move({0, 0, 0.25});
  EXPECT_EQ(norm(blocks.force()), 0);
}

TEST(Faces, PushOutWhatLayOnThemFromTheStart) {
  Blocks blocks(0.5, 0.5);
  EXPECT_EQ(norm(blocks.force()), 0);
  blocks.move({0, 0, -1e-3});
  EXPECT_GT(blocks.force().z, 0);
}

TEST(Faces, AllowAnOverlapOfTheStart) {
  Blocks blocks(0.5, 0.49);
  EXPECT_EQ(norm(blocks.force()), 0);
  EXPECT_GT(blocks.touching().statistics().initial_penetrations, 0);
  test::verified("block that overlaps at the start: overlap reported", "geometry")
      .near(blocks.touching().statistics().worst_initial, 0.01, 1e-12);
  blocks.move({0, 0, -1e-3});
  EXPECT_GT(blocks.force().z, 0);
}

/// What lies under a thin plate is behind its upper face.
TEST(Faces, LeaveAloneWhatIsOnTheFarSide) {
  Blocks blocks(0.05, -0.2);
  EXPECT_EQ(blocks.touching().statistics().initial_penetrations, 0);
  EXPECT_EQ(norm(blocks.force()), 0);
  blocks.move({0, 0, 1e-3});
  EXPECT_LT(blocks.force().z, 0) << "pushed out of the lower face";
}

/// Contact of two boxes of solids, each with a mesh of its own.
class TwoBoxes {
 public:
  using Place = std::function<test::Point(double, double, double)>;
  TwoBoxes(std::array<Index, 3> first, const Place& first_place, std::array<Index, 3> second,
           const Place& second_place) {
    bodies_.take_two_parts_of_solids();
    test::add_box(bodies_.model, 0, first[0], first[1], first[2], first_place);
    second_ = test::add_box(bodies_.model, 1, second[0], second[1], second[2], second_place);
    made_ = bodies_.build();
    touching_.emplace(bodies_.attach(made_));
    test::add_forces(*touching_, made_);
  }
  /// Moves the second box as a run does: velocities first.
  void step(const Vec3& velocity, double step) {
    for (Index i = second_; i < bodies_.model.nodes.count(); ++i) {
      const Index node = test::at(made_, i);
      made_.nodes.velocity[node] = velocity;
      made_.nodes.position[node] += step * velocity;
    }
    made_.clock.step = step;
    ++made_.clock.cycle;
    test::add_forces(*touching_, made_);
  }
  Vec3 force(Index node) const { return made_.contact_force[test::at(made_, second_ + node)]; }
  const contact::ContactStatistics& statistics() const { return touching_->statistics(); }
  void verify_search() { touching_->verify_search_every(1); }

 private:
  test::Bodies bodies_;
  Index second_ = 0;
  domain::Domain made_;
  std::optional<contact::Interface> touching_;
};

constexpr double level = 100.3;

test::Point slab(double u, double v, double w) {
  return {2 * u - 1, 2 * v - 1, level + 0.5 * w};
}

/// Down and to the side, over edges of the mesh: each node that went through one face is behind some face.
TEST(Faces, StopWhatSlidesOverEdgesWhileItGoesThrough) {
  for (int start = 0; start < 60; ++start) {
    const double x = -0.8 + 0.011 * start;
    TwoBoxes boxes({4, 4, 1}, slab, {1, 1, 1}, [&](double u, double v, double w) {
      return test::Point{x + 0.2 * u, 0.7 * x + 0.2 * v, level + 0.5 + 0.0021 + 0.2 * w};
    });
    boxes.verify_search();
    for (int i = 0; i < 6; ++i) boxes.step({0.1, 0.03, -0.01}, 0.1);
    for (Index node = 0; node < 4; ++node)
      EXPECT_GT(boxes.force(node).z, 0) << "start " << start << ", node " << node;
  }
}

/// Far from the origin, pressed down as slowly as by gravity.
TEST(Faces, StopWhatLiesOnThemToTheLastBit) {
  TwoBoxes boxes({4, 4, 1}, slab, {2, 2, 1}, [](double u, double v, double w) {
    return test::Point{0.9 * u - 0.4, 0.7 * v - 0.3, level + 0.5 + 0.2 * w};
  });
  for (int i = 1; i <= 2000; ++i) boxes.step({1e-10, 2e-10, -1e-9 * i}, 1e-3);
  for (Index node = 0; node < 9; ++node) EXPECT_GT(boxes.force(node).z, 0) << node;
  EXPECT_LT(boxes.statistics().worst_initial, 1e-12);
}

/// The far side of a solid is no intruder, be it thin, thinner on one side, and its mesh coarse.
TEST(Faces, LeaveAloneTheirOwnSolids) {
  TwoBoxes boxes(
      {4, 4, 1},
      [](double u, double v, double w) {
        return test::Point{40 * u, 40 * v, level + (1 - 0.4 * u) * w};
      },
      {4, 4, 1},
      [](double u, double v, double w) {
        return test::Point{40 * u, 40 * v, level + 5 + 0.1 * w};
      });
  EXPECT_EQ(boxes.statistics().initial_penetrations, 0);
}

/// Two columns of one element with flush sides that overlap a little.
TEST(Faces, OfFlushColumnsPressOnEachOther) {
  TwoBoxes boxes(
      {1, 1, 3},
      [](double u, double v, double w) {
        return test::Point{u, v, level + 3 * w};
      },
      {1, 1, 3},
      [](double u, double v, double w) {
        return test::Point{u, v, level + 2.99 + 3 * w};
      });
  EXPECT_EQ(boxes.statistics().initial_penetrations, 8);
  for (int i = 0; i < 5; ++i) boxes.step({1e-4, -1e-4, -1e-2}, 0.1);
  for (Index node = 0; node < 4; ++node) {
    EXPECT_GT(boxes.force(node).z, 0) << node;
    EXPECT_LT(std::hypot(boxes.force(node).x, boxes.force(node).y), 0.05 * boxes.force(node).z) << node;
  }
}

/// A flush column comes down while its sides swing over the rims of the other by a ten thousandth of their
/// width: all nodes bear from where they touch on, no matter on which side of the rim.
TEST(Faces, AreEnteredAtFlushRims) {
  constexpr double swing = 1e-4;
  TwoBoxes boxes(
      {1, 1, 3},
      [](double u, double v, double w) {
        return test::Point{u, v, level + 3 * w};
      },
      {1, 1, 3},
      [](double u, double v, double w) {
        return test::Point{u + swing, v - swing, level + 3 + 0.5 * swing + 3 * w};
      });
  for (int i = 0; i < 12; ++i) {
    constexpr double step = 1e-3;
    boxes.step({(i % 2 == 0 ? -2 : 2) * swing / step, 0, -0.1 * swing / step}, step);
    if (i < 7) continue;
    const double middle = 0.25 * (boxes.force(0) + boxes.force(1) + boxes.force(2) + boxes.force(3)).z;
    EXPECT_GT(middle, 0) << i;
    for (Index node = 0; node < 4; ++node)
      EXPECT_NEAR(boxes.force(node).z, middle, 0.01 * middle) << "step " << i << ", node " << node;
  }
}

// What the springs of nodes hold that slide off a face, deep in it, pushes them off: the force has a
// potential.
TEST(Faces, PushOffTheirRims) {
  constexpr double depth = 0.01;
  constexpr double move = 5e-4;
  Blocks blocks(0.5, 0.5 + 0.1 * depth);
  // Two of the four nodes below are 0.05 from the rim at x = 1.
  blocks.move({0.75, 0, 0});
  for (int i = 0; i < 11; ++i) blocks.move({0, 0, -0.1 * depth});
  const double held = 0.5 * blocks.force().z;
  EXPECT_NEAR(blocks.force().x, 0, 1e-12 * held);
  double work = 0;
  double before = 0;
  for (double x = 0; x < 0.16; x += move) {
    blocks.move({move, 0, 0});
    const double now = blocks.force().x;
    work += 0.5 * (before + now) * move;
    before = now;
  }
  EXPECT_NEAR(before, 0, 1e-12 * held);
  EXPECT_NEAR(blocks.force().z, held, 1e-9 * held);
  test::verified("node that slides off a face of a solid: work over what its spring held", "1")
      .near(work / (0.5 * held * depth), 1, 2e-3);
}

/// One box comes down along the side of another, or glides in over its upper face, apart by little or
/// nothing: its nodes pass behind planes of faces that they do not meet. Steps are short: at the larger
/// gaps no path over a step crosses those faces.
TEST(Faces, AreNotEnteredByWhatPassesTheirRims) {
  constexpr double start = 0.01;
  constexpr double move = 5e-5;
  for (const bool glides : {false, true})
    for (const double gap : {0.0, 1e-6, 2e-4, 8e-4}) {
      const test::Point corner =
          glides ? test::Point{-1 - start, 0, level + 3 + gap} : test::Point{1 + gap, 0, level + 3 + start};
      TwoBoxes boxes(
          {2, 2, 3},
          [](double u, double v, double w) {
            return test::Point{u, v, level + 3 * w};
          },
          {2, 2, 3},
          [&](double u, double v, double w) {
            return test::Point{corner[0] + u, corner[1] + v, corner[2] + 3 * w};
          });
      const Vec3 velocity = glides ? Vec3{move, 0, 0} : Vec3{0, 0, -move};
      double largest = 0;
      for (int i = 0; i < 3 * start / move; ++i) {
        boxes.step(velocity, 1);
        for (Index node = 0; node < 36; ++node) largest = std::max(largest, norm(boxes.force(node)));
      }
      EXPECT_EQ(largest, 0) << (glides ? "glides" : "falls") << ", gap " << gap;
    }
}

/// Turned by an angle about the x axis.
Vec3 turned(double angle, const Vec3& a) {
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  return {a.x, cosine * a.y - sine * a.z, sine * a.y + cosine * a.z};
}

// The force of a corner that a body turns about is that of its penetration: a stiffness that followed the
// faces of the corner would make or lose energy.
TEST(Faces, PressAsHardWhenABodyTurnsAboutItsCorner) {
  constexpr double start = 0.9;
  const Vec3 corner{0.1, 0.1, 1.001};
  test::Bodies bodies;
  bodies.take_two_parts_of_solids();
  test::add_box(bodies.model, 0, 1, 1, 1, [&](double u, double v, double w) {
    return test::Point{2 * u - 1, 2 * v - 1, w};
  });
  // The edge along x rises from the corner, which so is the lowest node at all angles.
  const auto place = [&](double angle, const Vec3& local) {
    return corner + turned(angle, {0.2 * local.x, 0.2 * local.y, 0.2 * local.z + 0.04 * local.x});
  };
  const Index small = test::add_box(bodies.model, 1, 1, 1, 1, [&](double u, double v, double w) {
    const Vec3 x = place(start, {u, v, w});
    return test::Point{x.x, x.y, x.z};
  });
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  std::array<Vec3, 8> local;
  for (Index i = 0; i < 8; ++i) {
    const Vec3 back = turned(-start, made.nodes.position[test::at(made, small + i)] - corner);
    local[i] = {back.x / 0.2, back.y / 0.2, (back.z - 0.2 * back.x) / 0.2};
  }
  const auto put = [&](double angle, double depth) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Index i = 0; i < 8; ++i)
      x[test::at(made, small + i)] = place(angle, local[i]) - Vec3{0, 0, 0.001 + depth};
    test::move_to(touching, made, x, 0.1);
  };
  put(start, 0.002);
  test::settle(touching, made);
  ASSERT_EQ(made.contacts[0].active_pairs, 1);
  const auto force = [&] {
    double sum = 0;
    for (Index i = 0; i < 8; ++i) sum += made.contact_force[test::at(made, small + i)].z;
    return sum;
  };
  const double before = force();
  ASSERT_GT(before, 0);
  test::Largest off("cube turned about a corner pressed into a face: force, relative change", "none", 1e-12);
  for (double angle = start; angle > 0.4; angle -= 0.02) {
    put(angle, 0.002);
    test::settle(touching, made);
    ASSERT_EQ(made.contacts[0].active_pairs, 1);
    off.compare(force(), before, before);
  }
}

}  // namespace
}  // namespace crumple::faces_test
