// SPDX-License-Identifier: BSD-3-Clause
//
// Decks with a contact of everything beside contacts of pairs of parts have several contacts at the same
// nodes. Each is stable by itself, and all of them together must be, too.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/conservation.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::several_contacts_test {
namespace {

/// Two steel sheets of 8 x 8 shells that meet at 20 mm/ms, under `contacts` contacts of the same kind.
model::Model sheets(int contacts, double soft_scale) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1.0, 3));
  model.parts.push_back({.id = 2, .title = "second", .section = 0, .material = 0});
  test::add_grid(model, 0, 8, 8, [](double u, double v) { return test::Point{80 * u, 80 * v, 0}; });
  const Index upper = model.nodes.count();
  test::add_grid(model, 1, 8, 8, [](double u, double v) {
    return test::Point{3.1 + 80 * u, 4.3 + 80 * v, 1.5};
  });
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back(
        {.node = i, .velocity = {0, 0, i < upper ? 10.0 : -10.0}, .angular_velocity = {}});
  for (int i = 0; i < contacts; ++i) {
    model::Contact& contact = model.contacts.emplace_back(model::self_contact(i + 1, "all", {0, 1}));
    contact.soft_scale = soft_scale;
  }
  model.control.end_time = 0.5;
  return model;
}

struct Found {
  double lowest_contact = 0;  ///< over the largest internal energy so far or later
  double imbalance = 0;       ///< largest, over the initial energy
  double momentum_drift = 0;
  double kinetic = 0;  ///< at the end, over the initial energy
};

Found run(const model::Model& model) {
  timeloop::Simulation simulation(model, test::execution());
  test::Conservation kept;
  double lowest = 0;
  double largest_internal = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    kept.watch(now);
    largest_internal = std::max(largest_internal, now.energy.internal);
    for (const domain::ContactReport& contact : now.contacts) lowest = std::min(lowest, contact.energy);
  });
  return {lowest / largest_internal, kept.worst_imbalance, kept.momentum_drift,
          simulation.domain().energy.kinetic / simulation.domain().energy.initial_total};
}

/// The stiffness of the contacts is what is stable: together they have as much of it as one has alone.
TEST(SeveralContacts, TogetherDoWhatOneDoes) {
  for (const double soft_scale : {0.0, 0.1}) {
    const Found alone = run(sheets(1, soft_scale));
    for (const int contacts : {3, 5}) {
      const Found found = run(sheets(contacts, soft_scale));
      const std::string title = std::to_string(contacts) + " contacts at the same nodes, " +
                                (soft_scale > 0 ? "SOFT 1" : "SOFT 0") + ": ";
      test::verified(title + "energy that a contact makes, over the largest internal", "zero")
          .below(-found.lowest_contact, 1e-3);
      test::verified(title + "drift of the momentum", "conservation").below(found.momentum_drift, 1e-12);
      test::verified(title + "imbalance over the initial energy", "conservation")
          .below(found.imbalance, 1e-5);
      test::verified(title + "kinetic energy after the rebound, over the initial one", "one contact alone")
          .near(found.kinetic, alone.kinetic, 1e-9);
    }
  }
}

}  // namespace
}  // namespace crumple::several_contacts_test
