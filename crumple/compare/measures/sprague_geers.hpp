// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace crumple::compare {

/// Errors of a curve c(t) against a reference m(t) after M. A. Sprague and T. L. Geers, A spectral-element
/// method for modelling cavitation in transient fluid-structure interaction, Int. J. Numer. Meth. Engng 60
/// (2004) 2467-2499: with the integrals I_mm, I_cc, I_mc of m m, c c and m c over the time,
///   M = sqrt(I_cc / I_mm) - 1,  P = acos(I_mc / sqrt(I_mm I_cc)) / pi,  C = sqrt(M M + P P).
/// Zero is perfect. M is positive where the curve is larger; P lies between 0 and 1.
struct SpragueGeers {
  double magnitude = 0;  ///< M [-]; infinite if the reference is zero and the curve is not
  double phase = 0;      ///< P [-]; zero if one of the curves is zero, which has no phase
  double combined = 0;   ///< C [-]
};

/// Of evenly spaced samples, as many of each; integrals by the trapezoidal rule.
SpragueGeers sprague_geers(std::span<const double> reference, std::span<const double> curve);

}  // namespace crumple::compare
