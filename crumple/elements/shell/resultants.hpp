// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What shells have in common whose strains are linear over the thickness: strains at the points from those of
// the middle surface and the bending, resultants from the stresses at the points.

#include "elements/shell/formulation.hpp"

namespace crumple::elements {

/// Strain increments that curvature adds at the upper surface: half the thickness times its increment.
template <class Pack>
struct Bending {
  Pack xx, yy, xy;
};

/// Leaves the strain increments of all points over one point in plane for the material.
template <class Pack>
CRUMPLE_INLINE void store_strains(const ShellPlace<RealOf<Pack>>& place,
                                  const materials::PlaneStrain<Pack>& membrane,
                                  const Bending<Pack>& bending) {
  const ShellConstants<RealOf<Pack>>& constants = place.task.constants;
  for (int p = 0; p < constants.points; ++p) {
    const Pack z(constants.place[p]);
    const materials::PlaneStrain<Pack> strain{
        multiply_add(z, bending.xx, membrane.xx), multiply_add(z, bending.yy, membrane.yy),
        multiply_add(z, bending.xy, membrane.xy), membrane.yz, membrane.zx};
    materials::store_five(place.strain + p * materials::components * tile_lanes, tile_lanes, strain);
  }
}

/// Resultants of the stresses: forces and moments per length, times the thickness factors.
template <class Pack>
struct Resultants {
  Pack xx, yy, xy, yz, zx;
  Pack bend_xx, bend_yy, bend_xy;
};

template <class Pack>
CRUMPLE_INLINE Resultants<Pack> integrate(const ShellPlace<RealOf<Pack>>& place, const Pack& thickness) {
  using Real = RealOf<Pack>;
  const ShellConstants<Real>& constants = place.task.constants;
  const Pack zero(Real(0));
  Resultants<Pack> r{zero, zero, zero, zero, zero, zero, zero, zero};
  for (int p = 0; p < constants.points; ++p) {
    const auto s = materials::load_five<materials::PlaneStress<Pack>>(
        place.state + p * materials::components * lanes, lanes);
    const Pack weight(constants.weight[p]);
    const Pack moment(constants.weight[p] * constants.place[p]);
    r.xx = multiply_add(weight, s.xx, r.xx);
    r.yy = multiply_add(weight, s.yy, r.yy);
    r.xy = multiply_add(weight, s.xy, r.xy);
    r.yz = multiply_add(weight, s.yz, r.yz);
    r.zx = multiply_add(weight, s.zx, r.zx);
    r.bend_xx = multiply_add(moment, s.xx, r.bend_xx);
    r.bend_yy = multiply_add(moment, s.yy, r.bend_yy);
    r.bend_xy = multiply_add(moment, s.xy, r.bend_xy);
  }
  const Pack shear = thickness * Pack(constants.shear_root);
  const Pack bend = thickness * (Real(0.5) * own_state<Pack>(place, element_state::thickness));
  return {thickness * r.xx, thickness * r.yy, thickness * r.xy, shear * r.yz,
          shear * r.zx,     bend * r.bend_xx, bend * r.bend_yy, bend * r.bend_xy};
}

}  // namespace crumple::elements
