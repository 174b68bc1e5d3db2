// SPDX-License-Identifier: BSD-3-Clause
#include "production/kernel_tables.hpp"
#include "production/x86/kernels.hpp"

namespace cellsearch::production {

const Kernels& avx2_kernels() {
  static constexpr Kernels table = x86_kernels<InstructionSet::Avx2>;
  return table;
}

}  // namespace cellsearch::production
