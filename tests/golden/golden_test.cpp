// SPDX-License-Identifier: BSD-3-Clause
//
// Fingerprints of the whole state after short runs: equal for 1, 2, 3 and 4 threads and for all instruction
// sets of a family, and equal to the golden ones of the golden compiler (docs/determinism.md). To renew them
// after a change that is meant to change bits: CRUMPLE_UPDATE_GOLDEN=1 ctest -L golden, then look at the
// difference and commit it.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

#include "support/meshes.hpp"
#include "support/run.hpp"

namespace crumple {
namespace {

constexpr const char* golden_file = "tests/golden/hashes.txt";

/// A square tube of plastic steel that runs onto a wall and folds onto itself: everything acts at once.
model::Model crushed_tube(model::ShellFormulation formulation) {
  model::PlasticKinematic steel;
  steel.youngs_modulus = 210;
  steel.poissons_ratio = 0.3;
  steel.yield_stress = 0.25;
  steel.tangent_modulus = 1.0;
  steel.isotropic_fraction = 0.5;
  model::Model model = test::one_part({.id = 1, .title = "steel", .density = 7.85e-6, .law = steel},
                                      test::shell_section(1.0, 3, formulation));
  constexpr Index sides = 4;
  constexpr Index columns = 6;
  constexpr Index rows = 24;
  constexpr double width = 30;
  for (Index side = 0; side < sides; ++side) {
    const double angle = side * std::numbers::pi / 2;
    // Four free panels in a square, a contact distance apart at the corners: many surfaces, no sewing needed.
    test::add_grid(model, 0, columns, rows, [&](double u, double v) {
      const double bow = 0.3 * std::sin(6 * std::numbers::pi * v) * std::sin(std::numbers::pi * u);
      const double across = (width - 1.5) * (u - 0.5);
      const double out = 0.5 * width + bow;
      return test::Point{across * std::cos(angle) - out * std::sin(angle),
                         across * std::sin(angle) + out * std::cos(angle), 120.0 * v};
    });
  }
  model::RigidWall wall;
  wall.normal = {0, 0, 1};
  wall.friction = 0.2;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    model.initial_velocities.push_back({.node = i, .velocity = {0, 0, -40}, .angular_velocity = {}});
    wall.nodes.push_back(i);
    if (model.nodes.position[i][2] > 119)
      model.lumped_masses.push_back({.id = i + 1, .node = i, .mass = 0.5});
  }
  model.rigid_walls.push_back(wall);
  model.contacts.push_back(
      {.id = 1, .title = "self", .parts = {0}, .static_friction = 0.2, .dynamic_friction = 0.1});
  model.control.end_time = 1.0;
  model.control.end_cycle = 400;
  return model;
}

std::uint64_t hash_after_run(const model::Model& model, const domain::Execution& execution) {
  timeloop::Simulation simulation(model, execution);
  test::run(simulation);
  return simulation.state_hash();
}

std::string family(Isa isa) {
  return isa == Isa::Avx2 || isa == Isa::Avx512 ? "fma" : "plain";
}

bool golden_compiler() {
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ == 12 && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  return true;
#else
  return false;
#endif
}

std::map<std::string, std::string> read_golden() {
  std::map<std::string, std::string> hashes;
  std::ifstream in(golden_file);
  std::string name;
  std::string hash;
  while (in >> name >> hash) hashes[name] = hash;
  return hashes;
}

void write_golden(const std::map<std::string, std::string>& hashes) {
  std::ofstream out(golden_file);
  for (const auto& [name, hash] : hashes) out << name << ' ' << hash << '\n';
}

void check_golden(const std::string& name, std::uint64_t value) {
  if (!golden_compiler()) GTEST_SKIP() << "golden hashes hold for g++ 12 in the release preset";
  std::ostringstream text;
  text << std::hex << value;
  std::map<std::string, std::string> hashes = read_golden();
  if (std::getenv("CRUMPLE_UPDATE_GOLDEN") != nullptr) {
    hashes[name] = text.str();
    write_golden(hashes);
  }
  EXPECT_EQ(text.str(), hashes[name]) << name;
}

struct Case {
  const char* name;
  model::ShellFormulation formulation;
  Precision precision;
};

class Golden : public ::testing::TestWithParam<Case> {};

TEST_P(Golden, CrushedTube) {
  const model::Model model = crushed_tube(GetParam().formulation);
  std::map<std::string, std::uint64_t> by_family;
  for (const Isa isa : available_isas()) {
    const std::uint64_t one = hash_after_run(model, {GetParam().precision, isa, 1});
    if (isa == default_isa()) {
      for (const int threads : {2, 3, 4})
        ASSERT_EQ(hash_after_run(model, {GetParam().precision, isa, threads}), one)
            << isa_name(isa) << ", " << threads << " threads";
    }
    const auto [entry, first] = by_family.emplace(family(isa), one);
    ASSERT_TRUE(first || entry->second == one) << isa_name(isa) << " differs from its family " << family(isa);
  }
  for (const auto& [name, hash] : by_family)
    check_golden(std::string("crushed_tube_") + GetParam().name + "_" + name, hash);
}

INSTANTIATE_TEST_SUITE_P(
    All, Golden,
    ::testing::Values(Case{"BelytschkoTsayDouble", model::ShellFormulation::BelytschkoTsay,
                           Precision::Double},
                      Case{"BelytschkoTsayMixed", model::ShellFormulation::BelytschkoTsay, Precision::Mixed},
                      Case{"HughesLiuDouble", model::ShellFormulation::HughesLiu, Precision::Double},
                      Case{"HughesLiuMixed", model::ShellFormulation::HughesLiu, Precision::Mixed}),
    [](const auto& which) { return which.param.name; });

}  // namespace
}  // namespace crumple
