// SPDX-License-Identifier: BSD-3-Clause
#include "elements/common/erosion_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "materials/plasticity/principal.hpp"

namespace crumple::elements {
namespace {

using materials::tile_lanes;
using Tensor = PointTensor;

/// Largest and smallest principal value.
struct Extremes {
  double largest, smallest;
};

Extremes extremes_of(const Tensor& tensor) {
  const auto found = materials::principal(tensor);
  const auto [least, most] = std::minmax({found.value[0], found.value[1], found.value[2]});
  return {most, least};
}

/// What one point is judged by.
struct PointState {
  Tensor stress;
  Tensor strain;
  double plastic_strain = 0;
  double impulse = 0;  ///< [stress^2 time]
  double time = 0;
};

bool reaches(const std::optional<double>& limit, double value) {
  return limit && value >= *limit;
}
bool falls_to(const std::optional<double>& limit, double value) {
  return limit && value <= *limit;
}

/// sqrt(2/3 e' : e') of a strain with the shears of the tensor.
double effective_strain(const Tensor& e) {
  return 2.0 / 3.0 * std::sqrt(materials::equivalent_square(e));
}

int met_by_stress(const model::ErosionCriteria& c, const PointState& point) {
  const double pressure = -materials::mean_stress(point.stress);
  int met = 0;
  if (reaches(c.largest_pressure, pressure)) ++met;
  if (falls_to(c.smallest_pressure, pressure)) ++met;
  if (c.largest_principal_stress && reaches(c.largest_principal_stress, extremes_of(point.stress).largest))
    ++met;
  if (c.largest_equivalent_stress &&
      reaches(c.largest_equivalent_stress, std::sqrt(materials::equivalent_square(point.stress))))
    ++met;
  if (reaches(c.impulse, point.impulse)) ++met;
  return met;
}

int met_by_strain(const model::ErosionCriteria& c, const PointState& point) {
  const double volumetric = 3 * materials::mean_stress(point.strain);
  int met = 0;
  if (c.volumetric_strain &&
      (*c.volumetric_strain > 0 ? volumetric >= *c.volumetric_strain : volumetric <= *c.volumetric_strain))
    ++met;
  if (c.effective_strain && reaches(c.effective_strain, effective_strain(point.strain))) ++met;
  if (reaches(c.effective_plastic_strain, point.plastic_strain)) ++met;
  if (!c.largest_principal_strain && !c.smallest_principal_strain && !c.shear_strain) return met;
  const Extremes strain = extremes_of(point.strain);
  if (reaches(c.largest_principal_strain, strain.largest)) ++met;
  if (falls_to(c.smallest_principal_strain, strain.smallest)) ++met;
  if (reaches(c.shear_strain, 0.5 * (strain.largest - strain.smallest))) ++met;
  return met;
}

bool fails(const model::ErosionCriteria& c, const PointState& point) {
  const int of_time = reaches(c.time, point.time) ? 1 : 0;
  return met_by_stress(c, point) + met_by_strain(c, point) + of_time >= c.conditions;
}

int points_to_fail(const model::ErosionCriteria& criteria, int points) {
  if (criteria.points > 0) return std::min(criteria.points, points);
  constexpr double percent = 0.01;
  return std::clamp(static_cast<int>(std::ceil(-percent * criteria.points * points - percent)), 1, points);
}

/// All points of one element.
template <class Real>
class Element {
 public:
  Element(const ErosionCheck& check, const PointTile<Real>& tile, Index group, Index lane)
      : check_(check), points_(tile, group, lane) {}

  void judge() {
    int failed = 0;
    for (int p = 0; p < points_.count(); ++p) {
      if (item(p, erosion_item::failed) == Real(0) && fails(*check_.criteria, advance(p)))
        item(p, erosion_item::failed) = Real(1);
      if (item(p, erosion_item::failed) != Real(0)) ++failed;
    }
    if (failed == 0) return;
    const bool gone = failed >= points_to_fail(*check_.criteria, points_.count());
    for (int p = 0; p < points_.count(); ++p) {
      if (gone) item(p, erosion_item::failed) = Real(1);
      if (item(p, erosion_item::failed) != Real(0)) points_.lower_stress(p, 0);
    }
    if (gone) points_.end();
  }

 private:
  Real& item(int p, Index which) const {
    return points_.state(check_.first + erosion_item::count * p + which);
  }
  double kept(int p, Index which) const {
    return kept_sum(item(p, which), item(p, which + erosion_item::rest));
  }
  void keep(int p, Index which, double sum) const {
    keep_sum(sum, item(p, which), item(p, which + erosion_item::rest));
  }

  /// Increment of the strain, the shears those of the tensor.
  Tensor growth(int p) const {
    const std::array<double, 6> more = points_.increments(p);
    if (!points_.is_shell()) return {more[0], more[1], more[2], 0.5 * more[3], 0.5 * more[4], 0.5 * more[5]};
    const PointTile<Real>& tile = points_.tile();
    const double zz = double(tile.thickness_strain[p / tile.points * tile_lanes + points_.place()]);
    return {more[0], more[1], zz, 0.5 * more[2], 0.5 * more[3], 0.5 * more[4]};
  }

  /// Brings strain and impulse of a point up to date.
  PointState advance(int p) const {
    const auto kept_strain = [&](Index c) { return kept(p, erosion_item::strain + c); };
    Tensor strain{kept_strain(0), kept_strain(1), kept_strain(2),
                  kept_strain(3), kept_strain(4), kept_strain(5)};
    if (!points_.is_shell()) strain = materials::turned(strain, points_.turn(p));
    const Tensor more = growth(p);
    strain = {strain.xx + more.xx, strain.yy + more.yy, strain.zz + more.zz,
              strain.xy + more.xy, strain.yz + more.yz, strain.zx + more.zx};
    const double numbers[] = {strain.xx, strain.yy, strain.zz, strain.xy, strain.yz, strain.zx};
    for (Index c = 0; c < 6; ++c) keep(p, erosion_item::strain + c, numbers[c]);
    return {points_.stress(p), strain, plastic_strain(p), add_impulse(p), check_.time};
  }

  double plastic_strain(int p) const {
    return check_.plastic_strain == no_index ? 0 : double(points_.state(check_.plastic_strain + p));
  }

  /// The integral over time of the squared excess of the largest principal stress (F.R. Tuler & B.M. Butcher,
  /// Int. J. Fracture Mech. 4 (1968) 431-437).
  double add_impulse(int p) const {
    const model::ErosionCriteria& c = *check_.criteria;
    if (!c.impulse) return 0;
    const double excess =
        std::max(0.0, extremes_of(points_.stress(p)).largest - c.threshold_stress.value_or(0));
    const double impulse = kept(p, erosion_item::impulse) + excess * excess * check_.step;
    keep(p, erosion_item::impulse, impulse);
    return impulse;
  }

  const ErosionCheck& check_;
  TilePoints<Real> points_;
};

}  // namespace

ErosionCheck erosion_check(const domain::ElementBlock& block, double time, double step) {
  const domain::StateItem* const plastic_strain = block.find("plastic_strain");
  return {&*block.erosion, block.find("erosion")->first,
          plastic_strain == nullptr ? no_index : plastic_strain->first, time, step};
}

void declare_erosion(domain::ElementBlock& block) {
  domain::add_item(block, "erosion", "-, strain, stress^2 * time", erosion_item::count * block.points);
}

template <class Real>
void check_erosion(const ErosionCheck& check, const PointTile<Real>& tile) {
  for (Index group = 0; group < tile.groups; ++group)
    for (Index lane = 0; lane < lanes; ++lane) Element<Real>(check, tile, group, lane).judge();
}
template void check_erosion(const ErosionCheck& check, const PointTile<float>& tile);
template void check_erosion(const ErosionCheck& check, const PointTile<double>& tile);

}  // namespace crumple::elements
