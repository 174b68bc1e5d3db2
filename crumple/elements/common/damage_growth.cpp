// SPDX-License-Identifier: BSD-3-Clause
#include "elements/common/damage_growth.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "math/power.hpp"

namespace crumple::elements {
namespace {

using model::GissmoDamage;

/// What failure depends on beside the plastic strain.
struct StressState {
  double triaxiality = 0;  ///< mean stress over von Mises stress [-]
  double lode = 0;         ///< 27/2 of the third invariant of the deviator over the cube of that [-]
};

StressState state_of(const PointTensor& s) {
  const double equivalent = std::sqrt(materials::equivalent_square(s));
  if (!(equivalent > 0)) return {};
  const double mean = materials::mean_stress(s);
  const double xx = (s.xx - mean) / equivalent;
  const double yy = (s.yy - mean) / equivalent;
  const double zz = (s.zz - mean) / equivalent;
  const double xy = s.xy / equivalent;
  const double yz = s.yz / equivalent;
  const double zx = s.zx / equivalent;
  const double third = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
  constexpr double factor = 13.5;
  return {mean / equivalent, std::clamp(factor * third, -1.0, 1.0)};
}

/// x^y; exactly x for y = 1.
double raised(double x, double y) {
  return y == 1 ? x : math::power(x, y);
}

/// Share of the regularization that SHRF and BIAXF take away: none in uniaxial tension, from there linear to
/// pure shear and to equal tension along two axes.
double missing_share(const GissmoDamage& law, double triaxiality) {
  const double from_tension = std::clamp(3 * triaxiality - 1, -1.0, 1.0);
  return from_tension < 0 ? -from_tension * law.shear_reduction : from_tension * law.biaxial_reduction;
}

double size_factor(const GissmoDamage& law, double size, const StressState& at) {
  if (law.size_factor.empty()) return 1;
  const double factor = law.size_factor.at(at.triaxiality, size);
  return factor + (1 - factor) * missing_share(law, at.triaxiality);
}

double rate_factor(const GissmoDamage& law, double rate) {
  if (!law.rate_factor) return 1;
  constexpr double natural = 0.69314718055994531;  // ln 2
  return law.rate_factor->at(law.logarithmic_rates ? natural * math::binary_log(rate) : rate);
}

/// Failed points, or layers, at which an element goes.
int enough_of(double given, int points, int layers) {
  if (given > 0) return std::clamp(static_cast<int>(std::ceil(given)), 1, points);
  constexpr double percent = 0.01;
  return std::clamp(static_cast<int>(std::ceil(-percent * given * layers - percent)), 1, layers);
}

/// All points of one element.
template <class Real>
class DamagedElement {
 public:
  DamagedElement(const DamageGrowth& growth, const PointTile<Real>& tile, Index group, Index lane)
      : growth_(growth), law_(*growth.law), points_(tile, group, lane) {}

  void restore() const {
    for (int p = 0; p < points_.count(); ++p) {
      for (Index k = 0; k < 2; ++k) item(p, damage_item::plastic_strain + k) = plastic_strain(p, k);
      item(p, damage_item::work) = Real(0);
      const double lost = double(item(p, damage_item::lost));
      if (lost > 0 && lost < 1) restore_point(p, lost);
    }
  }

  void grow() const {
    double left = 0;
    bool any_lost = false;
    for (int p = 0; p < points_.count(); ++p) {
      if (item(p, damage_item::lost) < Real(1)) add(p);
      const double lost = double(item(p, damage_item::lost));
      points_.take_work(p, double(item(p, damage_item::work)));
      if (lost > 0) points_.lower_stress(p, 1 - lost);
      any_lost = any_lost || lost > 0;
      left += (1 - lost) * points_.share(p);
    }
    if (!any_lost) return;
    if (Real* const yield = points_.tile().yield_stress) {
      Real& stress = yield[points_.place()];
      stress = static_cast<Real>(left * double(stress));
    }
    if (is_gone()) end();
  }

 private:
  Real& item(int p, Index which) const {
    return points_.state(growth_.history + damage_item::points + damage_item::per_point * p + which);
  }
  double kept(int p, Index which) const { return kept_sum(item(p, which), item(p, which + 1)); }
  Real& plastic_strain(int p, Index which) const {
    return points_.state(
        growth_.plastic_strain[static_cast<std::size_t>(p)][static_cast<std::size_t>(which)]);
  }

  /// Makes the undamaged stress of a point, and keeps what the work of the step lacks of its own.
  void restore_point(int p, double lost) const {
    // Of solids the increments are in the axes of the step's end, as the law turns the stress.
    PointTensor s = points_.stress(p);
    if (!points_.is_shell()) s = materials::turned(s, points_.turn(p));
    const std::array<double, 6> more = points_.increments(p);
    const double work = points_.is_shell() ? s.xx * more[0] + s.yy * more[1] + s.xy * more[2] +
                                                 s.yz * more[3] + s.zx * more[4]
                                           : s.xx * more[0] + s.yy * more[1] + s.zz * more[2] +
                                                 s.xy * more[3] + s.yz * more[4] + s.zx * more[5];
    item(p, damage_item::work) = static_cast<Real>(0.5 * points_.share(p) * lost / (1 - lost) * work);
    for (int c = 0; c < points_.components(); ++c) {
      Real& stress = points_.state(points_.components() * p + c);
      stress = static_cast<Real>(double(stress) / (1 - lost));
    }
  }

  /// Adds the plastic strain of the step to damage and instability of a point.
  void add(int p) const {
    const double more =
        kept_sum(plastic_strain(p, 0), plastic_strain(p, 1)) - kept(p, damage_item::plastic_strain);
    if (!(more > 0)) return;
    const StressState at = state_of(points_.stress(p));
    const double by_rate = growth_.step > 0 ? rate_factor(law_, more / growth_.step) : 1;
    const double failure =
        by_rate * size_factor(law_, size(), at) * law_.failure_strain.at(at.lode, at.triaxiality);
    const double root = std::min(1.0, kept(p, damage_item::root) + more / failure);
    keep_sum(root, item(p, damage_item::root), item(p, damage_item::root + 1));
    const double damage = raised(root, law_.exponent);
    points_.state(growth_.damage + p) = static_cast<Real>(damage);
    if (!law_.acts) return;
    const double critical = critical_damage(p, more, at, by_rate, damage);
    item(p, damage_item::lost) = root < 1 ? fading(damage, critical) : Real(1);
  }

  /// The damage at which the stress begins to fade; one as long as that is to come.
  double critical_damage(int p, double more, const StressState& at, double by_rate, double damage) const {
    if (law_.critical_strain.empty()) return law_.critical_damage;
    const double before = kept(p, damage_item::instability);
    if (before >= 1) return double(item(p, damage_item::critical));
    const double critical =
        (law_.rates_scale_critical ? by_rate : 1) * law_.critical_strain.at(at.lode, at.triaxiality);
    const double now = std::min(1.0, before + more / critical);
    keep_sum(now, item(p, damage_item::instability), item(p, damage_item::instability + 1));
    if (now < 1) return 1;
    item(p, damage_item::critical) = static_cast<Real>(damage);
    return damage;
  }

  /// Share of the stress that is lost.
  Real fading(double damage, double critical) const {
    if (!(damage > critical)) return Real(0);
    const double exponent = law_.fading_exponent.at(0, size());
    const auto lost = static_cast<Real>(raised((damage - critical) / (1 - critical), exponent));
    // Failure is by the damage alone, and what has not failed can be restored.
    constexpr auto most = static_cast<Real>(1 - 1e-6);
    return std::min(lost, most);
  }

  double size() const { return double(points_.state(growth_.history + damage_item::size)); }

  bool failed(int p) const { return item(p, damage_item::lost) == Real(1); }

  /// Of shells with several points in plane a layer has failed when one of them has.
  bool is_gone() const {
    const int layers = points_.is_shell() ? points_.tile().points : points_.count();
    const int planes = points_.is_shell() ? points_.tile().planes : 1;
    const bool by_layers = law_.points < 0;
    int count = 0;
    for (int layer = 0; layer < layers; ++layer) {
      int in_layer = 0;
      for (int plane = 0; plane < planes; ++plane)
        if (failed(plane * layers + layer)) ++in_layer;
      count += by_layers ? std::min(in_layer, 1) : in_layer;
    }
    return count >= enough_of(law_.points, points_.count(), layers);
  }

  void end() const {
    for (int p = 0; p < points_.count(); ++p) {
      if (failed(p)) continue;
      item(p, damage_item::lost) = Real(1);
      points_.lower_stress(p, 0);
    }
    points_.end();
  }

  const DamageGrowth& growth_;
  const GissmoDamage& law_;
  TilePoints<Real> points_;
};

/// Components of an item at every point of a block; throws where it has none.
std::vector<Index> components_of(const domain::ElementBlock& block, const std::string& name) {
  std::vector<Index> found;
  for (Index point = 0; point < block.points; ++point) {
    Index component = no_index;
    for (const domain::StateItem& item : block.items) {
      if (item.name != name) continue;
      const Index at = item.point_of(point);
      if (at != no_index && at < item.count) component = item.first + at;
    }
    if (component == no_index) throw Error("A material with damage has no plastic strain.");
    found.push_back(component);
  }
  return found;
}

}  // namespace

DamageGrowth damage_growth(const domain::ElementBlock& block, double step) {
  DamageGrowth growth{&*block.damage, block.find("gissmo_damage")->first,
                      block.find("damage_history")->first};
  growth.step = step;
  const std::vector<Index> sum = components_of(block, "plastic_strain");
  const std::vector<Index> rest = components_of(block, "plastic_strain_rest");
  for (std::size_t p = 0; p < sum.size(); ++p) growth.plastic_strain.push_back({sum[p], rest[p]});
  return growth;
}

void declare_damage(domain::ElementBlock& block) {
  if (!block.damage) return;
  components_of(block, "plastic_strain");
  // A law may have a damage of its own, as that of Johnson & Cook.
  domain::add_item(block, "gissmo_damage", "-", block.points);
  domain::add_item(block, "damage_history", "length, -, work / volume",
                   damage_item::points + damage_item::per_point * block.points);
}

void set_damage_size(domain::ElementBlock& block, Index place, double size) {
  if (block.damage) block.set_state(place, block.find("damage_history")->first + damage_item::size, size);
}

template <class Real>
void restore_stress(const DamageGrowth& growth, const PointTile<Real>& tile) {
  for (Index group = 0; group < tile.groups; ++group)
    for (Index lane = 0; lane < lanes; ++lane) DamagedElement<Real>(growth, tile, group, lane).restore();
}
template <class Real>
void grow_damage(const DamageGrowth& growth, const PointTile<Real>& tile) {
  for (Index group = 0; group < tile.groups; ++group)
    for (Index lane = 0; lane < lanes; ++lane) DamagedElement<Real>(growth, tile, group, lane).grow();
}
template void restore_stress(const DamageGrowth& growth, const PointTile<float>& tile);
template void restore_stress(const DamageGrowth& growth, const PointTile<double>& tile);
template void grow_damage(const DamageGrowth& growth, const PointTile<float>& tile);
template void grow_damage(const DamageGrowth& growth, const PointTile<double>& tile);

}  // namespace crumple::elements
