// SPDX-License-Identifier: BSD-3-Clause
#include "domain/node_fields.hpp"

namespace crumple::domain {
namespace {

template <class Real>
void write_record(NodeRecord<Real>& record, const Vec3& position, const Vec3& velocity, const Vec3& angular) {
  for (int axis = 0; axis < 3; ++axis) {
    record.position[axis] = position[axis];
    record.velocity[axis] = static_cast<Real>(velocity[axis]);
    record.angular_velocity[axis] = static_cast<Real>(angular[axis]);
  }
}

}  // namespace

void NodeFields::publish(Index node) {
  if (!float_records.empty())
    write_record(float_records[node], position[node], velocity[node], angular_velocity[node]);
  else
    write_record(double_records[node], position[node], velocity[node], angular_velocity[node]);
}

void NodeFields::publish_all() {
  for (Index node = 0; node < count(); ++node) publish(node);
}

}  // namespace crumple::domain
