// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/bulk_modulus.hpp"

#include <gtest/gtest.h>

namespace crumple::contact::bulk_modulus_test {
namespace {

double modulus_of(const model::ConstitutiveLaw& law) {
  model::Model model;
  model::Material material;
  material.law = law;
  model.materials.push_back(material);
  model::Part part;
  part.material = 0;
  return bulk_modulus(model, part);
}

/// Of a foam with E = 2 whose curve has the slopes 10 and 90.
double modulus_of_foam(double contact_modulus) {
  model::LowDensityFoam law;
  law.youngs_modulus = 2;
  law.compression = {0, 0.1, 0.2};
  law.stress = {0, 1, 10};
  law.contact_modulus = contact_modulus;
  return modulus_of(law);
}

/// With E alone nodes of dense foam go through what they are pressed on.
TEST(BulkModulus, OfFoamIsThatOfItsSteepestSlope) {
  EXPECT_NEAR(modulus_of_foam(0), 90.0 / 3, 1e-12);
}

TEST(BulkModulus, OfFoamTakesKcon) {
  EXPECT_NEAR(modulus_of_foam(6), 2, 1e-12);
}

TEST(BulkModulus, OfCrushableFoamIsThatOfItsSteepestSlope) {
  model::CrushableFoam law;
  law.youngs_modulus = 2;
  law.crush = {0, 0.5, 0.9};
  law.yield_stress = {0, 1, 13};
  EXPECT_NEAR(modulus_of(law), 30.0 / 3, 1e-12);
}

}  // namespace
}  // namespace crumple::contact::bulk_modulus_test
