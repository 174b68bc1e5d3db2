// SPDX-License-Identifier: BSD-3-Clause
#include "elements/line/discrete_law.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "math/relaxation.hpp"

namespace crumple::elements {
namespace {

double steepest(const model::Curve& curve) {
  double slope = 0;
  for (std::size_t i = 1; i < curve.abscissa.size(); ++i)
    slope = std::max(slope, std::fabs((curve.ordinate[i] - curve.ordinate[i - 1]) /
                                      (curve.abscissa[i] - curve.abscissa[i - 1])));
  return slope;
}

/// Largest amount of the ordinates.
double largest(const model::Curve& curve) {
  double most = 0;
  for (const double y : curve.ordinate) most = std::max(most, std::fabs(y));
  return most;
}

/// The law by its numbers and, where it has them, curves of the model.
struct Parts {
  double stiffness = 0;
  double damping = 0;
  double yield_force = 0;
  double plastic_modulus = 0;
  double relaxing = 0;
  double decay = 0;
  double cut_off = 0;
  double cut_off_force = 0;
  double side = 0;
  const model::Curve* spring = nullptr;
  const model::Curve* damper = nullptr;
  const model::Curve* rate_factor = nullptr;
};

struct PartsOf {
  const model::Model& model;

  Parts operator()(const model::LinearSpring& law) const { return {.stiffness = law.stiffness}; }
  Parts operator()(const model::LinearDamper& law) const { return {.damping = law.damping}; }
  Parts operator()(const model::ElastoplasticSpring& law) const {
    return {
        .stiffness = law.stiffness,
        .yield_force = law.yield_force,
        .plastic_modulus = law.stiffness * law.tangent_stiffness / (law.stiffness - law.tangent_stiffness)};
  }
  Parts operator()(const model::NonlinearSpring& law) const {
    Parts parts;
    parts.spring = &model.curves[law.curve];
    parts.stiffness = steepest(*parts.spring);
    if (law.rate_curve == no_index) return parts;
    parts.rate_factor = &model.curves[law.rate_curve];
    parts.stiffness *= std::max(1.0, largest(*parts.rate_factor));
    return parts;
  }
  Parts operator()(const model::NonlinearDamper& law) const {
    Parts parts;
    parts.damper = &model.curves[law.curve];
    parts.damping = steepest(*parts.damper);
    return parts;
  }
  Parts operator()(const model::MaxwellSpring& law) const {
    return {.stiffness = law.stiffness,
            .relaxing = law.stiffness - law.final_stiffness,
            .decay = law.decay,
            .cut_off = law.cut_off,
            .cut_off_force = law.cut_off_force};
  }
  Parts operator()(const model::InelasticSpring& law) const {
    Parts parts;
    parts.side = law.tension ? 1 : -1;
    parts.spring = &model.curves[law.curve];
    parts.stiffness = std::max(law.unloading_stiffness, steepest(*parts.spring));
    return parts;
  }
};

}  // namespace

double SlopedCurve::at(double x) const {
  const double* const above = std::upper_bound(x_ + 1, x_ + size_ - 1, x);
  const auto i = above - x_;
  const double share = (x - x_[i - 1]) / (x_[i] - x_[i - 1]);
  return y_[i - 1] + share * (y_[i] - y_[i - 1]);
}

double SlopedCurve::inverse(double y) const {
  const double* const above = std::upper_bound(y_ + 1, y_ + size_ - 1, y);
  const auto i = above - y_;
  const double share = (y - y_[i - 1]) / (y_[i] - y_[i - 1]);
  return x_[i - 1] + share * (x_[i] - x_[i - 1]);
}

std::vector<double> discrete_law_numbers(const model::SpringLaw& law, const model::Model& model) {
  const Parts parts = std::visit(PartsOf{model}, law);
  std::vector<double> numbers{parts.stiffness,       parts.damping,       parts.yield_force,
                              parts.plastic_modulus, parts.relaxing,      parts.decay,
                              parts.cut_off,         parts.cut_off_force, parts.side};
  for (const model::Curve* const curve : {parts.spring, parts.damper, parts.rate_factor}) {
    numbers.push_back(curve == nullptr ? 0 : static_cast<double>(curve->abscissa.size()));
    if (curve == nullptr) continue;
    numbers.insert(numbers.end(), curve->abscissa.begin(), curve->abscissa.end());
    numbers.insert(numbers.end(), curve->ordinate.begin(), curve->ordinate.end());
  }
  return numbers;
}

DiscreteLaw::DiscreteLaw(const std::vector<double>& numbers)
    : stiffness_(numbers[0]),
      damping_(numbers[1]),
      yield_force_(numbers[2]),
      plastic_modulus_(numbers[3]),
      relaxing_(numbers[4]),
      decay_(numbers[5]),
      cut_off_(numbers[6]),
      cut_off_force_(numbers[7]),
      side_(numbers[8]) {
  std::size_t at = 9;
  for (SlopedCurve* const curve : {&spring_, &damper_, &rate_factor_}) {
    const auto size = static_cast<std::size_t>(numbers[at++]);
    *curve = SlopedCurve(numbers.data() + at, size);
    at += 2 * size;
  }
}

double DiscreteLaw::plastic_force(double deformation, DiscreteHistory& history) const {
  const double trial = stiffness_ * (deformation - history.plastic);
  const double beyond = std::fabs(trial) - (yield_force_ + plastic_modulus_ * history.hardening);
  if (beyond <= 0) return trial;
  const double flow = beyond / (stiffness_ + plastic_modulus_);
  history.hardening += flow;
  history.plastic += std::copysign(flow, trial);
  return trial - std::copysign(stiffness_ * flow, trial);
}

/// The spring in series with the damper has relaxed by what the damper has moved, `history.plastic`.
double DiscreteLaw::relaxing_force(const DiscreteMotion& motion, DiscreteHistory& history) const {
  if (motion.time >= cut_off_) return cut_off_force_;
  const math::Relaxation step = math::relaxation(1, decay_, motion.step);
  const double before = motion.deformation - motion.change - history.plastic;
  const double elastic = (1 - step.lost) * before + step.gained * motion.change;
  history.plastic = motion.deformation - elastic;
  return (stiffness_ - relaxing_) * motion.deformation + relaxing_ * elastic;
}

/// Elastic from the deformation that remains, `history.plastic`, up to the curve, which moves it.
double DiscreteLaw::one_sided_force(double deformation, DiscreteHistory& history) const {
  const double along = side_ * deformation;
  const double elastic = stiffness_ * (along - history.plastic);
  if (elastic <= 0) return 0;
  const double most = spring_.at(along);
  if (elastic <= most) return side_ * elastic;
  history.plastic = along - most / stiffness_;
  return side_ * most;
}

double DiscreteLaw::force(const DiscreteMotion& motion, DiscreteHistory& history) const {
  if (yield_force_ > 0) return plastic_force(motion.deformation, history);
  if (cut_off_ > 0) return relaxing_force(motion, history);
  if (side_ != 0) return one_sided_force(motion.deformation, history);
  if (!damper_.empty()) return damper_.at(motion.rate);
  if (damping_ > 0) return damping_ * motion.rate;
  if (spring_.empty()) return stiffness_ * motion.deformation;
  const double factor = rate_factor_.empty() ? 1.0 : rate_factor_.at(motion.rate);
  return factor * spring_.at(motion.deformation);
}

}  // namespace crumple::elements
