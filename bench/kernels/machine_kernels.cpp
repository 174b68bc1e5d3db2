// SPDX-License-Identifier: BSD-3-Clause
#include "machine_kernels.hpp"

#include "base/isa_variants.hpp"
#include "base/pack.hpp"

namespace crumple::bench {
namespace {

template <class Pack>
double sum_of_lanes(const Pack& pack) {
  alignas(64) RealOf<Pack> numbers[width_of<Pack>];
  store(numbers, pack);
  double sum = 0;
  for (const RealOf<Pack> number : numbers) sum += static_cast<double>(number);
  return sum;
}

template <class Real>
double peak(long rounds) {
  using Pack = NativePack<Real>;
  Pack chain[independent_chains];
  for (int c = 0; c < independent_chains; ++c) chain[c] = Pack(static_cast<Real>(c));
  const Pack factor(Real(0.999999));
  const Pack term(Real(1e-3));
  for (long round = 0; round < rounds; ++round)
    for (int c = 0; c < independent_chains; ++c) chain[c] = multiply_add(chain[c], factor, term);
  Pack all = chain[0];
  for (int c = 1; c < independent_chains; ++c) all = all + chain[c];
  return sum_of_lanes(all);
}

double read(const double* from, std::size_t count) {
  using Pack = NativePack<double>;
  constexpr std::size_t width = width_of<Pack>;
  const Pack zero = 0.0;
  Pack sum[4] = {zero, zero, zero, zero};
  for (std::size_t i = 0; i < count; i += 4 * width)
    for (std::size_t k = 0; k < 4; ++k) sum[k] = sum[k] + load<Pack>(from + i + k * width);
  const Pack all = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  return sum_of_lanes(all);
}

void update(double* at, std::size_t count, double factor) {
  using Pack = NativePack<double>;
  const Pack times(factor);
  for (std::size_t i = 0; i < count; i += width_of<Pack>) {
    const Pack product = times * load<Pack>(at + i);
    store(at + i, product);
  }
}

}  // namespace

template <>
MachineKernels machine_kernels<compiled_isa>() {
  return {&peak<float>, &peak<double>, width_of<NativePack<float>>, width_of<NativePack<double>>,
          &read,        &update};
}

}  // namespace crumple::bench
