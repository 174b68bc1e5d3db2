// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "production/kernels.hpp"

namespace cellsearch::production {

/// The loops of each instruction set, each in a file that is compiled for it.
const Kernels& portable_kernels();
const Kernels& avx2_kernels();
const Kernels& avx512_kernels();

}  // namespace cellsearch::production
