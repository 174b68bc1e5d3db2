// SPDX-License-Identifier: BSD-3-Clause
// The motion of the nodes: one item (a position, a velocity) per vector.
#include <cmath>

#include "base/isa_variants.hpp"
#include "base/prefetch.hpp"
#include "math/small_vectors.hpp"
#include "timeloop/node_kernels.hpp"

namespace crumple::timeloop {
namespace {

using domain::NodeFields;
using domain::NodeForce;
using domain::NodeRecord;
using math::Double4;

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

CRUMPLE_INLINE double sum3(const Double4& v) {
  return (v[0] + v[1]) + v[2];
}
/// 1 / a and 1 / b, zero for zero. One division for both: it is the slowest operation here.
CRUMPLE_INLINE Double2 inverses(double a, double b) {
  const Double2 both{a, b};
  const Double2 one{1.0, 1.0};
  return both > Double2{} ? one / both : Double2{};
}

/// Three numbers of each of four nodes as they lie in memory: x y z x, y z x y, z x y z.
struct FourNodes {
  Double4 first, second, third;
};

CRUMPLE_INLINE FourNodes read_four(const double* from) {
  return {math::read<Double4>(from), math::read<Double4>(from + 4), math::read<Double4>(from + 8)};
}
CRUMPLE_INLINE void write_four(double* to, const FourNodes& from) {
  math::write(to, from.first);
  math::write(to + 4, from.second);
  math::write(to + 8, from.third);
}
/// From one item per node, whose fourth place is padding.
CRUMPLE_INLINE FourNodes side_by_side(const Double4& n0, const Double4& n1, const Double4& n2,
                                      const Double4& n3) {
  return {__builtin_shufflevector(n0, n1, 0, 1, 2, 4), __builtin_shufflevector(n1, n2, 1, 2, 4, 5),
          __builtin_shufflevector(n2, n3, 2, 4, 5, 6)};
}
/// From one number per node, the same for all axes.
CRUMPLE_INLINE FourNodes for_each_axis(const Double4& n) {
  return {__builtin_shufflevector(n, n, 0, 0, 0, 1), __builtin_shufflevector(n, n, 1, 1, 2, 2),
          __builtin_shufflevector(n, n, 2, 3, 3, 3)};
}
CRUMPLE_INLINE FourNodes operator+(const FourNodes& a, const FourNodes& b) {
  return {a.first + b.first, a.second + b.second, a.third + b.third};
}
CRUMPLE_INLINE FourNodes operator*(const FourNodes& a, const FourNodes& b) {
  return {a.first * b.first, a.second * b.second, a.third * b.third};
}
CRUMPLE_INLINE FourNodes operator*(double a, const FourNodes& b) {
  return {a * b.first, a * b.second, a * b.third};
}
CRUMPLE_INLINE Double4 larger(const Double4& a, const Double4& b) {
  return a > b ? a : b;
}
CRUMPLE_INLINE Double4 smaller(const Double4& a, const Double4& b) {
  return a < b ? a : b;
}
CRUMPLE_INLINE FourNodes smaller(const FourNodes& a, const FourNodes& b) {
  return {smaller(a.first, b.first), smaller(a.second, b.second), smaller(a.third, b.third)};
}
CRUMPLE_INLINE FourNodes larger(const FourNodes& a, const FourNodes& b) {
  return {larger(a.first, b.first), larger(a.second, b.second), larger(a.third, b.third)};
}
CRUMPLE_INLINE double sum_of(const FourNodes& n) {
  const Double4 sum = (n.first + n.second) + n.third;
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}
/// The largest of each axis.
CRUMPLE_INLINE Double4 largest_by_axis(const FourNodes& n) {
  const Double4 x_y_z = larger(n.first, larger(Double4{n.second[2], n.second[0], n.second[1], 0},
                                               Double4{n.third[1], n.third[2], n.third[0], 0}));
  return larger(x_y_z, Double4{n.first[3], n.second[3], n.third[3], 0});
}

/// Range of velocities.
class Ranger {
 public:
  CRUMPLE_INLINE void include(const FourNodes& v) {
    low_ = smaller(v, low_);
    high_ = larger(v, high_);
    zero_ += 0.0 * ((v.first + v.second) + v.third);
  }
  CRUMPLE_INLINE void include(const Double4& v) { include(side_by_side(v, v, v, v)); }
  CRUMPLE_INLINE VelocityRange range() const {
    const Double4 low = -largest_by_axis(-1 * low_);
    const Double4 high = largest_by_axis(high_);
    return {{low[0], low[1], low[2]},
            {high[0], high[1], high[2]},
            (zero_[0] + zero_[1]) + (zero_[2] + zero_[3]) == 0};
  }

 private:
  CRUMPLE_INLINE static FourNodes all(double value) {
    const Double4 v{value, value, value, value};
    return {v, v, v};
  }

  FourNodes low_ = all(VelocityRange::largest);
  FourNodes high_ = all(-VelocityRange::largest);
  Double4 zero_{};  // unless a velocity is not finite
};

template <class Record>
CRUMPLE_INLINE VelocityRange drift_all(NodeFields& nodes, Record* records, NodeRange range, double step) {
  double* const position = &nodes.position.data()->x;
  const double* const velocity = &nodes.velocity.data()->x;
  const double* const angular = &nodes.angular_velocity.data()->x;
  const auto one = [&](std::ptrdiff_t i) {
    const Double4 v = read3(velocity + 3 * i);
    const Double4 x = read3(position + 3 * i) + step * v;
    write3(position + 3 * i, x);
    math::write(records[i].position, x);
    write_motion(records[i], v, read3(angular + 3 * i));
  };
  Ranger ranger;
  std::ptrdiff_t i = range.first;
  for (; i + 4 <= range.last; i += 4) {
    for (int k = 0; k < 4; ++k) one(i + k);
    ranger.include(read_four(velocity + 3 * i));
  }
  for (; i < range.last; ++i) {
    one(i);
    ranger.include(read3(velocity + 3 * i));
  }
  return ranger.range();
}

VelocityRange drift(NodeFields& nodes, NodeRange range, double step) {
  if (!nodes.float_records.empty()) return drift_all(nodes, nodes.float_records.data(), range, step);
  return drift_all(nodes, nodes.double_records.data(), range, step);
}

/// The kick of a run of nodes, and what it sums up.
class Kicker {
 public:
  CRUMPLE_INLINE Kicker(NodeFields& nodes, const Kick& kick)
      : interval_(kick.interval),
        velocity_(&nodes.velocity.data()->x),
        angular_(&nodes.angular_velocity.data()->x),
        acceleration_(kick.keep_acceleration ? &nodes.acceleration.data()->x : nullptr),
        previous_(kick.previous_velocity != nullptr ? &kick.previous_velocity->x : nullptr),
        forces_(nodes.force.data()),
        mass_(nodes.mass.data()),
        inertia_(nodes.inertia.data()),
        fixed_(nodes.fixed.data()) {}

  /// Asks for what the nodes i to i + 3 need: there are more rows of numbers than the processor follows.
  CRUMPLE_INLINE void ask_for_four(std::ptrdiff_t i) const {
    prefetch<true>(forces_ + i, 4);
    prefetch<true>(velocity_ + 3 * i, 12);
    prefetch<true>(angular_ + 3 * i, 12);
    prefetch<false>(mass_ + i, 4);
    prefetch<false>(inertia_ + i, 4);
  }
  CRUMPLE_INLINE void one(std::ptrdiff_t i);
  /// Whether the nodes i to i + 3 are free in all respects and have mass, and all or none of them turn.
  CRUMPLE_INLINE bool are_plain(std::ptrdiff_t i) const;
  CRUMPLE_INLINE void four_plain(std::ptrdiff_t i);
  CRUMPLE_INLINE KickSums sums() const;

 private:
  double interval_;
  double* velocity_;
  double* angular_;
  double* acceleration_;
  double* previous_;
  NodeForce* forces_;
  const double* mass_;
  const double* inertia_;
  const std::uint8_t* fixed_;
  Double4 translational_{};
  Double4 rotational_{};
  Double4 fastest_{};  // squared, by axis
  FourNodes four_translational_{};
  FourNodes four_rotational_{};
  FourNodes four_fastest_{};
};

void Kicker::one(std::ptrdiff_t i) {
  const Double4 force = math::read<Double4>(forces_[i].force);
  const Double4 moment = math::read<Double4>(forces_[i].moment);
  math::write(forces_[i].force, Double4{});
  math::write(forces_[i].moment, Double4{});
  // Nodes of solids alone: nothing turns them.
  const bool turns = inertia_[i] > 0;
  // A node that a rigid body moves keeps its velocities here, and its energy is the body's.
  const bool free = (fixed_[i] & domain::moved_by_body) == 0;
  const double m = free ? mass_[i] : 0.0;
  const double own = free ? inertia_[i] : 0.0;
  const Double2 per = inverses(m, own);
  const Double4 a = held(per[0] * force, fixed_[i]);
  const Double4 old_v = read3(velocity_ + 3 * i);
  const Double4 new_v = old_v + interval_ * a;
  translational_ += m * (old_v * new_v);
  fastest_ = larger(new_v * new_v, fastest_);
  write3(velocity_ + 3 * i, new_v);
  if (turns) {
    const Double4 old_w = read3(angular_ + 3 * i);
    const Double4 new_w = held(old_w + interval_ * (per[1] * moment), fixed_[i] >> 3U);
    rotational_ += own * (old_w * new_w);
    write3(angular_ + 3 * i, new_w);
  }
  if (acceleration_ != nullptr) write3(acceleration_ + 3 * i, a);
  if (previous_ != nullptr) write3(previous_ + 3 * i, old_v);
}

bool Kicker::are_plain(std::ptrdiff_t i) const {
  std::uint32_t fixed = 0;
  __builtin_memcpy(&fixed, fixed_ + i, sizeof(fixed));
  const auto has = [&](const double* of, int k) { return of[i + k] > 0 ? 1 : 0; };
  const int heavy = has(mass_, 0) + has(mass_, 1) + has(mass_, 2) + has(mass_, 3);
  const int turning = has(inertia_, 0) + has(inertia_, 1) + has(inertia_, 2) + has(inertia_, 3);
  return fixed == 0 && heavy == 4 && turning % 4 == 0;
}

void Kicker::four_plain(std::ptrdiff_t i) {
  const auto force = [&](int k) { return math::read<Double4>(forces_[i + k].force); };
  const auto moment = [&](int k) { return math::read<Double4>(forces_[i + k].moment); };
  const Double4 one{1.0, 1.0, 1.0, 1.0};
  const Double4 m = math::read<Double4>(mass_ + i);
  const FourNodes a = for_each_axis(one / m) * side_by_side(force(0), force(1), force(2), force(3));
  const FourNodes old_v = read_four(velocity_ + 3 * i);
  const FourNodes new_v = old_v + interval_ * a;
  four_translational_ = four_translational_ + for_each_axis(m) * (old_v * new_v);
  four_fastest_ = larger(new_v * new_v, four_fastest_);
  write_four(velocity_ + 3 * i, new_v);
  if (inertia_[i] > 0) {
    const Double4 own = math::read<Double4>(inertia_ + i);
    const FourNodes turn =
        for_each_axis(one / own) * side_by_side(moment(0), moment(1), moment(2), moment(3));
    const FourNodes old_w = read_four(angular_ + 3 * i);
    const FourNodes new_w = old_w + interval_ * turn;
    four_rotational_ = four_rotational_ + for_each_axis(own) * (old_w * new_w);
    write_four(angular_ + 3 * i, new_w);
  }
  for (int k = 0; k < 4; ++k) {
    math::write(forces_[i + k].force, Double4{});
    math::write(forces_[i + k].moment, Double4{});
  }
  if (acceleration_ != nullptr) write_four(acceleration_ + 3 * i, a);
  if (previous_ != nullptr) write_four(previous_ + 3 * i, old_v);
}

KickSums Kicker::sums() const {
  const Double4 fastest = larger(fastest_, largest_by_axis(four_fastest_));
  return {0.5 * (sum_of(four_translational_) + sum3(translational_)),
          0.5 * (sum_of(four_rotational_) + sum3(rotational_)), std::sqrt(sum3(fastest))};
}

KickSums kick(NodeFields& nodes, NodeRange range, const Kick& kick) {
  constexpr std::ptrdiff_t ahead = 64;
  Kicker kicker(nodes, kick);
  std::ptrdiff_t i = range.first;
  for (; i + 4 <= range.last; i += 4) {
    if (i + ahead + 4 <= range.last) kicker.ask_for_four(i + ahead);
    if (kicker.are_plain(i))
      kicker.four_plain(i);
    else
      for (int k = 0; k < 4; ++k) kicker.one(i + k);
  }
  for (; i < range.last; ++i) kicker.one(i);
  return kicker.sums();
}

}  // namespace

template <>
NodeKernels node_kernels<compiled_isa>() {
  return {&drift, &kick};
}

}  // namespace crumple::timeloop
