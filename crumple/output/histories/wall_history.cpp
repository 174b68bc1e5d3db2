// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable wall_variables[] = {
    {"normal", "normal_force"}, {"fx", "x_force"}, {"fy", "y_force"}, {"fz", "z_force"}};

void print_walls(const HistoryItems& items, const Sample& sample, std::string& text) {
  for (std::size_t wall = 0; wall < items.ids.size(); ++wall) {
    fmt::format_to(std::back_inserter(text), "{:12.5E} {:7}", sample.time(), items.ids[wall]);
    for (std::size_t i = 0; i < std::size(wall_variables); ++i)
      fmt::format_to(std::back_inserter(text), "{:15.6E}", sample.of(i)[wall]);
    text += '\n';
  }
}

constexpr HistoryForm rwforc_form{
    model::HistoryFile::Rwforc, "rwforc", "rwforc/forces",
    "\n\n    time       wall#   normal-force    x-force        y-force        z-force\n", print_walls};

/// The force of a single step is noise: nodes strike and leave a wall one by one, and sampling it would give
/// neither peaks nor means. The mean over an interval follows from the impulse and loses nothing.
class WallHistory : public SampledHistory {
 public:
  explicit WallHistory(const View& view)
      : SampledHistory(rwforc_form, wall_variables), time_(view.domain.clock.time) {
    // A run that is taken up in another folder begins its rows here; the kick at the start belongs to the
    // first row.
    const bool begins = view.domain.clock.cycle == 0;
    for (const domain::WallReport& wall : view.domain.walls) {
      impulse_.push_back(begins ? math::Vec3{} : wall.impulse);
      normal_impulse_.push_back(begins ? 0 : wall.normal_impulse);
    }
  }

  void declare(domain::StateList& list) override {
    list.keep("wall_history_time", "time", domain::Entity::Run, time_);
    list.keep_list("wall_history_impulse", "force*time", domain::Entity::Wall, 3, impulse_);
    list.keep_list("wall_history_normal_impulse", "force*time", domain::Entity::Wall, 1, normal_impulse_);
  }

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    for (const domain::WallReport& wall : view.domain.walls) items.ids.push_back(wall.id);
    for (const model::RigidWall& wall : view.model.rigid_walls) items.titles.push_back(wall.title);
    items.titles.resize(items.ids.size());
    return items;
  }

  void take(const View& view, Sample& sample) override {
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
      sample.add_item({normal, force.x, force.y, force.z});
    }
    time_ = time;
  }

 private:
  double time_;                         ///< of the row before [time]
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
