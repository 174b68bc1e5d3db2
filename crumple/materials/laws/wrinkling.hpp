// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A linear orthotropic sheet that cannot bear pressure in any direction: it wrinkles or goes slack. Its
// energy is the relaxed one (A.C. Pipkin, IMA J. Appl. Math. 36 (1986) 85-99; M. Epstein & M.A. Forcinito,
// Int. J. Solids Struct. 38 (2001) 5253-5272), the largest of stress : strain - stress : S : stress / 2 over
// all stresses without pressure, S being the compliance. So the stress has a potential: no cycle gains
// energy. Of a wrinkled sheet it is a tension along one direction, which makes (n.strain.n)^2 / (n n : S : n
// n) largest. docs/theory/fabric.md.

#include "materials/common/plane_stress.hpp"

namespace crumple::materials {

/// A symmetric tensor in the axes of the yarns; ab of strains is the engineering shear.
template <class Pack>
struct YarnTensor {
  Pack aa, bb, ab;
};

/// The yarns' first axis in those of the lamina.
template <class Pack>
struct YarnAxes {
  Pack cosine, sine;

  CRUMPLE_INLINE YarnTensor<Pack> strain(const Pack& xx, const Pack& yy, const Pack& xy) const {
    const Pack cc = cosine * cosine;
    const Pack ss = sine * sine;
    const Pack sc = sine * cosine;
    const Pack across = sc * (yy - xx);
    return {multiply_add(cc, xx, multiply_add(ss, yy, Pack(sc * xy))),
            multiply_add(ss, xx, multiply_add(cc, yy, Pack(-(sc * xy)))),
            multiply_add(Pack(cc - ss), xy, Pack(across + across))};
  }
  CRUMPLE_INLINE PlaneStress<Pack> lamina_stress(const YarnTensor<Pack>& s) const {
    using Real = RealOf<Pack>;
    const Pack cc = cosine * cosine;
    const Pack ss = sine * sine;
    const Pack sc = sine * cosine;
    const Pack twice = (sc + sc) * s.ab;
    const Pack zero(Real(0));
    return {multiply_add(cc, s.aa, multiply_add(ss, s.bb, Pack(-twice))),
            multiply_add(ss, s.aa, multiply_add(cc, s.bb, twice)),
            multiply_add(Pack(cc - ss), s.ab, Pack(sc * (s.aa - s.bb))), zero, zero};
  }
};

/// Directions in which the search for the tension begins, 15 degrees apart over half a turn.
inline constexpr int wrinkle_directions = 12;
inline constexpr double wrinkle_cosine[wrinkle_directions] = {1,
                                                              0.96592582628906829,
                                                              0.86602540378443865,
                                                              0.70710678118654752,
                                                              0.5,
                                                              0.25881904510252076,
                                                              0,
                                                              -0.25881904510252076,
                                                              -0.5,
                                                              -0.70710678118654752,
                                                              -0.86602540378443865,
                                                              -0.96592582628906829};
inline constexpr double wrinkle_sine[wrinkle_directions] = {0,
                                                            0.25881904510252076,
                                                            0.5,
                                                            0.70710678118654752,
                                                            0.86602540378443865,
                                                            0.96592582628906829,
                                                            1,
                                                            0.96592582628906829,
                                                            0.86602540378443865,
                                                            0.70710678118654752,
                                                            0.5,
                                                            0.25881904510252076};

/// The constants of a sheet, as they lie in memory.
struct SheetNumbers {
  enum Place { Aa, Bb, Ab, Gab, ComplianceAa, ComplianceBb, ComplianceMixed, Roots };
  /// Roots: root of the modulus of a tension along each direction.
  static constexpr int count = Roots + wrinkle_directions;
  const double* c;

  template <class Pack>
  CRUMPLE_INLINE Pack at(int place) const {
    return Pack(static_cast<RealOf<Pack>>(c[place]));
  }
};

template <class Pack>
CRUMPLE_INLINE YarnTensor<Pack> elastic_stress(const SheetNumbers& sheet, const YarnTensor<Pack>& strain) {
  const Pack cross = sheet.at<Pack>(SheetNumbers::Ab);
  return {multiply_add(sheet.at<Pack>(SheetNumbers::Aa), strain.aa, Pack(cross * strain.bb)),
          multiply_add(sheet.at<Pack>(SheetNumbers::Bb), strain.bb, Pack(cross * strain.aa)),
          sheet.at<Pack>(SheetNumbers::Gab) * strain.ab};
}

/// Unit vector in the axes of the yarns.
template <class Pack>
struct YarnDirection {
  Pack cosine, sine;
};

/// n.strain.n.
template <class Pack>
CRUMPLE_INLINE Pack strain_along(const YarnTensor<Pack>& e, const Pack& c, const Pack& s) {
  return multiply_add(Pack(c * c), e.aa, multiply_add(Pack(s * s), e.bb, Pack((s * c) * e.ab)));
}

/// Larger principal strain and its direction.
template <class Pack>
struct LargestStrain {
  Pack value;
  YarnDirection<Pack> direction;
};
template <class Pack>
CRUMPLE_INLINE LargestStrain<Pack> largest_strain(const YarnTensor<Pack>& e) {
  using Real = RealOf<Pack>;
  const Pack half(Real(0.5));
  const Pack one(Real(1));
  const Pack zero(Real(0));
  const Pack difference = half * (e.aa - e.bb);
  const Pack shear = half * e.ab;
  // The larger of both as a factor, so that no square of a small strain is lost.
  const Pack size = larger(absolute(difference), absolute(shear));
  const Pack safe = select<Pack>(size > zero, size, one);
  const Pack x = difference / safe;
  const Pack y = shear / safe;
  const Pack root = square_root(multiply_add(x, x, Pack(y * y)));
  const Pack radius = size * root;
  const Pack cosine2 = select<Pack>(size > zero, Pack(x / select<Pack>(root > zero, root, one)), one);
  const Pack cosine = square_root(larger(zero, Pack(half * (one + cosine2))));
  const Pack sine = square_root(larger(zero, Pack(half * (one - cosine2))));
  return {multiply_add(half, Pack(e.aa + e.bb), radius),
          {cosine, select<Pack>(shear < zero, Pack(-sine), sine)}};
}

/// Compliance of a tension along a direction, n n : S : n n, and its first and second derivative by the
/// angle.
template <class Pack>
struct TensionCompliance {
  Pack value, first, second;
};
template <class Pack>
CRUMPLE_INLINE TensionCompliance<Pack> tension_compliance(const SheetNumbers& sheet,
                                                          const YarnDirection<Pack>& n) {
  const Pack aa = sheet.at<Pack>(SheetNumbers::ComplianceAa);
  const Pack bb = sheet.at<Pack>(SheetNumbers::ComplianceBb);
  const Pack mixed = sheet.at<Pack>(SheetNumbers::ComplianceMixed);
  const Pack cc = n.cosine * n.cosine;
  const Pack ss = n.sine * n.sine;
  const Pack sc = n.sine * n.cosine;
  const Pack inner = (mixed - (aa + aa)) * cc - (mixed - (bb + bb)) * ss;
  const Pack outer = (mixed - (aa + aa)) + (mixed - (bb + bb));
  const Pack twice = sc + sc;
  return {multiply_add(Pack(aa * cc), cc, multiply_add(Pack(bb * ss), ss, Pack((mixed * cc) * ss))),
          twice * inner, (cc + cc - ss - ss) * inner - (twice * twice) * outer};
}

/// A Newton step towards the largest n.strain.n / sqrt(n n : S : n n), no longer than half of what lies
/// between the directions at the beginning.
template <class Pack>
CRUMPLE_INLINE YarnDirection<Pack> improved(const SheetNumbers& sheet, const YarnTensor<Pack>& e,
                                            const YarnDirection<Pack>& n) {
  using Real = RealOf<Pack>;
  const Pack one(Real(1));
  const Pack zero(Real(0));
  const Pack half(Real(0.5));
  const Pack limit(Real(0.131));
  const Pack along = strain_along(e, n.cosine, n.sine);
  const Pack over = one / select<Pack>(along > zero, along, one);
  const Pack slip = multiply_add(Pack(n.cosine * n.cosine - n.sine * n.sine), e.ab,
                                 Pack(Real(2) * ((n.sine * n.cosine) * (e.bb - e.aa))));
  const Pack across = strain_along(e, Pack(-n.sine), n.cosine);
  const TensionCompliance<Pack> s = tension_compliance(sheet, n);
  const Pack per = one / s.value;
  const Pack by_strain = over * slip;
  const Pack by_compliance = per * s.first;
  const Pack slope = by_strain - half * by_compliance;
  const Pack curvature = (over * (Real(2) * (across - along)) - by_strain * by_strain) -
                         half * (per * s.second - by_compliance * by_compliance);
  const Pack newton = slope / select<Pack>(curvature < zero, Pack(-curvature), one);
  const Pack uphill = select<Pack>(slope < zero, Pack(-limit), limit);
  Pack step = larger(Pack(-limit), smaller(limit, select<Pack>(curvature < zero, newton, uphill)));
  step = select<Pack>(along > zero, step, zero);
  const Pack cosine = n.cosine - step * n.sine;
  const Pack sine = n.sine + step * n.cosine;
  const Pack scale = one / square_root(multiply_add(step, step, one));
  return {scale * cosine, scale * sine};
}

/// The stress of a sheet that bears no pressure; `trial` is that of one that does.
template <class Pack>
CRUMPLE_INLINE YarnTensor<Pack> without_pressure(const SheetNumbers& sheet, const YarnTensor<Pack>& e,
                                                 const YarnTensor<Pack>& trial) {
  using Real = RealOf<Pack>;
  const Pack zero(Real(0));
  // Neither principal stress below zero.
  const auto taut = (trial.aa >= zero) && (trial.bb >= zero) && (trial.aa * trial.bb >= trial.ab * trial.ab);
  if (!any<Pack>(!taut)) return trial;
  const LargestStrain<Pack> largest = largest_strain(e);
  YarnDirection<Pack> n = largest.direction;
  Pack best = largest.value / square_root(tension_compliance(sheet, n).value);
  for (int k = 0; k < wrinkle_directions; ++k) {
    const Pack c(static_cast<Real>(wrinkle_cosine[k]));
    const Pack s(static_cast<Real>(wrinkle_sine[k]));
    const Pack found = sheet.at<Pack>(SheetNumbers::Roots + k) * strain_along(e, c, s);
    const auto more = found > best;
    best = select<Pack>(more, found, best);
    n = {select<Pack>(more, c, n.cosine), select<Pack>(more, s, n.sine)};
  }
  constexpr int steps = 5;
  for (int i = 0; i < steps; ++i) n = improved(sheet, e, n);
  // Slack where no direction is longer than at rest.
  const Pack tension = larger(zero, strain_along(e, n.cosine, n.sine)) / tension_compliance(sheet, n).value;
  const Pack along = tension * n.cosine;
  const auto choose = [&](const Pack& whole, const Pack& left) { return select<Pack>(taut, whole, left); };
  return {choose(trial.aa, along * n.cosine), choose(trial.bb, (tension * n.sine) * n.sine),
          choose(trial.ab, along * n.sine)};
}

}  // namespace crumple::materials
