// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/history_view.hpp"
#include "materials/common/plane_stress.hpp"

namespace crumple::materials {

/// Stresses in the plane along fibres, across, and their shear; or strains with the engineering shear.
template <class Pack>
struct PlyPlane {
  Pack a, b, ab;
};

/// Turns between the lamina's axes and those of a ply or sheet, whose first axis is at an angle from the
/// lamina's first, counted about the normal.
template <class Pack>
struct PlyAxes {
  Pack cosine, sine;

  /// The angle's cosine and sine are two components of the history, one behind the other.
  CRUMPLE_INLINE PlyAxes(const HistoryView<RealOf<Pack>>& history, int first)
      : cosine(load<Pack>(history.at(first))), sine(load<Pack>(history.at(first + 1))) {}
  CRUMPLE_INLINE PlyPlane<Pack> stress(const PlaneStress<Pack>& s) const {
    const Pack cc = cosine * cosine;
    const Pack ss = sine * sine;
    const Pack sc = sine * cosine;
    const Pack twice = (sc + sc) * s.xy;
    return {multiply_add(cc, s.xx, multiply_add(ss, s.yy, twice)),
            multiply_add(ss, s.xx, multiply_add(cc, s.yy, Pack(-twice))),
            multiply_add(sc, Pack(s.yy - s.xx), Pack((cc - ss) * s.xy))};
  }
  CRUMPLE_INLINE PlyPlane<Pack> strain(const PlaneStrain<Pack>& e) const {
    const Pack cc = cosine * cosine;
    const Pack ss = sine * sine;
    const Pack sc = sine * cosine;
    const Pack share = sc * e.xy;
    return {multiply_add(cc, e.xx, multiply_add(ss, e.yy, share)),
            multiply_add(ss, e.xx, multiply_add(cc, e.yy, Pack(-share))),
            multiply_add(Pack(sc + sc), Pack(e.yy - e.xx), Pack((cc - ss) * e.xy))};
  }
  /// Components xx, yy, xy in the lamina's axes of a stress in those of the ply.
  CRUMPLE_INLINE PlyPlane<Pack> lamina_stress(const PlyPlane<Pack>& s) const {
    const Pack cc = cosine * cosine;
    const Pack ss = sine * sine;
    const Pack sc = sine * cosine;
    const Pack twice = (sc + sc) * s.ab;
    return {multiply_add(cc, s.a, multiply_add(ss, s.b, Pack(-twice))),
            multiply_add(ss, s.a, multiply_add(cc, s.b, twice)),
            multiply_add(sc, Pack(s.a - s.b), Pack((cc - ss) * s.ab))};
  }
  /// Adds a change of the stress in the axes of the ply.
  CRUMPLE_INLINE void add(const PlyPlane<Pack>& change, PlaneStress<Pack>& s) const {
    const PlyPlane<Pack> turned = lamina_stress(change);
    s.xx = s.xx + turned.a;
    s.yy = s.yy + turned.b;
    s.xy = s.xy + turned.ab;
  }
};

}  // namespace crumple::materials
