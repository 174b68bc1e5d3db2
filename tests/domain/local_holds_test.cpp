// SPDX-License-Identifier: BSD-3-Clause
#include "domain/local_holds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "domain/build.hpp"
#include "support/meshes.hpp"

namespace crumple::domain::local_holds_test {
namespace {

const double half = std::sqrt(0.5);

model::Model sheet() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1.0, 3));
  test::add_grid(model, 0, 2, 2, [](double u, double v) { return test::Point{u, v, 0}; });
  return model;
}

/// Held along (1, 0, 1).
model::LocalSupport oblique(Index node) {
  return {.node = node,
          .axes = {{{half, 0, half}, {0, 1, 0}, {-half, 0, half}}},
          .translation = {true, false, false},
          .rotation = {}};
}

TEST(LocalHolds, ProjectOnWhatSupportsLeaveFree) {
  model::Model model = sheet();
  model.local_supports.push_back(oblique(4));
  const Domain domain = build(model, {});
  const Index node = domain.nodes.domain_node[4];
  ASSERT_NE(domain.nodes.local_hold_of(node), nullptr);
  EXPECT_EQ(domain.nodes.local_hold_of(domain.nodes.domain_node[3]), nullptr);
  EXPECT_EQ(domain.nodes.local_hold_of(node)->held, 1);
  EXPECT_TRUE(domain.nodes.local_hold_of(node)->lasts);
  EXPECT_LT(norm(domain.nodes.free_translation(node, {3, 5, 1}) - Vec3{1, 5, -1}), 1e-15);
}

TEST(LocalHolds, HaveTheFixedAxesAndRepeatNothing) {
  model::Model model = sheet();
  for (int twice = 0; twice < 2; ++twice) model.local_supports.push_back(oblique(4));
  model.fixed_nodes.push_back({.node = 4, .translation = {true, false, false}, .rotation = {}});
  Domain domain = build(model, {});
  const Index node = domain.nodes.domain_node[4];
  EXPECT_EQ(domain.nodes.local_hold_of(node)->held, 2);
  EXPECT_LT(norm(domain.nodes.free_translation(node, {3, 5, 1}) - Vec3{0, 5, 0}), 1e-15);
  model.fixed_nodes[0].translation = {true, true, false};
  domain = build(model, {});
  EXPECT_EQ(domain.nodes.local_hold_of(node)->held, 3);
  EXPECT_EQ(norm(domain.nodes.free_translation(node, {3, 5, 1})), 0);
}

TEST(LocalHolds, LastFromBirthToDeath) {
  model::Model model = sheet();
  model::LocalSupport support{.node = 2, .translation = {true, true, false}, .rotation = {}};
  support.birth = 0.5;
  support.death = 2;
  model.local_supports.push_back(support);
  Domain domain = build(model, {});
  const Index node = domain.nodes.domain_node[2];
  EXPECT_FALSE(domain.nodes.local_hold_of(node)->lasts);
  for (const auto& [time, held] :
       {std::pair{0.0, 0}, std::pair{0.5, 2}, std::pair{1.9, 2}, std::pair{2.0, 0}}) {
    list_local_holds(model, time, domain.nodes);
    EXPECT_EQ(domain.nodes.local_hold_of(node)->held, held) << time;
  }
}

}  // namespace
}  // namespace crumple::domain::local_holds_test
