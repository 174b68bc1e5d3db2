// SPDX-License-Identifier: BSD-3-Clause
// One object over many builds: what it keeps of the last one must never show in the result.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "family_test_name.hpp"
#include "production_check.hpp"
#include "scenes.hpp"

namespace cellsearch::production_reuse_test {
namespace {

/// A mesh that goes through random changes, one before each build.
class ChangingMesh {
 public:
  explicit ChangingMesh(std::uint64_t seed) : random_(seed) { replace(); }

  const scenes::Mesh& mesh() const { return mesh_; }

  /// Makes the next change and names it.
  const char* change() {
    switch (random_.below(14)) {
      case 0:
      case 1:
      case 2:
        move_all(0.01 * size_);
        return "all drift a little";
      case 3:
        move_some(0.5 * size_);
        return "some jump";
      case 4:
        move_some(std::pow(10.0, random_.uniform(1.0, 12.0)) * size_);
        return "some jump far";
      case 5:
        stretch(random_.uniform(0.94, 1.06));
        return "stretched";
      case 6:
        stretch(random_.below(2) == 0 ? random_.uniform(2.0, 1e6) : random_.uniform(1e-6, 0.5));
        return "stretched far";
      case 7:
        stretch(0.0);
        return "collapsed";
      case 8:
        mesh_.positions = at_rest_;
        return "as it was";
      case 9:
        mesh_.expansion *= random_.below(3) == 0 ? random_.uniform(0.0, 100.0) : random_.uniform(0.9, 1.1);
        if (mesh_.expansion == 0.0) mesh_.expansion = 0.01 * size_;
        return "another expansion";
      case 10:
        expand_segments();
        return "other expansions of segments";
      case 11:
        remove_or_add();
        return "other numbers of nodes and segments";
      case 12:
        list_nodes();
        return "another list of nodes";
      default:
        if (random_.below(3) == 0) {
          replace();
          return "another mesh";
        }
        shift();
        return "shifted";
    }
  }

 private:
  void replace() {
    mesh_ = scenes::make_mesh(static_cast<std::uint64_t>(random_.below(100000)));
    mesh_.domain.reset();
    if (mesh_.segment_count() > 150) mesh_.segments.resize(4 * std::size_t{150});
    if (!mesh_.segment_expansion.empty()) mesh_.segment_expansion.resize(mesh_.segment_count());
    at_rest_ = mesh_.positions;
    Box box;
    for (std::size_t node = 0; node < mesh_.node_count(); ++node)
      box.include(&mesh_.positions[node * mesh_.stride]);
    size_ = 1e-3;
    for (std::size_t axis = 0; axis < 3; ++axis) size_ = std::fmax(size_, box.hi[axis] - box.lo[axis]);
    // Far from overflow, so that the changes stay finite.
    size_ = std::fmin(size_, 1e200);
  }

  template <class Change>
  void for_node(std::size_t node, const Change& change) {
    for (std::size_t axis = 0; axis < 3; ++axis) change(mesh_.positions[node * mesh_.stride + axis], axis);
  }

  double by(double most) { return random_.uniform(-most, most); }

  void move_all(double most) {
    for (std::size_t node = 0; node < mesh_.node_count(); ++node)
      for_node(node, [&](double& x, std::size_t) { x += by(most); });
  }

  void move_some(double most) {
    const Index count = 1 + random_.below(5);
    for (Index i = 0; i < count; ++i) {
      const std::size_t node = static_cast<std::size_t>(random_.below(mesh_.node_count()));
      for_node(node, [&](double& x, std::size_t) { x += by(most); });
    }
  }

  /// Along some axes, about the first node.
  void stretch(double factor) {
    const std::array<double, 3> about{mesh_.positions[0], mesh_.positions[1], mesh_.positions[2]};
    const Index axes = 1 + random_.below(7);
    const auto move = [&](double& x, std::size_t axis) {
      if (((axes >> axis) & 1) != 0) x = about[axis] + factor * (x - about[axis]);
    };
    for (std::size_t node = 0; node < mesh_.node_count(); ++node) for_node(node, move);
    for (const double x : mesh_.positions) {
      if (!(std::fabs(x) < 1e300)) mesh_.positions = at_rest_;
    }
  }

  void shift() {
    const double x = by(3.0 * size_);
    for (std::size_t node = 0; node < mesh_.node_count(); ++node)
      for_node(node, [&](double& place, std::size_t) { place += x; });
  }

  void expand_segments() {
    mesh_.segment_expansion.clear();
    if (random_.below(3) == 0) return;
    const double most = random_.below(4) == 0 ? 1e6 * size_ : 0.1 * size_;
    for (std::size_t segment = 0; segment < mesh_.segment_count(); ++segment) {
      const bool large = random_.below(20) == 0;
      mesh_.segment_expansion.push_back(large ? random_.uniform(0.0, most) : 0.0);
    }
  }

  void remove_or_add() {
    if (random_.below(2) == 0 && mesh_.segment_count() > 2) {
      mesh_.segments.resize(4 * (mesh_.segment_count() - 1 - mesh_.segment_count() / 4));
    } else {
      const Index node = mesh_.add_node(mesh_.positions[0] + by(size_), by(size_), by(size_));
      at_rest_ = mesh_.positions;
      const std::size_t nodes = mesh_.node_count();
      mesh_.add_segment(node, random_.below(nodes), random_.below(nodes), random_.below(nodes));
    }
    if (!mesh_.segment_expansion.empty()) mesh_.segment_expansion.resize(mesh_.segment_count(), 0.0);
  }

  void list_nodes() {
    mesh_.nodes.reset();
    if (random_.below(2) == 0) return;
    mesh_.nodes.emplace();
    const std::size_t sparse = 1 + static_cast<std::size_t>(random_.below(6));
    for (std::size_t node = 0; node < mesh_.node_count(); ++node) {
      if (random_.below(sparse) == 0) mesh_.nodes->push_back(static_cast<Index>(node));
    }
  }

  scenes::Random random_;
  scenes::Mesh mesh_;
  std::vector<double> at_rest_;
  double size_ = 1.0;
};

std::string history_of(const std::vector<std::string>& changes) {
  std::string history;
  for (const std::string& change : changes) history += change + "; ";
  return history;
}

/// One object per instruction set, with cells of any size for some of the seeds.
std::vector<Search> searches(std::uint64_t seed, double edge, const std::optional<CellDomain>& domain = {}) {
  std::vector<Search> result;
  for (const InstructionSet set : instruction_sets()) {
    Settings settings{.domain = domain, .instruction_set = set, .threads = seed % 8 == 0 ? 3 : 1};
    if (edge > 0.0) settings.cell_edge = edge;
    result.emplace_back(settings);
  }
  return result;
}

/// A domain over part of a mesh: nodes come and go through its faces while the mesh changes.
CellDomain domain_within(const scenes::Mesh& mesh) {
  CellDomain domain{.box = {{0, 0, 0}, {0, 0, 0}}, .cells = {3, 2, 4}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double first = mesh.positions[axis];
    const double last = mesh.positions[(mesh.node_count() - 1) * mesh.stride + axis];
    domain.box.lo[axis] = std::fmin(first, last) - 1e-3;
    domain.box.hi[axis] = std::fmax(first, last) + 1e-3;
  }
  return domain;
}

void expect_nothing_kept(std::uint64_t begin, std::uint64_t end) {
  for (std::uint64_t seed = begin; seed < end && !testing::Test::HasFailure(); ++seed) {
    ChangingMesh changing(seed);
    std::optional<CellDomain> domain;
    if (seed % 4 == 1) domain = domain_within(changing.mesh());
    std::vector<Search> reused = searches(seed, seed % 5 == 0 ? 0.05 : 0.0, domain);
    std::vector<std::string> changes{changing.mesh().name};
    for (int build = 0; build < 20; ++build) {
      const Candidates expected = by_brute_force(changing.mesh().scene(), {.domain = domain});
      for (Search& search : reused) {
        EXPECT_EQ(difference_from(expected, search, changing.mesh().scene()), "")
            << "sequence " << seed << ", " << name_of(*search.settings().instruction_set) << ", build "
            << build << ": " << history_of(changes);
      }
      changes.emplace_back(changing.change());
    }
  }
}

TEST(ProductionReuse, KeepsNothingThatShowsOverRandomChanges) {
  expect_nothing_kept(0, 300);
}

TEST(ProductionReuse, KeepsNothingThatShowsOverThousandsOfRandomChangesNightly) {
  expect_nothing_kept(300, 300 + 5000);
}

/// Builds again after each step, with every instruction set.
template <class Step>
void expect_exact_over(scenes::Mesh mesh, int builds, const Step& step) {
  std::vector<Search> reused = searches(1, 0.0);
  for (int build = 0; build < builds; ++build) {
    const Candidates expected = by_brute_force(mesh.scene());
    for (Search& search : reused) {
      EXPECT_EQ(difference_from(expected, search, mesh.scene()), "")
          << mesh.name << ", " << name_of(*search.settings().instruction_set) << ", build " << build;
    }
    step(mesh, build);
  }
}

class ProductionMotion : public testing::TestWithParam<scenes::Family> {};

// Longer than the cells are kept, with steps far below the cells.
TEST_P(ProductionMotion, IsFollowedOverManySmallSteps) {
  scenes::Random random(5);
  expect_exact_over(GetParam().make(2000, 3), 36, [&](scenes::Mesh& mesh, int) {
    for (double& x : mesh.positions) x += random.uniform(-0.05, 0.05);
  });
}

TEST_P(ProductionMotion, IsFollowedWhereAllIsCrushedAndSpringsBack) {
  const scenes::Mesh at_rest = GetParam().make(2000, 4);
  expect_exact_over(at_rest, 24, [&](scenes::Mesh& mesh, int build) {
    const double height = build < 12 ? 1.0 - build / 11.0 : (build - 11) / 8.0;
    for (std::size_t place = 0; place < mesh.positions.size(); ++place)
      mesh.positions[place] = at_rest.positions[place] * (place % 3 == 2 ? height : 1.0);
  });
}

TEST_P(ProductionMotion, IsFollowedWhereAllFallsIntoOnePointAndComesBack) {
  scenes::Mesh at_rest = GetParam().make(2000, 6);
  at_rest.segments.resize(4 * std::size_t{100});
  if (!at_rest.segment_expansion.empty()) at_rest.segment_expansion.resize(100);
  expect_exact_over(at_rest, 9, [&](scenes::Mesh& mesh, int build) {
    const std::array<double, 4> sizes{1e-3, 1e-12, 0.0, 1.0};
    for (std::size_t place = 0; place < mesh.positions.size(); ++place)
      mesh.positions[place] = at_rest.positions[place] * sizes[static_cast<std::size_t>(build) % 4];
  });
}

INSTANTIATE_TEST_SUITE_P(Families, ProductionMotion,
                         testing::ValuesIn(scenes::families().begin(), scenes::families().end()),
                         scenes::test_name);

}  // namespace
}  // namespace cellsearch::production_reuse_test
