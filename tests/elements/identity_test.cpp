// SPDX-License-Identifier: BSD-3-Clause
// The same bits for any number of threads and for instruction sets that round alike.
#include <gtest/gtest.h>

#include <cstring>

#include "shell_harness.hpp"
#include "support/alike.hpp"
#include "support/larger.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::identity_test {
namespace {

/// Everything that the shells leave behind after some cycles of violent motion.
struct Trace {
  std::vector<float> float_state;
  std::vector<double> double_state;
  std::vector<double> forces;
  std::vector<double> sums;

  bool operator==(const Trace& b) const {
    const auto same = [](const auto& x, const auto& y) {
      return x.size() == y.size() &&
             (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
    };
    return same(float_state, b.float_state) && same(double_state, b.double_state) && same(forces, b.forces) &&
           same(sums, b.sums);
  }
};

Trace run(const model::Model& model, const domain::Execution& execution) {
  Driven body(model, execution);
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Trace trace;
  for (int i = 0; i < 8; ++i) {
    std::vector<Vec3> u;
    std::vector<Vec3> r;
    for (Index n = 0; n < body.domain.nodes.count(); ++n) {
      u.push_back(0.01 * Vec3{uniform(generator), uniform(generator), uniform(generator)});
      r.push_back(0.01 * Vec3{uniform(generator), uniform(generator), uniform(generator)});
    }
    body.step(1e-7, u, r);
  }
  for (const domain::ShellBlock& block : body.domain.shells) {
    trace.float_state.insert(trace.float_state.end(), block.float_state.begin(), block.float_state.end());
    trace.double_state.insert(trace.double_state.end(), block.double_state.begin(), block.double_state.end());
    trace.sums.insert(trace.sums.end(), {block.internal_energy, block.hourglass_energy});
  }
  trace.sums.push_back(body.domain.clock.element_limit);
  for (Index n = 0; n < body.domain.nodes.count(); ++n)
    for (int axis = 0; axis < 3; ++axis) {
      trace.forces.push_back(body.force(n)[axis]);
      trace.forces.push_back(body.moment(n)[axis]);
    }
  return trace;
}

/// 37 x 37 elements in two parts: several chunks, the last groups not full.
model::Model two_parts(const Kind& kind, model::HourglassForm form, const model::Material& material) {
  model::Model model = plate(kind.formulation, 37, 0.2, 3, material);
  model.control.hourglass.form = form;
  model.control.thickness_change = form == model::HourglassForm::Viscous;
  model.parts.push_back(model.parts[0]);
  model.parts[1].id = 2;
  for (std::size_t e = 0; e < model.shells.size(); e += 1)
    if (model.nodes.position[model.shells[e].node[0]][0] > 70) model.shells[e].part = 1;
  return model;
}

class Identity : public ::testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(All, Identity, ::testing::ValuesIn(all_kinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST_P(Identity, ForOneTwoAndThreeThreads) {
  const model::Model model = two_parts(GetParam(), model::HourglassForm::Viscous, plastic());
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    const Isa isa = available_isas().back();
    const Trace one = run(model, {precision, isa, 1});
    EXPECT_TRUE(one == run(model, {precision, isa, 2}));
    EXPECT_TRUE(one == run(model, {precision, isa, 3}));
  }
}

TEST_P(Identity, ForInstructionSetsThatRoundAlike) {
  for (const auto form : {model::HourglassForm::Viscous, model::HourglassForm::Stiffness})
    for (const Precision precision : {Precision::Double, Precision::Mixed}) {
      const model::Model model = two_parts(GetParam(), form, plastic());
      std::vector<Trace> traces;
      for (const Isa isa : available_isas()) traces.push_back(run(model, {precision, isa, 1}));
      test::expect_alike(traces, std::equal_to<>());
      for (const Trace& other : traces) {
        double largest = 0;
        double worst = 0;
        for (std::size_t i = 0; i < other.forces.size(); ++i) {
          largest = test::larger_of(largest, std::fabs(other.forces[i]));
          worst = test::larger_of(worst, std::fabs(other.forces[i] - traces[0].forces[i]));
        }
        EXPECT_LT(worst, (precision == Precision::Mixed ? 1e-4 : 1e-12) * largest);
      }
    }
}

/// Float and double kernels compute the same thing.
TEST_P(Identity, MixedAgreesWithDouble) {
  const model::Model model = two_parts(GetParam(), model::HourglassForm::Viscous, plastic());
  const Trace exact = run(model, {Precision::Double, Isa::Scalar, 1});
  const Trace rounded = run(model, {Precision::Mixed, Isa::Scalar, 1});
  double largest = 0;
  double worst = 0;
  for (std::size_t i = 0; i < exact.forces.size(); ++i) {
    largest = test::larger_of(largest, std::fabs(exact.forces[i]));
    worst = test::larger_of(worst, std::fabs(exact.forces[i] - rounded.forces[i]));
  }
  test::verified("violent motion in mixed precision: forces over the largest, difference", "double precision")
      .below(worst / largest, 1e-5);
  EXPECT_GT(exact.sums[0], 0);
  test::verified("violent motion in mixed precision: energy over that in double precision",
                 "double precision")
      .near(rounded.sums[0] / exact.sums[0], 1, 1e-5);
}

/// Elements of the fill and inactive ones leave no force, no energy and no limit on the step.
TEST_P(Identity, InactiveElementsAreSilent) {
  model::Model model = plate(GetParam().formulation, 3, 0.1);
  Driven body(model, {Precision::Double, available_isas().back(), 1});
  domain::ShellBlock& block = body.domain.shells[0];
  for (Index e = 0; e < block.elements; ++e) block.set_state(e, block.find("active")->first, 0);
  body.step(
      1e-7,
      [](const Vec3& x) {
        return Vec3{1.01 * x.x, 0.98 * x.y, 0.01 * x.x * x.y};
      },
      [](const Vec3& x) {
        return Vec3{0.01 * x.x, 0, 0};
      });
  for (Index n = 0; n < body.domain.nodes.count(); ++n) {
    EXPECT_EQ(norm(body.force(n)), 0);
    EXPECT_EQ(norm(body.moment(n)), 0);
  }
  EXPECT_EQ(block.internal_energy, 0);
  EXPECT_EQ(block.hourglass_energy, 0);
  EXPECT_GT(body.domain.clock.element_limit, 1);
}

}  // namespace
}  // namespace crumple::elements::testing::identity_test
