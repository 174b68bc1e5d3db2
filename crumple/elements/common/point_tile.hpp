// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "base/index.hpp"
#include "materials/common/shell_material.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/common/solid_stress.hpp"

namespace crumple::elements {

/// One tile of shells or solids with the stresses of its points. Rows of the scratch are tile_lanes apart.
template <class Real>
struct PointTile {
  Real* state = nullptr;  ///< of the first group; the stress stands at component 0
  std::ptrdiff_t group_stride = 0;
  Index groups = 0;
  int planes = 1;                          ///< of a shell
  int points = 1;                          ///< of one plane
  const Real* strain = nullptr;            ///< increments of the middle of the step [point][5 or 6]
  const Real* turn = nullptr;              ///< of solids: rotation less the unit matrix [point][9]
  const Real* thickness_strain = nullptr;  ///< of shells: increment zz [plane]
  const Real* weight = nullptr;            ///< of shells: share of a point in its plane
  const Real* area = nullptr;              ///< of shells: factor on that [point], or nullptr
  Real* energy = nullptr;                  ///< work density of the step: of solids [point], of shells [plane]
  Real* intact = nullptr;                  ///< [plane] of the law; zero where the element has failed
  Real* yield_stress = nullptr;            ///< of shells: MaterialTask::yield's, or nullptr
};

/// Stresses, and strains with the shears of the tensor.
using PointTensor = materials::SolidStress<double>;

/// The points of one element of a tile. Not for kernels: it has the same bits for every instruction set.
template <class Real>
class TilePoints {
 public:
  TilePoints(const PointTile<Real>& tile, Index group, Index lane)
      : tile_(tile), state_(tile.state + group * tile.group_stride + lane), place_(group * lanes + lane) {}

  const PointTile<Real>& tile() const { return tile_; }
  bool is_shell() const { return tile_.turn == nullptr; }
  int count() const { return tile_.planes * tile_.points; }
  int components() const { return is_shell() ? materials::components : materials::solid_components; }
  /// A number of the element's state.
  Real& state(Index component) const { return state_[component * lanes]; }
  /// The element's number in a row of the scratch.
  Index place() const { return place_; }

  /// Strain increments of a point, engineering shears; of solids in the axes of the end of the step.
  std::array<double, 6> increments(int p) const {
    std::array<double, 6> more{};
    for (int c = 0; c < components(); ++c)
      more[static_cast<std::size_t>(c)] =
          double(tile_.strain[(p * components() + c) * materials::tile_lanes + place_]);
    if (is_shell()) return more;
    const auto on = materials::turned_on(
        materials::SolidStrain<double>{more[0], more[1], more[2], more[3], more[4], more[5]}, turn(p));
    return {on.xx, on.yy, on.zz, on.xy, on.yz, on.zx};
  }

  /// Rotation of a point of a solid in the step.
  materials::Turn<double> turn(int p) const {
    double rotation[9];
    for (int k = 0; k < 9; ++k)
      rotation[k] = double(tile_.turn[(p * 9 + k) * materials::tile_lanes + place_]);
    return materials::load_turn<double>(rotation, 1);
  }

  PointTensor stress(int p) const {
    const auto at = [&](int c) { return double(state(components() * p + c)); };
    return is_shell() ? PointTensor{at(0), at(1), 0, at(2), at(3), at(4)}
                      : PointTensor{at(0), at(1), at(2), at(3), at(4), at(5)};
  }

  /// Of the work density of a point in that of its row.
  double share(int p) const {
    double share = 1;
    if (tile_.weight != nullptr) share *= double(tile_.weight[p % tile_.points]);
    if (tile_.area != nullptr) share *= double(tile_.area[p * materials::tile_lanes + place_]);
    return share;
  }

  /// Takes work of a point out of that of the step.
  void take_work(int p, double work) const {
    const int row = is_shell() ? p / tile_.points : p;
    Real& energy = tile_.energy[row * materials::tile_lanes + place_];
    energy = static_cast<Real>(double(energy) - work);
  }

  /// Leaves `left` of the stress at the end of the step, and takes half of the rest's work out of that of the
  /// step.
  void lower_stress(int p, double left) const {
    const std::array<double, 6> more = increments(p);
    double work = 0;
    for (int c = 0; c < components(); ++c) {
      Real& s = state(components() * p + c);
      work += double(s) * more[static_cast<std::size_t>(c)];
      s = static_cast<Real>(left * double(s));
    }
    take_work(p, 0.5 * (1 - left) * share(p) * work);
  }

  /// Says that the element has failed.
  void end() const {
    for (int plane = 0; plane < tile_.planes; ++plane)
      tile_.intact[plane * materials::tile_lanes + place_] = Real(0);
  }

 private:
  const PointTile<Real>& tile_;
  Real* state_;
  Index place_;
};

/// A sum kept in two numbers of the state, the second being what rounding takes from the first: in float slow
/// growth would come to a halt otherwise.
template <class Real>
double kept_sum(const Real& sum, const Real& rest) {
  return double(sum) + double(rest);
}
template <class Real>
void keep_sum(double value, Real& sum, Real& rest) {
  sum = static_cast<Real>(value);
  rest = static_cast<Real>(value - double(sum));
}

}  // namespace crumple::elements
