// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/composite_damage.hpp"

#include <algorithm>
#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {

void CompositeDamageLaw::declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                                         Index /*tensor*/) {
  domain::add_item(block, "material_axis", "-", 2);
  domain::add_item(block, "failed_modes", "-", composite_mode::count * block.points);
  domain::add_item(block, "ply_strain", "-", 3 * block.points);
  domain::add_item(block, "ply_strain_rest", "-", 3 * block.points);
}

void CompositeDamageLaw::prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                                         domain::ElementBlock& block, Index history, Index place) {
  OrthotropicElasticLaw::set_axes(std::get<Model>(law), axes, block, history, place);
}

std::vector<double> CompositeDamageLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require(law.tension_a > 0 && law.compression_a > 0 && law.tension_b > 0 && law.compression_b > 0 &&
              law.shear_strength > 0,
          material, "the strengths XT, XC, YT, YC and SC must be above zero");
  require(law.shear_softening >= 0, material, "ALPH must not be negative");
  require(law.shear_in_fibre_mode >= 0 && law.shear_in_fibre_mode <= 1, material, "BETA must be from 0 to 1");
  require(law.failure_compression <= 0, material, "DFAILC must not be above zero");
  std::vector<double> numbers = OrthotropicElasticLaw::constants_of(law, material);
  numbers.resize(Count);
  numbers[FibreTension] = law.tension_a;
  numbers[FibreCompression] = law.compression_a;
  numbers[MatrixTension] = law.tension_b;
  numbers[MatrixCompression] = law.compression_b;
  numbers[Shear] = law.shear_strength;
  numbers[Softening] = law.shear_softening;
  numbers[Beta] = law.shear_in_fibre_mode;
  numbers[TensionLeft] = law.fibre_tension_left > 0 ? law.fibre_tension_left : 1;
  numbers[CompressionLeft] =
      law.fibre_compression_by_matrix > 0
          ? std::min(law.compression_a, law.fibre_compression_by_matrix * law.compression_b)
          : law.compression_a;
  numbers[IsTsaiWu] = law.matrix == Model::Matrix::TsaiWu ? 1 : 0;
  numbers[IsByEnergy] = law.matrix == Model::Matrix::ChangShear ? 1 : 0;
  numbers[GoesByTension] = law.goes_by_fibre_tension ? 1 : 0;
  numbers[LimitTension] = law.failure_tension;
  numbers[LimitCompression] = law.failure_compression;
  numbers[LimitMatrix] = law.failure_matrix;
  numbers[LimitShear] = law.failure_shear;
  numbers[LimitEffective] = law.failure_effective;
  return numbers;
}

bool CompositeDamageLaw::can_fail(const model::ConstitutiveLaw& law) {
  const auto& own = std::get<Model>(law);
  return own.goes_by_fibre_tension || own.failure_tension > 0 || own.failure_compression < 0 ||
         own.failure_matrix > 0 || own.failure_shear > 0 || own.failure_effective > 0;
}

const char* CompositeDamageLaw::name_of(const model::ConstitutiveLaw& law) {
  const auto& own = std::get<Model>(law);
  switch (own.matrix) {
    case Model::Matrix::TsaiWu:
      return "Tsai-Wu composite";
    case Model::Matrix::ChangShear:
      return "composite damage";
    default:
      return "Chang-Chang composite";
  }
}

}  // namespace crumple::materials
