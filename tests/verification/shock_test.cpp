// SPDX-License-Identifier: BSD-3-Clause
// Plane shocks in bars of solids: the states behind them are those of the Hugoniot.
//
// A bar of copper flies against a rigid end, in uniaxial strain. With Us = C + S u, u the velocity of impact,
// the conditions of Rankine and Hugoniot give p = rho0 Us u, rho0 / rho = 1 - u / Us, E = rho0 u^2 / 2 (C, S,
// gamma of OFHC copper: S.P. Marsh, LASL Shock Hugoniot Data, 1980; strength: Johnson & Cook 1983).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/copper.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::shock_test {
namespace {

constexpr double density = test::copper_density;
constexpr double speed_of_sound = 3.94;
constexpr double slope = 1.489;
constexpr double gamma = 2.02;
constexpr Index pieces = 200;
constexpr double bar_length = 20;

model::EquationOfState copper_equation() {
  return {.id = 1,
          .title = "copper",
          .initial_energy = 0,
          .initial_volume = 1,
          .law = model::Gruneisen{speed_of_sound, {slope, 0, 0}, gamma, 0}};
}
model::ConstitutiveLaw fluid() {
  return model::NullMaterial{};
}
model::ConstitutiveLaw metal() {
  model::JohnsonCook law = test::ofhc_copper();
  law.thermal_exponent = 1.09;
  law.melting_rise = 1062;
  law.heat_capacity = 383e-6;
  return law;
}

using Formulation = model::SolidFormulation;

model::Model flying_bar(const model::ConstitutiveLaw& law, double velocity, double end_time,
                        Formulation form) {
  model::Material material{.id = 1, .title = "bar", .density = density, .law = law};
  model::Model model = test::one_solid_part(material);
  model.equations_of_state.push_back(copper_equation());
  model.parts[0].equation_of_state = 0;
  model.solid_sections[0].formulation = form;
  model.control.end_time = end_time;
  const double side = bar_length / pieces;
  test::add_box(model, 0, 1, 1, pieces, [&](double u, double v, double w) {
    return test::Point{side * u, side * v, bar_length * w};
  });
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const bool at_wall = model.nodes.position[i][2] == 0;
    if (!at_wall) model.initial_velocities.push_back({.node = i, .velocity = {0, 0, -velocity}});
    model.fixed_nodes.push_back({.node = i, .translation = {true, true, at_wall}});
  }
  return model;
}

/// Means over the elements from 45 to 70 % of the bar: behind the shock, and away from the end, where the
/// start of the shock leaves the bar too hot (W.F. Noh, J. Comp. Phys. 72 (1987) 78-120).
struct Behind {
  double pressure = 0;
  double axial = 0;  ///< compressive stress
  double volume = 0;
  double energy = 0;
  double wave_speed = 0;
  double scatter = 0;  ///< largest difference of a pressure from their mean
};
Behind behind(const domain::Domain& domain) {
  const domain::SolidBlock& block = domain.solids.front();
  const auto at = [&](Index place, const char* name, Index which = 0) {
    return block.state(place, block.find(name)->first + which);
  };
  Behind found;
  std::vector<double> pressures;
  for (Index place = 0; place < block.elements; ++place) {
    const Index element = block.element[place];
    if (element < 45 * pieces / 100 || element >= 70 * pieces / 100) continue;
    pressures.push_back(-(at(place, "stress", 0) + at(place, "stress", 1) + at(place, "stress", 2)) / 3);
    found.pressure += pressures.back();
    found.axial -= at(place, "stress", 2);
    found.volume += 1 + at(place, "volume_change");
    found.energy += at(place, "internal_energy");
    found.wave_speed += at(place, "wave_speed");
  }
  const double over = 1.0 / static_cast<double>(pressures.size());
  for (double* const sum : {&found.pressure, &found.axial, &found.volume, &found.energy, &found.wave_speed})
    *sum *= over;
  for (const double p : pressures)
    found.scatter = test::larger_of(found.scatter, std::fabs(p - found.pressure));
  return found;
}

/// Compressed length in reference coordinates: where the pressure has half its value behind the shock.
double shock_place(const domain::Domain& domain, double pressure) {
  const domain::SolidBlock& block = domain.solids.front();
  const Index stress = block.find("stress")->first;
  std::vector<double> by_element(pieces);
  for (Index place = 0; place < block.elements; ++place)
    by_element[block.element[place]] =
        -(block.state(place, stress) + block.state(place, stress + 1) + block.state(place, stress + 2)) / 3;
  const double half = pressure / 2;
  for (Index e = pieces - 1; e > 0; --e)
    if (by_element[e] < half && by_element[e - 1] >= half) {
      const double share = (by_element[e - 1] - half) / (by_element[e - 1] - by_element[e]);
      return (e - 0.5 + share) * bar_length / pieces;
    }
  return 0;
}

struct Shock {
  Behind state;
  double speed = 0;  ///< in reference coordinates
  double energy_error = 0;
  double energy_ratio = 0;  ///< sum of the energies of the equation of state over the internal energy
  double limit = 0;         ///< stable step at the end
};
Shock shock(const model::ConstitutiveLaw& law, double velocity, const domain::Execution& execution,
            Formulation form = Formulation::OnePointHexahedron) {
  const double expected = speed_of_sound + slope * velocity;
  const double pressure = density * expected * velocity;
  const double early = 0.4 * bar_length / expected;
  const double late = 0.8 * bar_length / expected;
  const model::Model model = flying_bar(law, velocity, late, form);
  timeloop::Simulation simulation(model, execution);
  double place = 0;
  double time = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (time == 0 && domain.clock.time > early) {
      time = domain.clock.time;
      place = shock_place(domain, pressure);
    }
  });
  const domain::Domain& domain = simulation.domain();
  Shock found;
  found.state = behind(domain);
  found.speed = (shock_place(domain, pressure) - place) / (domain.clock.time - time);
  const domain::EnergyLedger& energy = domain.energy;
  found.energy_error =
      std::fabs(energy.total() - energy.initial_total - energy.external_work) / energy.internal;
  const domain::SolidBlock& block = domain.solids.front();
  double sum = 0;
  for (Index e = 0; e < block.elements; ++e) sum += block.state(e, block.find("internal_energy")->first);
  const double side = bar_length / pieces;
  found.energy_ratio = sum * side * side * side / energy.internal;
  found.limit = domain.clock.element_limit;
  return found;
}

class Shocks : public ::testing::TestWithParam<Precision> {};
INSTANTIATE_TEST_SUITE_P(Both, Shocks, ::testing::Values(Precision::Double, Precision::Mixed),
                         [](const auto& p) { return p.param == Precision::Double ? "double" : "mixed"; });

TEST_P(Shocks, FluidReachesTheHugoniot) {
  for (const double velocity : {0.1, 0.5, 1.5}) {
    const Shock found = shock(fluid(), velocity, {GetParam(), default_isa(), 1});
    const double speed = speed_of_sound + slope * velocity;
    const double pressure = density * speed * velocity;
    const double volume = 1 - velocity / speed;
    const double energy = 0.5 * density * velocity * velocity;
    std::printf(
        "u %.1f km/s: Us %.4f (%.4f) p %.4f (%.4f, scatter %.1e) v %.5f (%.5f) E %.5f (%.5f) "
        "energy error %.1e\n",
        velocity, found.speed, speed, found.state.pressure, pressure, found.state.scatter / pressure,
        found.state.volume, volume, found.state.energy, energy, found.energy_error);
    const std::string wave = "shock in copper at " + test::figure(velocity) + " km/s: ";
    const char* const hugoniot = "Rankine and Hugoniot";
    test::verified(wave + "velocity over exact", hugoniot).near(found.speed / speed, 1, 1e-3);
    test::verified(wave + "pressure over exact", hugoniot).near(found.state.pressure / pressure, 1, 5e-4);
    test::verified(wave + "volume over exact", hugoniot).near(found.state.volume / volume, 1, 1e-4);
    test::verified(wave + "energy over exact", hugoniot).near(found.state.energy / energy, 1, 3e-3);
    EXPECT_LT(found.state.scatter, 0.01 * pressure);
    EXPECT_LT(found.energy_error, 1e-3);
    EXPECT_NEAR(found.energy_ratio, 1, 1e-3);
  }
}

/// Eight points instead of one: in uniaxial strain all have the same state.
TEST_P(Shocks, EightPointsSeeTheSameShock) {
  const Shock one = shock(metal(), 0.5, {GetParam(), default_isa(), 1});
  const Shock eight = shock(metal(), 0.5, {GetParam(), default_isa(), 1}, Formulation::SelectiveHexahedron);
  EXPECT_NEAR(eight.state.axial / one.state.axial, 1, 1e-4);
  EXPECT_NEAR(eight.state.energy / one.state.energy, 1, 1e-3);
  EXPECT_NEAR(eight.speed / one.speed, 1, 1e-4);
  EXPECT_LT(eight.energy_error, 1e-3);
}

/// Strength adds two thirds of the yield stress to the axial stress; the pressure at the volume stays on the
/// equation of state.
TEST_P(Shocks, MetalCarriesItsStrengthOnTop) {
  const double velocity = 0.5;
  const Shock found = shock(metal(), velocity, {GetParam(), default_isa(), 1});
  const double eta = 1 - found.state.volume;
  const double below = 1 - slope * eta;
  const double hugoniot = density * speed_of_sound * speed_of_sound * eta / (below * below);
  const double pressure = hugoniot * (1 - gamma * eta / 2) + gamma * found.state.energy;
  std::printf(
      "p %.4f, by the equation of state %.4f; axial stress %.4f; momentum rho0 Us u %.4f, error %.1e\n",
      found.state.pressure, pressure, found.state.axial, density * found.speed * velocity,
      found.energy_error);
  EXPECT_NEAR(found.state.pressure / pressure, 1, 1e-3);
  const double strength = found.state.axial - found.state.pressure;
  EXPECT_GT(strength, 2.0 / 3 * 0.15);
  EXPECT_LT(strength, 2.0 / 3 * 0.5);
  // Conservation of momentum across the plastic shock; a precursor of 0.2 GPa runs ahead of it.
  EXPECT_NEAR(found.state.axial / (density * found.speed * velocity), 1, 0.01);
  EXPECT_LT(found.energy_error, 0.01);
}

/// The compressed copper is thinner and its waves are faster: c^2 = -v^2 dp/dv at constant entropy over rho0.
TEST(Shocks, StepFollowsTheWaveSpeed) {
  const auto pressure = [](double volume, double energy) {
    const double eta = 1 - volume;
    const double below = 1 - slope * eta;
    return density * speed_of_sound * speed_of_sound * eta / (below * below) * (1 - gamma * eta / 2) +
           gamma * energy;
  };
  const double velocity = 1.5;
  const Shock found = shock(fluid(), velocity, test::execution());
  const double volume = 1 - velocity / (speed_of_sound + slope * velocity);
  const double energy = 0.5 * density * velocity * velocity;
  constexpr double h = 1e-6;
  const double over_volume = (pressure(volume + h, energy) - pressure(volume - h, energy)) / (2 * h);
  const double wave_speed = volume * std::sqrt((gamma * pressure(volume, energy) - over_volume) / density);
  std::printf("wave speed %.4f (%.4f) km/s\n", found.state.wave_speed, wave_speed);
  EXPECT_NEAR(found.state.wave_speed / wave_speed, 1, 2e-3);
  // That of a free box of a fluid, cubes at first. The bulk viscosity of the front takes up to half of it.
  const double side = bar_length / pieces;
  const double behind_front = side / std::sqrt(2 + 1 / (volume * volume)) / wave_speed;
  EXPECT_LE(found.limit, behind_front * 1.001);
  EXPECT_GT(found.limit, 0.5 * behind_front);
}

TEST(Shocks, AreTheSameForAnyNumberOfThreads) {
  std::vector<double> pressure;
  for (const int threads : {1, 3})
    pressure.push_back(shock(metal(), 0.5, {Precision::Mixed, default_isa(), threads}).state.pressure);
  EXPECT_EQ(pressure[0], pressure[1]);
}

}  // namespace
}  // namespace crumple::shock_test
