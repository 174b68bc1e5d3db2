// SPDX-License-Identifier: BSD-3-Clause
// Prony series against the closed forms of linear viscoelasticity (J.D. Ferry, Viscoelastic Properties of
// Polymers (1980), chapter 3).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::viscoelastic_test {
namespace {

const std::vector<model::Relaxation> shear{{0.4, 0}, {1.5, 3}, {0.7, 40}, {2.0, 900}};
const std::vector<model::Relaxation> bulk{{20, 0}, {5, 100}};

model::Material material_of(const std::vector<model::Relaxation>& shears,
                            const std::vector<model::Relaxation>& bulks) {
  model::Material material;
  material.id = 76;
  material.density = 1e-9;
  model::Viscoelastic law;
  law.shear = shears;
  law.bulk = bulks;
  set_instantaneous(law);
  material.law = law;
  return material;
}
double modulus_at(const std::vector<model::Relaxation>& parts, double time) {
  double sum = 0;
  for (const model::Relaxation& part : parts) sum += part.modulus * std::exp(-part.decay * time);
  return sum;
}
/// The integral of the modulus over the time.
double integral_to(const std::vector<model::Relaxation>& parts, double time) {
  double sum = 0;
  for (const model::Relaxation& part : parts)
    sum += part.decay > 0 ? -part.modulus / part.decay * std::expm1(-part.decay * time) : part.modulus * time;
  return sum;
}

class Viscous : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Viscous, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// A strain in no time, then held in steps of very different lengths.
TEST_P(Viscous, HeldStrainRelaxesByTheSeries) {
  const Six strain{3e-3, -1e-3, -5e-4, 4e-3, 1e-3, -2e-3};
  const double trace = 1.5e-3;
  test::Largest off("viscoelastic, strain held: stress over the first, error", "Prony series", 1e-13);
  SolidDriver<double> point(material_of(shear, bulk), GetParam());
  point.apply(strain, 0);
  test::Points exact;
  test::Points found;
  double time = 0;
  for (int i = 0; i < 200; ++i) {
    const double g = modulus_at(shear, time);
    const double k = modulus_at(bulk, time);
    for (int c = 0; c < 6; ++c) {
      const double expected = c < 3 ? 2 * g * (strain[c] - trace / 3) + k * trace : g * strain[c];
      off.compare(point.stress()[c], expected, 0.02);
    }
    if (time > 0 && i % 5 == 0) found.push_back({std::log10(time), point.stress()[3] / strain[3]});
    if (time > 0) exact.push_back({std::log10(time), g});
    const double step = 1e-6 * std::pow(1.08, i);
    point.apply(Six{}, step);
    time += step;
  }
  if (GetParam() == Isa::Scalar)
    test::drawn("Viscoelastic solid, shear strain held", "log10 of the time [s]", "shear modulus [MPa]")
        .accepted("Prony series", exact)
        .found("one point of material", found)
        .note();
}

/// A constant rate is met exactly, whatever the step.
TEST_P(Viscous, ConstantRateIsExactForAnyStep) {
  test::Largest off("viscoelastic, constant strain rate, steps from 1e-7 to 0.1 s: stress, relative error",
                    "integral of the series", 1e-12);
  for (const double step : {1e-7, 1e-4, 0.1}) {
    SolidDriver<double> point(material_of(shear, bulk), GetParam());
    constexpr double rate = 0.01;
    for (int i = 1; i <= 20; ++i) {
      point.apply({rate * step, 0, 0, 2 * rate * step, 0, 0}, step);
      const double g = integral_to(shear, i * step);
      const double k = integral_to(bulk, i * step);
      off.compare(point.stress()[3], 2 * rate * g, 2 * rate * g);
      off.compare(point.stress()[0], rate * (4.0 / 3 * g + k), rate * (4.0 / 3 * g + k));
    }
  }
}

/// A cycle of shear dissipates pi G'' of the square of its amplitude, G'' = sum G w t / (1 + w^2 t^2).
TEST_P(Viscous, CyclesLoseTheLossModulus) {
  for (const double frequency : {1.0, 10.0, 300.0}) {
    double loss = 0;
    for (const model::Relaxation& part : shear)
      if (part.decay > 0)
        loss += part.modulus * frequency * part.decay / (part.decay * part.decay + frequency * frequency);
    double error[2];
    for (const int fine : {0, 1}) {
      const int steps = fine == 0 ? 100 : 200;
      SolidDriver<double> point(material_of(shear, bulk), GetParam());
      constexpr double amplitude = 0.01;
      const auto at = [&](int i) { return amplitude * std::sin(2 * std::numbers::pi * i / steps); };
      const double step = 2 * std::numbers::pi / frequency / steps;
      // Until nothing is left of the beginning: the slowest part decays with 3 / s.
      const int cycles = 2 + static_cast<int>(40 / 3.0 * frequency / (2 * std::numbers::pi));
      double work = 0;
      for (int i = 1; i <= cycles * steps; ++i) {
        point.apply({0, 0, 0, at(i) - at(i - 1), 0, 0}, step);
        if (i > (cycles - 1) * steps) work += point.energy();
      }
      error[fine] = std::fabs(work / (std::numbers::pi * loss * amplitude * amplitude) - 1);
    }
    test::verified(
        "viscoelastic, shear at " + std::to_string(frequency) + " rad/s: loss of a cycle, relative error",
        "loss modulus")
        .below(error[1], 2e-3);
    EXPECT_NEAR(error[0] / error[1], 4, 0.2);
  }
}

TEST_P(Viscous, PressureIsTheLogarithmOfTheVolume) {
  MotionDriver<double> point(material_of(shear, {{20, 0}}), GetParam());
  double error[2];
  for (const int fine : {0, 1}) {
    MotionDriver<double> moved(material_of(shear, {{20, 0}}), GetParam());
    const double side = std::cbrt(0.6);
    moved.move_in_steps({{{side, 0, 0}, {0, side, 0}, {0, 0, side}}}, fine == 0 ? 50 : 100, 1e-3);
    error[fine] = std::fabs(moved.stress()[0] / (20 * std::log(0.6)) - 1);
  }
  test::verified("viscoelastic, compressed to 0.6 of the volume: pressure, relative error", "K ln V")
      .below(error[1], 1e-5);
  EXPECT_NEAR(error[0] / error[1], 4, 0.1);
}

TEST_P(Viscous, StressTurnsWithTheBodyAndRelaxes) {
  const std::array<double, 3> axis{0.6, 0, 0.8};
  SolidDriver<double> still(material_of(shear, bulk), GetParam());
  SolidDriver<double> turning(material_of(shear, bulk), GetParam());
  const Six strain{3e-3, -1e-3, -5e-4, 4e-3, 1e-3, -2e-3};
  for (SolidDriver<double>* point : {&still, &turning}) point->apply(strain, 1e-3);
  turning.set_turn(0, 0, turn_about(axis, 0.1));
  for (int i = 0; i < 25; ++i)
    for (SolidDriver<double>* point : {&still, &turning}) point->apply(Six{}, 2e-3);
  test::verified("viscoelastic, turned by 2.5 rad while it relaxes: stress over the first, error",
                 "turned stress")
      .below(largest_difference(turning.stress(), rotated(still.stress(), turn_about(axis, 2.5))) / 0.02,
             1e-13);
}

/// In float too nothing is lost that is small beside the stress: 100 000 steps of 1e-8 decay times each.
TEST_P(Viscous, SlowRelaxationIsNotLostInFloat) {
  SolidDriver<float> point(material_of({{1, 1}}, {{20, 0}}), GetParam());
  point.apply({0, 0, 0, 1e-3, 0, 0}, 0);
  const double first = point.stress()[3];
  for (int i = 0; i < 100000; ++i) point.apply(Six{}, 1e-8);
  test::verified("viscoelastic, 100000 steps in single precision: stress lost over 0.001 of it, error",
                 "1 - exp(-t)")
      .near((1 - point.stress()[3] / first) / 1e-3, 1, 2e-3);
}

TEST(ViscoelasticConstants, AreChecked) {
  EXPECT_NO_THROW(solid_material_constants(material_of(shear, bulk)));
  EXPECT_THROW(solid_material_constants(material_of({{1, -1}}, bulk)), Error);
  EXPECT_THROW(solid_material_constants(material_of({}, bulk)), Error);
}

const std::vector<model::Relaxation> series{{1.5, 3}, {0.7, 40}};

model::Material rubber(bool is_ogden, const std::vector<model::Relaxation>& relaxing) {
  model::Material material;
  material.id = 77;
  material.density = 1e-9;
  if (is_ogden) {
    model::OgdenRubber law;
    law.poissons_ratio = 0.49;
    law.modulus = {0.6, -0.01};
    law.exponent = {1.3, -2};
    law.youngs_modulus = 2 * 0.4 * 1.49;
    law.relaxing = relaxing;
    material.law = law;
  } else {
    model::PolynomialRubber law;
    law.poissons_ratio = 0.49;
    law.c10 = 0.15;
    law.c01 = 0.05;
    law.youngs_modulus = 4 * 0.2 * 1.49;
    law.relaxing = relaxing;
    material.law = law;
  }
  return material;
}

/// A shear at a constant rate, then held: beside the stress of the rubber that of the series, for rubber of
/// either kind.
TEST_P(Viscous, RubberRelaxesBesideItsOwnStress) {
  constexpr double amount = 1e-3;
  constexpr double until = 0.2;
  test::Largest off("rubber with a Prony series, sheared and held: shear stress beside its own, error over G",
                    "convolution of the series", 1e-6);
  for (const bool is_ogden : {false, true}) {
    MotionDriver<double> point(rubber(is_ogden, series), GetParam());
    MotionDriver<double> lasting(rubber(is_ogden, {}), GetParam());
    for (int i = 1; i <= 100; ++i) {
      const double time = 0.01 * i;
      const double shear_now = amount * std::min(1.0, time / until);
      const Matrix f{{{1, shear_now, 0}, {0, 1, 0}, {0, 0, 1}}};
      point.move_to(f, 0.01);
      lasting.move_to(f, 0.01);
      const double held = std::max(0.0, time - until);
      double exact = 0;
      for (const model::Relaxation& term : series)
        exact += amount / until * term.modulus / term.decay *
                 (std::exp(-term.decay * held) - std::exp(-term.decay * time));
      off.compare(point.stress()[3] - lasting.stress()[3], exact, amount * 2.2);
    }
  }
}

/// At once, in one step, the series adds its shear modulus, in the wave speed too, and turns with the body.
TEST_P(Viscous, RubberIsStifferAtOnceAndTurns) {
  for (const bool is_ogden : {false, true}) {
    MotionDriver<double> point(rubber(is_ogden, series), GetParam());
    MotionDriver<double> lasting(rubber(is_ogden, {}), GetParam());
    const Matrix f{{{1.1, 0.2, 0}, {0, 0.95, 0}, {0, 0, 1}}};
    for (MotionDriver<double>* const one : {&point, &lasting}) one->move_to(f, 0);
    const double more = point.wave_speed() * point.wave_speed() - lasting.wave_speed() * lasting.wave_speed();
    EXPECT_NEAR(more, 4.0 / 3.0 * 2.2 * 1.1 * 0.95 / 1e-9, 1e-3 * more);
    const auto excess = [&] {
      const Six a = point.stress();
      const Six b = lasting.stress();
      Six difference{};
      for (std::size_t k = 0; k < 6; ++k) difference[k] = a[k] - b[k];
      return difference;
    };
    const double before = equivalent(excess());
    EXPECT_GT(before, 0.2);
    EXPECT_NEAR(mean(excess()), 0, 1e-12);
    // Turned by 90 degrees about z in no time: xx and yy change places.
    const Six still = excess();
    for (int i = 1; i <= 90; ++i) {
      const double angle = std::numbers::pi / 180 * i;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      const Matrix turned_body{
          {{c * 1.1, c * 0.2 - s * 0.95, 0}, {s * 1.1, s * 0.2 + c * 0.95, 0}, {0, 0, 1}}};
      point.move_to(turned_body, 0);
      lasting.move_to(turned_body, 0);
    }
    EXPECT_NEAR(excess()[0], still[1], 1e-3 * before);
    EXPECT_NEAR(excess()[1], still[0], 1e-3 * before);
    EXPECT_NEAR(excess()[3], -still[3], 1e-3 * before);
    // And it is gone after a long time.
    for (int i = 0; i < 100; ++i) {
      point.move_to({{{0, -0.95, 0}, {1.1, 0.2, 0}, {0, 0, 1}}}, 0.1);
      lasting.move_to({{{0, -0.95, 0}, {1.1, 0.2, 0}, {0, 0, 1}}}, 0.1);
    }
    EXPECT_NEAR(equivalent(excess()), 0, 1e-9);
  }
}

}  // namespace
}  // namespace crumple::materials::testing::viscoelastic_test
