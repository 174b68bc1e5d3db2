// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "base/isa.hpp"
#include "elements/common/element_sums.hpp"
#include "elements/shell/shell_task.hpp"
#include "elements/solid/solid_task.hpp"
#include "model/section.hpp"

namespace crumple::elements {

/// Works off one chunk.
template <class Task>
using Kernel = void (*)(const Task& task, ElementSums& sums);
template <class Real>
using ShellKernel = Kernel<ShellTask<Real>>;
template <class Real>
using SolidKernel = Kernel<SolidTask<Real>>;

template <class Formulation>
inline constexpr bool is_of_solids =
    std::is_same_v<decltype(Formulation::formulation), const model::SolidFormulation>;

/// The kernel of one formulation, of shells or of solids. Defined in kernels/<formulation>.cpp, which is
/// compiled once per instruction set (kernel_definition.hpp).
template <class Formulation, Isa Variant, class Real>
Kernel<std::conditional_t<is_of_solids<Formulation>, SolidTask<Real>, ShellTask<Real>>> formulation_kernel();

/// The kernel for an instruction set chosen at run time, of the formulation at place `kind` of its list.
template <class Real>
ShellKernel<Real> shell_kernel(Isa isa, int kind);
template <class Real>
SolidKernel<Real> solid_kernel(Isa isa, int kind);

}  // namespace crumple::elements
