// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "materials/common/shell_material.hpp"
#include "materials/sample_materials.hpp"

namespace crumple::materials::testing {

/// What the drivers of shells and solids have in common: one tile of elements whose points have `Count`
/// components of stress and strain, and the state that a material's update reads and writes.
template <class Real, class Block, int Count>
class TileDriver {
 public:
  using Components = std::array<double, Count>;

  void set_strain(Index element, int point, const Components& strain) {
    for (int c = 0; c < Count; ++c)
      strain_[(static_cast<std::size_t>(point) * Count + c) * tile_lanes + element] =
          static_cast<Real>(strain[c]);
  }

  Components stress(Index element = 0, int point = 0) const {
    Components s{};
    for (int c = 0; c < Count; ++c) s[c] = block_.state(element, point * Count + c);
    return s;
  }
  double item(const std::string& name, Index element = 0, int at = 0) const {
    return block_.state(element, block_.find(name)->first + at);
  }
  bool has(const std::string& name) const { return block_.find(name) != nullptr; }
  /// Stress less back stress.
  Components relative(Index element = 0, int point = 0) const {
    Components s = stress(element, point);
    if (has("back_stress"))
      for (int c = 0; c < Count; ++c) s[c] -= item("back_stress", element, point * Count + c);
    return s;
  }
  /// Whether any point of the element is intact; only of materials that can fail.
  bool intact(Index element = 0) const { return intact_[element] == Real(1); }

  std::vector<Real> bits() {
    const auto& state = values(block_);
    std::vector<Real> all(state.begin(), state.end());
    all.insert(all.end(), out_.begin(), out_.end());
    return all;
  }

 protected:
  TileDriver(const model::Material& material, int points) : points_(points) {
    block_.points = points;
    block_.elements = tile_lanes;
    domain::add_item(block_, "stress", "stress", Count * points);
    strain_.assign(static_cast<std::size_t>(points) * Count * tile_lanes, Real(0));
    if (can_fail(material)) intact_.assign(tile_lanes, Real(-1));
  }
  /// Once the history is declared.
  void allocate(const std::vector<double>& constants, std::size_t outputs) {
    block_.material_constants = constants;
    values(block_).assign(static_cast<std::size_t>(tile_lanes) * block_.components, Real(0));
    out_.assign(outputs * tile_lanes, Real(0));
  }

  /// What tasks of both kinds name alike.
  template <class Task>
  Task task(double step) {
    Task task;
    task.state = values(block_).data();
    task.group_stride = static_cast<std::ptrdiff_t>(block_.components) * lanes;
    task.groups = tile_groups;
    task.points = points_;
    task.history = history_;
    task.strain = strain_.data();
    task.constants = block_.material_constants.data();
    task.step = static_cast<Real>(step);
    task.energy = out_.data();
    if (!intact_.empty()) task.intact = intact_.data();
    return task;
  }

  /// Calls apply(lateral) again and again from the present state until it leaves the stress yy at zero.
  template <class Apply>
  void solve_lateral(double a, double b, const Apply& apply) {
    const auto state = values(block_);
    const auto stress_yy = [&](double yy) {
      values(block_) = state;
      apply(yy);
      return stress()[1];
    };
    double fa = stress_yy(a);
    for (int i = 0; i < 100; ++i) {
      const double fb = stress_yy(b);
      if (fb == 0 || fb == fa || b == a) break;
      const double c = b - fb * (b - a) / (fb - fa);
      a = b;
      fa = fb;
      b = c;
    }
  }

  static AlignedArray<Real>& values(Block& block) { return domain::state_of<Real>(block); }

  int points_;
  Index history_ = 0;
  Block block_;
  AlignedArray<Real> strain_, intact_;
  AlignedArray<Real> out_;  ///< energies, then whatever else the update returns
};

/// Strains of random size and direction for three points of every element, from elastic to hundreds of yield
/// strains within one pack.
template <class Driver>
void random_walk(Driver& driver, int seed, int steps, double size, double step_time) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < steps; ++i) {
    for (Index e = 0; e < tile_lanes; ++e)
      for (int p = 0; p < 3; ++p) {
        typename Driver::Components strain;
        const double magnitude = size * std::exp2(6 * uniform(generator));
        for (double& component : strain) component = magnitude * uniform(generator);
        driver.set_strain(e, p, strain);
      }
    driver.apply(step_time);
  }
}

}  // namespace crumple::materials::testing
