// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/shell/shell_task.hpp"
#include "math/pack_vec3.hpp"

namespace crumple::elements {

/// Geometry of a four-node shell in its lamina axes.
template <class Pack>
struct LaminaGeometry {
  Pack x31, y31, x42, y42;      ///< diagonals
  Pack x_mode, y_mode, z_mode;  ///< hourglass pattern of the positions: node 1 - 2 + 3 - 4
  Pack area;
  Pack inverse_twice_area;
};

/// Gradients of a nodal field at the centre, B1.f and B2.f, from its differences over the diagonals
/// (Belytschko, Lin & Tsay 1984).
template <class Pack>
struct CentreGradient {
  Pack x, y;
};
template <class Pack>
CRUMPLE_INLINE CentreGradient<Pack> gradient(const LaminaGeometry<Pack>& g, const Pack& f31,
                                             const Pack& f42) {
  return {g.inverse_twice_area * multiply_add(g.y42, f31, Pack(-(g.y31 * f42))),
          g.inverse_twice_area * multiply_add(g.x31, f42, Pack(-(g.x42 * f31)))};
}

/// Generalised hourglass rates or stresses: membrane x and y, warping z, bending x and y.
template <class Pack>
struct HourglassModes {
  Pack x, y, z, bending_x, bending_y;
};

template <class Pack>
CRUMPLE_INLINE HourglassModes<Pack> scaled(const HourglassModes<Pack>& modes, const Pack& factor) {
  return {factor * modes.x, factor * modes.y, factor * modes.z, factor * modes.bending_x,
          factor * modes.bending_y};
}

/// gamma.f, the hourglass part of a field: its pattern less what the centre gradients explain.
template <class Pack>
CRUMPLE_INLINE Pack hourglass_part(const LaminaGeometry<Pack>& g, const Pack& f_mode,
                                   const CentreGradient<Pack>& gradient) {
  return multiply_add(Pack(-g.x_mode), gradient.x, multiply_add(Pack(-g.y_mode), gradient.y, f_mode));
}

/// gamma at the four nodes (Flanagan & Belytschko 1981).
template <class Pack>
struct HourglassVector {
  Pack node[4];
};
template <class Pack>
CRUMPLE_INLINE HourglassVector<Pack> hourglass_vector(const LaminaGeometry<Pack>& g) {
  const Pack one(RealOf<Pack>(1));
  const Pack a = g.inverse_twice_area * multiply_add(g.y_mode, g.x42, Pack(-(g.x_mode * g.y42)));
  const Pack b = g.inverse_twice_area * multiply_add(g.x_mode, g.y31, Pack(-(g.y_mode * g.x31)));
  return {{one - a, -(one + b), one + a, b - one}};
}

/// Coefficients of this element: stress per rate (viscous) or per displacement (stiffness), forces in all.
template <class Pack>
struct HourglassModuli {
  Pack membrane, warping, bending;
};

/// Viscous form: 1/4 Q rho c t sqrt(A) in the membrane (Flanagan & Belytschko 1981, with the shell's t
/// sqrt(A) for the brick's V^(2/3)), the same integrated over the thickness for bending, and t for sqrt(A) in
/// warping where t is the smaller. Stiffness form: Belytschko, Lin & Tsay (1984), C1 to C3.
/// docs/theory/hourglass.md.
template <class Pack>
CRUMPLE_INLINE HourglassModuli<Pack> hourglass_moduli(const ShellConstants<RealOf<Pack>>& constants,
                                                      const LaminaGeometry<Pack>& g, const Pack& thickness) {
  const Pack t2 = thickness * thickness;
  const Pack membrane(constants.hourglass_membrane);
  const Pack warping(constants.hourglass_warping);
  const Pack bending(constants.hourglass_bending);
  if (constants.viscous) {
    const Pack length = square_root(g.area);
    const Pack t_length = thickness * length;
    // A shell thicker than long would be damped faster than its step allows.
    return {membrane * t_length, warping * (thickness * smaller(thickness, length)),
            bending * (t_length * t2)};
  }
  Pack squares = g.x31 * g.x31;
  squares = multiply_add(g.y31, g.y31, squares);
  squares = multiply_add(g.x42, g.x42, squares);
  squares = multiply_add(g.y42, g.y42, squares);
  // A B.B; the warping stiffness of a shell thicker than long is held at that of t = sqrt(A), so that it
  // cannot govern the step.
  const Pack t_shape = thickness * (squares * g.inverse_twice_area);
  const Pack slender = smaller(t2, g.area) * (g.inverse_twice_area + g.inverse_twice_area);
  return {membrane * t_shape, warping * (t_shape * slender), bending * (t_shape * t2)};
}

/// Stresses at time n from those at n-1 (both in lamina axes) and the rates between.
template <class Pack>
CRUMPLE_INLINE HourglassModes<Pack> hourglass_stress(const ShellConstants<RealOf<Pack>>& constants,
                                                     const HourglassModuli<Pack>& moduli, const Pack& step,
                                                     const HourglassModes<Pack>& old,
                                                     const HourglassModes<Pack>& rate) {
  if (constants.viscous)
    return {moduli.membrane * rate.x, moduli.membrane * rate.y, moduli.warping * rate.z,
            moduli.bending * rate.bending_x, moduli.bending * rate.bending_y};
  const Pack membrane = moduli.membrane * step;
  const Pack warping = moduli.warping * step;
  const Pack bending = moduli.bending * step;
  return {multiply_add(membrane, rate.x, old.x), multiply_add(membrane, rate.y, old.y),
          multiply_add(warping, rate.z, old.z), multiply_add(bending, rate.bending_x, old.bending_x),
          multiply_add(bending, rate.bending_y, old.bending_y)};
}

/// What the hourglass stresses of a square of the same area are when all of it yields: tension and pressure
/// of the yield stress in halves of it, the bending moment of that, and the torsion moment for the warping.
/// docs/theory/hourglass.md.
template <class Pack>
CRUMPLE_INLINE HourglassModuli<Pack> plastic_limits(const LaminaGeometry<Pack>& g, const Pack& thickness,
                                                    const Pack& yield_stress) {
  using Real = RealOf<Pack>;
  const Pack force = yield_stress * thickness;
  const Pack membrane = Real(0.25) * (force * square_root(g.area));
  return {membrane, Real(0.28867513459481287) * (force * thickness), Real(0.25) * (membrane * thickness)};
}

/// Hourglass stresses of the stiffness form where the metal flows: they return to the yield surface with the
/// stress that they vary about, of which `left` remains, and never exceed the limits.
template <class Pack>
CRUMPLE_INLINE HourglassModes<Pack> yielding(const HourglassModes<Pack>& trial, const Pack& left,
                                             const HourglassModuli<Pack>& limit) {
  const auto bounded = [](const Pack& q, const Pack& most) { return larger(smaller(q, most), Pack(-most)); };
  return {bounded(left * trial.x, limit.membrane), bounded(left * trial.y, limit.membrane),
          bounded(left * trial.z, limit.warping), bounded(left * trial.bending_x, limit.bending),
          bounded(left * trial.bending_y, limit.bending)};
}

/// Work of the mean of old and new stress over a step.
template <class Pack>
CRUMPLE_INLINE Pack hourglass_work(const Pack& step, const HourglassModes<Pack>& old,
                                   const HourglassModes<Pack>& now, const HourglassModes<Pack>& rate) {
  Pack twice = (old.x + now.x) * rate.x;
  twice = multiply_add(Pack(old.y + now.y), rate.y, twice);
  twice = multiply_add(Pack(old.z + now.z), rate.z, twice);
  twice = multiply_add(Pack(old.bending_x + now.bending_x), rate.bending_x, twice);
  twice = multiply_add(Pack(old.bending_y + now.bending_y), rate.bending_y, twice);
  return RealOf<Pack>(0.5) * (step * twice);
}

}  // namespace crumple::elements
