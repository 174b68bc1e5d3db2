// SPDX-License-Identifier: BSD-3-Clause
// All laws of integrated beams, for the instruction set that this file is being compiled for.
#include "materials/laws/section_laws.hpp"
#include "base/isa_variants.hpp"
#include "materials/section_update.hpp"

namespace crumple::materials {
namespace {

template <class Law>
void update_section_pack(const SectionTask& task) {
  using Pack = NativePack<double>;
  update_sections<typename Law::template FibreUpdate<Pack>, Pack>(task);
}

template <class... Laws>
SectionUpdate pick_section_law(int kind, SectionLawList<Laws...> /*list*/) {
  constexpr SectionUpdate updates[] = {&update_section_pack<Laws>...};
  return updates[kind];
}

}  // namespace

template <>
SectionUpdate section_law_kernel<compiled_isa>(int kind) {
  return pick_section_law(kind, SectionLaws{});
}

}  // namespace crumple::materials
