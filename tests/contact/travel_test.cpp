// SPDX-License-Identifier: BSD-3-Clause
#include "contact/travel.hpp"

#include <gtest/gtest.h>

#include <cellsearch/error.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace crumple::contact {
namespace {

/// Nodes that swing, each with its own frequency, while all of them drift away together.
std::vector<Vec3> swinging(int nodes, double time) {
  std::vector<Vec3> x;
  for (int i = 0; i < nodes; ++i) {
    const double phase = (1 + 0.37 * i) * time;
    x.push_back(
        {10 * time + 0.3 * std::sin(phase), 0.2 * std::cos(2 * phase), i + 0.1 * std::sin(5 * phase)});
  }
  return x;
}

// The bound holds for every pair, measured whenever, and is not so large that it would be of no use.
TEST(Travel, NobodyComesNearerThanTheWayAllows) {
  constexpr int nodes = 9;
  constexpr int steps = 400;
  const std::vector<Index> all{0, 1, 2, 3, 4, 5, 6, 7, 8};
  Travel travel(0.05, 1);
  const auto x_at = [](int step) { return swinging(nodes, 0.002 * step); };
  travel.start(x_at(0), all);
  struct Measured {
    int a;
    int b;
    double distance;
    double length_to_meet;
  };
  std::vector<Measured> measured;
  double tightest = std::numeric_limits<double>::max();
  for (int step = 1; step <= steps; ++step) {
    const std::vector<Vec3> x = x_at(step);
    travel.update(x);
    // By the time the way has grown by g, no distance has shrunk by more.
    for (const Measured& pair : measured) {
      const double used = travel.length() - (pair.length_to_meet - pair.distance);
      const double nearer = pair.distance - norm(x[pair.a] - x[pair.b]);
      EXPECT_LE(nearer, used * (1 + 1e-12));
      if (nearer > 0.1) tightest = std::min(tightest, used / nearer);
    }
    if (step % 7 != 0) continue;
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b < a; ++b) {
        const double distance = norm(x[a] - x[b]);
        measured.push_back({a, b, distance, travel.length_to_meet(distance)});
      }
  }
  EXPECT_LT(tightest, 6);
}

TEST(Travel, AMotionInCommonIsNoWay) {
  std::vector<Vec3> x{{0, 0, 0}, {1, 2, 3}};
  Travel travel(0.1, 1);
  travel.start(x, std::vector<Index>{0, 1});
  for (int step = 0; step < 64; ++step) {
    for (Vec3& p : x) p += Vec3{0.25, -0.5, 1};
    travel.update(x);
  }
  EXPECT_EQ(travel.length(), 0);
}

TEST(Travel, RefusesWhatIsNotFinite) {
  std::vector<Vec3> x{{0, 0, 0}, {1, 2, 3}};
  Travel travel(0.1, 1);
  travel.start(x, std::vector<Index>{0, 1});
  x[1].y = std::nan("");
  EXPECT_THROW(travel.update(x), cellsearch::Error);
}

}  // namespace
}  // namespace crumple::contact
