// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::model {

/// Sets Young's modulus [stress] and Poisson's ratio [-] of a law by bulk and shear modulus [stress], both
/// above zero.
template <class Law>
void set_moduli(Law& law, double bulk, double shear) {
  law.youngs_modulus = 9 * bulk * shear / (3 * bulk + shear);
  law.poissons_ratio = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
}

}  // namespace crumple::model
