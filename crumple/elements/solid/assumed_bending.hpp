// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid/solid_geometry.hpp"
#include "elements/solid/tangents.hpp"

// Strains that the trilinear map has in bending, and must not have: docs/theory/assumed_strain_hexahedron.md.
//
// q_k is the hourglass coefficient of the velocity, free of its linear part, of the product of the two
// coordinates other than x_k, q_4 that of all three; x = (xi, eta, zeta), t_i are the tangents at the centre,
// g_i the vectors dual to them. With i, j, k all different:
//
//     shear of bending between t_i and t_j     (x_i t_i + x_j t_j).(q_k + x_k q_4)      is taken away
//     what bending adds to the volume          T_j = x_j (|g_i|^2 t_i.q_k + |g_k|^2 t_k.q_i)
//                                              goes into the thickness: -T_j in the direction of g_j
//
// Both are taken times the Jacobian of the centre over that of the point: over the element their integral is
// zero then, and a uniform stress does no work on them (J.C. Simo and M.S. Rifai, IJNME 29 (1990) 1595-1638).
// The shear that remains between t_i and t_j is constant along both: that of twist.
namespace crumple::elements {

/// A symmetric 3x3 matrix: xx, yy, zz, xy, yz, zx.
template <class Pack>
struct SymmetricPack {
  Pack of[6];
};

/// sym(a b^T).
template <class Pack>
CRUMPLE_INLINE SymmetricPack<Pack> symmetric_product(const math::PackVec3<Pack>& a,
                                                     const math::PackVec3<Pack>& b) {
  const Pack half(RealOf<Pack>(0.5));
  const auto mean = [&](const Pack& one, const Pack& other) { return half * (one + other); };
  return {{a.x * b.x, a.y * b.y, a.z * b.z, mean(a.x * b.y, a.y * b.x), mean(a.y * b.z, a.z * b.y),
           mean(a.z * b.x, a.x * b.z)}};
}

/// What the strains of bending need of the geometry.
template <class Pack>
struct BendingFrame {
  ThreeVectors<Pack> tangent;    ///< at the centre
  SymmetricPack<Pack> shear[3];  ///< [k] strain of a unit shear between the two tangents other than t_k
  SymmetricPack<Pack> along[3];  ///< [k] unit strain in the direction of g_k
  Pack square[3];                ///< |g_k|^2
  Pack jacobian;                 ///< at the centre
};
template <class Pack>
CRUMPLE_INLINE BendingFrame<Pack> bending_frame(const SolidPatterns<Pack>& x) {
  const Pack eighth(RealOf<Pack>(0.125));
  BendingFrame<Pack> frame;
  for (int i = 0; i < 3; ++i) frame.tangent.of[i] = eighth * x.of[i];
  const ThreeVectors<Pack> area = areas_across(frame.tangent);
  frame.jacobian = math::dot(frame.tangent.of[0], area.of[0]);
  const Pack share = Pack(RealOf<Pack>(1)) / frame.jacobian;
  math::PackVec3<Pack> dual[3];
  for (int i = 0; i < 3; ++i) dual[i] = share * area.of[i];
  for (int k = 0; k < 3; ++k) {
    frame.shear[k] = symmetric_product(dual[(k + 1) % 3], dual[(k + 2) % 3]);
    frame.square[k] = math::dot(dual[k], dual[k]);
    const math::PackVec3<Pack> scaled = Pack(Pack(RealOf<Pack>(1)) / frame.square[k]) * dual[k];
    frame.along[k] = symmetric_product(scaled, dual[k]);
  }
  return frame;
}

/// What the length that gives the stable step is times, by the tangents at the centre and the areas across
/// them. Where t_i and g_i are not parallel, a shear that is taken away no longer cancels what direct strains
/// along the tangents have of the same mode, and the highest frequency grows with |t_i| |g_i|, which is one
/// over the cosine of the angle between them. The number holds lone parallelepipeds below 1
/// (docs/theory/assumed_strain_hexahedron.md).
template <class Pack>
CRUMPLE_INLINE Pack skew_factor(const ThreeVectors<Pack>& tangent) {
  const ThreeVectors<Pack> area = areas_across(tangent);
  const Pack jacobian = math::dot(tangent.of[0], area.of[0]);
  Pack largest(RealOf<Pack>(0));
  for (int i = 0; i < 3; ++i)
    largest =
        larger(largest, Pack(math::dot(tangent.of[i], tangent.of[i]) * math::dot(area.of[i], area.of[i])));
  return smaller(Pack(RealOf<Pack>(1)),
                 Pack(Pack(RealOf<Pack>(1.6)) * absolute(jacobian) / square_root(largest)));
}

/// One number for each tangent i and mode k, and for each tangent and the fourth mode: t_i.q_k of a velocity,
/// or the conjugate sums.
template <class Pack>
struct BendingModes {
  Pack of[3][3];  ///< [i][k], not used where they are equal
  Pack fourth[3];
};

template <class Pack>
CRUMPLE_INLINE BendingModes<Pack> no_bending() {
  const Pack zero(RealOf<Pack>(0));
  BendingModes<Pack> none;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) none.of[i][k] = zero;
    none.fourth[i] = zero;
  }
  return none;
}

/// Those of a velocity field whose mean gradient is `l`.
template <class Pack>
CRUMPLE_INLINE BendingModes<Pack> bending_modes(const BendingFrame<Pack>& frame, const SolidPatterns<Pack>& x,
                                                const SolidPatterns<Pack>& v, const PackMatrix<Pack>& l) {
  const Pack eighth(RealOf<Pack>(0.125));
  math::PackVec3<Pack> q[4];
  for (int m = 0; m < 4; ++m) {
    const int p = pattern::hourglass + m;
    q[m] = eighth * (v.of[p] - l * x.of[p]);
  }
  BendingModes<Pack> modes;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) modes.of[i][k] = math::dot(frame.tangent.of[i], q[k]);
    modes.fourth[i] = math::dot(frame.tangent.of[i], q[3]);
  }
  return modes;
}

/// Visits i, j, k, all different, for every pair of a mode k and a tangent i.
template <class Visit>
CRUMPLE_INLINE void for_each_bending(const Visit& visit) {
  for (int k = 0; k < 3; ++k) {
    visit((k + 1) % 3, (k + 2) % 3, k);
    visit((k + 2) % 3, (k + 1) % 3, k);
  }
}

/// Takes the strains of bending at the point `at` from the velocity gradient there.
template <class Pack>
CRUMPLE_INLINE void correct_bending(const BendingFrame<Pack>& frame, const BendingModes<Pack>& modes,
                                    const Pack& jacobian, const Pack (&at)[3], PackMatrix<Pack>& l) {
  const Pack zero(RealOf<Pack>(0));
  Pack shear[3] = {zero, zero, zero};
  Pack swelling[3] = {zero, zero, zero};
  for_each_bending([&](int i, int j, int k) {
    shear[k] = multiply_add(at[i], multiply_add(at[k], modes.fourth[i], modes.of[i][k]), shear[k]);
    swelling[j] = multiply_add(Pack(at[j] * frame.square[i]), modes.of[i][k], swelling[j]);
  });
  Pack less[6] = {zero, zero, zero, zero, zero, zero};
  const Pack share = frame.jacobian / jacobian;
  for (int k = 0; k < 3; ++k) {
    shear[k] = share * shear[k];
    swelling[k] = share * swelling[k];
  }
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 6; ++c)
      less[c] = multiply_add(shear[k], frame.shear[k].of[c],
                             multiply_add(swelling[k], frame.along[k].of[c], less[c]));
  l.x = l.x - math::PackVec3<Pack>{less[0], less[3], less[5]};
  l.y = l.y - math::PackVec3<Pack>{less[3], less[1], less[4]};
  l.z = l.z - math::PackVec3<Pack>{less[5], less[4], less[2]};
}

/// Product of a stress and a strain.
template <class Pack>
CRUMPLE_INLINE Pack work_of(const PackMatrix<Pack>& stress, const SymmetricPack<Pack>& strain) {
  const Pack(&e)[6] = strain.of;
  const Pack direct = multiply_add(stress.x.x, e[0], multiply_add(stress.y.y, e[1], Pack(stress.z.z * e[2])));
  const Pack across = multiply_add(stress.x.y, e[3], multiply_add(stress.y.z, e[4], Pack(stress.z.x * e[5])));
  return direct + (across + across);
}

/// The transpose: adds what a stress at the point does on the modes.
template <class Pack>
CRUMPLE_INLINE void add_bending(const BendingFrame<Pack>& frame, const PackMatrix<Pack>& stress,
                                const Pack (&at)[3], BendingModes<Pack>& work) {
  Pack shear[3];
  Pack swelling[3];
  for (int k = 0; k < 3; ++k) {
    shear[k] = frame.jacobian * work_of(stress, frame.shear[k]);
    swelling[k] = frame.jacobian * work_of(stress, frame.along[k]);
  }
  for_each_bending([&](int i, int j, int k) {
    const Pack share = shear[k] * at[i];
    work.of[i][k] = multiply_add(Pack(swelling[j] * at[j]), frame.square[i], Pack(work.of[i][k] + share));
    work.fourth[i] = multiply_add(share, at[k], work.fourth[i]);
  });
}

/// Takes the forces of `work` from those conjugate to the patterns, with what they do through the mean
/// gradient of `whole`.
template <class Pack>
CRUMPLE_INLINE void take_bending_forces(const BendingFrame<Pack>& frame, const BendingModes<Pack>& work,
                                        const SolidPatterns<Pack>& x, const SolidGeometry<Pack>& whole,
                                        SolidPatterns<Pack>& conjugate) {
  using Vec = math::PackVec3<Pack>;
  using math::multiply_add;
  const Pack eighth(RealOf<Pack>(0.125));
  const Vec(&t)[3] = frame.tangent.of;
  Vec force[4];
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    force[k] = eighth * multiply_add(work.of[i][k], t[i], work.of[j][k] * t[j]);
  }
  force[3] =
      eighth * multiply_add(work.fourth[0], t[0], multiply_add(work.fourth[1], t[1], work.fourth[2] * t[2]));
  for (int m = 0; m < 4; ++m) {
    Vec& own = conjugate.of[pattern::hourglass + m];
    own = own - force[m];
  }
  const Pack per_volume = Pack(RealOf<Pack>(1)) / whole.volume;
  for (int p = 0; p < 6; ++p) {
    const Vec g = per_volume * whole.gradient[p];
    for (int m = 0; m < 4; ++m)
      conjugate.of[p] = multiply_add(math::dot(x.of[pattern::hourglass + m], g), force[m], conjugate.of[p]);
  }
}

}  // namespace crumple::elements
