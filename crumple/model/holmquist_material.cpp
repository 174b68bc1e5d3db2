// SPDX-License-Identifier: BSD-3-Clause
#include "model/holmquist_material.hpp"

#include "model/elastic_moduli.hpp"

namespace crumple::model {
namespace {

void set_elastic_by(BrittleSolid& law, double bulk) {
  if (law.shear_modulus > 0 && bulk > 0) set_moduli(law, bulk, law.shear_modulus);
}

}  // namespace

void set_elastic(HolmquistCeramic& law) {
  set_elastic_by(law, law.bulk_modulus);
}

void set_elastic(HolmquistConcrete& law) {
  if (law.crush_volume > 0) set_elastic_by(law, law.crush_pressure / law.crush_volume);
}

}  // namespace crumple::model
