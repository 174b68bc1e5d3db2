// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "base/aligned_array.hpp"
#include "domain/node_fields.hpp"
#include "math/pack_vec3.hpp"
#include "math/small_vectors.hpp"

namespace crumple::elements {

/// What a four-node shell needs of its nodes. All of it is differences, taken in double for the positions, so
/// that float keeps its digits however far the element is from the origin. 31 is node 3 less node 1; "mode"
/// is the hourglass pattern, node 1 - 2 + 3 - 4; "sum" adds all four.
template <class Pack>
struct ShellNodes {
  using Vec = math::PackVec3<Pack>;
  Vec r31, r42, r_mode;         ///< positions at time n
  Vec v31, v42, v_mode;         ///< velocities at n - 1/2
  Vec w31, w42, w_mode, w_sum;  ///< angular velocities at n - 1/2
};

namespace gather_row {
inline constexpr int r31 = 0;
inline constexpr int r42 = 3;
inline constexpr int r_mode = 6;
inline constexpr int v31 = 9;
inline constexpr int v42 = 12;
inline constexpr int v_mode = 15;
inline constexpr int w31 = 18;
inline constexpr int w42 = 21;
inline constexpr int w_mode = 24;
inline constexpr int w_sum = 27;
inline constexpr int count = 30;
}  // namespace gather_row

/// The same as gather() has left it, each read when it is asked for: all together are more than a processor
/// has registers.
template <class Pack>
struct GatheredNodes {
  using Vec = math::PackVec3<Pack>;
  const RealOf<Pack>* rows;  ///< [gather_row::count][width]

  CRUMPLE_INLINE Vec r31() const { return vec(gather_row::r31); }
  CRUMPLE_INLINE Vec r42() const { return vec(gather_row::r42); }
  CRUMPLE_INLINE Vec r_mode() const { return vec(gather_row::r_mode); }
  CRUMPLE_INLINE Vec v31() const { return vec(gather_row::v31); }
  CRUMPLE_INLINE Vec v42() const { return vec(gather_row::v42); }
  CRUMPLE_INLINE Vec v_mode() const { return vec(gather_row::v_mode); }
  CRUMPLE_INLINE Vec w31() const { return vec(gather_row::w31); }
  CRUMPLE_INLINE Vec w42() const { return vec(gather_row::w42); }
  CRUMPLE_INLINE Vec w_mode() const { return vec(gather_row::w_mode); }
  CRUMPLE_INLINE Vec w_sum() const { return vec(gather_row::w_sum); }
  CRUMPLE_INLINE ShellNodes<Pack> all() const {
    return {r31(), r42(), r_mode(), v31(), v42(), v_mode(), w31(), w42(), w_mode(), w_sum()};
  }

  CRUMPLE_INLINE Vec vec(int row) const {
    const RealOf<Pack>* const first = rows + row * width_of<Pack>;
    return {load<Pack>(first), load<Pack>(first + width_of<Pack>), load<Pack>(first + 2 * width_of<Pack>)};
  }
};

/// The differences of one quantity over the element.
template <class Number>
struct NodeDifferences {
  Number d31, d42, mode, sum;
};
template <class Number>
CRUMPLE_INLINE NodeDifferences<Number> differences(const Number& n1, const Number& n2, const Number& n3,
                                                   const Number& n4) {
  const Number sum13 = n1 + n3;
  const Number sum24 = n2 + n4;
  return {n3 - n1, n4 - n2, sum13 - sum24, sum13 + sum24};
}
/// The same for positions: relative to node 1 first, to keep the digits. No sum.
template <class Number>
CRUMPLE_INLINE NodeDifferences<Number> position_differences(const Number& n1, const Number& n2,
                                                            const Number& n3, const Number& n4) {
  const Number d31 = n3 - n1;
  const Number d42 = n4 - n2;
  const Number d21 = n2 - n1;
  return {d31, d42, (d31 - d42) - (d21 + d21), d21};
}

/// One element, number by number.
template <class Real, int Width>
CRUMPLE_INLINE void gather_one(const domain::NodeRecord<Real>* nodes, const Index* node, int lane,
                               Real (*rows)[Width]) {
  const auto& n1 = nodes[node[lane]];
  const auto& n2 = nodes[node[lanes + lane]];
  const auto& n3 = nodes[node[2 * lanes + lane]];
  const auto& n4 = nodes[node[3 * lanes + lane]];
  for (int axis = 0; axis < 3; ++axis) {
    const auto r =
        position_differences(n1.position[axis], n2.position[axis], n3.position[axis], n4.position[axis]);
    const auto v = differences(n1.velocity[axis], n2.velocity[axis], n3.velocity[axis], n4.velocity[axis]);
    const auto w = differences(n1.angular_velocity[axis], n2.angular_velocity[axis],
                               n3.angular_velocity[axis], n4.angular_velocity[axis]);
    rows[gather_row::r31 + axis][lane] = static_cast<Real>(r.d31);
    rows[gather_row::r42 + axis][lane] = static_cast<Real>(r.d42);
    rows[gather_row::r_mode + axis][lane] = static_cast<Real>(r.mode);
    rows[gather_row::v31 + axis][lane] = v.d31;
    rows[gather_row::v42 + axis][lane] = v.d42;
    rows[gather_row::v_mode + axis][lane] = v.mode;
    rows[gather_row::w31 + axis][lane] = w.d31;
    rows[gather_row::w42 + axis][lane] = w.d42;
    rows[gather_row::w_mode + axis][lane] = w.mode;
    rows[gather_row::w_sum + axis][lane] = w.sum;
  }
}

/// Writes what four elements have of one vector quantity to three rows.
template <class Real, class Vector>
CRUMPLE_INLINE void write_rows(Real* row, std::size_t stride, const Vector& a, const Vector& b,
                               const Vector& c, const Vector& d) {
  const auto columns = math::transposed(a, b, c, d);
  math::write(row, columns.row[0]);
  math::write(row + stride, columns.row[1]);
  math::write(row + 2 * stride, columns.row[2]);
}

/// Four elements, record by record: each is read whole and turned in registers, several times faster than
/// number by number. The arithmetic is that of gather_one.
template <int Width>
CRUMPLE_INLINE void gather_four(const domain::NodeRecord<float>* nodes, const Index* node, int lane,
                                float (*rows)[Width]) {
  using math::Double4;
  using math::Float4;
  using math::Float8;
  NodeDifferences<Float4> r[4];
  NodeDifferences<Float8> vw[4];  // velocity and angular velocity lie side by side
  for (int i = 0; i < 4; ++i) {
    const domain::NodeRecord<float>* n[4];
    Double4 x[4];
    Float8 m[4];
    for (int k = 0; k < 4; ++k) {
      n[k] = &nodes[node[k * lanes + lane + i]];
      x[k] = math::read<Double4>(n[k]);
      m[k] = math::read<Float8>(reinterpret_cast<const char*>(n[k]) + sizeof(Double4));
    }
    const auto exact = position_differences(x[0], x[1], x[2], x[3]);
    r[i] = {__builtin_convertvector(exact.d31, Float4), __builtin_convertvector(exact.d42, Float4),
            __builtin_convertvector(exact.mode, Float4), Float4{}};
    vw[i] = differences(m[0], m[1], m[2], m[3]);
  }
  write_rows(&rows[gather_row::r31][lane], Width, r[0].d31, r[1].d31, r[2].d31, r[3].d31);
  write_rows(&rows[gather_row::r42][lane], Width, r[0].d42, r[1].d42, r[2].d42, r[3].d42);
  write_rows(&rows[gather_row::r_mode][lane], Width, r[0].mode, r[1].mode, r[2].mode, r[3].mode);
  const auto write_both = [&](int v_row, int w_row, const math::Four<Float8>& columns) {
    for (int axis = 0; axis < 3; ++axis) {
      const Float8 both = columns.row[axis];
      if (v_row >= 0) math::write(&rows[v_row + axis][lane], __builtin_shufflevector(both, both, 0, 1, 2, 3));
      math::write(&rows[w_row + axis][lane], __builtin_shufflevector(both, both, 4, 5, 6, 7));
    }
  };
  using namespace gather_row;
  write_both(v31, w31, math::transposed(vw[0].d31, vw[1].d31, vw[2].d31, vw[3].d31));
  write_both(v42, w42, math::transposed(vw[0].d42, vw[1].d42, vw[2].d42, vw[3].d42));
  write_both(v_mode, w_mode, math::transposed(vw[0].mode, vw[1].mode, vw[2].mode, vw[3].mode));
  write_both(-1, w_sum, math::transposed(vw[0].sum, vw[1].sum, vw[2].sum, vw[3].sum));
}

template <int Width>
CRUMPLE_INLINE void gather_four(const domain::NodeRecord<double>* nodes, const Index* node, int lane,
                                double (*rows)[Width]) {
  using math::Double4;
  // Positions, velocities and angular velocities are the three thirds of a record.
  for (int part = 0; part < 3; ++part) {
    NodeDifferences<Double4> d[4];
    for (int i = 0; i < 4; ++i) {
      Double4 n[4];
      for (int k = 0; k < 4; ++k)
        n[k] = math::read<Double4>(reinterpret_cast<const char*>(&nodes[node[k * lanes + lane + i]]) +
                                   part * sizeof(Double4));
      d[i] = part == 0 ? position_differences(n[0], n[1], n[2], n[3]) : differences(n[0], n[1], n[2], n[3]);
    }
    double* const first = &rows[9 * part][lane];
    write_rows(first, Width, d[0].d31, d[1].d31, d[2].d31, d[3].d31);
    write_rows(first + 3 * Width, Width, d[0].d42, d[1].d42, d[2].d42, d[3].d42);
    write_rows(first + 6 * Width, Width, d[0].mode, d[1].mode, d[2].mode, d[3].mode);
    if (part == 2) write_rows(&rows[gather_row::w_sum][lane], Width, d[0].sum, d[1].sum, d[2].sum, d[3].sum);
  }
}

/// Reads the nodes of width_of<Pack> elements into `rows`, [gather_row::count][width]; `node` is [4][lanes]
/// from the first of them.
template <class Pack>
CRUMPLE_INLINE void gather(const domain::NodeRecord<RealOf<Pack>>* nodes, const Index* node,
                           RealOf<Pack>* rows) {
  using Real = RealOf<Pack>;
  constexpr int width = width_of<Pack>;
  const auto row = reinterpret_cast<Real(*)[width]>(rows);
  if constexpr (width >= 4)
    for (int lane = 0; lane < width; lane += 4) gather_four<width>(nodes, node, lane, row);
  else
    for (int lane = 0; lane < width; ++lane) gather_one<Real, width>(nodes, node, lane, row);
}

}  // namespace crumple::elements
