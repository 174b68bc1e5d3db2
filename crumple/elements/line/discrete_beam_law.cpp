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

  /// Between its ends.
  double at(double place) const {
    const auto next = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), place) - x.begin());
    const std::size_t i = std::clamp<std::size_t>(next, 1, x.size() - 1);
    return y[i - 1] + (place - x[i - 1]) * (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
  }

  double steepest() const {
    double slope = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
      slope = std::max(slope, std::fabs((y[i] - y[i - 1]) / (x[i] - x[i - 1])));
    return slope;
  }
};

/// Whether a curve of unloading lies below that of loading, nearer to zero, anywhere where both have points.
bool lies_below(const model::Curve& unloading, const model::Curve& loading) {
  const BothSigns back(unloading);
  const BothSigns load(loading);
  double most = 0;
  for (const double force : load.y) most = std::max(most, std::fabs(force));
  constexpr double small = 1e-9;
  const auto falls_below = [&](double place) {
    if (place < std::max(back.x.front(), load.x.front()) || place > std::min(back.x.back(), load.x.back()))
      return false;
    return std::copysign(1.0, place) * (load.at(place) - back.at(place)) > small * most;
  };
  return std::ranges::any_of(back.x, falls_below) || std::ranges::any_of(load.x, falls_below);
}

/// How a direction unloads by its curve: shifted along u that one would come before any loading where it lies
/// below, and is then the lower limit of what stiffness leads to.
model::DiscreteBeamLaw::Unloading unloading_of(const model::DiscreteBeamLaw& law,
                                               const model::DiscreteBeamDirection& one,
                                               const std::vector<model::Curve>& curves) {
  using Unloading = model::DiscreteBeamLaw::Unloading;
  if (law.unloading != Unloading::Curve || one.curve == no_index || one.unloading_curve == no_index)
    return law.unloading;
  const bool below = lies_below(curves[static_cast<std::size_t>(one.unloading_curve)],
                                curves[static_cast<std::size_t>(one.curve)]);
  return below ? Unloading::Stiffness : Unloading::Curve;
}

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

/// The same of factors, which are no forces: the curve as it is, and its largest amount.
void append_factors(const model::Model& model, Index curve, std::vector<double>& numbers) {
  if (curve == no_index) {
    numbers.insert(numbers.end(), {1, 0});
    return;
  }
  const model::Curve& points = model.curves[static_cast<std::size_t>(curve)];
  double most = 0;
  for (const double y : points.ordinate) most = std::max(most, std::fabs(y));
  numbers.insert(numbers.end(), {most, static_cast<double>(points.abscissa.size())});
  numbers.insert(numbers.end(), points.abscissa.begin(), points.abscissa.end());
  numbers.insert(numbers.end(), points.ordinate.begin(), points.ordinate.end());
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
  std::vector<double> numbers{static_cast<double>(law.kind),
                              law.youngs_modulus * data.cable_area,
                              data.cable_area,
                              law.ramp_time,
                              static_cast<double>(law.unloading),
                              law.permanent_share,
                              law.joint_failure ? 1.0 : 0.0};
  append_curve(model, law.stress_curve, numbers);
  for (const model::DiscreteBeamDirection& one : law.direction) {
    numbers.insert(numbers.end(),
                   {one.stiffness, one.damping, one.preload, one.tensile_limit, one.compressive_limit,
                    one.unloading_stiffness, static_cast<double>(unloading_of(law, one, model.curves))});
    append_curve(model, one.curve, numbers);
    append_curve(model, one.damping_curve, numbers);
    append_factors(model, one.damping_factor, numbers);
    append_curve(model, one.unloading_curve == no_index ? one.curve : one.unloading_curve, numbers);
  }
  return numbers;
}

DiscreteBeamResponse::DiscreteBeamResponse(const double* numbers)
    : kind_(static_cast<model::DiscreteBeamLaw::Kind>(static_cast<int>(numbers[0]))),
      axial_stiffness_(numbers[1]),
      area_(numbers[2]),
      ramp_time_(numbers[3]),
      unloading_(static_cast<Unloading>(static_cast<int>(numbers[4]))),
      permanent_share_(numbers[5]),
      joint_failure_(numbers[6] != 0) {
  const double* at = numbers + 7;
  stress_ = next_curve(at, steepest_stress_);
  for (Direction& one : directions_) {
    one.stiffness = at[0];
    one.damping = at[1];
    one.preload = at[2];
    one.tensile_limit = at[3];
    one.compressive_limit = at[4];
    one.unloading_stiffness = at[5];
    one.unloading = static_cast<Unloading>(static_cast<int>(at[6]));
    at += 7;
    double slope = 0;
    double factor = 0;
    double back = 0;
    one.curve = next_curve(at, slope);
    double damping = 0;
    one.damping_curve = next_curve(at, damping);
    one.damping_factor = next_curve(at, factor);
    one.most_damping = one.damping + factor * damping;
    one.unloading_curve = next_curve(at, back);
    one.most_stiffness = std::fabs(one.stiffness) + slope;
    if (unloading_ == Unloading::None) continue;
    // Loading is to follow its curve.
    one.unloading_stiffness = std::max({one.unloading_stiffness, slope, back});
    // The parabola is twice as steep as the straight line between its ends.
    if (one.unloading == Unloading::Quadratic) back = 2 * slope / (1 - permanent_share_);
    if (one.unloading == Unloading::Stiffness) back = std::max(back, one.unloading_stiffness);
    one.most_stiffness = std::fabs(one.stiffness) + std::max(slope, back);
  }
}

double DiscreteBeamResponse::Direction::force(double displacement, double rate, double share,
                                              double by_curve) const {
  double sum = share * preload + stiffness * displacement + damping * rate;
  if (!curve.empty()) sum += by_curve;
  if (damping_curve.empty()) return sum;
  const double factor = damping_factor.empty() ? 1.0 : damping_factor.at(displacement);
  return sum + factor * damping_curve.at(rate);
}

double DiscreteBeamResponse::Direction::tension(double displacement) const {
  if (tensile_limit == 0 || displacement <= 0) return 0;
  return (displacement / tensile_limit) * (displacement / tensile_limit);
}

double DiscreteBeamResponse::Direction::compression(double displacement) const {
  if (compressive_limit == 0 || displacement >= 0) return 0;
  return (displacement / compressive_limit) * (displacement / compressive_limit);
}

/// The unloading curve from what remains of the displacement of this sign, `history`, at most the loading
/// curve, which moves it.
double DiscreteBeamResponse::shifted_force(const Direction& one, double displacement, double* history,
                                           int stride) const {
  double& remains = history[displacement < 0 ? stride : 0];
  const double sign = displacement < 0 ? -1 : 1;
  const double most = sign * one.curve.at(displacement);
  const double elastic = sign * one.unloading_curve.at(displacement - remains);
  if (elastic <= most) return sign * std::max(elastic, 0.0);
  if (most > 0) remains = displacement - one.unloading_curve.inverse(sign * most);
  return sign * most;
}

/// A parabola between the largest displacement of this sign, `history`, and the share of it that remains.
double DiscreteBeamResponse::quadratic_force(const Direction& one, double displacement, double* history,
                                             int stride) const {
  double& largest = history[displacement < 0 ? stride : 0];
  if (std::fabs(displacement) >= std::fabs(largest)) {
    largest = displacement;
    return one.curve.at(displacement);
  }
  const double remains = permanent_share_ * largest;
  const double share = (displacement - remains) / (largest - remains);
  return share > 0 ? share * share * one.curve.at(largest) : 0;
}

double DiscreteBeamResponse::curve_force(const Direction& one, double before, double now, double* history,
                                         int stride) const {
  switch (one.unloading) {
    case Unloading::Curve:
      return shifted_force(one, now, history, stride);
    case Unloading::Quadratic:
      return quadratic_force(one, now, history, stride);
    case Unloading::Stiffness: {
      // Between both curves, which meet at the origin, with the stiffness from the force before; beyond a
      // crossing of theirs there is that of loading alone.
      const double sign = now < 0 ? -1 : 1;
      const double most = sign * one.curve.at(now);
      const double least = std::min(most, sign * one.unloading_curve.at(now));
      const double elastic = sign * (history[0] + one.unloading_stiffness * (now - before));
      history[0] = sign * std::clamp(elastic, least, most);
      return history[0];
    }
    default:
      return one.curve.at(now);
  }
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
    double tension = 0;
    double compression = 0;
    for (int i = 0; i < discrete_directions; ++i) {
      const int at = i * step.width + lane;
      step.force[at] = 0;
      if (i >= used) continue;
      const Direction& one = directions_[static_cast<std::size_t>(i)];
      const double displacement = step.displacement[at];
      const double rate = step.step > 0 ? (displacement - step.before[at]) / step.step : 0.0;
      double* const history =
          has_history() ? step.history + (discrete_history * i * step.width + lane) : nullptr;
      const double by_curve =
          one.curve.empty() ? 0 : curve_force(one, step.before[at], displacement, history, step.width);
      step.force[at] = one.force(displacement, rate, share, by_curve);
      if (kind_ == Kind::Cable) {
        const double strain = displacement / step.free_length[lane];
        step.force[at] += stress_.empty() ? axial_stiffness_ * strain : area_ * stress_.at(strain);
        step.force[at] = std::max(0.0, step.force[at]);
      }
      tension += one.tension(displacement);
      compression += one.compression(displacement);
    }
    const double most = joint_failure_ ? tension + compression : std::max(tension, compression);
    step.intact[lane] = most < 1 ? 1 : 0;
  }
}

}  // namespace crumple::elements
