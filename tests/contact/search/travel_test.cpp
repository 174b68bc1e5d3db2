// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/travel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cellsearch/error.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/larger.hpp"

namespace crumple::contact::travel_test {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

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

/// The way of the step from `from` to `to`: the size of what any two moved relative to each other, by axis.
double way_between(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  Vec3 way;
  for (std::size_t a = 0; a < to.size(); ++a)
    for (std::size_t b = 0; b < to.size(); ++b)
      for (int axis = 0; axis < 3; ++axis)
        way[axis] = test::larger_of(way[axis], (to[a] - from[a])[axis] - (to[b] - from[b])[axis]);
  return norm(way);
}

/// Whether a step's way is told.
using Told = bool (*)(int step);
bool never(int /*step*/) {
  return false;
}
bool always(int /*step*/) {
  return true;
}
bool mostly(int step) {
  return step % 23 != 0;
}

struct Telling {
  const char* name = "";
  Told told = never;
  double leg_limit = 0;  ///< steps are some 0.003 long
  double loosest = 0;    ///< of the bound over the truth
};

class TravelTold : public ::testing::TestWithParam<Telling> {};

// The bound holds for every pair, measured whenever, and is not so large that it would be of no use.
TEST_P(TravelTold, NobodyComesNearerThanTheWayAllows) {
  constexpr int nodes = 9;
  constexpr int steps = 400;
  const std::vector<Index> all{0, 1, 2, 3, 4, 5, 6, 7, 8};
  Travel travel(GetParam().leg_limit, 1);
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
  double length = 0;
  for (int step = 1; step <= steps; ++step) {
    const std::vector<Vec3> x = x_at(step);
    travel.update(x, GetParam().told(step) ? way_between(x_at(step - 1), x) : unknown);
    EXPECT_GE(travel.length(), length);
    length = travel.length();
    // By the time the way has grown by g, no distance has shrunk by more.
    for (const Measured& pair : measured) {
      const double used = length - (pair.length_to_meet - pair.distance);
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
  EXPECT_LT(tightest, GetParam().loosest);
}

INSTANTIATE_TEST_SUITE_P(All, TravelTold,
                         ::testing::Values(Telling{"unknown", never, 0.05, 6},
                                           Telling{"known_long_legs", always, 0.05, 6},
                                           Telling{"known_short_legs", always, 0.002, 6},
                                           Telling{"mostly_long_legs", mostly, 0.05, 6},
                                           Telling{"mostly_short_legs", mostly, 0.002, 6}),
                         [](const auto& which) { return std::string(which.param.name); });

// Steps to and fro add up to much more than anybody has moved.
TEST(Travel, MeasuresWhereNodesGoToAndFro) {
  constexpr double amplitude = 0.01;
  const auto x_at = [](int step) {
    return std::vector<Vec3>{{0, 0, 0}, {1 + amplitude * std::sin(0.3 * step), 0, 0}};
  };
  Travel travel(0.05, 1);
  travel.start(x_at(0), std::vector<Index>{0, 1});
  double sum = 0;
  for (int step = 1; step <= 1000; ++step) {
    const double way = way_between(x_at(step - 1), x_at(step));
    sum += way;
    travel.update(x_at(step), way);
  }
  EXPECT_GT(sum, 1.8);
  EXPECT_LE(travel.length(), 0.05);
  EXPECT_GE(travel.length(), 0.99 * 2 * amplitude);
}

TEST(Travel, AMotionInCommonIsNoWay) {
  std::vector<Vec3> x{{0, 0, 0}, {1, 2, 3}};
  Travel travel(0.1, 1);
  travel.start(x, std::vector<Index>{0, 1});
  for (int step = 0; step < 64; ++step) {
    for (Vec3& p : x) p += Vec3{0.25, -0.5, 1};
    travel.update(x, unknown);
  }
  EXPECT_EQ(travel.length(), 0);
  // Where it is told, rounding alone counts.
  for (int step = 0; step < 64; ++step) {
    for (Vec3& p : x) p += Vec3{0.25, -0.5, 1};
    travel.update(x, 0);
  }
  EXPECT_LT(travel.length(), 1e-10);
}

TEST(Travel, RefusesWhatIsNotFinite) {
  std::vector<Vec3> x{{0, 0, 0}, {1, 2, 3}};
  Travel travel(0.1, 1);
  travel.start(x, std::vector<Index>{0, 1});
  travel.update(x, 0.01);
  x[1].y = std::nan("");
  EXPECT_THROW(travel.update(x, std::nan("")), cellsearch::Error);
  EXPECT_THROW(travel.update(x, unknown), cellsearch::Error);
}

}  // namespace
}  // namespace crumple::contact::travel_test
