// SPDX-License-Identifier: BSD-3-Clause
// Time per element-cycle of the shell kernels with gather, scatter and interface sum, one thread: formulation
// x material x precision x instruction set, in cache (1k elements) and out of it (100k). Three points through
// the thickness; of the plastic materials a fifth of the elements, side by side, yields in every cycle. The
// counter "element" is what to quote.
//
//   bench_shell_cycle --benchmark_filter=BelytschkoTsay/.*/mixed/avx512
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "domain/build.hpp"
#include "elements/shells.hpp"

namespace {

using namespace crumple;

struct NamedMaterial {
  const char* name;
  model::ConstitutiveLaw law;
};
const NamedMaterial materials[] = {
    {"elastic", model::Elastic{210000, 0.3}},
    {"plastic_kinematic", model::PlasticKinematic{210000, 0.3, 250, 2100, 0.5, 0, 0, 0}},
    {"plastic_isotropic", model::PlasticKinematic{210000, 0.3, 250, 2100, 1, 0, 0, 0}},
    {"piecewise_linear",
     model::PiecewiseLinearPlasticity{
         210000, 0.3, {0, 0.002, 0.01, 0.03, 0.1}, {250, 260, 280, 300, 320}, 0, 0, 0}},
};
struct NamedFormulation {
  const char* name;
  model::ShellFormulation formulation;
};
const NamedFormulation formulations[] = {{"BelytschkoTsay", model::ShellFormulation::BelytschkoTsay},
                                         {"HughesLiu", model::ShellFormulation::HughesLiu}};

model::Model sheet(Index n, const NamedFormulation& formulation, const NamedMaterial& material) {
  model::Model model;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) {
      model.nodes.id.push_back(model.nodes.count() + 1);
      model.nodes.position.push_back({5.0 * i, 5.0 * j, 2 * std::sin(0.25 * i) + std::cos(0.2 * j)});
    }
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index first = j * (n + 1) + i;
      model.shells.push_back({.id = static_cast<UserId>(model.shells.size()) + 1,
                              .part = 0,
                              .node = {first, first + 1, first + n + 2, first + n + 1}});
    }
  model::ShellSection section;
  section.formulation = formulation.formulation;
  section.thickness_points = 3;
  section.thickness = {1.5, 1.5, 1.5, 1.5};
  model.shell_sections.push_back(section);
  model.materials.push_back({.id = 1, .title = "", .density = 7.85e-9, .law = material.law});
  model.parts.push_back({.id = 1, .title = "", .section = 0, .material = 0});
  return model;
}

void shell_cycle(benchmark::State& state, Index n, const NamedFormulation& formulation,
                 const NamedMaterial& material, domain::Execution execution) {
  const model::Model model = sheet(n, formulation, material);
  domain::Domain domain = domain::build(model, execution);
  elements::prepare_shells(model, domain);
  const double step = 1e-7;
  for (Index i = 0; i < domain.nodes.count(); ++i) {
    const auto& x = domain.nodes.position[i];
    const double stretch = (x.y < n ? 3e-3 : 3e-5) / step;  // the lowest fifth: 2.5 times the yield strain
    domain.nodes.velocity[i] = {stretch * x.x, 0, 1e-3 * stretch * std::sin(x.x)};
    domain.nodes.angular_velocity[i] = {0, 1e-3 * stretch * x.x, 0};
  }
  domain.nodes.publish_all();
  double direction = 1;
  for ([[maybe_unused]] auto iteration : state) {
    // Back and forth: the state stays bounded and the same elements yield for ever.
    domain.clock.step = direction * step;
    direction = -direction;
    elements::add_shell_forces(domain);
  }
  benchmark::DoNotOptimize(domain.clock.element_limit);
  state.counters["element"] =
      benchmark::Counter(static_cast<double>(model.shells.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

bool register_all() {
  for (const auto& formulation : formulations)
    for (const auto& material : materials)
      for (const Precision precision : {Precision::Mixed, Precision::Double})
        for (const Isa isa : available_isas())
          for (const Index n : {32, 316}) {
            const std::string name = std::string(formulation.name) + '/' + material.name + '/' +
                                     (precision == Precision::Mixed ? "mixed/" : "double/") +
                                     std::string(isa_name(isa)) + (n == 32 ? "/1k" : "/100k");
            benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
              shell_cycle(state, n, formulation, material, {precision, isa, 1});
            })->MinTime(0.1);
          }
  return true;
}

[[maybe_unused]] const bool registered = register_all();

}  // namespace
