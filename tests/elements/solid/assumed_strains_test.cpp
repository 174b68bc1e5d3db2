// SPDX-License-Identifier: BSD-3-Clause
// Hourglass control by assumed strains (IHQ 6) where the element changes its shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "elements/solid_harness.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::assumed_strains_test {
namespace {

/// What a cube with assumed strains stores in its hourglass modes when it is deformed in them by `pattern`,
/// then stretched in one direction to half and in others to twice and 1.5 times its size, and straightened.
struct BentAndStretched {
  double bent = 0;          ///< [energy]
  double stretched = 0;     ///< [energy]
  double straightened = 0;  ///< [energy]
  double least = 0;         ///< at any time [energy]
  double work = 0;          ///< against the nodal forces, in all [energy]
  double booked = 0;        ///< internal and hourglass energy at the end [energy]

  template <class Pattern>
  explicit BentAndStretched(const Pattern& pattern)
      : body_(cube(), {Precision::Double, available_isas().back(), 1}) {
    std::vector<Vec3> bend;
    for (const Vec3& x : body_.domain.nodes.position) bend.push_back(0.2 * pattern(x - Vec3{1, 1, 1}));
    const auto scaled = [](const Vec3& by, const Vec3& a) {
      return Vec3{by.x * a.x, by.y * a.y, by.z * a.z};
    };
    const auto growth = [](double f) { return std::pow(f, 1.0 / steps) - 1; };
    const Vec3 shape{0.5, 2, 1.5};
    const Vec3 stretch{growth(shape.x), growth(shape.y), growth(shape.z)};
    bent = drive([&](Index i, const Vec3&) { return 1.0 / steps * bend[i]; });
    stretched = drive([&](Index, const Vec3& x) { return scaled(stretch, x); });
    straightened = drive([&](Index i, const Vec3&) { return -1.0 / steps * scaled(shape, bend[i]); });
  }

 private:
  static constexpr int steps = 4000;
  static model::Model cube() {
    model::Model model = solid_cube(solid_cases[5], 1, 0, elastic());
    model.control.hourglass.coefficient = 1;
    return model;
  }
  /// Each node moves by move_of(node, its position) in each step. Returns the energy at the end.
  template <class Move>
  double drive(const Move& move_of) {
    const domain::SolidBlock& block = body_.domain.solids[0];
    std::vector<Vec3> move(body_.domain.nodes.count());
    for (int k = 0; k < steps; ++k) {
      for (Index i = 0; i < body_.domain.nodes.count(); ++i)
        move[i] = move_of(i, body_.domain.nodes.position[i]);
      for (std::size_t i = 0; i < move.size(); ++i)
        work -= 0.5 * dot(body_.force(static_cast<Index>(i)), move[i]);
      body_.step(1e-7, move, std::vector<Vec3>(move.size()));
      for (std::size_t i = 0; i < move.size(); ++i)
        work -= 0.5 * dot(body_.force(static_cast<Index>(i)), move[i]);
      least = std::min(least, block.hourglass_energy);
    }
    booked = block.internal_energy + block.hourglass_energy;
    return block.hourglass_energy;
  }

  Driven body_;
};

TEST(AssumedStrains, GiveBackWhatBendingStoredWhateverTheShape) {
  const BentAndStretched found([](const Vec3& u) {
    return Vec3{0.3 * u.x * u.z, -0.1 * u.x * u.y, 0.2 * u.x * u.y * u.z};
  });
  EXPECT_GT(found.bent, 0);
  const std::string name = "IHQ 6, cube bent, stretched and straightened: hourglass energy ";
  test::verified(name + "after the stretch over that before", "convected modes")
      .near(found.stretched / found.bent, 1, 1e-3);
  test::verified(name + "at the end over that stored", "elastic")
      .near(found.straightened / found.bent, 0, 1e-3);
  EXPECT_GE(found.least, -1e-9 * found.bent);
  test::verified(name + "and internal energy over the work of the nodal forces", "conservation")
      .near(found.booked / found.work, 1, 1e-3);
}

TEST(AssumedStrains, NeverStoreLessThanNothing) {
  const BentAndStretched found([](const Vec3& u) {
    return Vec3{0.3 * u.x * u.z + 0.1 * u.y * u.z, 0.2 * u.x * u.z - 0.1 * u.x * u.y, 0.1 * u.x * u.y * u.z};
  });
  EXPECT_GT(found.bent, 0);
  EXPECT_GE(found.least, -1e-9 * found.bent);
  EXPECT_GE(found.straightened, -1e-9 * found.bent);
  test::verified(
      "IHQ 6, cube twisted, stretched and straightened: internal and hourglass energy over the work of the "
      "nodal forces",
      "conservation")
      .near(found.booked / found.work, 1, 1e-3);
}

}  // namespace
}  // namespace crumple::elements::testing::assumed_strains_test
