// SPDX-License-Identifier: BSD-3-Clause
#include "materials/eos/gruneisen.hpp"

#include "materials/common/checks.hpp"

namespace crumple::materials {

std::vector<double> GruneisenEquation::constants(const Model& law, const model::Material& material) {
  require(law.sound_speed > 0, material, "the sound speed C of its equation of state must be above zero");
  std::vector<double> numbers(Count);
  numbers[Stiffness] = material.density * law.sound_speed * law.sound_speed;
  numbers[S1] = law.slopes[0];
  numbers[S2] = law.slopes[1];
  numbers[S3] = law.slopes[2];
  numbers[Gamma] = law.gamma;
  numbers[Correction] = law.volume_correction;
  return numbers;
}

}  // namespace crumple::materials
