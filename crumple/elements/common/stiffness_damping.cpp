// SPDX-License-Identifier: BSD-3-Clause
#include "elements/common/stiffness_damping.hpp"

#include <cmath>

#include "materials/common/deformation.hpp"
#include "materials/common/solid_material.hpp"

namespace crumple::elements {
namespace {

using materials::tile_lanes;

/// Steps of elements that set none are longer.
constexpr double longest_step = 1e29;

/// One point of one element.
template <class Real>
struct DampedPoint {
  Real* stress;   ///< rows of `lanes`
  Real* damping;  ///< the same
  Real* strain;   ///< rows of tile_lanes
  int components;

  double increment(int c) const { return double(strain[c * tile_lanes]); }
  bool stressed() const {
    for (int c = 0; c < components; ++c)
      if (stress[c * lanes] != Real(0)) return true;
    return false;
  }
};

/// All points of one element.
template <class Real>
class DampedElement {
 public:
  DampedElement(const StiffnessDamping& damping, const DampingTile<Real>& tile, Index group, Index lane)
      : damping_(damping),
        tile_(tile),
        state_(tile.state + group * tile.group_stride + lane),
        place_(group * lanes + lane) {}

  void add() const {
    const double step = double(*item(damping_item::stable_step));
    const double beta = damping_.given.share > 0 ? damping_.given.share * step : damping_.given.beta;
    const double per_strain = damping_.step > 0 ? beta / damping_.step : 0;
    for (int row = 0; row < (is_shell() ? tile_.planes : count()); ++row)
      tile_.work[row * tile_lanes + place_] = Real(0);
    for (int p = 0; p < count(); ++p) {
      const DampedPoint<Real> at = point(p);
      if (!is_shell()) turn(at, p);
      Real& work = tile_.work[(is_shell() ? p / tile_.points : p) * tile_lanes + place_];
      work = static_cast<Real>(double(work) + share_of(p) * resist(at, at.stressed() ? per_strain : 0));
      for (int c = 0; c < components(); ++c) {
        const Real own = at.stress[c * lanes];
        at.strain[c * tile_lanes] = own;
        at.stress[c * lanes] = own + at.damping[c * lanes];
      }
    }
  }

  void end() const {
    for (int p = 0; p < count(); ++p) {
      const DampedPoint<Real> at = point(p);
      for (int c = 0; c < components(); ++c) at.stress[c * lanes] = at.strain[c * tile_lanes];
    }
    Real& limit = tile_.limit[place_];
    if (!(double(limit) < longest_step)) return;
    *item(damping_item::stable_step) = limit;
    limit = static_cast<Real>(damped_share(damping_.given, double(limit)) * double(limit));
  }

 private:
  bool is_shell() const { return tile_.turn == nullptr; }
  int components() const { return is_shell() ? materials::components : materials::solid_components; }
  int count() const { return tile_.planes * tile_.points; }
  Real* item(Index which) const { return state_ + (damping_.first + which) * lanes; }
  DampedPoint<Real> point(int p) const {
    const Index first = components() * p;
    return {state_ + first * lanes, item(damping_item::stress + first),
            tile_.strain + first * tile_lanes + place_, components()};
  }

  /// Of the work of a point in that of its row.
  double share_of(int p) const {
    double share = 0.5;
    if (tile_.weight != nullptr) share *= double(tile_.weight[p % tile_.points]);
    if (tile_.area != nullptr) share *= double(tile_.area[p * tile_lanes + place_]);
    return share;
  }

  /// Brings the damping stress of time n-1, and the strain increment of the step's middle, into the axes of
  /// time n.
  void turn(const DampedPoint<Real>& at, int p) const {
    double rotation[9];
    for (int k = 0; k < 9; ++k) rotation[k] = double(tile_.turn[(p * 9 + k) * tile_lanes + place_]);
    const auto turn = materials::load_turn<double>(rotation, 1);
    const auto old = [&](int c) { return double(at.damping[c * lanes]); };
    const auto more = [&](int c) { return at.increment(c); };
    const auto stress = materials::turned(
        materials::SolidStress<double>{old(0), old(1), old(2), old(3), old(4), old(5)}, turn);
    const auto strain = materials::turned_on(
        materials::SolidStrain<double>{more(0), more(1), more(2), more(3), more(4), more(5)}, turn);
    const double stresses[] = {stress.xx, stress.yy, stress.zz, stress.xy, stress.yz, stress.zx};
    const double strains[] = {strain.xx, strain.yy, strain.zz, strain.xy, strain.yz, strain.zx};
    for (int c = 0; c < 6; ++c) {
      at.damping[c * lanes] = static_cast<Real>(stresses[c]);
      at.strain[c * tile_lanes] = static_cast<Real>(strains[c]);
    }
  }

  /// Brings the damping stress of a point to `per_strain` times the elastic stress of the increment; returns
  /// the sum of the old one and the new one times the increment.
  double resist(const DampedPoint<Real>& at, double per_strain) const {
    const int direct = is_shell() ? 2 : 3;
    double trace = 0;
    for (int c = 0; c < direct; ++c) trace += at.increment(c);
    double work = 0;
    for (int c = 0; c < components(); ++c) {
      const double more = at.increment(c);
      const double stress = c < direct ? damping_.cross * trace + (damping_.direct - damping_.cross) * more
                                       : damping_.shear * more;
      const double old = double(at.damping[c * lanes]);
      at.damping[c * lanes] = static_cast<Real>(per_strain * stress);
      work += (old + double(at.damping[c * lanes])) * more;
    }
    return work;
  }

  const StiffnessDamping& damping_;
  const DampingTile<Real>& tile_;
  Real* state_;
  Index place_;  ///< in the tile
};

}  // namespace

StiffnessDamping shell_damping(const materials::ElasticConstants& elastic) {
  const double nu = elastic.poissons_ratio;
  StiffnessDamping damping;
  damping.direct = elastic.youngs_modulus / (1 - nu * nu);
  damping.cross = nu * damping.direct;
  damping.shear = elastic.shear_modulus();
  return damping;
}

StiffnessDamping solid_damping(const materials::ElasticConstants& elastic, bool averages) {
  StiffnessDamping damping;
  damping.shear = elastic.shear_modulus();
  const double nu = elastic.poissons_ratio;
  const double bulk = averages ? 0 : elastic.youngs_modulus / (3 * (1 - 2 * nu));
  damping.direct = bulk + 4.0 / 3 * damping.shear;
  damping.cross = bulk - 2.0 / 3 * damping.shear;
  return damping;
}

void declare_damping(const StiffnessDamping& damping, Index components, domain::DampedBlock& block) {
  if (!block.damping) return;
  domain::add_item(block, "damping", "time, stress", damping_item::stress + components * block.points);
  block.damping_moduli = {damping.direct, damping.cross, damping.shear};
}

StiffnessDamping damping_of(const domain::DampedBlock& block, double step) {
  StiffnessDamping damping;
  damping.given = *block.damping;
  damping.first = block.find("damping")->first;
  damping.direct = block.damping_moduli[0];
  damping.cross = block.damping_moduli[1];
  damping.shear = block.damping_moduli[2];
  damping.step = step;
  return damping;
}

double damped_share(const model::StiffnessDamping& damping, double undamped_step) {
  const double x = damping.share > 0 ? damping.share : damping.beta / undamped_step;
  // The difference of two large numbers would lose its digits.
  return 1 / (std::sqrt(1 + x * x) + x);
}

template <class Real>
void add_damping(const StiffnessDamping& damping, const DampingTile<Real>& tile) {
  for (Index group = 0; group < tile.groups; ++group)
    for (Index lane = 0; lane < lanes; ++lane) DampedElement<Real>(damping, tile, group, lane).add();
}
template <class Real>
void end_damping(const StiffnessDamping& damping, const DampingTile<Real>& tile) {
  for (Index group = 0; group < tile.groups; ++group)
    for (Index lane = 0; lane < lanes; ++lane) DampedElement<Real>(damping, tile, group, lane).end();
}
template void add_damping(const StiffnessDamping& damping, const DampingTile<float>& tile);
template void add_damping(const StiffnessDamping& damping, const DampingTile<double>& tile);
template void end_damping(const StiffnessDamping& damping, const DampingTile<float>& tile);
template void end_damping(const StiffnessDamping& damping, const DampingTile<double>& tile);

}  // namespace crumple::elements
