// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/isa.hpp"
#include "elements/shell_task.hpp"

namespace crumple::elements {

template <class Real>
using ShellKernel = void (*)(const ShellTask<Real>& task, ShellSums& sums);

/// The kernel of the formulation at place `kind` of the list. Defined in kernels/shell_formulations.cpp,
/// which is compiled once per instruction set.
template <Isa Variant, class Real>
ShellKernel<Real> shell_formulation_kernel(int kind);

template <>
ShellKernel<float> shell_formulation_kernel<Isa::Scalar, float>(int kind);
template <>
ShellKernel<double> shell_formulation_kernel<Isa::Scalar, double>(int kind);
template <>
ShellKernel<float> shell_formulation_kernel<Isa::Baseline, float>(int kind);
template <>
ShellKernel<double> shell_formulation_kernel<Isa::Baseline, double>(int kind);
template <>
ShellKernel<float> shell_formulation_kernel<Isa::Avx2, float>(int kind);
template <>
ShellKernel<double> shell_formulation_kernel<Isa::Avx2, double>(int kind);
template <>
ShellKernel<float> shell_formulation_kernel<Isa::Avx512, float>(int kind);
template <>
ShellKernel<double> shell_formulation_kernel<Isa::Avx512, double>(int kind);

/// The kernel for an instruction set chosen at run time.
template <class Real>
ShellKernel<Real> shell_kernel(Isa isa, int kind);

}  // namespace crumple::elements
