// SPDX-License-Identifier: BSD-3-Clause
//
// A strip is pulled apart: its halves fly away from each other, the columns in the middle yield, fail and
// erode. What must hold is bookkeeping and exact: no energy, momentum or mass is lost or made when elements
// leave.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::erosion_test {
namespace {

constexpr double size = 2.0;
constexpr double thickness = 1.0;
constexpr double speed = 40.0;  // mm/ms each way
constexpr Index columns = 20;
constexpr Index rows = 3;

/// What makes the middle fail.
enum class Failure {
  Law,        ///< the law's own plastic strain
  Criterion,  ///< a principal strain (*MAT_ADD_EROSION)
  Fibres,     ///< the strain of failure of fibres (*MAT_ENHANCED_COMPOSITE_DAMAGE)
  Damage,     ///< damage that lets the stress fade (*MAT_ADD_DAMAGE_GISSMO)
  Step        ///< the stable step of what gets narrow (TDEL)
};

struct Case {
  model::ShellFormulation formulation;
  Failure failure;
};

/// As stiff as the metal; its strength stays up to the same strain.
model::CompositeDamage fibres() {
  model::CompositeDamage law;
  law.modulus_a = law.modulus_b = law.modulus_c = 210;
  law.poisson_ba = law.poisson_ca = law.poisson_cb = 0.3;
  law.shear_ab = law.shear_bc = law.shear_ca = 80;
  law.tension_a = law.compression_a = law.tension_b = law.compression_b = law.shear_strength = 0.27;
  law.failure_tension = 0.04;
  set_stand_in(law);
  return law;
}

model::Model strip(const Case& of) {
  model::Model model =
      test::one_part(test::elastic_steel(), test::shell_section(thickness, 3, of.formulation));
  model::PlasticKinematic soft;
  soft.youngs_modulus = 210;
  soft.poissons_ratio = 0.3;
  soft.yield_stress = 0.25;
  soft.tangent_modulus = 1;
  soft.isotropic_fraction = 0.5;
  model::Material middle{.id = 2, .title = "soft", .density = 7.85e-6, .law = soft};
  if (of.failure == Failure::Fibres)
    middle.law = fibres();
  else if (of.failure == Failure::Law)
    std::get<model::PlasticKinematic>(middle.law).failure_strain = 0.04;
  else if (of.failure == Failure::Damage)
    middle.damage = model::GissmoDamage{.exponent = 2,
                                        .failure_strain = model::constant_family(0.06),
                                        .critical_strain = {},
                                        .critical_damage = 0.4,
                                        .fading_exponent = model::constant_family(1.5),
                                        .size_factor = {}};
  else if (of.failure == Failure::Step)
    middle.least_step = 0.985 * size * std::sqrt(7.85e-6 * (1 - 0.09) / 210);
  else
    middle.erosion = model::ErosionCriteria{.largest_principal_strain = 0.04};
  model.materials.push_back(middle);
  model.parts.push_back({.id = 2, .title = "middle", .section = 0, .material = 1});
  test::add_grid(model, 0, columns, rows, [](double u, double v) {
    return test::Point{u * columns * size, v * rows * size, 0};
  });
  for (Index row = 0; row < rows; ++row)
    for (Index column = columns / 2 - 1; column <= columns / 2; ++column)
      model.shells[row * columns + column].part = 1;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const double x = model.nodes.position[i][0] - 0.5 * columns * size;
    const double v = speed * (x > 1e-9 ? 1 : x < -1e-9 ? -1 : 0);
    model.initial_velocities.push_back({.node = i, .velocity = {v, 0, 0}, .angular_velocity = {}});
  }
  model.control.end_time = 0.1;
  model.control.step_scale = 0.3;
  return model;
}

/// Smaller than the rest of the mesh and out of reach: the step is its own, and constant, so that the
/// central difference keeps the energy to round-off.
void add_clock(model::Model& model) {
  model.parts.push_back({.id = 3, .title = "clock", .section = 0, .material = 0});
  test::add_grid(model, 2, 1, 1, [](double u, double v) {
    return test::Point{1000 + 0.5 * size * u, 0.5 * size * v, 0};
  });
}

class Strip : public ::testing::TestWithParam<Case> {};

TEST_P(Strip, PulledApartLosesNothing) {
  model::Model model = strip(GetParam());
  add_clock(model);
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    timeloop::Simulation simulation(model, {precision, default_isa(), 1});
    const domain::Domain& domain = simulation.domain();
    const auto mass = [&] {
      return std::accumulate(domain.nodes.mass.begin(), domain.nodes.mass.end(), 0.0);
    };
    const double initial_mass = mass();
    double worst = 0;
    double worst_momentum = 0;
    Index eroded = 0;
    double eroded_energy = 0;
    long last_erosion = 0;
    test::run(simulation, [&](const domain::Domain& now) {
      worst = test::larger_of(worst, std::fabs(now.energy.imbalance()) / now.energy.initial_total);
      worst_momentum = test::larger_of(worst_momentum, norm(test::momentum(now)));
      Index count = 0;
      for (const domain::ShellBlock& block : now.shells) count += block.eroded;
      EXPECT_GE(count, eroded);
      // The ledger moves when an element goes, and, by its last hourglass work, one step later.
      if (count > eroded) {
        EXPECT_GT(now.energy.eroded, eroded_energy);
        last_erosion = now.clock.cycle;
      } else if (now.clock.cycle > last_erosion + 1) {
        EXPECT_EQ(now.energy.eroded, eroded_energy);
      }
      eroded = count;
      eroded_energy = now.energy.eroded;
    });
    EXPECT_EQ(eroded, 2 * rows);
    EXPECT_LT(last_erosion, domain.clock.cycle - 100) << "and the rest goes on";
    EXPECT_EQ(mass(), initial_mass);

    // What the elements kept for themselves is what the ledger got.
    const domain::ShellBlock& middle = domain.shells[1];
    const domain::StateItem& energy = *middle.find("energy");
    const domain::StateItem& active = *middle.find("active");
    double gone = 0;
    double left = 0;
    for (Index place = 0; place < middle.elements; ++place)
      (middle.state(place, active.first) == 0 ? gone : left) +=
          middle.state(place, energy.first) + middle.state(place, energy.first + 1);
    const double round_off = precision == Precision::Double ? 1e-12 : 1e-5;
    EXPECT_NEAR(domain.energy.eroded, gone, (precision == Precision::Double ? 1e-14 : 1e-6) * gone);
    EXPECT_EQ(left, 0);
    EXPECT_NEAR(middle.internal_energy + middle.hourglass_energy, 0, round_off * gone);
    // At least the plastic work up to the failure strain.
    const double volume = 2 * rows * size * size * thickness;
    EXPECT_GT(gone, 0.25 * 0.04 * volume);
    EXPECT_LT(gone, 2 * 0.29 * 0.04 * volume);

    // The halves fly on: each keeps its share of the momentum.
    EXPECT_GT(domain.energy.kinetic, 0.5 * domain.energy.initial_total);
    const double momentum_of_half = 0.5 * initial_mass * speed;
    EXPECT_LT(worst_momentum, (precision == Precision::Double ? 1e-11 : 1e-5) * momentum_of_half);
    test::verified(std::string("strip torn apart by erosion, ") +
                       (GetParam().failure == Failure::Law      ? ""
                        : GetParam().failure == Failure::Fibres ? "*MAT_ENHANCED_COMPOSITE_DAMAGE, "
                        : GetParam().failure == Failure::Damage ? "*MAT_ADD_DAMAGE_GISSMO, "
                        : GetParam().failure == Failure::Step   ? "TDEL, "
                                                                : "*MAT_ADD_EROSION, ") +
                       (precision == Precision::Double ? "double" : "mixed") +
                       ": energy over the initial one",
                   "conservation")
        .below(worst, 1e-6);
    RecordProperty(precision == Precision::Double ? "energy_double" : "energy_mixed", std::to_string(worst));
  }
}

INSTANTIATE_TEST_SUITE_P(Formulations, Strip,
                         ::testing::Values(Case{model::ShellFormulation::BelytschkoTsay, Failure::Law},
                                           Case{model::ShellFormulation::HughesLiu, Failure::Law},
                                           Case{model::ShellFormulation::BelytschkoTsay, Failure::Criterion},
                                           Case{model::ShellFormulation::FullyIntegrated, Failure::Criterion},
                                           Case{model::ShellFormulation::BelytschkoTsay, Failure::Fibres},
                                           Case{model::ShellFormulation::FullyIntegrated, Failure::Fibres},
                                           Case{model::ShellFormulation::BelytschkoTsay, Failure::Damage},
                                           Case{model::ShellFormulation::FullyIntegrated, Failure::Damage},
                                           Case{model::ShellFormulation::BelytschkoTsay, Failure::Step}),
                         [](const auto& test) {
                           const auto formulation = test.param.formulation;
                           const std::string name =
                               formulation == model::ShellFormulation::BelytschkoTsay ? "BelytschkoTsay"
                               : formulation == model::ShellFormulation::HughesLiu    ? "HughesLiu"
                                                                                      : "FullyIntegrated";
                           return name + (test.param.failure == Failure::Law         ? ""
                                          : test.param.failure == Failure::Criterion ? "ByCriterion"
                                          : test.param.failure == Failure::Fibres    ? "OfFibres"
                                          : test.param.failure == Failure::Damage    ? "ByDamage"
                                                                                     : "ByStep");
                         });

}  // namespace
}  // namespace crumple::erosion_test
