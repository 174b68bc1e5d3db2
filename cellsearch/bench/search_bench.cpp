// SPDX-License-Identifier: BSD-3-Clause
// Time per segment of build and query, over the number of nodes, for each scene and method. The counts per
// segment beside it do not depend on the machine: flat counts are what O(N) means.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "cellsearch/search.hpp"
#include "scenes.hpp"

namespace {

using cellsearch::scenes::Mesh;
using MakeMesh = Mesh (*)(int nodes);

struct BenchScene {
  const char* name;
  MakeMesh make;
};

const BenchScene bench_scenes[] = {
    {"folded_sheets", [](int nodes) { return cellsearch::scenes::folded_sheets(nodes, 42); }},
    {"crushed_tube", [](int nodes) { return cellsearch::scenes::crushed_tube(nodes, 42); }},
    {"mixed_sizes_8", [](int nodes) { return cellsearch::scenes::mixed_sizes(nodes, 8.0, 42); }},
    {"sparse_patches", [](int nodes) { return cellsearch::scenes::sparse_patches(nodes / 18, 1e4, 42); }},
};

void run(benchmark::State& state, MakeMesh make, cellsearch::Method method, int threads) {
  const Mesh mesh = make(static_cast<int>(state.range(0)));
  cellsearch::Search search({.method = method, .threads = threads});
  for (auto iteration : state) {
    benchmark::DoNotOptimize(search.find(mesh.scene()).node.data());
    benchmark::ClobberMemory();
  }
  const cellsearch::Statistics& statistics = search.statistics();
  const double segments = static_cast<double>(statistics.segments);
  const auto per_segment = [&](double count) { return benchmark::Counter(count / segments); };
  state.counters["time/segment"] = benchmark::Counter(
      segments, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["pairs/segment"] = per_segment(static_cast<double>(statistics.candidates));
  state.counters["visits/segment"] = per_segment(static_cast<double>(statistics.raw_visits));
  state.counters["bytes/node"] = benchmark::Counter(static_cast<double>(statistics.bytes) /
                                                       static_cast<double>(statistics.participants));
}

void add(const BenchScene& scene, cellsearch::Method method, int threads, std::int64_t most_nodes) {
  const std::string name =
      std::string(scene.name) + "/" + std::string(name_of(method)) + "/threads:" + std::to_string(threads);
  const MakeMesh make = scene.make;
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { run(state, make, method, threads); })
      ->RangeMultiplier(10)
      ->Range(1000, most_nodes)
      ->ArgName("nodes")
      ->UseRealTime();
}

}  // namespace

int main(int argc, char** argv) {
  for (const BenchScene& scene : bench_scenes) {
    add(scene, cellsearch::Method::LinkedCell, 1, 1000000);
    add(scene, cellsearch::Method::LinkedCell, 2, 1000000);
    add(scene, cellsearch::Method::BruteForce, 1, 10000);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
