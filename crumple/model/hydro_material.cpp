// SPDX-License-Identifier: BSD-3-Clause
#include "model/hydro_material.hpp"

namespace crumple::model {

void set_elastic(HydroPlasticity& law, double bulk_modulus) {
  const double g = law.shear_modulus;
  const double k = bulk_modulus;
  law.youngs_modulus = 9 * k * g / (3 * k + g);
  law.poissons_ratio = (3 * k - 2 * g) / (2 * (3 * k + g));
}

}  // namespace crumple::model
