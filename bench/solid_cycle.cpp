// SPDX-License-Identifier: BSD-3-Clause
// The whole time step of a block of solids, without contact, as bench_shell_cycle measures shells.
//
//   bench_solid_cycle [word...]    only rows whose name contains every word
//   CRUMPLE_BENCH_SECONDS=4        per row, default 1
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/measurement/solid_benchmark.hpp"

namespace {

using namespace crumple;

struct Size {
  const char* name;
  Index side;
};
constexpr Size sizes[] = {{"1k", 10}, {"10k", 22}, {"100k", 46}, {"1M", 100}};

bool wanted(const std::string& name, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    if ((name + ' ').find(word) == std::string::npos) return false;
  return true;
}

}  // namespace

int main(int count, char** values) {
  const std::vector<std::string> words(values + 1, values + count);
  const char* const seconds = std::getenv("CRUMPLE_BENCH_SECONDS");
  fmt::print("{:<62} {:>8} {:>8} {:>8} {:>8}\n", "ns per element-cycle", "wall", "cpu", "elements", "nodes");
  for (const app::NamedSolid& solid : app::benchmark_solids())
    for (const Precision precision : {Precision::Mixed, Precision::Double})
      for (const Isa isa : available_isas())
        for (const Size& size : sizes)
          for (const int threads : {1, 2}) {
            const std::string name =
                fmt::format("{} {} {} {} {}t", solid.name, precision == Precision::Mixed ? "mixed" : "double",
                            isa_name(isa), size.name, threads);
            if (!wanted(name, words)) continue;
            const app::CycleTimes times = app::measure_solids({size.side, solid, {precision, isa, threads}},
                                                              seconds != nullptr ? std::atof(seconds) : 1.0);
            fmt::print("{:<62} {:8.2f} {:8.2f} {:8.2f} {:8.2f}\n", name, times.wall, times.processor,
                       times.elements, times.integrate);
            std::fflush(stdout);
          }
  return 0;
}
