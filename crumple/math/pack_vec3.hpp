// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/pack.hpp"

namespace crumple::math {

/// One three-vector per lane of a pack. Products are accumulated by multiply_add in a fixed order, so that
/// every instruction set with FMA gives the same bits.
template <class Pack>
struct PackVec3 {
  Pack x;
  Pack y;
  Pack z;
};

template <class Pack>
CRUMPLE_INLINE PackVec3<Pack> operator+(const PackVec3<Pack>& a, const PackVec3<Pack>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Pack>
CRUMPLE_INLINE PackVec3<Pack> operator-(const PackVec3<Pack>& a, const PackVec3<Pack>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Pack>
CRUMPLE_INLINE PackVec3<Pack> operator*(const Pack& s, const PackVec3<Pack>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class Pack>
CRUMPLE_INLINE PackVec3<Pack> operator-(const PackVec3<Pack>& a) {
  return {-a.x, -a.y, -a.z};
}

/// s a + b.
template <class Pack>
CRUMPLE_INLINE PackVec3<Pack> multiply_add(const Pack& s, const PackVec3<Pack>& a, const PackVec3<Pack>& b) {
  return {crumple::multiply_add(s, a.x, b.x), crumple::multiply_add(s, a.y, b.y),
          crumple::multiply_add(s, a.z, b.z)};
}

template <class Pack>
CRUMPLE_INLINE Pack dot(const PackVec3<Pack>& a, const PackVec3<Pack>& b) {
  return crumple::multiply_add(a.x, b.x, crumple::multiply_add(a.y, b.y, Pack(a.z * b.z)));
}

template <class Pack>
CRUMPLE_INLINE PackVec3<Pack> cross(const PackVec3<Pack>& a, const PackVec3<Pack>& b) {
  return {crumple::multiply_add(a.y, b.z, Pack(-(a.z * b.y))),
          crumple::multiply_add(a.z, b.x, Pack(-(a.x * b.z))),
          crumple::multiply_add(a.x, b.y, Pack(-(a.y * b.x)))};
}

}  // namespace crumple::math
