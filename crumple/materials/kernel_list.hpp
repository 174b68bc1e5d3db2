// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/isa.hpp"
#include "materials/common/shell_material.hpp"
#include "materials/common/solid_material.hpp"

namespace crumple::materials {

/// The update of the law at place `kind` of the list. Defined in kernels/shell_laws.cpp, which is compiled
/// once per instruction set.
template <Isa Variant, class Real>
MaterialUpdate<Real> shell_law_kernel(int kind);

template <>
MaterialUpdate<float> shell_law_kernel<Isa::Scalar, float>(int kind);
template <>
MaterialUpdate<double> shell_law_kernel<Isa::Scalar, double>(int kind);
template <>
MaterialUpdate<float> shell_law_kernel<Isa::Baseline, float>(int kind);
template <>
MaterialUpdate<double> shell_law_kernel<Isa::Baseline, double>(int kind);
template <>
MaterialUpdate<float> shell_law_kernel<Isa::Avx2, float>(int kind);
template <>
MaterialUpdate<double> shell_law_kernel<Isa::Avx2, double>(int kind);
template <>
MaterialUpdate<float> shell_law_kernel<Isa::Avx512, float>(int kind);
template <>
MaterialUpdate<double> shell_law_kernel<Isa::Avx512, double>(int kind);

/// The same for solids, in kernels/solid_laws.cpp.
template <Isa Variant, class Real>
SolidMaterialUpdate<Real> solid_law_kernel(int kind);

template <>
SolidMaterialUpdate<float> solid_law_kernel<Isa::Scalar, float>(int kind);
template <>
SolidMaterialUpdate<double> solid_law_kernel<Isa::Scalar, double>(int kind);
template <>
SolidMaterialUpdate<float> solid_law_kernel<Isa::Baseline, float>(int kind);
template <>
SolidMaterialUpdate<double> solid_law_kernel<Isa::Baseline, double>(int kind);
template <>
SolidMaterialUpdate<float> solid_law_kernel<Isa::Avx2, float>(int kind);
template <>
SolidMaterialUpdate<double> solid_law_kernel<Isa::Avx2, double>(int kind);
template <>
SolidMaterialUpdate<float> solid_law_kernel<Isa::Avx512, float>(int kind);
template <>
SolidMaterialUpdate<double> solid_law_kernel<Isa::Avx512, double>(int kind);

}  // namespace crumple::materials
