// SPDX-License-Identifier: BSD-3-Clause
// Google Benchmark over all scenes and methods of this library: build and query together, one object kept.
// The counts per segment beside the time do not depend on the machine: flat counts are what O(N) means.
//
//   cellsearch_microbench --benchmark_filter=folded-sheets/production
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "cellsearch/search.hpp"
#include "scenes.hpp"

namespace {

using cellsearch::scenes::Family;
using cellsearch::scenes::Mesh;

void run(benchmark::State& state, const Family& family, cellsearch::Method method, int threads) {
  const Mesh mesh = family.make(static_cast<int>(state.range(0)), 42);
  cellsearch::Search search({.method = method, .threads = threads});
  try {
    search.find(mesh.scene());
  } catch (const cellsearch::Error& error) {
    state.SkipWithError(("unsuited: " + std::string(error.what())).c_str());
    return;
  }
  for (auto iteration : state) {
    benchmark::DoNotOptimize(search.find(mesh.scene()).node.data());
    benchmark::ClobberMemory();
  }
  const cellsearch::Statistics& statistics = search.statistics();
  const double segments = static_cast<double>(statistics.segments);
  const auto per_segment = [&](cellsearch::Offset count) {
    return benchmark::Counter(static_cast<double>(count) / segments);
  };
  state.counters["time/segment"] = benchmark::Counter(
      segments, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["pairs/segment"] = per_segment(statistics.candidates);
  state.counters["visits/segment"] = per_segment(statistics.raw_visits);
  state.counters["cells/segment"] = per_segment(statistics.cell_visits);
  state.counters["bytes/node"] = benchmark::Counter(static_cast<double>(statistics.bytes) /
                                                    static_cast<double>(statistics.participants));
}

void add(const Family& family, cellsearch::Method method, int threads) {
  const std::string name = std::string(family.name) + "/" + std::string(cellsearch::name_of(method)) +
                           "/threads:" + std::to_string(threads);
  const std::int64_t most_nodes = method == cellsearch::Method::BruteForce ? 10000 : 1000000;
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { run(state, family, method, threads); })
      ->RangeMultiplier(10)
      ->Range(1000, most_nodes)
      ->ArgName("nodes")
      ->UseRealTime();
}

}  // namespace

int main(int argc, char** argv) {
  for (const Family& family : cellsearch::scenes::families()) {
    for (const cellsearch::Method method : cellsearch::methods()) {
      for (const int threads : {1, 2}) add(family, method, threads);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
