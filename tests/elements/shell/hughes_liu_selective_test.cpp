// SPDX-License-Identifier: BSD-3-Clause
// Hughes & Liu's shell, selectively reduced: what full integration of membrane and bending with one point for
// the transverse shear passes, and what not.
#include <gtest/gtest.h>

#include "elements/shell_harness.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::elements::testing::hughes_liu_selective_test {
namespace {

constexpr double small = 1e-17;  // curvature: the square of the slope is below round-off

struct Bent {
  double bending_error;  ///< largest of the stress invariants at the outer points, over the exact ones
  double shear;          ///< root of the mean square, over the bending stress at the surface
};

/// A saddle with twist on a distorted mesh over 80 x 80.
Bent bent(Index n, double distortion) {
  model::Model model = test::one_part(elastic(), test::shell_section(thickness, 3));
  model.shell_sections[0].formulation = hughes_liu_selective.formulation;
  model.control.hourglass = {model::HourglassForm::Stiffness, 0.1, 0.1, 0.1};
  add_distorted_grid(model, n, 80.0 / n, distortion);
  Driven patch(model, {Precision::Double, available_isas().back(), 1});
  std::vector<Vec3> u;
  std::vector<Vec3> r;
  for (const Vec3& x : patch.domain.nodes.position) {
    u.push_back({0, 0, small * (0.5 * x.x * x.x + 0.2 * x.y * x.y + 0.8 * x.x * x.y)});
    r.push_back({small * (0.4 * x.y + 0.8 * x.x), -small * (x.x + 0.8 * x.y), 0});
  }
  patch.step(1e-7, u, r);
  const double outer = 0.5 * thickness * std::sqrt(0.6);
  // Curvatures 1, 0.4 and 0.8; invariants do not depend on each element's axes.
  const double sum = outer * youngs_modulus / (1 - poissons_ratio) * small * 1.4;
  const double deviator = outer * youngs_modulus / (1 + poissons_ratio) * small * std::hypot(0.6, 1.6);
  Bent result{0, 0};
  for (Index e = 0; e < patch.block().elements; ++e)
    for (Index point = 0; point < 12; point += 3) {
      const double xx = patch.stress(e, point, 0);
      const double yy = patch.stress(e, point, 1);
      const double found_deviator = std::hypot(xx - yy, 2 * patch.stress(e, point, 2));
      result.bending_error = test::larger_of(result.bending_error, std::fabs((xx + yy) / sum - 1));
      result.bending_error = test::larger_of(result.bending_error, std::fabs(found_deviator / deviator - 1));
      result.shear += std::pow(patch.stress(e, point, 3), 2) + std::pow(patch.stress(e, point, 4), 2);
    }
  result.shear =
      std::sqrt(result.shear / (4 * patch.block().elements)) / (youngs_modulus * 0.5 * thickness * small);
  return result;
}

/// Curvatures are exact on any mesh. The transverse shear is exact on parallelograms, also with warping
/// control, and vanishes with first order on others, as with one point.
TEST(HughesLiuSelectiveShell, BendsExactlyButForTheShear) {
  const std::string shell = "Hughes-Liu, selectively reduced, ";
  const char* const source = "Kirchhoff's plate, exact";
  test::verified(shell + "bending of squares: stress invariants, relative error", source)
      .below(bent(8, 0).bending_error, 1e-12);
  test::verified(shell + "bending of squares: transverse shear over bending stress", source)
      .below(bent(8, 0).shear, 1e-12);
  const Bent coarse = bent(8, 0.25);
  const Bent fine = bent(16, 0.25);
  const Bent finest = bent(32, 0.25);
  test::verified(shell + "bending of a distorted mesh: stress invariants, relative error", source)
      .below(finest.bending_error, 1e-11);
  EXPECT_NEAR(coarse.shear / fine.shear, 2, 0.35);
  test::verified(shell + "distorted, transverse shear of 16 x 16 over that of 32 x 32", "first order")
      .near(fine.shear / finest.shear, 2, 0.25);
}

/// In-plane bending of one rectangular element: the parasitic shear of the bilinear displacements makes it
/// stiffer by (1 + (1 - nu) / 2 (a / b)^2) / (1 - nu^2).
TEST(HughesLiuSelectiveShell, LocksInItsPlaneLikeTheBilinearElement) {
  test::Largest off("Hughes-Liu, selectively reduced, bent in its plane: energy, relative error",
                    "bilinear element, closed form", 1e-12);
  for (const double aspect : {0.5, 1.0, 5.0}) {
    const double factor =
        (1 + 0.5 * (1 - poissons_ratio) * aspect * aspect) / (1 - poissons_ratio * poissons_ratio);
    const double ratio = in_plane_bending_energy(hughes_liu_selective.formulation, aspect);
    off.compare(ratio, factor, factor, std::to_string(aspect));
  }
}

}  // namespace
}  // namespace crumple::elements::testing::hughes_liu_selective_test
