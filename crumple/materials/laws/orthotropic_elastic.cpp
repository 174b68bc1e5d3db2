// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/orthotropic_elastic.hpp"

#include <cmath>
#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {
namespace {

using math::Vec3;

/// What the material's first axis follows, before it is turned by the angle.
Vec3 direction(const model::OrthotropicElastic& law, const LaminaAxes& axes) {
  const Vec3 given{law.direction[0], law.direction[1], law.direction[2]};
  switch (law.axes) {
    case model::OrthotropicElastic::Axes::Side:
      return axes.side;
    case model::OrthotropicElastic::Axes::Vector:
      return given;
    case model::OrthotropicElastic::Axes::CrossNormal:
      return cross(given, axes.e3);
  }
  return axes.side;
}

}  // namespace

void OrthotropicElasticLaw::declare_history(const model::ConstitutiveLaw& /*law*/,
                                            domain::ElementBlock& block, Index /*tensor*/) {
  domain::add_item(block, "material_axis", "-", 2);
}

void OrthotropicElasticLaw::prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                                            domain::ElementBlock& block, Index history, Index place) {
  set_axes(std::get<Model>(law), axes, block, history, place);
}

void OrthotropicElasticLaw::set_axes(const model::OrthotropicElastic& law, const LaminaAxes& axes,
                                     domain::ElementBlock& block, Index history, Index place) {
  const Vec3 along = direction(law, axes);
  const double x = dot(along, axes.e1);
  const double y = dot(along, axes.e2);
  // A direction normal to the shell leaves nothing to follow.
  if (!(std::hypot(x, y) > 1e-6 * norm(along))) fail_axis(axes.shell);
  const double angle = std::atan2(y, x) + (axes.angle != 0 ? axes.angle : law.angle) + axes.layer_angle;
  block.set_state(place, history, std::cos(angle));
  block.set_state(place, history + 1, std::sin(angle));
}

std::vector<double> OrthotropicElasticLaw::constants(const model::Material& material) {
  return constants_of(std::get<Model>(material.law), material);
}

std::vector<double> OrthotropicElasticLaw::constants_of(const model::OrthotropicElastic& law,
                                                        const model::Material& material) {
  require(law.modulus_a > 0 && law.modulus_b > 0 && law.modulus_c > 0, material,
          "the moduli EA, EB and EC must be above zero");
  require(law.shear_ab > 0 && law.shear_bc > 0 && law.shear_ca > 0, material,
          "the shear moduli GAB, GBC and GCA must be above zero");
  // nu_ba / E_b = nu_ab / E_a.
  const double poisson_ab = law.poisson_ba * law.modulus_a / law.modulus_b;
  const double determinant = 1 - law.poisson_ba * poisson_ab;
  require(determinant > 0, material,
          "Poisson's ratio PRBA is too large for the moduli: its square must stay below EB / EA");
  std::vector<double> numbers(Count);
  numbers[Aa] = law.modulus_a / determinant;
  numbers[Bb] = law.modulus_b / determinant;
  numbers[Ab] = law.poisson_ba * law.modulus_a / determinant;
  numbers[Gab] = law.shear_ab;
  numbers[Gbc] = law.shear_bc;
  numbers[Gca] = law.shear_ca;
  numbers[LateralA] = law.poisson_ca / law.modulus_c;
  numbers[LateralB] = law.poisson_cb / law.modulus_c;
  return numbers;
}

}  // namespace crumple::materials
