// SPDX-License-Identifier: BSD-3-Clause
#include "production/quick_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "parallel.hpp"
#include "production/kernels.hpp"

namespace cellsearch::production {
namespace {

// The same blocks for any number of threads.
constexpr int check_blocks = 64;

bool ascends(std::span<const Index> list, BlockRange range, Index count) {
  bool good = true;
  for (Index i = range.begin; i < range.end; ++i) {
    const Index node = list[static_cast<std::size_t>(i)];
    const Index before = i == 0 ? -1 : list[static_cast<std::size_t>(i) - 1];
    good = good && node > before && node < count;
  }
  return good;
}

bool check_block(const Scene& scene, const Kernels& kernel, int block) {
  const Index nodes = static_cast<Index>(scene.positions.count());
  bool good = true;
  if (scene.nodes) {
    const BlockRange listed(static_cast<Index>(scene.nodes->size()), block, check_blocks);
    good = ascends(*scene.nodes, listed, nodes);
  }
  const BlockRange segments(static_cast<Index>(scene.segments.count()), block, check_blocks);
  const std::size_t first = static_cast<std::size_t>(segments.begin);
  const std::size_t count = static_cast<std::size_t>(segments.end) - first;
  const std::uint32_t largest = kernel.largest(scene.segments.nodes().subspan(4 * first, 4 * count));
  good = good && (count == 0 || largest < static_cast<std::uint32_t>(nodes));
  if (!scene.segment_expansion.empty()) {
    for (const double expansion : scene.segment_expansion.subspan(first, count)) {
      good = good && expansion >= 0.0 && std::isfinite(scene.expansion + expansion);
    }
  }
  return good;
}

}  // namespace

bool quick_checks(const Scene& scene, InstructionSet set, int threads) {
  check_layout(scene);
  if (!scene.node_radius.empty() || scene.groups.count > 0) return false;
  const Kernels& kernel = kernels(set);
  std::array<bool, check_blocks> good{};
  for_blocks(threads, check_blocks,
             [&](int block) { good[static_cast<std::size_t>(block)] = check_block(scene, kernel, block); });
  return std::find(good.begin(), good.end(), false) == good.end();
}

}  // namespace cellsearch::production
