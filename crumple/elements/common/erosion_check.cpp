// SPDX-License-Identifier: BSD-3-Clause
#include "elements/common/erosion_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "materials/common/shell_material.hpp"
#include "materials/common/solid_material.hpp"
#include "materials/plasticity/principal.hpp"

namespace crumple::elements {
namespace {

using materials::SolidStress;
using materials::tile_lanes;
using Tensor = SolidStress<double>;  // stresses, and strains with the shears of the tensor

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
  Element(const ErosionCheck& check, const ErosionTile<Real>& tile, Index group, Index lane)
      : check_(check),
        tile_(tile),
        state_(tile.state + group * tile.group_stride + lane),
        place_(group * lanes + lane),
        count_(tile.planes * tile.points) {}

  void judge() {
    int failed = 0;
    for (int p = 0; p < count_; ++p) {
      if (item(p)[erosion_item::failed * lanes] == Real(0) && fails(*check_.criteria, advance(p)))
        item(p)[erosion_item::failed * lanes] = Real(1);
      if (item(p)[erosion_item::failed * lanes] != Real(0)) ++failed;
    }
    if (failed == 0) return;
    const bool gone = failed >= points_to_fail(*check_.criteria, count_);
    for (int p = 0; p < count_; ++p) {
      if (gone) item(p)[erosion_item::failed * lanes] = Real(1);
      if (item(p)[erosion_item::failed * lanes] != Real(0)) take_stress(p);
    }
    if (!gone) return;
    for (int plane = 0; plane < tile_.planes; ++plane) tile_.intact[plane * tile_lanes + place_] = Real(0);
  }

 private:
  bool is_shell() const { return tile_.turn == nullptr; }
  int components() const { return is_shell() ? materials::components : materials::solid_components; }
  Real* item(int p) const { return state_ + (check_.first + erosion_item::count * p) * lanes; }
  static double kept_sum(const Real* item, Index c) {
    return double(item[c * lanes]) + double(item[(c + erosion_item::rest) * lanes]);
  }
  static void keep_sum(Real* item, Index c, double sum) {
    item[c * lanes] = static_cast<Real>(sum);
    item[(c + erosion_item::rest) * lanes] = static_cast<Real>(sum - double(item[c * lanes]));
  }
  Real* stress(int p) const { return state_ + components() * p * lanes; }
  /// Strain increments of a point, engineering shears; of solids in the axes of the end of the step.
  std::array<double, 6> increments(int p) const {
    std::array<double, 6> more{};
    for (int c = 0; c < components(); ++c)
      more[c] = double(tile_.strain[(p * components() + c) * tile_lanes + place_]);
    if (is_shell()) return more;
    const auto on = materials::turned_on(
        materials::SolidStrain<double>{more[0], more[1], more[2], more[3], more[4], more[5]}, turn(p));
    return {on.xx, on.yy, on.zz, on.xy, on.yz, on.zx};
  }

  /// Rotation of a point of a solid in the step.
  materials::Turn<double> turn(int p) const {
    double rotation[9];
    for (int k = 0; k < 9; ++k) rotation[k] = double(tile_.turn[(p * 9 + k) * tile_lanes + place_]);
    return materials::load_turn<double>(rotation, 1);
  }

  Tensor stress_tensor(int p) const {
    const Real* const s = stress(p);
    const auto at = [&](int c) { return double(s[c * lanes]); };
    return is_shell() ? Tensor{at(0), at(1), 0, at(2), at(3), at(4)}
                      : Tensor{at(0), at(1), at(2), at(3), at(4), at(5)};
  }

  /// Increment of the strain, the shears those of the tensor.
  Tensor growth(int p) const {
    const std::array<double, 6> more = increments(p);
    if (!is_shell()) return {more[0], more[1], more[2], 0.5 * more[3], 0.5 * more[4], 0.5 * more[5]};
    const double zz = double(tile_.thickness_strain[p / tile_.points * tile_lanes + place_]);
    return {more[0], more[1], zz, 0.5 * more[2], 0.5 * more[3], 0.5 * more[4]};
  }

  /// Brings strain and impulse of a point up to date.
  PointState advance(int p) const {
    Real* const at = item(p);
    const auto kept = [&](Index c) { return kept_sum(at, erosion_item::strain + c); };
    Tensor strain{kept(0), kept(1), kept(2), kept(3), kept(4), kept(5)};
    if (!is_shell()) strain = materials::turned(strain, turn(p));
    const Tensor more = growth(p);
    strain = {strain.xx + more.xx, strain.yy + more.yy, strain.zz + more.zz,
              strain.xy + more.xy, strain.yz + more.yz, strain.zx + more.zx};
    const double numbers[] = {strain.xx, strain.yy, strain.zz, strain.xy, strain.yz, strain.zx};
    for (Index c = 0; c < 6; ++c) keep_sum(at, erosion_item::strain + c, numbers[c]);
    return {stress_tensor(p), strain, plastic_strain(p), add_impulse(p), check_.time};
  }

  double plastic_strain(int p) const {
    return check_.plastic_strain == no_index ? 0 : double(state_[(check_.plastic_strain + p) * lanes]);
  }

  /// The integral over time of the squared excess of the largest principal stress (F.R. Tuler & B.M. Butcher,
  /// Int. J. Fracture Mech. 4 (1968) 431-437).
  double add_impulse(int p) const {
    const model::ErosionCriteria& c = *check_.criteria;
    if (!c.impulse) return 0;
    const double excess =
        std::max(0.0, extremes_of(stress_tensor(p)).largest - c.threshold_stress.value_or(0));
    const double impulse = kept_sum(item(p), erosion_item::impulse) + excess * excess * check_.step;
    keep_sum(item(p), erosion_item::impulse, impulse);
    return impulse;
  }

  /// Sets the stress to zero: the work of the step is then half of the old stress's alone.
  void take_stress(int p) const {
    Real* const s = stress(p);
    const std::array<double, 6> more = increments(p);
    double work = 0;
    for (int c = 0; c < components(); ++c) {
      work += double(s[c * lanes]) * more[c];
      s[c * lanes] = Real(0);
    }
    double share = 0.5;
    if (tile_.weight != nullptr) share *= double(tile_.weight[p % tile_.points]);
    if (tile_.area != nullptr) share *= double(tile_.area[p * tile_lanes + place_]);
    const int row = is_shell() ? p / tile_.points : p;
    Real& energy = tile_.energy[row * tile_lanes + place_];
    energy = static_cast<Real>(double(energy) - share * work);
  }

  const ErosionCheck& check_;
  const ErosionTile<Real>& tile_;
  Real* state_;
  Index place_;  ///< in the tile
  int count_;
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
void check_erosion(const ErosionCheck& check, const ErosionTile<Real>& tile) {
  for (Index group = 0; group < tile.groups; ++group)
    for (Index lane = 0; lane < lanes; ++lane) Element<Real>(check, tile, group, lane).judge();
}
template void check_erosion(const ErosionCheck& check, const ErosionTile<float>& tile);
template void check_erosion(const ErosionCheck& check, const ErosionTile<double>& tile);

}  // namespace crumple::elements
