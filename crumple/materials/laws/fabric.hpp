// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "materials/common/history_view.hpp"
#include "materials/common/plane_stress.hpp"
#include "materials/common/shell_material.hpp"
#include "materials/laws/wrinkling.hpp"

namespace crumple::materials {

/// Fabric of membranes: stress from the strain that has accumulated in the axes of the yarns, so that what
/// wrinkles finds its shape again (docs/theory/fabric.md).
struct FabricLaw {
  using Model = model::Fabric;
  static constexpr const char* name = "fabric";
  static constexpr bool updates_packs = true;

  enum Place { Wrinkles, Share, LinerDirect, LinerCross, LinerShear, Damping, Sheet };
  static constexpr int count = Sheet + SheetNumbers::count;

  /// After the axes of the yarns.
  static constexpr int strain_item = 2;

  static void declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block, Index tensor);
  static std::vector<double> constants(const model::Material& material);
  static bool can_fail(const model::ConstitutiveLaw& /*law*/) { return false; }
  /// Cosine and sine of the angle from the lamina's first axis to the first yarns.
  static void prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                              domain::ElementBlock& block, Index history, Index place);

  template <class Pack>
  struct Update {
    using Real = RealOf<Pack>;
    const double* c;

    CRUMPLE_INLINE explicit Update(const MaterialTask<Real>& task) : c(task.constants) {}

    CRUMPLE_INLINE Pack number(int place) const { return Pack(static_cast<Real>(c[place])); }

    /// Strain of a point in the axes of the yarns after its increment, which is returned.
    CRUMPLE_INLINE static YarnTensor<Pack> follow(const HistoryView<Real>& history,
                                                  const YarnTensor<Pack>& increment) {
      Real* const at = history.at(strain_item + history.point);
      const Index next = static_cast<Index>(history.points) * lanes;
      const YarnTensor<Pack> now{load<Pack>(at) + increment.aa, load<Pack>(at + next) + increment.bb,
                                 load<Pack>(at + 2 * next) + increment.ab};
      store(at, now.aa);
      store(at + next, now.bb);
      store(at + 2 * next, now.ab);
      return now;
    }

    /// Stress of fabric and liner.
    CRUMPLE_INLINE YarnTensor<Pack> stress(const YarnTensor<Pack>& strain,
                                           const YarnTensor<Pack>& increment) const {
      const SheetNumbers sheet{c + Sheet};
      YarnTensor<Pack> fabric = elastic_stress(sheet, strain);
      if (c[Wrinkles] != 0) fabric = without_pressure(sheet, strain, fabric);
      if (c[Damping] != 0) {
        const YarnTensor<Pack> viscous = elastic_stress(sheet, increment);
        const Pack d = number(Damping);
        fabric = {multiply_add(d, viscous.aa, fabric.aa), multiply_add(d, viscous.bb, fabric.bb),
                  multiply_add(d, viscous.ab, fabric.ab)};
      }
      const Pack share = number(Share);
      const Pack direct = number(LinerDirect);
      const Pack cross = number(LinerCross);
      return {multiply_add(share, fabric.aa, multiply_add(direct, strain.aa, Pack(cross * strain.bb))),
              multiply_add(share, fabric.bb, multiply_add(direct, strain.bb, Pack(cross * strain.aa))),
              multiply_add(share, fabric.ab, Pack(number(LinerShear) * strain.ab))};
    }

    /// Brings the points of one pack up to date. Neither shears across nor thickness have a part in it.
    CRUMPLE_INLINE void update(const MaterialTask<Real>& task, Index group, Index lane) const {
      Real* const state = task.state + group * task.group_stride + lane;
      Real* const own = state + task.history * lanes;
      const YarnAxes<Pack> axes{load<Pack>(own), load<Pack>(own + lanes)};
      const Pack zero(Real(0));
      Pack energy = zero;
      for (int p = 0; p < task.points; ++p) {
        Real* const stress_state = state + (task.stress + components * (task.first_point + p)) * lanes;
        const Real* const strains = task.strain + p * components * tile_lanes + group * lanes + lane;
        const auto old = load_five<PlaneStress<Pack>>(stress_state, lanes);
        const auto strain = load_five<PlaneStrain<Pack>>(strains, tile_lanes);
        const YarnTensor<Pack> increment = axes.strain(strain.xx, strain.yy, strain.xy);
        const YarnTensor<Pack> all = follow({own, task.all_points, task.first_point + p}, increment);
        const PlaneStress<Pack> now = axes.lamina_stress(stress(all, increment));
        Pack share(task.weight[p]);
        if (task.area != nullptr)
          share = share * load<Pack>(task.area + p * tile_lanes + group * lanes + lane);
        energy = multiply_add(share, mean_work(old, now, strain), energy);
        store_five(stress_state, lanes, now);
      }
      store(task.energy + group * lanes + lane, energy);
      store(task.thickness_strain + group * lanes + lane, zero);
      if (task.yield == nullptr) return;
      Real* const yield = task.yield + group * lanes + lane;
      store(yield + yield_row::stress * tile_lanes, Pack(static_cast<Real>(unlimited)));
      store(yield + yield_row::left * tile_lanes, Pack(Real(1)));
    }
  };
};

}  // namespace crumple::materials
