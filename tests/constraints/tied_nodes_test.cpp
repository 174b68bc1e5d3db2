// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/tied_nodes.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "base/error.hpp"
#include "support/verified.hpp"

namespace crumple::constraints::tied_nodes_test {
namespace {

using math::Vec3;

/// A square of nodes 0 to 3 of mass 2 and a node 4 of mass 1 above a quarter of it; nodes 5 of mass 3 and 6
/// as spares. Exact answers by hand.
class TiedNodesTest : public ::testing::Test {
 protected:
  TiedNodesTest() {
    constexpr Index count = 7;
    domain::NodeFields& nodes = domain_.nodes;
    nodes.position = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 1, 0}, {9, 9, 9}};
    nodes.velocity.assign(count, Vec3{});
    nodes.angular_velocity.assign(count, Vec3{});
    nodes.mass = {2, 2, 2, 2, 1, 3, 1};
    nodes.inertia.assign(count, 0.5);
    nodes.fixed.assign(count, 0);
    nodes.acceleration.resize(count);
    nodes.double_records.resize(count);
    for (Index i = 0; i < count; ++i) {
      nodes.domain_node.push_back(i);
      nodes.model_node.push_back(i);
      model_.nodes.id.push_back(i + 1);
      model_.nodes.position.push_back({});
    }
  }

  void tie(Index node, const std::array<Index, 4>& corner, const std::array<double, 4>& weight,
           bool rotations = false) {
    model::TiedContact& given = model_.tied_contacts.emplace_back();
    given.id = static_cast<UserId>(model_.tied_contacts.size());
    given.ties_rotations = rotations;
    domain::Tie& found = domain_.ties.emplace_back();
    found.id = given.id;
    found.nodes.push_back({.node = node, .corner = corner, .weight = weight});
    found.holds.push_back(1);
  }
  void tie_fourth(bool rotations = false) {
    tie(4, {0, 1, 2, 3}, {0.5625, 0.1875, 0.0625, 0.1875}, rotations);
  }

  /// A kick by a velocity change of each node, as forces over their own masses would give it.
  void kick(TiedNodes& tied, const std::vector<Vec3>& change) {
    tied.remember(domain_);
    for (std::size_t i = 0; i < change.size(); ++i) domain_.nodes.velocity[i] += change[i];
    tied.share(domain_);
    tied.follow(domain_, 0.5, 0.5);
  }
  Vec3 momentum() const {
    Vec3 sum;
    for (Index i = 0; i < domain_.nodes.count(); ++i)
      sum += domain_.nodes.mass[i] * domain_.nodes.velocity[i];
    return sum;
  }

  model::Model model_;
  domain::Domain domain_;
};

TEST_F(TiedNodesTest, ForceAndMassGoToTheSegment) {
  tie_fourth();
  TiedNodes tied(model_, domain_);
  EXPECT_DOUBLE_EQ(domain_.nodes.moving_mass(0), 2.5625);
  kick(tied, {{}, {}, {}, {}, {8, 0, 0}});
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].x, 8 * 0.5625 / 2.5625);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[2].x, 8 * 0.0625 / 2.0625);
  double mean = 0;
  for (const std::size_t k : {0U, 1U, 2U, 3U})
    mean += domain_.ties[0].nodes[0].weight[k] * domain_.nodes.velocity[k].x;
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[4].x, mean);
  test::verified("tied node is kicked: momentum of node and segment", "conservation")
      .near(momentum().x, 8, 1e-14);
  // What the tie gave the node is what it misses of its own kick.
  test::verified("tied node is kicked: force of the tie", "missing momentum over the step")
      .near(domain_.ties[0].force.x, (mean - 8) / 0.5, 1e-13);
}

// The clock needs it: what the nodes' velocities do not tell of their way.
TEST_F(TiedNodesTest, TellsHowFarItMovedNodesToTheirPlaces) {
  tie_fourth();
  // Node 6 is on the edge from node 4 to 5.
  tie(6, {4, 5, 5, 5}, {0.5, 0.5, 0, 0});
  const TiedNodes tied(model_, domain_);
  EXPECT_EQ(tied.place_nodes(domain_), 0);
  for (const auto& [far, near] : {std::pair<Index, Index>{4, 6}, {6, 4}}) {
    domain_.nodes.position[far] += Vec3{0.3, -0.4, 1.2};
    domain_.nodes.position[near] += Vec3{0, 0.25, 0};
    EXPECT_NEAR(tied.place_nodes(domain_), 1.3, 1e-15);
    EXPECT_EQ(norm(domain_.nodes.position[4] - Vec3{1, 1, 0}), 0);
    EXPECT_EQ(norm(domain_.nodes.position[6] - Vec3{1, 1, 0}), 0);
  }
}

TEST_F(TiedNodesTest, RotationsFollowWhereTheyAreTied) {
  tie_fourth(true);
  TiedNodes tied(model_, domain_);
  EXPECT_DOUBLE_EQ(domain_.nodes.moving_inertia(0), 0.5 + 0.5625 * 0.5);
  tied.remember(domain_);
  domain_.nodes.angular_velocity[4] = {0, 3, 0};
  tied.share(domain_);
  tied.follow(domain_, 1, 1);
  double moment = 0;
  for (Index i = 0; i < 4; ++i)
    moment += domain_.nodes.moving_inertia(i) * domain_.nodes.angular_velocity[i].y;
  test::verified("tied rotations: moment of momentum of the segment", "conservation")
      .near(moment, 1.5, 1e-14);
}

TEST_F(TiedNodesTest, VelocitiesAtTheStartKeepTheirMomentum) {
  domain_.nodes.velocity[4] = {10, 0, 0};
  tie_fourth();
  const Vec3 before = momentum();
  const TiedNodes tied(model_, domain_);
  test::verified("tie of a node that moves at the start: momentum, change", "conservation")
      .below(norm(momentum() - before), 1e-14);
  EXPECT_GT(domain_.nodes.velocity[0].x, domain_.nodes.velocity[2].x);
}

TEST_F(TiedNodesTest, ANodeOfASegmentMayBeTiedItself) {
  tie_fourth();
  // Node 6 is on the edge from node 4 to 5.
  tie(6, {4, 5, 5, 5}, {0.5, 0.5, 0, 0});
  TiedNodes tied(model_, domain_);
  EXPECT_DOUBLE_EQ(domain_.nodes.moving_mass(4), 1.5);
  EXPECT_DOUBLE_EQ(domain_.nodes.moving_mass(0), 2 + 0.5625 * 1.5);
  kick(tied, {{}, {}, {}, {}, {}, {}, {4, 0, 0}});
  test::verified("node tied to a tied node is kicked: momentum", "conservation").near(momentum().x, 4, 1e-14);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[6].x,
                   0.5 * (domain_.nodes.velocity[4].x + domain_.nodes.velocity[5].x));
}

TEST_F(TiedNodesTest, TheEndOfATieFreesTheNodeAndBooksItsEnergy) {
  tie_fourth();
  model_.tied_contacts[0].death_time = 1;
  TiedNodes tied(model_, domain_);
  // The segment opens around the node: its corners carry more energy than node and segment have.
  kick(tied, {{1, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {}});
  double free = 0;
  double carried = 0;
  for (Index i = 0; i < 5; ++i) {
    const double square = dot(domain_.nodes.velocity[i], domain_.nodes.velocity[i]);
    free += 0.5 * domain_.nodes.mass[i] * square;
    if (i < 4) carried += 0.5 * domain_.nodes.moving_mass(i) * square;
  }
  domain_.clock.time = 1;
  tied.release(domain_);
  test::verified("end of a tie: its energy", "kinetic energies before and after")
      .near(domain_.ties[0].energy, carried - free, 1e-14);
  EXPECT_GT(domain_.ties[0].energy, 0);
  EXPECT_EQ(domain_.ties[0].released, 1);
  EXPECT_FALSE(domain_.nodes.is_tied(4));
  EXPECT_DOUBLE_EQ(domain_.nodes.moving_mass(0), 2);
}

TEST_F(TiedNodesTest, SymmetryPlanesHoldBoth) {
  domain_.nodes.fixed.assign(7, domain::fixed_translation(2));
  tie_fourth();
  EXPECT_NO_THROW(TiedNodes(model_, domain_));
}

/// The message of the error that the constructor throws.
std::string fault(const model::Model& model, domain::Domain& domain) {
  try {
    const TiedNodes tied(model, domain);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST_F(TiedNodesTest, NodesThatSomethingElseHoldsAreRefused) {
  tie_fourth();
  model_.rivets.push_back({.id = 3, .node = {4, 6}});
  EXPECT_EQ(fault(model_, domain_),
            "Tied contact 1: node 5 is tied to a segment and belongs to rivet 3; a node has room for one "
            "constraint, as in LS-DYNA. Take it out of the contact, or tie by penalty (_OFFSET).");
  model_.rivets.clear();
  domain_.nodes.fixed[4] = domain::fixed_translation(0);
  EXPECT_NE(fault(model_, domain_).find("held by *BOUNDARY_SPC in a direction"), std::string::npos);
}

TEST_F(TiedNodesTest, RigidSegmentsAndCirclesAreRefused) {
  tie_fourth();
  model::RigidBody body;
  body.id = 8;
  body.nodes = {2};
  model_.rigid_bodies.push_back(body);
  EXPECT_NE(fault(model_, domain_).find("node 5 is tied to a segment with node 3 of rigid body 8"),
            std::string::npos);
  model_.rigid_bodies.clear();
  tie(0, {4, 5, 6, 6}, {0.5, 0.25, 0.25, 0});
  EXPECT_NE(fault(model_, domain_).find("tied to it in turn"), std::string::npos);
}

}  // namespace
}  // namespace crumple::constraints::tied_nodes_test
