// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "domain/shell_block.hpp"
#include "materials/shell_material.hpp"

namespace crumple::materials::testing {

using Five = std::array<double, components>;  ///< xx, yy, xy, yz, zx

inline double equivalent(const Five& s) {
  return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * (s[2] * s[2] + s[3] * s[3] + s[4] * s[4]));
}

/// One tile of elements with `points` points each, driven by strain increments.
template <class Real>
class PointDriver {
 public:
  PointDriver(const model::Material& material, Isa isa, int points = 1)
      : update_(shell_material_update<Real>(isa, shell_material_kind(material.law))), points_(points) {
    block_.thickness_points = points;
    block_.elements = tile_lanes;
    domain::add_item(block_, "stress", "stress", components * points);
    history_ = declare_history(material.law, block_);
    block_.material_constants = shell_material_constants(material);
    domain::state_of<Real>(block_).assign(static_cast<std::size_t>(tile_lanes) * block_.components, Real(0));
    strain_.assign(static_cast<std::size_t>(points) * components * tile_lanes, Real(0));
    weight_.assign(points, Real(1.0 / points));
    energy_.assign(tile_lanes, Real(0));
    thickness_strain_.assign(tile_lanes, Real(0));
    if (can_fail(material)) intact_.assign(tile_lanes, Real(-1));
  }

  /// Gives every element the same axes.
  void prepare(const model::ConstitutiveLaw& law, const LaminaAxes& axes) {
    for (Index e = 0; e < tile_lanes; ++e) prepare_element(law, axes, block_, history_, e);
  }

  void set_strain(Index element, int point, const Five& strain) {
    for (int c = 0; c < components; ++c)
      strain_[(static_cast<std::size_t>(point) * components + c) * tile_lanes + element] =
          static_cast<Real>(strain[c]);
  }

  /// Applies the strains that were set.
  void apply(double step = 1) {
    MaterialTask<Real> task;
    task.state = domain::state_of<Real>(block_).data();
    task.group_stride = static_cast<std::ptrdiff_t>(block_.components) * lanes;
    task.groups = tile_groups;
    task.points = points_;
    task.all_points = points_;
    task.history = history_;
    task.strain = strain_.data();
    task.weight = weight_.data();
    task.constants = block_.material_constants.data();
    task.step = static_cast<Real>(step);
    task.energy = energy_.data();
    task.thickness_strain = thickness_strain_.data();
    if (!intact_.empty()) task.intact = intact_.data();
    update_(task);
  }

  /// Applies one increment to point 0 of element 0.
  void apply(const Five& strain, double step = 1) {
    set_strain(0, 0, strain);
    apply(step);
  }

  /// Applies xx and whatever yy leaves the stress yy at zero.
  void apply_uniaxial(double xx, double poissons_ratio, double step = 1) {
    const auto state = domain::state_of<Real>(block_);
    const auto stress_yy = [&](double yy) {
      domain::state_of<Real>(block_) = state;
      apply({xx, yy, 0, 0, 0}, step);
      return stress()[1];
    };
    double a = -poissons_ratio * xx;
    double b = -0.5 * xx;
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

  Five stress(Index element = 0, int point = 0) const {
    Five s{};
    for (int c = 0; c < components; ++c) s[c] = block_.state(element, point * components + c);
    return s;
  }
  double item(const std::string& name, Index element = 0, int at = 0) const {
    return block_.state(element, block_.find(name)->first + at);
  }
  bool has(const std::string& name) const { return block_.find(name) != nullptr; }
  double energy(Index element = 0) const { return static_cast<double>(energy_[element]); }
  /// Whether any point of the element is intact; only of materials that can fail.
  bool intact(Index element = 0) const { return intact_[element] == Real(1); }
  double thickness_strain(Index element = 0) const { return static_cast<double>(thickness_strain_[element]); }

  std::vector<Real> bits() {
    const auto& state = domain::state_of<Real>(block_);
    std::vector<Real> all(state.begin(), state.end());
    all.insert(all.end(), energy_.begin(), energy_.end());
    all.insert(all.end(), thickness_strain_.begin(), thickness_strain_.end());
    return all;
  }

 private:
  MaterialUpdate<Real> update_;
  int points_;
  Index history_ = 0;
  domain::ShellBlock block_;
  AlignedArray<Real> strain_, weight_, energy_, thickness_strain_, intact_;
};

template <class Real>
bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0;
}

inline constexpr double youngs_modulus = 210000;
inline constexpr double poissons_ratio = 0.3;
inline constexpr double shear_modulus = 0.5 * youngs_modulus / (1 + poissons_ratio);
inline constexpr double initial_yield = 250;

inline model::Material plastic_kinematic(double tangent, double beta, double rate = 0, double exponent = 0) {
  model::Material material;
  material.id = 1;
  material.density = 7.85e-9;
  model::PlasticKinematic law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.yield_stress = initial_yield;
  law.tangent_modulus = tangent;
  law.isotropic_fraction = beta;
  law.cowper_symonds_rate = rate;
  law.cowper_symonds_exponent = exponent;
  material.law = law;
  return material;
}

inline model::Material tabulated(const std::vector<double>& strain, const std::vector<double>& stress) {
  model::Material material;
  material.id = 2;
  material.density = 7.85e-9;
  model::PiecewiseLinearPlasticity law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.plastic_strain = strain;
  law.yield_stress = stress;
  material.law = law;
  return material;
}

/// 500 MPa (e + p)^0.22 from the intersection with the elastic line on.
inline model::Material power_law(double rate = 0, double exponent = 0) {
  model::Material material;
  material.id = 3;
  material.density = 7.85e-9;
  model::PowerLawPlasticity law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.strength = 500;
  law.exponent = 0.22;
  law.yield_strain = std::pow(youngs_modulus / 500, 1 / (0.22 - 1));
  law.cowper_symonds_rate = rate;
  law.cowper_symonds_exponent = exponent;
  material.law = law;
  return material;
}

/// Steel 4340 of Johnson & Cook (1985), without heat and fracture, in t, mm, s.
inline model::JohnsonCook johnson_cook_law() {
  model::JohnsonCook law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.yield_stress = 792;
  law.hardening = 510;
  law.exponent = 0.26;
  law.rate_coefficient = 0.014;
  law.reference_rate = 1;
  return law;
}
inline model::Material johnson_cook(const model::JohnsonCook& law) {
  model::Material material;
  material.id = 4;
  material.density = 7.83e-9;
  material.law = law;
  return material;
}

/// Slope of the yield stress over the plastic strain that belongs to a tangent modulus.
inline double plastic_modulus(double tangent) {
  return youngs_modulus * tangent / (youngs_modulus - tangent);
}

}  // namespace crumple::materials::testing
