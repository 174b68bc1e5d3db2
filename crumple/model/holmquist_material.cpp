// SPDX-License-Identifier: BSD-3-Clause
#include "model/holmquist_material.hpp"

namespace crumple::model {
namespace {

void set_elastic_by(BrittleSolid& law, double k) {
  const double g = law.shear_modulus;
  if (!(g > 0 && k > 0)) return;
  law.youngs_modulus = 9 * k * g / (3 * k + g);
  law.poissons_ratio = (3 * k - 2 * g) / (2 * (3 * k + g));
}

}  // namespace

void set_elastic(HolmquistCeramic& law) {
  set_elastic_by(law, law.bulk_modulus);
}

void set_elastic(HolmquistConcrete& law) {
  if (law.crush_volume > 0) set_elastic_by(law, law.crush_pressure / law.crush_volume);
}

}  // namespace crumple::model
