// SPDX-License-Identifier: BSD-3-Clause
#include "elements/line/discrete_beam_law.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::elements {
namespace {

/// Points of a curve; one that begins at or above zero holds for both signs.
struct BothSigns {
  std::vector<double> x, y;

  explicit BothSigns(const model::Curve& curve) {
    if (curve.abscissa.front() >= 0)
      for (std::size_t i = curve.abscissa.size(); i-- > 0;) {
        if (curve.abscissa[i] == 0) continue;
        x.push_back(-curve.abscissa[i]);
        y.push_back(-curve.ordinate[i]);
      }
    x.insert(x.end(), curve.abscissa.begin(), curve.abscissa.end());
    y.insert(y.end(), curve.ordinate.begin(), curve.ordinate.end());
  }

  double steepest() const {
    double slope = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
      slope = std::max(slope, std::fabs((y[i] - y[i - 1]) / (x[i] - x[i - 1])));
    return slope;
  }
};

/// Appends the largest slope, the size and the points; returns that slope.
double append_curve(const model::Model& model, Index curve, std::vector<double>& numbers) {
  if (curve == no_index) {
    numbers.insert(numbers.end(), {0, 0});
    return 0;
  }
  const BothSigns points(model.curves[static_cast<std::size_t>(curve)]);
  const double slope = points.steepest();
  numbers.insert(numbers.end(), {slope, static_cast<double>(points.x.size())});
  numbers.insert(numbers.end(), points.x.begin(), points.x.end());
  numbers.insert(numbers.end(), points.y.begin(), points.y.end());
  return slope;
}

/// Reads what append_curve() has left.
SlopedCurve next_curve(const double*& at, double& slope) {
  slope = at[0];
  const auto size = static_cast<std::size_t>(at[1]);
  const SlopedCurve curve(at + 2, size);
  at += 2 + 2 * size;
  return curve;
}

}  // namespace

std::vector<double> discrete_beam_numbers(const model::DiscreteBeamLaw& law, const model::Model& model,
                                          const model::DiscreteBeamData& data) {
  std::vector<double> numbers{static_cast<double>(law.kind), law.youngs_modulus * data.cable_area,
                              data.cable_area, law.ramp_time};
  append_curve(model, law.stress_curve, numbers);
  for (const model::DiscreteBeamDirection& one : law.direction) {
    numbers.insert(numbers.end(),
                   {one.stiffness, one.damping, one.preload, one.tensile_limit, one.compressive_limit});
    append_curve(model, one.curve, numbers);
    append_curve(model, one.damping_curve, numbers);
  }
  return numbers;
}

DiscreteBeamResponse::DiscreteBeamResponse(const double* numbers)
    : kind_(static_cast<model::DiscreteBeamLaw::Kind>(static_cast<int>(numbers[0]))),
      axial_stiffness_(numbers[1]),
      area_(numbers[2]),
      ramp_time_(numbers[3]) {
  const double* at = numbers + 4;
  stress_ = next_curve(at, steepest_stress_);
  for (Direction& one : directions_) {
    one.stiffness = at[0];
    one.damping = at[1];
    one.preload = at[2];
    one.tensile_limit = at[3];
    one.compressive_limit = at[4];
    at += 5;
    double slope = 0;
    one.curve = next_curve(at, slope);
    one.most_stiffness = std::fabs(one.stiffness) + slope;
    one.damping_curve = next_curve(at, slope);
    one.most_damping = one.damping + slope;
  }
}

double DiscreteBeamResponse::Direction::force(double displacement, double rate, double share) const {
  double sum = share * preload + stiffness * displacement + damping * rate;
  if (!curve.empty()) sum += curve.at(displacement);
  if (!damping_curve.empty()) sum += damping_curve.at(rate);
  return sum;
}

bool DiscreteBeamResponse::Direction::holds(double displacement) const {
  return (tensile_limit == 0 || displacement < tensile_limit) &&
         (compressive_limit == 0 || displacement > -compressive_limit);
}

double DiscreteBeamResponse::preload_share(double time) const {
  return ramp_time_ > 0 ? std::min(1.0, time / ramp_time_) : 1.0;
}

double DiscreteBeamResponse::stiffness(int direction, double free_length) const {
  double most = directions_[static_cast<std::size_t>(direction)].most_stiffness;
  if (direction == 0 && kind_ == model::DiscreteBeamLaw::Kind::Cable)
    most += (axial_stiffness_ + area_ * steepest_stress_) / free_length;
  return most;
}

void DiscreteBeamResponse::forces(const DiscreteBeamStep& step) const {
  using Kind = model::DiscreteBeamLaw::Kind;
  const double share = preload_share(step.time);
  const int used = kind_ == Kind::Axes ? discrete_directions : 1;
  for (int lane = 0; lane < step.width; ++lane) {
    bool intact = true;
    for (int i = 0; i < discrete_directions; ++i) {
      const int at = i * step.width + lane;
      step.force[at] = 0;
      if (i >= used) continue;
      const Direction& one = directions_[static_cast<std::size_t>(i)];
      const double displacement = step.displacement[at];
      const double rate = step.step > 0 ? (displacement - step.before[at]) / step.step : 0.0;
      step.force[at] = one.force(displacement, rate, share);
      if (kind_ == Kind::Cable) {
        const double strain = displacement / step.free_length[lane];
        step.force[at] += stress_.empty() ? axial_stiffness_ * strain : area_ * stress_.at(strain);
        step.force[at] = std::max(0.0, step.force[at]);
      }
      intact = intact && one.holds(displacement);
    }
    step.intact[lane] = intact ? 1 : 0;
  }
}

}  // namespace crumple::elements
