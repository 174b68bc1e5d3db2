// SPDX-License-Identifier: BSD-3-Clause
// Ties beside a contact of all parts: what is tied does not touch, until its tie ends.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/larger.hpp"
#include "support/run.hpp"
#include "support/shapes.hpp"
#include "support/ties.hpp"

namespace crumple::tied_beside_contact_test {
namespace {

using math::Vec3;

struct End {
  std::vector<Vec3> position;
  double contact_energy = 0;
};

End end_of(const model::Model& model) {
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  End end{.position = {domain.nodes.position.begin(), domain.nodes.position.end()}};
  for (const domain::ContactReport& contact : domain.contacts) end.contact_energy += contact.energy;
  return end;
}

/// The contact with friction of all parts changes no bit of the motion.
void expect_no_contact(model::Model model, const char* what) {
  const End alone = end_of(model);
  test::touch_all(model, 0.3);
  const End beside = end_of(model);
  EXPECT_TRUE(std::ranges::equal(alone.position, beside.position, [](const Vec3& a, const Vec3& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  })) << what;
  EXPECT_EQ(beside.contact_energy, 0) << what;
}

model::Model shaken(model::Model model) {
  test::shake(model);
  model.control.end_time = 0.05;
  return model;
}

TEST(TiedBesideContact, WhatIsTiedDoesNotTouch) {
  for (const auto method : {model::TieMethod::Constraint, model::TieMethod::Penalty}) {
    expect_no_contact(shaken(test::two_blocks(2, 3, 4, method)), "blocks, nodes apart");
    expect_no_contact(shaken(test::two_blocks(2, 4, 4, method)), "blocks, one mesh finer");
    model::Model joint = test::shell_joint(true, 8);
    joint.tied_contacts[0].method = method;
    expect_no_contact(shaken(joint), "strip that stands on a plate");
  }
}

// A tie that ends at once leaves a contact: a block that comes at 5 m/s does not go through the other.
TEST(TiedBesideContact, WhatIsTiedNoLongerDoes) {
  for (const auto method : {model::TieMethod::Constraint, model::TieMethod::Penalty}) {
    model::Model model = test::two_blocks(2, 2, 4, method);
    model.tied_contacts[0].death_time = 1e-9;
    for (Index i = 0; i < model.nodes.count(); ++i)
      if (model.nodes.position[i][0] > 10 || i >= 45)
        model.initial_velocities.push_back({.node = i, .velocity = {-5, 0, 0}, .angular_velocity = {}});
    model.control.end_time = 0.02;
    test::touch_all(model);
    const End end = end_of(model);
    double left = 0;
    double right = 1e9;
    for (std::size_t i = 0; i < end.position.size(); ++i) {
      if (i < 45)
        left = test::larger_of(left, end.position[i].x);
      else
        right = std::min(right, end.position[i].x);
    }
    EXPECT_LT(left - right, 0.02) << "of 0.1 without contact";
  }
}

}  // namespace
}  // namespace crumple::tied_beside_contact_test
