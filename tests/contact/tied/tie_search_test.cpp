// SPDX-License-Identifier: BSD-3-Clause
#include "contact/tied/tie_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "base/error.hpp"
#include "contact/surface/nearest_segment.hpp"
#include "domain/build.hpp"
#include "support/largest.hpp"
#include "support/ties.hpp"

namespace crumple::contact::tie_search_test {
namespace {

domain::Domain found(const model::Model& model) {
  domain::Domain domain = domain::build(model, {Precision::Double, default_isa(), 1});
  find_ties(model, domain);
  return domain;
}

/// Two plates of 4 x 4 shells of side 1 and thickness 0.2, `gap` above each other.
model::Model two_plates(double gap, model::TieMethod method) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.2, 3));
  model.parts.push_back({.id = 2, .title = "upper", .section = 0, .material = 0});
  test::add_grid(model, 0, 4, 4, [](double u, double v) { return test::Point{4 * u, 4 * v, 0}; });
  test::add_grid(model, 1, 3, 3, [=](double u, double v) {
    return test::Point{0.5 + 3 * u, 0.5 + 3 * v, gap};
  });
  test::add_tie(model, method);
  return model;
}

TEST(TieSearch, NearestAgreesWithBruteForce) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.1, 3));
  test::add_grid(model, 0, 17, 13, [](double u, double v) {
    return test::Point{10 * u, 8 * v, std::sin(5 * u) * std::cos(3 * v)};
  });
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-4, 14);
  const Index first = model.nodes.count();
  for (int i = 0; i < 200; ++i) {
    model.nodes.id.push_back(model.nodes.count() + 1);
    model.nodes.position.push_back({place(random), place(random), place(random) / 4});
  }
  const domain::Domain domain = domain::build(model, {Precision::Double, default_isa(), 1});
  model::Contact contact = model::self_contact(1, "", {0});
  const Surface surface = build_surface(model, domain, contact);
  const Configuration x{domain.nodes.position.data(), domain.nodes.velocity.data(), 0};
  std::vector<Index> all(static_cast<std::size_t>(surface.segments()));
  std::iota(all.begin(), all.end(), 0);
  const NearestSegment tree(surface, x, all);
  test::Largest off("nearest segment of a bent surface: squared distance, error",
                    "brute force over all segments", 1e-12);
  for (Index i = first; i < model.nodes.count(); ++i) {
    const Index node = domain.nodes.domain_node[i];
    double least = 1e30;
    for (const Index s : all)
      least = std::min(least, nearest_point(shape_of(surface, x, s), x[node]).distance_squared);
    off.compare(tree.find(node, {}, false).nearest.distance_squared, least);
  }
}

TEST(TieSearch, ConstraintPutsNodesOntoTheSegment) {
  const model::Model model = two_plates(0.15, model::TieMethod::Constraint);
  const domain::Domain domain = found(model);
  const domain::Tie& tie = domain.ties[0];
  ASSERT_EQ(tie.nodes.size(), 16U);
  EXPECT_EQ(tie.segments, 16);
  EXPECT_NEAR(tie.largest_move, 0.15, 1e-15);
  test::Largest weights("tied nodes: sum of the weights less 1", "partition of unity", 1e-15);
  for (const domain::TiedNode& tied : tie.nodes) {
    EXPECT_NEAR(domain.nodes.position[tied.node].z, 0, 1e-15);
    EXPECT_EQ(domain.nodes.reference[tied.node].z, domain.nodes.position[tied.node].z);
    double sum = 0;
    for (const double weight : tied.weight) sum += weight;
    weights.compare(sum, 1);
  }
}

TEST(TieSearch, PenaltyKeepsTheGap) {
  const domain::Domain domain = found(two_plates(0.15, model::TieMethod::Penalty));
  for (const domain::TiedNode& tied : domain.ties[0].nodes) {
    EXPECT_NEAR(std::fabs(tied.height), 0.15, 1e-15);
    EXPECT_EQ(tied.side, tied.height > 0 ? 1 : -1);
    EXPECT_NEAR(domain.nodes.position[tied.node].z, 0.15, 1e-15);
  }
  EXPECT_EQ(domain.ties[0].largest_move, 0);
}

/// 0.6 of the sum of both thicknesses, here more than 0.05 of a diagonal.
TEST(TieSearch, WhatIsTooFarIsListedWorstFirst) {
  EXPECT_EQ(found(two_plates(0.2399, model::TieMethod::Constraint)).ties[0].nodes.size(), 16U);
  model::Model model = two_plates(0.2399, model::TieMethod::Constraint);
  model.nodes.position[25][2] = 0.3;
  model.nodes.position[30][2] = 0.5;
  const domain::Tie tie = found(model).ties[0];
  EXPECT_EQ(tie.nodes.size(), 14U);
  ASSERT_EQ(tie.untied.size(), 2U);
  EXPECT_EQ(tie.untied[0].node, 31);
  EXPECT_NEAR(tie.untied[0].distance, 0.5, 1e-15);
  EXPECT_EQ(tie.untied[1].node, 26);
  model.tied_contacts[0].tolerance = 0.4;
  EXPECT_EQ(found(model).ties[0].nodes.size(), 15U);
}

TEST(TieSearch, AContactThatTiesNothingIsAnError) {
  EXPECT_THROW(found(two_plates(0.25, model::TieMethod::Constraint)), Error);
}

TEST(TieSearch, ANodeIsHeldByTheFirstConstraintAlone) {
  model::Model model = two_plates(0.1, model::TieMethod::Constraint);
  test::add_tie(model, model::TieMethod::Constraint);
  const domain::Domain domain = found(model);
  EXPECT_EQ(domain.ties[0].nodes.size(), 16U);
  EXPECT_TRUE(domain.ties[1].nodes.empty());
  EXPECT_EQ(domain.ties[1].tied_elsewhere, 16);
}

/// The nodes at the rim of a block lie on the rim of the other one, as near to its sides as to its end.
TEST(TieSearch, NodesAtARimAreTiedToTheFaceAcross) {
  const model::Model model = test::two_blocks(2, 4, 3, model::TieMethod::Penalty);
  const domain::Domain domain = found(model);
  const domain::Tie& tie = domain.ties[0];
  ASSERT_EQ(tie.nodes.size(), 25U);
  double area = 0;
  for (const domain::TiedNode& tied : tie.nodes) {
    for (const Index corner : tied.corner) EXPECT_NEAR(domain.nodes.position[corner].x, 10, 1e-12);
    area += tied.area;
  }
  test::verified("tied face of a block: sum of the nodes' areas", "geometry").near(area, 16, 1e-12);
}

/// Three plates, the third tied to the second before the second is to the first: all come to lie on the
/// first.
TEST(TieSearch, ChainsFollowInAnyOrder) {
  for (const bool reversed : {false, true}) {
    model::Model model = two_plates(0.15, model::TieMethod::Constraint);
    model.parts.push_back({.id = 3, .title = "top", .section = 0, .material = 0});
    const Index top = model.nodes.count();
    test::add_grid(model, 2, 2, 2, [](double u, double v) {
      return test::Point{1 + 2 * u, 1 + 2 * v, 0.27};
    });
    model::TiedContact second = model.tied_contacts[0];
    second.id += 1;
    second.side[0].parts = {2};
    second.side[1].parts = {1};
    model.tied_contacts.insert(reversed ? model.tied_contacts.begin() : model.tied_contacts.end(), second);
    const domain::Domain domain = found(model);
    for (Index i = top; i < model.nodes.count(); ++i) {
      const Index node = domain.nodes.domain_node[i];
      EXPECT_NEAR(domain.nodes.position[node].z, 0, 1e-15) << reversed;
      EXPECT_NEAR(domain.nodes.reference[node].z, 0, 1e-15) << reversed;
    }
  }
}

}  // namespace
}  // namespace crumple::contact::tie_search_test
