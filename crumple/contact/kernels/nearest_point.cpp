// SPDX-License-Identifier: BSD-3-Clause
// The nearest point on the four sub-triangles of a segment, one per lane. The operations and their order are
// those of nearest_point(): the bits are the same.
#include "base/pack.hpp"
#include "contact/nearest_point_kernel.hpp"
#include "math/small_vectors.hpp"

namespace crumple::contact {
namespace {

using math::Double4;
using Mask4 = long long __attribute__((vector_size(32)));

/// The instruction set's value, spelled as the build names it.
[[maybe_unused]] constexpr Isa scalar = Isa::Scalar;
[[maybe_unused]] constexpr Isa baseline = Isa::Baseline;
[[maybe_unused]] constexpr Isa avx2 = Isa::Avx2;
[[maybe_unused]] constexpr Isa avx512 = Isa::Avx512;

/// One point per lane.
struct Points {
  Double4 x;
  Double4 y;
  Double4 z;
};

CRUMPLE_INLINE Double4 all(double a) {
  return Double4{a, a, a, a};
}
CRUMPLE_INLINE Points all(const Vec3& a) {
  return {all(a.x), all(a.y), all(a.z)};
}
CRUMPLE_INLINE Points operator-(const Points& a, const Points& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
CRUMPLE_INLINE Points operator+(const Points& a, const Points& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
CRUMPLE_INLINE Points operator*(const Double4& a, const Points& b) {
  return {a * b.x, a * b.y, a * b.z};
}
CRUMPLE_INLINE Double4 dot(const Points& a, const Points& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// The next lane's number.
CRUMPLE_INLINE Double4 next_of(const Double4& a) {
  return __builtin_shufflevector(a, a, 1, 2, 3, 0);
}

/// Weights of the corners of a triangle.
struct Weights {
  Double4 a;
  Double4 b;
  Double4 c;
};

CRUMPLE_INLINE Weights nearest_on_triangles(const Points& p, const Points& a, const Points& b,
                                            const Points& c) {
  const Double4 zero{};
  const Double4 one = all(1.0);
  const Points ab = b - a;
  const Points ac = c - a;
  const Double4 a_ab = dot(p - a, ab);
  const Double4 a_ac = dot(p - a, ac);
  const Double4 b_ab = dot(p - b, ab);
  const Double4 b_ac = dot(p - b, ac);
  const Double4 c_ab = dot(p - c, ab);
  const Double4 c_ac = dot(p - c, ac);
  const Double4 area_c = a_ab * b_ac - b_ab * a_ac;
  const Double4 area_b = c_ab * a_ac - a_ab * c_ac;
  const Double4 area_a = b_ab * c_ac - c_ab * b_ac;
  // The regions in the order in which nearest_point() asks for them; the first that fits has it.
  const Mask4 at_a = (a_ab <= zero) & (a_ac <= zero);
  const Mask4 at_b = (b_ab >= zero) & (b_ac <= b_ab);
  const Mask4 at_c = (c_ac >= zero) & (c_ab <= c_ac);
  const Mask4 on_ab = (area_c <= zero) & (a_ab >= zero) & (b_ab <= zero);
  const Mask4 on_ac = (area_b <= zero) & (a_ac >= zero) & (c_ac <= zero);
  const Mask4 on_bc = (area_a <= zero) & (b_ac - b_ab >= zero) & (c_ab - c_ac >= zero);
  const Double4 whole = area_a + area_b + area_c;
  Double4 part = on_bc ? b_ac - b_ab : area_b;
  Double4 of = on_bc ? (b_ac - b_ab) + (c_ab - c_ac) : whole;
  part = on_ac ? a_ac : part;
  of = on_ac ? a_ac - c_ac : of;
  part = on_ab ? a_ab : part;
  of = on_ab ? a_ab - b_ab : of;
  const Mask4 on_rim = on_ab | on_ac | on_bc;
  const Mask4 divides = ~on_rim | (of > zero);
  // No division by zero where the quotient is not asked for.
  const Double4 t = divides ? part / (divides ? of : one) : zero;
  const Double4 w = on_rim ? zero : area_c / (on_rim ? one : whole);
  Weights weights{one - t - w, t, w};
  weights.a = on_bc ? zero : weights.a;
  weights.b = on_bc ? one - t : weights.b;
  weights.c = on_bc ? t : weights.c;
  weights.a = on_ac ? one - t : weights.a;
  weights.b = on_ac ? zero : weights.b;
  weights.c = on_ac ? t : weights.c;
  weights.a = on_ab ? one - t : weights.a;
  weights.b = on_ab ? t : weights.b;
  weights.c = on_ab ? zero : weights.c;
  weights.a = at_c ? zero : weights.a;
  weights.b = at_c ? zero : weights.b;
  weights.c = at_c ? one : weights.c;
  weights.a = at_b ? zero : weights.a;
  weights.b = at_b ? one : weights.b;
  weights.c = at_b ? zero : weights.c;
  weights.a = at_a ? one : weights.a;
  weights.b = at_a ? zero : weights.b;
  weights.c = at_a ? zero : weights.c;
  return weights;
}

NearestPoint nearest(const SegmentShape& shape, const Vec3& p) {
  if (shape.triangle) return nearest_point(shape, p);
  const auto& corner = shape.corner;
  const Points first{Double4{corner[0].x, corner[1].x, corner[2].x, corner[3].x},
                     Double4{corner[0].y, corner[1].y, corner[2].y, corner[3].y},
                     Double4{corner[0].z, corner[1].z, corner[2].z, corner[3].z}};
  const Points second{next_of(first.x), next_of(first.y), next_of(first.z)};
  const Points centre = all(shape.centre);
  const Weights w = nearest_on_triangles(all(p), first, second, centre);
  const Points point = w.a * first + w.b * second + w.c * centre;
  const Points away = all(p) - point;
  const Double4 distance_squared = dot(away, away);
  int k = 0;
  for (int other = 1; other < 4; ++other)
    if (!(distance_squared[other] >= distance_squared[k])) k = other;
  return nearest_on(k, {w.a[k], w.b[k], w.c[k]}, {point.x[k], point.y[k], point.z[k]}, distance_squared[k]);
}

}  // namespace

template <>
NearestPointKernel nearest_point_kernel<CRUMPLE_ISA>() {
  return &nearest;
}

}  // namespace crumple::contact
