// SPDX-License-Identifier: BSD-3-Clause
// All laws of the list, for the instruction set that this file is being compiled for.
#include "base/isa_variants.hpp"
#include "materials/common/tile_update.hpp"
#include "materials/kernel_list.hpp"
#include "materials/list.hpp"

namespace crumple::materials {
namespace {

template <class Law, class Real>
void update(const MaterialTask<Real>& task) {
  using Pack = NativePack<Real>;
  using Update = typename Law::template Update<Pack>;
  if constexpr (requires { Law::is_turned; })
    update_turned_tile<Update, Pack>(task);
  else if constexpr (requires { Law::updates_packs; })
    update_own_tile<Update, Pack>(task);
  else
    update_tile<Update, Pack>(task);
}

template <class Real, class... Laws>
MaterialUpdate<Real> pick(int kind, LawList<Laws...> /*list*/) {
  constexpr MaterialUpdate<Real> updates[] = {&update<Laws, Real>...};
  return updates[kind];
}

}  // namespace

template <>
MaterialUpdate<float> shell_law_kernel<compiled_isa, float>(int kind) {
  return pick<float>(kind, ShellLaws{});
}
template <>
MaterialUpdate<double> shell_law_kernel<compiled_isa, double>(int kind) {
  return pick<double>(kind, ShellLaws{});
}

}  // namespace crumple::materials
