// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/bench_command.hpp"

#include <algorithm>
#include <array>
#include <cellsearch/search.hpp>
#include <cmath>
#include <ostream>
#include <variant>
#include <vector>

#include "app/console/print.hpp"
#include "app/measurement/shell_benchmark.hpp"
#include "app/measurement/solid_benchmark.hpp"
#include "base/stopwatch.hpp"

namespace crumple::app {

namespace {

constexpr Index small_side = 32;   ///< elements along an edge: in the cache
constexpr Index large_side = 316;  ///< 100 000 elements: out of it

/// One line: mixed and double, small and large.
void print_shells(std::ostream& out, const NamedFormulation& formulation, const NamedLaw& law, Isa isa,
                  int threads) {
  constexpr double seconds = 0.4;
  print(out, "  {:<30} {:>7}", formulation.name, threads);
  for (const Precision precision : {Precision::Mixed, Precision::Double})
    for (const Index side : {small_side, large_side}) {
      const ShellBenchmark benchmark{side, formulation.formulation, law.law, 3, {precision, isa, threads}};
      print(out, " {:>12.1f}", measure_shells(benchmark, seconds).wall);
      out.flush();
    }
  print(out, "\n");
}

/// One line: mixed and double, small and large.
void print_solids(std::ostream& out, const NamedSolid& solid, Isa isa, int threads) {
  constexpr Index small_block = 10;
  constexpr Index large_block = 46;
  constexpr double seconds = 0.4;
  print(out, "  {:<30} {:>7}", solid.name, threads);
  for (const Precision precision : {Precision::Mixed, Precision::Double})
    for (const Index side : {small_block, large_block}) {
      const Index hexahedra = model::is_tetrahedral(solid.formulation) ? side * 55 / 100 : side;
      print(out, " {:>12.1f}", measure_solids({hexahedra, solid, {precision, isa, threads}}, seconds).wall);
      out.flush();
    }
  print(out, "\n");
}

/// Two sheets of n x n segments, half an edge apart.
struct Sheets {
  std::vector<double> positions;
  std::vector<cellsearch::Index> connectivity;

  explicit Sheets(cellsearch::Index n) {
    for (cellsearch::Index sheet = 0; sheet < 2; ++sheet) {
      const auto first = static_cast<cellsearch::Index>(positions.size() / 3);
      for (cellsearch::Index j = 0; j <= n; ++j)
        for (cellsearch::Index i = 0; i <= n; ++i)
          positions.insert(positions.end(),
                           {i + 0.3 * sheet, j + 0.3 * sheet, 0.5 * sheet + std::sin(0.1 * i)});
      for (cellsearch::Index j = 0; j < n; ++j)
        for (cellsearch::Index i = 0; i < n; ++i) {
          const cellsearch::Index corner = first + j * (n + 1) + i;
          connectivity.insert(connectivity.end(), {corner, corner + 1, corner + n + 2, corner + n + 1});
        }
    }
  }
};

void print_search(std::ostream& out, cellsearch::Method method, cellsearch::Index side, int threads) {
  constexpr int repetitions = 5;
  const Sheets sheets(side);
  cellsearch::Scene scene;
  scene.positions = cellsearch::Positions(sheets.positions);
  scene.segments = cellsearch::Segments(sheets.connectivity);
  scene.expansion = 0.6;
  cellsearch::Settings settings;
  settings.method = method;
  settings.threads = threads;
  cellsearch::Search search(settings);
  double best = 1e30;
  for (int i = 0; i < repetitions; ++i) {
    const Stopwatch watch;
    search.find(scene);
    best = std::min(best, watch.seconds());
  }
  print(out, "  {:<30} {:>7} {:>12.1f}\n", cellsearch::name_of(method), threads,
        1e9 * best / (static_cast<double>(sheets.connectivity.size()) / 4));
}

}  // namespace

ExitCode bench_machine(const Options& options, const Console& console) {
  std::ostream& out = console.out;
  const int most_threads = options.threads.value_or(1);
  const Isa isa = options.isa ? parse_isa(*options.isa) : default_isa();
  const std::vector<NamedLaw> laws = benchmark_laws();
  const auto plastic = std::find_if(laws.begin(), laws.end(), [](const NamedLaw& law) {
    return std::holds_alternative<model::PlasticKinematic>(law.law);
  });
  print(out,
        "{}, {}\n\nTime step without contact, 3 points, one fifth yielding [ns per shell and cycle]\n"
        "  {:<30} {:>7} {:>12} {:>12} {:>12} {:>12}\n",
        program_version(), isa_name(isa), "formulation", "threads", "mixed 1k", "mixed 100k", "double 1k",
        "double 100k");
  std::vector<int> thread_counts{1};
  if (most_threads > 1) thread_counts.push_back(most_threads);
  for (const NamedFormulation& formulation : benchmark_formulations())
    for (const int threads : thread_counts) print_shells(out, formulation, *plastic, isa, threads);
  print(out, "\nThe same of solids [ns per element and cycle]\n");
  for (const NamedSolid& solid : benchmark_solids())
    for (const int threads : thread_counts) print_solids(out, solid, isa, threads);
  print(out, "\nContact search, two sheets of 100k segments [ns per segment]\n  {:<30} {:>7} {:>12}\n",
        "method", "threads", "time");
  for (const cellsearch::Method method : cellsearch::methods()) {
    if (method == cellsearch::Method::BruteForce) continue;  // minutes
    for (const int threads : thread_counts) print_search(out, method, large_side, threads);
  }
  return ExitCode::Normal;
}

}  // namespace crumple::app
