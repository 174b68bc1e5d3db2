// SPDX-License-Identifier: BSD-3-Clause
// Time per element-cycle of the whole time step without contact, for every formulation, material, precision
// and instruction set there is (the registries are asked), on one and two threads, in cache and out of it.
// A fifth of the elements yields in every cycle. Smallest of many short batches: other load on the machine
// makes them longer, never shorter.
//
//   bench_shell_cycle                                   everything (minutes)
//   bench_shell_cycle belytschko-tsay plastic mixed     lines whose name holds all of these words
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "app/measurement/shell_benchmark.hpp"

namespace {

using namespace crumple;

struct Size {
  const char* name;
  Index side;
};
constexpr Size sizes[] = {{"1k", 32}, {"10k", 100}, {"100k", 316}, {"1M", 1000}};

bool wanted(const std::string& name, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    if ((name + ' ').find(word) == std::string::npos) return false;
  return true;
}

void measure(const std::string& name, const app::ShellBenchmark& benchmark, double seconds) {
  try {
    const app::CycleTimes times = app::measure_shells(benchmark, seconds);
    fmt::print("{:<62} {:8.2f} {:8.2f} {:8.2f} {:8.2f}\n", name, times.wall, times.processor, times.elements,
               times.integrate);
  } catch (const std::exception& refused) {
    fmt::print("{:<62} {}\n", name, refused.what());
  }
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** values) {
  const std::vector<std::string> words(values + 1, values + count);
  const char* const seconds = std::getenv("CRUMPLE_BENCH_SECONDS");
  fmt::print("{:<62} {:>8} {:>8} {:>8} {:>8}\n", "ns per element-cycle", "wall", "cpu", "elements", "nodes");
  for (const auto& formulation : app::benchmark_formulations())
    for (const auto& law : app::benchmark_laws())
      for (const Precision precision : {Precision::Mixed, Precision::Double})
        for (const Isa isa : available_isas())
          for (const Size& size : sizes)
            for (const int threads : {1, 2}) {
              const std::string name = fmt::format("{} {} {} {} {} {}t", formulation.name, law.name,
                                                   precision == Precision::Mixed ? "mixed" : "double",
                                                   isa_name(isa), size.name, threads);
              if (!wanted(name, words)) continue;
              measure(name, {size.side, formulation.formulation, law.law, 3, {precision, isa, threads}},
                      seconds != nullptr ? std::atof(seconds) : 1.0);
            }
  return 0;
}
