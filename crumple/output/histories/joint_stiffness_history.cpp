// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/history.hpp"

namespace crumple::output {

namespace {

class JointStiffnessHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    for (const domain::JointStiffnessReport& joint : view.domain.joint_stiffnesses) {
      const auto& q = joint.position;
      const auto& rate = joint.rate;
      const auto& elastic = joint.elastic;
      const auto& damping = joint.damping;
      table.add_row(view.domain.clock.time, joint.id, q[0], q[1], q[2], rate[0], rate[1], rate[2], elastic[0],
                    elastic[1], elastic[2], damping[0], damping[1], damping[2], joint.energy,
                    joint.friction_energy, joint.damping_energy);
    }
  }
};

}  // namespace

std::unique_ptr<History> make_joint_stiffness_history() {
  return std::make_unique<JointStiffnessHistory>();
}

}  // namespace crumple::output
