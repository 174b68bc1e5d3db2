// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/index.hpp"
#include "base/isa.hpp"
#include "domain/element_block.hpp"
#include "model/material.hpp"

namespace crumple::materials {

/// Stress and strain components of a point of a beam's cross section with the axis r: rr, rs, rt. The other
/// stresses are zero. Shear strains are engineering ones.
inline constexpr int section_components = 3;

/// Numbers of a cross section, strains and what is conjugate to them: stretch (normal force), curvature about
/// s and t (bending moments), twist per length (torsion), shear along s and t (shear forces).
namespace section_row {
inline constexpr int stretch = 0;
inline constexpr int curvature_s = 1;
inline constexpr int curvature_t = 2;
inline constexpr int twist = 3;
inline constexpr int shear_s = 4;
inline constexpr int shear_t = 5;
inline constexpr int count = 6;
}  // namespace section_row

/// Numbers of a point in SectionTask::place.
namespace section_place {
inline constexpr int s = 0;
inline constexpr int t = 1;
inline constexpr int area = 2;
inline constexpr int count = 3;
}  // namespace section_place

/// One call of a material: all points of the cross sections of one pack of beams.
struct SectionTask {
  double* state = nullptr;  ///< component 0 at the first lane of the pack; components are `lanes` apart
  Index stress = 0;         ///< first component of "stress" [points][3] in the state
  Index history = 0;        ///< first component of the material's own items
  int points = 0;
  const double* place = nullptr;      ///< of the points [point][section_place]
  const double* constants = nullptr;  ///< ElementBlock::material_constants
  double step = 0;                    ///< the step that the increments belong to [time]; may be 0
  const double* strain = nullptr;     ///< increments [section_row][pack]
  double* resultant = nullptr;        ///< out [section_row][pack]
  double* intact = nullptr;           ///< out [pack]: 1 where any point has not failed, else 0
};

using SectionUpdate = void (*)(const SectionTask& task);

/// Place of the law in the list (materials/laws/section_laws.hpp), or -1 if integrated beams cannot use it.
int section_material_kind(const model::ConstitutiveLaw& law);

/// Adds the law's own items to a block whose points are set; returns the first component.
Index declare_section_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block);

/// The numbers that the update reads. Throws Error naming the material if one is out of its range.
std::vector<double> section_material_constants(const model::Material& material);

/// The update of a kind for an instruction set: the same bits as materials/common/shell_material.hpp says.
SectionUpdate section_material_update(Isa isa, int kind);

/// Defined in kernels/section_laws.cpp, which is compiled once per instruction set.
template <Isa Variant>
SectionUpdate section_law_kernel(int kind);
template <>
SectionUpdate section_law_kernel<Isa::Scalar>(int kind);
template <>
SectionUpdate section_law_kernel<Isa::Baseline>(int kind);
template <>
SectionUpdate section_law_kernel<Isa::Avx2>(int kind);
template <>
SectionUpdate section_law_kernel<Isa::Avx512>(int kind);

}  // namespace crumple::materials
