// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "domain/shell_block.hpp"
#include "materials/common/shell_material.hpp"
#include "materials/tile_driver.hpp"

namespace crumple::materials::testing {

using Five = std::array<double, components>;  ///< xx, yy, xy, yz, zx

inline double equivalent(const Five& s) {
  return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * (s[2] * s[2] + s[3] * s[3] + s[4] * s[4]));
}

/// One tile of shells with `points` points each, driven by strain increments.
template <class Real>
class PointDriver : public TileDriver<Real, domain::ShellBlock, components> {
  using Base = TileDriver<Real, domain::ShellBlock, components>;

 public:
  PointDriver(const model::Material& material, Isa isa, int points = 1)
      : Base(material, points), update_(shell_material_update<Real>(isa, shell_material_kind(material.law))) {
    this->block_.thickness_points = points;
    this->history_ = declare_history(material.law, this->block_);
    this->allocate(shell_material_constants(material), 2);
    weight_.assign(points, Real(1.0 / points));
  }

  /// Gives every element the same axes.
  void prepare(const model::ConstitutiveLaw& law, const LaminaAxes& axes) {
    for (Index e = 0; e < tile_lanes; ++e) prepare_element(law, axes, this->block_, this->history_, e);
  }

  /// Applies the strains that were set.
  void apply(double step = 1) {
    auto task = this->template task<MaterialTask<Real>>(step);
    task.all_points = this->points_;
    task.weight = weight_.data();
    task.thickness_strain = this->out_.data() + tile_lanes;
    update_(task);
  }

  /// Applies one increment to point 0 of element 0.
  void apply(const Five& strain, double step = 1) {
    this->set_strain(0, 0, strain);
    apply(step);
  }

  /// Applies xx and whatever yy leaves the stress yy at zero.
  void apply_uniaxial(double xx, double elastic_ratio, double step = 1) {
    this->solve_lateral(-elastic_ratio * xx, -0.5 * xx, [&](double yy) { apply({xx, yy, 0, 0, 0}, step); });
  }

  /// The work per volume of leading point 0 of element 0 from no strain along straight lines over `corners`
  /// and back, each in so many steps.
  double work_around(const std::vector<Five>& corners, int steps) {
    double work = 0;
    Five at{};
    const auto go = [&](const Five& to) {
      Five step;
      for (std::size_t k = 0; k < at.size(); ++k) step[k] = (to[k] - at[k]) / steps;
      for (int i = 0; i < steps; ++i) {
        apply(step);
        work += energy();
      }
      at = to;
    };
    for (const Five& corner : corners) go(corner);
    go({});
    return work;
  }

  double energy(Index element = 0) const { return static_cast<double>(this->out_[element]); }
  double thickness_strain(Index element = 0) const {
    return static_cast<double>(this->out_[tile_lanes + element]);
  }

 private:
  MaterialUpdate<Real> update_;
  AlignedArray<Real> weight_;
};

}  // namespace crumple::materials::testing
