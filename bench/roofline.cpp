// SPDX-License-Identifier: BSD-3-Clause
// The roofline of the shell cycle on this machine, one thread: measured limits (multiply-adds in registers,
// memory read and updated in place), operations counted by running the kernels with a pack that counts, bytes
// from the layout of the data, and the time of a whole step out of cache and in it.
//
//   bench_roofline                 the fastest instruction set
//   CRUMPLE_ISA=avx2 bench_roofline
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "app/measurement/shell_benchmark.hpp"
#include "base/isa_variants.hpp"
#include "counting_pack.hpp"
#include "elements/kernel_list.hpp"
#include "elements/shell/chunk.hpp"
#include "elements/shell/list.hpp"
#include "machine_kernels.hpp"
#include "materials/list.hpp"
#include "timeloop/simulation.hpp"

namespace {

using namespace crumple;
using Counter = CountingPack<float>;

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Shortest of some runs [s].
template <class Work>
double shortest(int runs, const Work& work) {
  double best = 1e30;
  for (int run = 0; run < runs; ++run) {
    const double start = processor_seconds();
    work();
    best = std::min(best, processor_seconds() - start);
  }
  return best;
}

struct Limits {
  double float_rate = 0;   ///< 1e9 operations per second
  double double_rate = 0;  ///< the same
  double read = 0;         ///< 1e9 bytes per second
  double update = 0;       ///< the same, read and written bytes together
};

bench::MachineKernels kernels_of(Isa isa) {
  return visit_isa(isa, []<Isa Variant>() { return bench::machine_kernels<Variant>(); });
}

Limits measure_limits(Isa isa) {
  constexpr long rounds = 2000000;
  constexpr std::size_t numbers = std::size_t{1} << 25;  // 256 MiB
  constexpr int runs = 10;
  const bench::MachineKernels kernels = kernels_of(isa);
  const double operations = 2e-9 * bench::independent_chains * rounds;
  volatile double sink = 0;
  Limits limits;
  limits.float_rate =
      operations * kernels.float_width / shortest(runs, [&] { sink = kernels.float_peak(rounds); });
  limits.double_rate =
      operations * kernels.double_width / shortest(runs, [&] { sink = kernels.double_peak(rounds); });
  AlignedArray<double> memory(numbers, 1.0);
  const double bytes = 1e-9 * sizeof(double) * numbers;
  limits.read = bytes / shortest(runs, [&] { sink = kernels.read(memory.data(), numbers); });
  limits.update = 2 * bytes / shortest(runs, [&] { kernels.update(memory.data(), numbers, 1.0000001); });
  return limits;
}

/// The material of a block, counting.
template <class... Laws>
materials::MaterialUpdate<float> counting_update(int kind, materials::LawList<Laws...> /*list*/) {
  constexpr materials::MaterialUpdate<float> updates[] = {
      &materials::update_tile<typename Laws::template Update<Counter>, Counter>...};
  return updates[kind];
}
template <class... Formulations>
elements::ShellKernel<float> counting_kernel(int kind, elements::FormulationList<Formulations...> /*list*/) {
  constexpr elements::ShellKernel<float> kernels[] = {&elements::shell_chunk<Formulations, Counter>...};
  return kernels[kind];
}

/// The laws that the table shows. Others use powers, which work on the bits of a number.
using CountedLaws = materials::LawList<materials::ElasticLaw, materials::PlasticKinematicLaw>;

struct Work {
  double operations = 0;  ///< per element and cycle
  double bytes = 0;       ///< moved between memory and processor if nothing stays in the cache
};

/// Differences at gathering, sums at scattering and a node's motion, which are not made of packs.
constexpr double gather_operations = 51;
constexpr double scatter_operations = 24;
constexpr double node_operations = 45;

/// A node per element; what is written is read first.
double bytes_per_element(const domain::ShellBlock& block, Precision precision) {
  const bool mixed = precision == Precision::Mixed;
  const double number = mixed ? sizeof(float) : sizeof(double);
  const double record = mixed ? sizeof(domain::NodeRecord<float>) : sizeof(domain::NodeRecord<double>);
  const double vector = sizeof(domain::Vec3);
  const double state = 2 * block.components * number;
  const double indices = 8 * sizeof(Index);
  const double elements = record + 2 * sizeof(domain::NodeForce);
  const double drift = 2 * vector + 2 * vector + 2 * record;
  const double kick = 2 * sizeof(domain::NodeForce) + 4 * vector + 2 * sizeof(double) + 1;
  return state + indices + elements + drift + kick;
}

Work count(const app::ShellBenchmark& benchmark) {
  const model::Model model = app::shell_benchmark_model(benchmark);
  timeloop::Simulation simulation(model, {Precision::Mixed, benchmark.execution.isa, 1});
  simulation.start();
  for (int cycle = 0; cycle < app::cycles_to_yield; ++cycle) simulation.step();
  domain::Domain& domain = simulation.domain();
  domain::ShellBlock& block = domain.shells.front();
  elements::ShellTask<float> task;
  task.constants = elements::from_numbers<elements::ShellConstants<float>>(block.element_constants);
  task.nodes = domain.nodes.float_records.data();
  task.force = domain.nodes.force.data();
  task.node = block.node.data();
  task.target = block.target.data();
  task.state = block.float_state.data();
  task.components = block.components;
  task.groups = block.groups();
  task.energy = block.energy.data();
  task.step = static_cast<float>(domain.clock.step);
  task.material_constants = block.material_constants.data();
  task.material = counting_update(task.constants.material, CountedLaws{});
  elements::ElementSums sums;
  Counter::operations = 0;
  counting_kernel(task.constants.formulation, elements::ShellFormulations{})(task, sums);
  const double in_packs = static_cast<double>(Counter::operations) / block.elements;
  return {in_packs + gather_operations + scatter_operations + node_operations,
          bytes_per_element(block, benchmark.execution.precision)};
}

void print_row(const app::NamedFormulation& formulation, const app::NamedLaw& law, Precision precision,
               Isa isa, const Limits& limits) {
  app::ShellBenchmark benchmark{32, formulation.formulation, law.law, 3, {precision, isa, 1}};
  const Work work = count(benchmark);
  const double in_cache = app::measure_shells(benchmark, 1).processor;
  benchmark.side = 1000;
  const double out_of_cache = app::measure_shells(benchmark, 2).processor;
  const double peak = precision == Precision::Mixed ? limits.float_rate : limits.double_rate;
  const double compute_bound = work.operations / peak;
  const double memory_bound = work.bytes / limits.update;
  fmt::print("{:<28} {:<18} {:<6} {:6.0f} {:6.0f} {:8.1f} {:8.1f} {:8.1f} {:8.1f} {:6.0f}% {:6.0f}%\n",
             formulation.name, law.name, precision == Precision::Mixed ? "mixed" : "double", work.operations,
             work.bytes, compute_bound, memory_bound, in_cache, out_of_cache, 100 * compute_bound / in_cache,
             100 * std::max(compute_bound, memory_bound) / out_of_cache);
  std::fflush(stdout);
}

}  // namespace

int main() {
  const Isa isa = default_isa();
  const Limits limits = measure_limits(isa);
  fmt::print(
      "{}, one thread: {:.0f} Gflop/s float, {:.0f} Gflop/s double; memory {:.1f} GB/s read, {:.1f} GB/s "
      "updated in place\n\n",
      isa_name(isa), limits.float_rate, limits.double_rate, limits.read, limits.update);
  fmt::print("{:<28} {:<18} {:<6} {:>6} {:>6} {:>8} {:>8} {:>8} {:>8} {:>7} {:>7}\n", "per element and cycle",
             "material", "", "flops", "bytes", "ns/flop", "ns/byte", "ns 1k", "ns 1M", "of roof", "of roof");
  for (const app::NamedFormulation& formulation : app::benchmark_formulations())
    for (const app::NamedLaw& law : app::benchmark_laws())
      if (materials::shell_material_kind(law.law) < CountedLaws::count)
        for (const Precision precision : {Precision::Mixed, Precision::Double})
          print_row(formulation, law, precision, isa, limits);
  return 0;
}
