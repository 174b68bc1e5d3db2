// SPDX-License-Identifier: BSD-3-Clause
#include "math/quadrature.hpp"

#include <cassert>

namespace crumple::math {
namespace {

/// Legendre polynomial P_n and its derivative; |x| < 1.
struct Legendre {
  double value;
  double derivative;
};

Legendre legendre(int n, double x) {
  double before = 1;
  double now = x;
  if (n == 0) return {1, 0};
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
    before = now;
    now = next;
  }
  return {now, n * (before - x * now) / (1 - x * x)};
}

/// The root of f between a and b, where f changes sign once, by bisection down to neighbouring doubles.
template <class Function>
double root_between(double a, double b, const Function& f) {
  const bool rising = f(a) < 0;
  for (;;) {
    const double middle = 0.5 * (a + b);
    if (middle <= a || middle >= b) return middle;
    ((f(middle) < 0) == rising ? a : b) = middle;
  }
}

/// The n roots of f in (-1, 1), ascending and exactly symmetric. f is odd or even.
template <class Function>
std::vector<double> symmetric_roots(int n, const Function& f) {
  std::vector<double> root(n, 0.0);
  // Roots of Legendre polynomials up to degree 10 lie at least 0.01 apart.
  constexpr int pieces = 4096;
  int found = 0;
  for (int i = pieces - 1; i >= 0 && found < n / 2; --i) {
    const double a = (i + 0.25) / pieces;
    const double b = (i + 1.25) / pieces;
    if (b >= 1 || (f(a) < 0) == (f(b) < 0)) continue;
    root[n - 1 - found] = root_between(a, b, f);
    root[found] = -root[n - 1 - found];
    ++found;
  }
  assert(found == n / 2);
  return root;
}

}  // namespace

Quadrature gauss_rule(int n) {
  assert(n >= 1 && n <= 20);
  Quadrature rule;
  rule.point = symmetric_roots(n, [n](double x) { return legendre(n, x).value; });
  for (const double x : rule.point) {
    const double slope = legendre(n, x).derivative;
    rule.weight.push_back(1.0 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

Quadrature lobatto_rule(int n) {
  assert(n >= 2 && n <= 20);
  Quadrature rule;
  rule.point = symmetric_roots(n - 2, [n](double x) { return legendre(n - 1, x).derivative; });
  rule.point.insert(rule.point.begin(), -1.0);
  rule.point.push_back(1.0);
  for (int i = 0; i < n; ++i) {
    const bool end = i == 0 || i == n - 1;
    const double value = end ? 1.0 : legendre(n - 1, rule.point[i]).value;
    rule.weight.push_back(1.0 / (n * (n - 1) * value * value));
  }
  return rule;
}

Quadrature trapezoid_rule(int n) {
  assert(n >= 2);
  Quadrature rule;
  const double spaces = n - 1;
  for (int i = 0; i < n; ++i) {
    rule.point.push_back((2 * i - spaces) / spaces);
    rule.weight.push_back((i == 0 || i == n - 1 ? 0.5 : 1.0) / spaces);
  }
  return rule;
}

}  // namespace crumple::math
