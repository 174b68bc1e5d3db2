// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

using math::Vec3;

constexpr Variable rigid_body_variables[] = {
    {"x", "global_x"},    {"y", "global_y"},   {"z", "global_z"},    {"vx", "global_vx"},
    {"vy", "global_vy"},  {"vz", "global_vz"}, {"wx", "global_rvx"}, {"wy", "global_rvy"},
    {"wz", "global_rvz"}, {"kinetic", ""},     {"fx", ""},           {"fy", ""},
    {"fz", ""},           {"", "global_dx"},   {"", "global_dy"},    {"", "global_dz"},
    {"", "global_rdx"},   {"", "global_rdy"},  {"", "global_rdz"},   {"", "global_ax"},
    {"", "global_ay"},    {"", "global_az"},   {"", "dircos_11"},    {"", "dircos_12"},
    {"", "dircos_13"},    {"", "dircos_21"},   {"", "dircos_22"},    {"", "dircos_23"},
    {"", "dircos_31"},    {"", "dircos_32"},   {"", "dircos_33"},    {"", "local_dx"},
    {"", "local_dy"},     {"", "local_dz"},    {"", "local_rdx"},    {"", "local_rdy"},
    {"", "local_rdz"},    {"", "local_vx"},    {"", "local_vy"},     {"", "local_vz"},
    {"", "local_rvx"},    {"", "local_rvy"},   {"", "local_rvz"},    {"", "local_ax"},
    {"", "local_ay"},     {"", "local_az"},
};

/// Places of the vectors in the list above; the direction cosines are there row by row.
enum Place : std::size_t {
  Coordinate = 0,
  Velocity = 3,
  AngularVelocity = 6,
  Displacement = 13,
  Rotation = 16,
  Acceleration = 19,
  Cosines = 22,
  LocalDisplacement = 31,
  LocalRotation = 34,
  LocalVelocity = 37,
  LocalAngularVelocity = 40,
  LocalAcceleration = 43,
};

void print_vectors(const Sample& sample, std::size_t body, std::string_view label,
                   std::initializer_list<Place> vectors, std::string& text) {
  fmt::format_to(std::back_inserter(text), "{:>14}:  ", label);
  for (const Place vector : vectors)
    for (std::size_t axis = 0; axis < 3; ++axis)
      fmt::format_to(std::back_inserter(text), "{:12.4E}", sample.of(vector + axis)[body]);
  text += '\n';
}

void print_body(const Sample& sample, std::size_t body, std::string& text) {
  text += "   global             x           y           z          x-rot       y-rot       z-rot\n";
  print_vectors(sample, body, "coordinates", {Coordinate}, text);
  print_vectors(sample, body, "displacements", {Displacement, Rotation}, text);
  print_vectors(sample, body, "velocities", {Velocity, AngularVelocity}, text);
  print_vectors(sample, body, "accelerations", {Acceleration}, text);
  text +=
      "\nprincipal or user defined local coordinate direction vectors\n"
      "                     a           b           c\n";
  for (std::size_t row = 0; row < 3; ++row) {
    fmt::format_to(std::back_inserter(text), "     row {}", row + 1);
    for (std::size_t column = 0; column < 3; ++column)
      fmt::format_to(std::back_inserter(text), "{:15.4E}", sample.of(Cosines + 3 * row + column)[body]);
    text += '\n';
  }
  text +=
      "\n output in principal or user defined local coordinate directions\n"
      "                      a           b           c          a-rot       b-rot       c-rot\n";
  print_vectors(sample, body, "displacements", {LocalDisplacement, LocalRotation}, text);
  print_vectors(sample, body, "velocities", {LocalVelocity, LocalAngularVelocity}, text);
  print_vectors(sample, body, "accelerations", {LocalAcceleration}, text);
}

void print_bodies(const HistoryItems& items, const Sample& sample, std::string& text) {
  fmt::format_to(std::back_inserter(text),
                 "1\n\n  r i g i d   b o d y   m o t i o n   a t  cycle={:8}    time={:15.6E}\n",
                 sample.cycle(), sample.time());
  const auto nodal = static_cast<std::size_t>(items.marks[0].second[0]);
  for (std::size_t body = 0; body < items.ids.size(); ++body) {
    const bool is_nodal = body + nodal >= items.ids.size();
    fmt::format_to(std::back_inserter(text), "{} rigid body {:7}\n", is_nodal ? " nodal" : "\n",
                   items.ids[body]);
    print_body(sample, body, text);
  }
}

constexpr HistoryForm rbdout_form{model::HistoryFile::Rbdout, "rbdout", "rbdout", "", print_bodies};

/// Axis times angle [rad].
Vec3 rotation_vector(const math::Quaternion& turn) {
  const double sine = math::norm(turn.v);
  if (sine == 0) return {};
  return (2 * std::atan2(turn.w < 0 ? -sine : sine, std::fabs(turn.w)) / sine) * turn.v;
}

class RigidBodyHistory : public SampledHistory {
 public:
  explicit RigidBodyHistory(const View& view) : SampledHistory(rbdout_form, rigid_body_variables) {
    for (std::size_t i = 0; i < count(view); ++i)
      start_.push_back({view.domain.rigid_bodies[i].centre, view.domain.rigid_bodies[i].turn});
  }

  void declare(domain::StateList& list) override {
    list.keep_list("rigid_body_history_start", "by item", domain::Entity::RigidBody, 7, start_);
  }

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    std::int64_t nodal = 0;
    for (std::size_t i = 0; i < count(view); ++i) {
      items.ids.push_back(view.domain.rigid_bodies[i].id);
      // LS-DYNA's groups of nodes come last; one before a part is shown as a part.
      nodal = view.domain.rigid_bodies[i].part == no_index ? nodal + 1 : 0;
    }
    items.marks.push_back({"num_nodal", {nodal}});
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (std::size_t i = 0; i < count(view); ++i) {
      const domain::RigidBody& body = view.domain.rigid_bodies[i];
      sample.add_item({body.centre.x, body.centre.y, body.centre.z, body.velocity.x, body.velocity.y,
                       body.velocity.z, body.angular_velocity.x, body.angular_velocity.y,
                       body.angular_velocity.z, body.kinetic_energy, body.reaction.x, body.reaction.y,
                       body.reaction.z});
    }
  }

  void take_rest(const View& view, Sample& sample) override {
    for (std::size_t i = 0; i < count(view); ++i) {
      const domain::RigidBody& body = view.domain.rigid_bodies[i];
      const math::Matrix3 axes = math::matrix_of(body.turn);
      const auto& [a, b, c] = axes.column;
      sample.add_item({a.x, b.x, c.x, a.y, b.y, c.y, a.z, b.z, c.z}, Cosines);
      const Vec3 moved = body.centre - start_[i].centre;
      const math::Quaternion back{start_[i].turn.w, -start_[i].turn.v};
      const Vec3 turned = rotation_vector(body.turn * back);
      const auto add = [&](Place place, const Vec3& vector) {
        sample.add_item({vector.x, vector.y, vector.z}, place);
      };
      const auto add_local = [&](Place place, const Vec3& vector) {
        add(place, math::transposed_product(axes, vector));
      };
      add(Displacement, moved);
      add(Rotation, turned);
      add(Acceleration, body.acceleration);
      add_local(LocalDisplacement, moved);
      add_local(LocalRotation, turned);
      add_local(LocalVelocity, body.velocity);
      add_local(LocalAngularVelocity, body.angular_velocity);
      add_local(LocalAcceleration, body.acceleration);
    }
  }

 private:
  struct Position {
    Vec3 centre;            ///< [length]
    math::Quaternion turn;  ///< from the body's axes to the global ones
  };
  // Those of the model come first; the others are welds.
  static std::size_t count(const View& view) { return view.model.rigid_bodies.size(); }

  std::vector<Position> start_;  ///< by body, at time zero
};

}  // namespace

std::unique_ptr<History> make_rigid_body_history(const View& view) {
  return std::make_unique<RigidBodyHistory>(view);
}

}  // namespace crumple::output
