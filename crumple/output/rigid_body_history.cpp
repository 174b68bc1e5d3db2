// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"

namespace crumple::output {

namespace {

class RigidBodyHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    // Those of the model come first; the others are welds.
    for (std::size_t i = 0; i < view.model.rigid_bodies.size(); ++i) {
      const domain::RigidBody& body = view.domain.rigid_bodies[i];
      table.add_row(view.domain.clock.time, body.id, body.centre.x, body.centre.y, body.centre.z,
                    body.velocity.x, body.velocity.y, body.velocity.z, body.angular_velocity.x,
                    body.angular_velocity.y, body.angular_velocity.z, body.kinetic_energy, body.reaction.x,
                    body.reaction.y, body.reaction.z);
    }
  }
};

}  // namespace

std::unique_ptr<History> make_rigid_body_history() {
  return std::make_unique<RigidBodyHistory>();
}

}  // namespace crumple::output
