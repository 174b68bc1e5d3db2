// SPDX-License-Identifier: BSD-3-Clause
// Seams of flush solids: what slides over them is borne by one after the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/bodies.hpp"
#include "support/meshes.hpp"
#include "support/verified.hpp"

namespace crumple::seam_test {
namespace {

using math::Vec3;

constexpr double top = 1.0;

/// Where the second block of the floor stands beside the first.
struct Seam {
  double gap = 0;   ///< between the two [length]
  double step = 0;  ///< by how much the second is higher [length]
};

/// A floor of two blocks with elements of 1 x 1 x 1, whose seam is the plane x = 0, and a block on the first.
class Floor {
 public:
  Floor(const Seam& seam, Index elements, double start) {
    bodies_.take_two_parts_of_solids();
    test::add_box(bodies_.model, 0, 4, 3, 1, [](double u, double v, double w) {
      return test::Point{4 * u - 4, 3 * v, top * w};
    });
    test::add_box(bodies_.model, 0, 4, 3, 1, [&](double u, double v, double w) {
      return test::Point{seam.gap + 4 * u, 3 * v, seam.step + top * w};
    });
    slider_ = test::add_box(bodies_.model, 1, elements, elements, 1, [&](double u, double v, double w) {
      return test::Point{start + 0.8 * u, 1.13 + 0.8 * v, top + 1e-4 + 0.5 * w};
    });
    made_ = bodies_.build();
    touching_.emplace(bodies_.attach(made_));
    test::add_forces(*touching_, made_);
  }

  /// Moves the block as a run does: velocities first.
  void move(const Vec3& by) {
    for (Index i = slider_; i < bodies_.model.nodes.count(); ++i) {
      const Index node = test::at(made_, i);
      made_.nodes.velocity[node] = by;
      made_.nodes.position[node] += by;
    }
    made_.clock.step = 1;
    ++made_.clock.cycle;
    test::add_forces(*touching_, made_);
  }
  /// On the block.
  Vec3 force() const {
    Vec3 sum;
    for (Index i = slider_; i < bodies_.model.nodes.count(); ++i)
      sum += made_.contact_force[test::at(made_, i)];
    return sum;
  }

 private:
  test::Bodies bodies_;
  Index slider_ = 0;
  domain::Domain made_;
  std::optional<contact::Interface> touching_;
};

/// Pressed down by `depth`, the block slides over the seam. The largest force along, over the one upwards.
struct Slide {
  double along = 0;
  double least_upwards = 0;
  double most_upwards = 0;
};
Slide slide(const Seam& seam, Index elements, double depth) {
  constexpr double start = -1.53;
  constexpr double move = 0.01;
  Floor floor(seam, elements, start);
  floor.move({move, 0, -1e-4 - 0.5 * depth});
  floor.move({move, 0, -0.5 * depth});
  floor.move({move, 0, 0});
  const double upwards = floor.force().z;
  Slide found{0, upwards, upwards};
  for (int i = 0; i < 2.3 / move; ++i) {
    floor.move({move, 0, 0});
    const Vec3 force = floor.force();
    found.along = std::max(found.along, std::fabs(force.x) / upwards);
    found.least_upwards = std::min(found.least_upwards, force.z);
    found.most_upwards = std::max(found.most_upwards, force.z);
  }
  found.least_upwards /= upwards;
  found.most_upwards /= upwards;
  return found;
}

TEST(Seams, AreNoObstacleToWhatIsPressedOntoThem) {
  for (const Index elements : {1, 3})
    for (const Seam& seam : {Seam{0, 0}, Seam{1e-8, 0}, Seam{1e-3, 0}, Seam{0, 1e-8}, Seam{0, 1e-4}}) {
      const Slide found = slide(seam, elements, 2e-3);
      test::verified("block slid over the seam of two flush blocks: force along over the one upwards",
                     "no friction")
          .below(found.along, 1e-9);
      EXPECT_GT(found.least_upwards, 0.5) << elements << " gap " << seam.gap << " step " << seam.step;
    }
}

TEST(Seams, ThatAreStepsStopWhatSlides) {
  for (const double step : {0.01, 0.05, 0.1}) {
    const Slide found = slide({0, step}, 1, 2e-3);
    EXPECT_GT(found.along, 1) << step;
  }
}

}  // namespace
}  // namespace crumple::seam_test
