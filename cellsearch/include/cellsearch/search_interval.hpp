// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cellsearch {

/// Eq. (10) of the paper: for how many time steps the candidates of one search stay complete,
/// n = (c - h) / (vmax dtmax), rounded down, at least 1 and at most `cap`.
///
/// `expansion`: c [length]; `contact_distance`: h, the distance at which a node starts to touch a segment
/// (thickness; the paper has h = 0) [length]; `largest_speed`: vmax, of nodes relative to the contact surface
/// [length/time]; `largest_step`: dtmax [time]; `cap`: >= 1.
///
/// Bodies at rest (vmax = 0) give `cap`. Where nothing is left to move (c <= h) or a number is negative or
/// NaN, the answer is 1: search at every step. It is a prediction: a caller that must not miss anything
/// also watches the motion itself and searches again before c - h is used up.
int search_interval(double expansion, double contact_distance, double largest_speed, double largest_step,
                    int cap);

}  // namespace cellsearch
