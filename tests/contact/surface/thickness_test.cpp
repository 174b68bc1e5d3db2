// SPDX-License-Identifier: BSD-3-Clause
// Where shells that are thick beside their edges have their whole thickness in contact, and where not.

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "contact/bodies.hpp"
#include "contact/surface/surface.hpp"
#include "support/largest.hpp"

namespace crumple::thickness_test {
namespace {

using model::ContactKind;
using test::Bodies;
using test::Vec3;

/// Sheets of one side and thickness over each other, each a part: the first at z = 0, the last ones moved.
class Stack {
 public:
  Stack(double side, double thickness, int elements, const std::vector<double>& heights)
      : bodies_(thickness) {
    bodies_.contact.kind = ContactKind::SurfaceToSurface;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      if (i > 0) bodies_.part();
      first_.push_back(bodies_.sheet(elements, elements, [&](double u, double v) {
        return Vec3{side * u, side * v, heights[i]};
      }));
    }
    first_.push_back(bodies_.model.nodes.count());
  }

  Bodies& bodies() { return bodies_; }
  model::Contact& contact() { return bodies_.contact; }

  void start() {
    made_ = bodies_.build();
    touching_.emplace(bodies_.attach(*made_));
    touching_->verify_search_every(1);
    test::add_forces(*touching_, *made_);
  }
  void move(std::size_t sheet, double by) {
    std::vector<Vec3> x(made_->nodes.position.begin(), made_->nodes.position.end());
    for (Index node = first_[sheet]; node < first_[sheet + 1]; ++node) x[test::at(*made_, node)].z += by;
    test::move_to(*touching_, *made_, x, 0.1);
  }
  double force_on(std::size_t sheet) const {
    double sum = 0;
    for (Index node = first_[sheet]; node < first_[sheet + 1]; ++node)
      sum += made_->contact_force[test::at(*made_, node)].z;
    return sum;
  }
  const domain::Domain& made() const { return *made_; }
  const contact::Interface& touching() const { return *touching_; }

 private:
  Bodies bodies_;
  std::vector<Index> first_;
  std::optional<domain::Domain> made_;
  std::optional<contact::Interface> touching_;
};

/// How far an upper tool goes down before a sheet between two tools bears it, in steps of a hundredth of the
/// thickness [thickness].
double travel_to_clamp(ContactKind kind, int elements) {
  constexpr double thickness = 1;
  Stack stack(10, thickness, elements, {0, thickness, -thickness});
  stack.contact().kind = kind;
  stack.contact().side[0].parts = {0};
  stack.contact().side[1].parts = {1, 2};
  stack.start();
  EXPECT_EQ(stack.made().contacts[0].initial_overlaps.size(), 0U);
  double travel = 0;
  for (; travel < 1 && stack.force_on(1) <= 0; travel += 0.01) stack.move(1, -0.01);
  return travel;
}

TEST(ShellThickness, OfASheetBetweenToolsDoesNotDependOnTheMesh) {
  for (const ContactKind kind : {ContactKind::SurfaceToSurface, ContactKind::NodesToSurface})
    for (const int elements : {2, 5, 10, 20})
      test::verified(
          "sheet of 1 mm between tools, mesh of 5 to 0.5 mm: travel of the tool over the thickness", "none")
          .below(travel_to_clamp(kind, elements), 0.05);
}

TEST(ShellThickness, OfPlatesHoldsThemApart) {
  Stack stack(40, 6, 10, {0, 7});  // 4 mm elements
  stack.contact().side[0].parts = {0};
  stack.contact().side[1].parts = {1};
  stack.start();
  stack.move(1, -0.99);
  EXPECT_EQ(stack.force_on(1), 0);
  stack.move(1, -0.02);
  EXPECT_GT(stack.force_on(1), 0) << "at 5.99 mm";
  EXPECT_EQ(stack.made().contacts[0].thickness_cut.shells, 0);
}

TEST(ShellThickness, IsCutWhereASurfaceMayTouchItself) {
  const auto cut_of = [](ContactKind kind, const std::vector<Index>& first, const std::vector<Index>& second,
                         const std::vector<Index>& nodes) {
    Stack stack(40, 6, 10, {0, 7});
    stack.contact().kind = kind;
    stack.contact().side[0].parts = first;
    stack.contact().side[0].nodes = nodes;
    stack.contact().side[1].parts = second;
    stack.start();
    return stack.made().contacts[0].thickness_cut;
  };
  const domain::ThicknessCut all = cut_of(ContactKind::SingleSurface, {0, 1}, {}, {});
  EXPECT_EQ(all.shells, 200);
  EXPECT_EQ(all.from, 6);
  EXPECT_DOUBLE_EQ(all.to, 1.6);
  EXPECT_EQ(all.part, 1);
  EXPECT_EQ(cut_of(ContactKind::SurfaceToSurface, {0}, {0, 1}, {}).shells, 100)
      << "one part is on both sides";
  EXPECT_EQ(cut_of(ContactKind::NodesToSurface, {1}, {0, 1}, {}).shells, 100);
  EXPECT_EQ(cut_of(ContactKind::NodesToSurface, {0}, {1}, {}).shells, 0);
  EXPECT_EQ(cut_of(ContactKind::NodesToSurface, {}, {0}, {0}).shells, 1) << "a node of the surface is named";
}

// A mesh that begins within the whole thickness overlaps at the start, and does not push.
TEST(ShellThickness, ThatOverlapsAtTheStartIsAllowed) {
  Stack stack(40, 6, 10, {0, 4});
  stack.contact().side[0].parts = {0};
  stack.contact().side[1].parts = {1};
  stack.start();
  ASSERT_GE(stack.made().contacts[0].initial_overlaps.size(), 2U * 121U);
  test::verified("plates of 6 mm that begin 4 mm apart: initial penetration", "2 mm")
      .near(stack.made().contacts[0].initial_overlaps.front().depth, 2, 1e-12);
  stack.move(1, 0);
  EXPECT_EQ(stack.force_on(1), 0);
  stack.move(1, -0.01);
  EXPECT_GT(stack.force_on(1), 0);
}

}  // namespace
}  // namespace crumple::thickness_test
