// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"

namespace crumple::output {

namespace {

/// The force of a single step is noise: nodes strike and leave a wall one by one, and sampling it would give
/// neither peaks nor means. The mean over an interval follows from the impulse and loses nothing.
class WallHistory : public History {
 public:
  explicit WallHistory(const View& view)
      : impulse_(view.domain.walls.size()), normal_impulse_(view.domain.walls.size()) {}

  void add_rows(const View& view, CsvFile& table) override {
    const double time = view.domain.clock.time;
    for (std::size_t i = 0; i < view.domain.walls.size(); ++i) {
      const domain::WallReport& wall = view.domain.walls[i];
      math::Vec3 force;
      double normal = 0;
      if (time > time_) {
        force = (1.0 / (time - time_)) * (wall.impulse - impulse_[i]);
        normal = (wall.normal_impulse - normal_impulse_[i]) / (time - time_);
        impulse_[i] = wall.impulse;
        normal_impulse_[i] = wall.normal_impulse;
      }
      table.add_row(time, wall.id, normal, force.x, force.y, force.z);
    }
    time_ = time;
  }

  void declare(domain::StateList& list) override {
    list.keep("wall_history_time", "time", domain::Entity::Run, time_);
    list.keep_list("wall_history_impulse", "force*time", domain::Entity::Wall, 3, impulse_);
    list.keep_list("wall_history_normal_impulse", "force*time", domain::Entity::Wall, 1, normal_impulse_);
  }

 private:
  double time_ = 0;
  std::vector<math::Vec3> impulse_;     ///< up to the row before
  std::vector<double> normal_impulse_;  ///< likewise
};

class WallMotionHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    for (std::size_t i = 0; i < view.domain.walls.size(); ++i) {
      const domain::WallReport& wall = view.domain.walls[i];
      if (!(wall.mass > 0) && view.model.rigid_walls[i].motion.curve == no_index) continue;
      const math::Vec3& moved = wall.displacement_now;
      const math::Vec3& velocity = wall.velocity;
      table.add_row(view.domain.clock.time, wall.id, moved.x, moved.y, moved.z, velocity.x, velocity.y,
                    velocity.z, wall.kinetic_energy);
    }
  }
};

}  // namespace

std::unique_ptr<History> make_wall_history(const View& view) {
  return std::make_unique<WallHistory>(view);
}

std::unique_ptr<History> make_wall_motion_history() {
  return std::make_unique<WallMotionHistory>();
}

}  // namespace crumple::output
