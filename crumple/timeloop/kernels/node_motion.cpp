// SPDX-License-Identifier: BSD-3-Clause
// The motion of the nodes: one item (a position, a velocity) per vector.
#include <cmath>

#include "math/small_vectors.hpp"
#include "timeloop/node_kernels.hpp"

namespace crumple::timeloop {
namespace {

using domain::NodeFields;
using domain::NodeForce;
using domain::NodeRecord;
using math::Double4;

/// The instruction set's value, spelled as the build names it.
[[maybe_unused]] constexpr Isa scalar = Isa::Scalar;
[[maybe_unused]] constexpr Isa baseline = Isa::Baseline;
[[maybe_unused]] constexpr Isa avx2 = Isa::Avx2;
[[maybe_unused]] constexpr Isa avx512 = Isa::Avx512;

using Double2 = double __attribute__((vector_size(16)));
using Mask4 = long long __attribute__((vector_size(32)));

/// Which of three axes stay free, for each value of three bits of NodeFields::fixed.
alignas(32) constexpr long long free_axes[8][4] = {{-1, -1, -1, 0}, {0, -1, -1, 0}, {-1, 0, -1, 0},
                                                   {0, 0, -1, 0},   {-1, -1, 0, 0}, {0, -1, 0, 0},
                                                   {-1, 0, 0, 0},   {0, 0, 0, 0}};

CRUMPLE_INLINE Double4 held(const Double4& vector, unsigned fixed) {
  Mask4 bits;
  __builtin_memcpy(&bits, &vector, sizeof(bits));
  bits &= math::read<Mask4>(free_axes[fixed & 7U]);
  Double4 result;
  __builtin_memcpy(&result, &bits, sizeof(bits));
  return result;
}

// A Vec3 is three numbers without padding: a vector must not touch what lies behind the last one.
CRUMPLE_INLINE Double4 read3(const double* from) {
  return Double4{from[0], from[1], from[2], 0.0};
}
CRUMPLE_INLINE void write3(double* to, const Double4& from) {
  to[0] = from[0];
  to[1] = from[1];
  to[2] = from[2];
}

CRUMPLE_INLINE void write_motion(NodeRecord<float>& record, const Double4& velocity, const Double4& angular) {
  math::write(record.velocity, math::to_float(velocity));
  math::write(record.angular_velocity, math::to_float(angular));
}
CRUMPLE_INLINE void write_motion(NodeRecord<double>& record, const Double4& velocity,
                                 const Double4& angular) {
  math::write(record.velocity, velocity);
  math::write(record.angular_velocity, angular);
}

template <class Record>
CRUMPLE_INLINE void drift_all(NodeFields& nodes, Record* records, NodeRange range, double step) {
  double* const position = &nodes.position.data()->x;
  const double* const velocity = &nodes.velocity.data()->x;
  const double* const angular = &nodes.angular_velocity.data()->x;
  for (std::ptrdiff_t i = range.first; i < range.last; ++i) {
    const Double4 v = read3(velocity + 3 * i);
    const Double4 x = read3(position + 3 * i) + step * v;
    write3(position + 3 * i, x);
    math::write(records[i].position, x);
    write_motion(records[i], v, read3(angular + 3 * i));
  }
}

void drift(NodeFields& nodes, NodeRange range, double step) {
  if (!nodes.float_records.empty())
    drift_all(nodes, nodes.float_records.data(), range, step);
  else
    drift_all(nodes, nodes.double_records.data(), range, step);
}

CRUMPLE_INLINE double sum3(const Double4& v) {
  return (v[0] + v[1]) + v[2];
}
/// 1 / a and 1 / b, zero for zero. One division for both: it is the slowest operation here.
CRUMPLE_INLINE Double2 inverses(double a, double b) {
  const Double2 both{a, b};
  const Double2 one{1.0, 1.0};
  return both > Double2{} ? one / both : Double2{};
}

KickSums kick(NodeFields& nodes, NodeRange range, const Kick& kick) {
  double* const velocity = &nodes.velocity.data()->x;
  double* const angular = &nodes.angular_velocity.data()->x;
  double* const acceleration = kick.keep_acceleration ? &nodes.acceleration.data()->x : nullptr;
  double* const previous = kick.previous_velocity != nullptr ? &kick.previous_velocity->x : nullptr;
  NodeForce* const forces = nodes.force.data();
  const double* const mass = nodes.mass.data();
  const double* const inertia = nodes.inertia.data();
  const std::uint8_t* const fixed = nodes.fixed.data();
  Double4 translational{};
  Double4 rotational{};
  Double4 fastest{};  // squared, by axis
  for (std::ptrdiff_t i = range.first; i < range.last; ++i) {
    const Double4 force = math::read<Double4>(forces[i].force);
    const Double4 moment = math::read<Double4>(forces[i].moment);
    math::write(forces[i].force, Double4{});
    math::write(forces[i].moment, Double4{});
    // Nodes of solids alone: nothing turns them.
    const bool turns = inertia[i] > 0;
    // A node that a rigid body moves keeps its velocities here, and its energy is the body's.
    const bool free = (fixed[i] & domain::moved_by_body) == 0;
    const double m = free ? mass[i] : 0.0;
    const double own = free ? inertia[i] : 0.0;
    const Double2 per = inverses(m, own);
    const Double4 a = held(per[0] * force, fixed[i]);
    const Double4 old_v = read3(velocity + 3 * i);
    const Double4 new_v = old_v + kick.interval * a;
    translational += m * (old_v * new_v);
    const Double4 squared = new_v * new_v;
    fastest = squared > fastest ? squared : fastest;
    write3(velocity + 3 * i, new_v);
    if (turns) {
      const Double4 old_w = read3(angular + 3 * i);
      const Double4 new_w = held(old_w + kick.interval * (per[1] * moment), fixed[i] >> 3U);
      rotational += own * (old_w * new_w);
      write3(angular + 3 * i, new_w);
    }
    if (acceleration != nullptr) write3(acceleration + 3 * i, a);
    if (previous != nullptr) write3(previous + 3 * i, old_v);
  }
  return {0.5 * sum3(translational), 0.5 * sum3(rotational), std::sqrt(sum3(fastest))};
}

}  // namespace

template <>
NodeKernels node_kernels<CRUMPLE_ISA>() {
  return {&drift, &kick};
}

}  // namespace crumple::timeloop
