// SPDX-License-Identifier: BSD-3-Clause
// *DEFINE_CURVE_FUNCTION.
//
// The run knows curves of points alone, so that the function is sampled: in equal intervals, each of them
// halved as long as the straight line between its ends is off. That is seen at three places without a common
// divisor, so that a wave which vanishes at one is seen at another. Where the function jumps the smallest
// interval keeps the jump; one that needs more such intervals, points or time than there are is an error.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "deck/build/build.hpp"
#include "deck/format/expression.hpp"

namespace crumple::deck {

namespace {

class FunctionSampler {
 public:
  FunctionSampler(const RawCurve& raw, double end_time, Report& report)
      : raw_(&raw), end_time_(end_time), report_(&report) {}

  model::Curve run();

 private:
  static constexpr int intervals = 128;
  static constexpr int most_halvings = 13;
  static constexpr std::size_t most_points = 1000000;
  static constexpr int most_jumps = 100;
  static constexpr std::size_t most_work = 200000000;  ///< characters evaluated: some seconds
  static constexpr double tolerance = 1e-5;            ///< of the largest value

  double value_at(double time);
  void give_up();
  bool is_straight(double from, double at_from, double to, double at_to);
  void refine(double from, double at_from, double to, double at_to, int halvings);

  const RawCurve* raw_;
  double end_time_;
  Report* report_;
  model::Curve curve_;
  double largest_ = 0;
  int jumps_ = 0;
  std::size_t work_ = 0;
  bool failed_ = false;
};

double FunctionSampler::value_at(double time) {
  if (failed_) return 0;
  const auto find = [&](std::string_view name) -> std::optional<Number> {
    if (name == "TIME") return Number{time, false};
    if (name == "PI") return Number{std::numbers::pi, false};
    if (name == "DTOR") return Number{std::numbers::pi / 180, false};
    if (name == "RTOD") return Number{180 / std::numbers::pi, false};
    return std::nullopt;
  };
  work_ += raw_->function.size();
  const Evaluated result = evaluate(raw_->function, find, WholeNumbers::AsReal);
  if (result.fault.empty()) return result.number.value;
  failed_ = true;
  report_->error(
      raw_->where, "function",
      fmt::format("read \"{}\", but at time {} {}; a function has numbers, parameters, functions, TIME "
                  "and PI",
                  raw_->function, time, result.fault));
  return 0;
}

void FunctionSampler::give_up() {
  if (failed_) return;
  failed_ = true;
  report_->error(
      raw_->where, "function",
      fmt::format("\"{}\" changes too fast or is too long to become a curve of {} points until the end "
                  "time {}; give its points with *DEFINE_CURVE",
                  raw_->function, most_points, end_time_));
}

bool FunctionSampler::is_straight(double from, double at_from, double to, double at_to) {
  for (const double part : {0.5, 0.29, 0.73}) {
    const double value = value_at(from + part * (to - from));
    largest_ = std::max(largest_, std::fabs(value));
    if (std::fabs(value - (at_from + part * (at_to - at_from))) > tolerance * largest_) return false;
  }
  return true;
}

void FunctionSampler::refine(double from, double at_from, double to, double at_to, int halvings) {
  const bool is_bent = !failed_ && !is_straight(from, at_from, to, at_to);
  const bool is_jump = is_bent && halvings == most_halvings;
  jumps_ += is_jump ? 1 : 0;
  if (jumps_ > most_jumps || curve_.abscissa.size() > most_points || work_ > most_work) give_up();
  if (is_bent && !is_jump && !failed_) {
    const double middle = from + 0.5 * (to - from);
    const double at_middle = value_at(middle);
    refine(from, at_from, middle, at_middle, halvings + 1);
    refine(middle, at_middle, to, at_to, halvings + 1);
    return;
  }
  if (to <= curve_.abscissa.back()) return;  // there is no number between
  curve_.abscissa.push_back(to);
  curve_.ordinate.push_back(at_to);
}

model::Curve FunctionSampler::run() {
  curve_.id = raw_->curve.id;
  double from = 0;
  double at_from = value_at(from);
  curve_.abscissa.push_back(from);
  curve_.ordinate.push_back(at_from);
  for (int i = 0; i <= intervals; ++i)
    largest_ = std::max(largest_, std::fabs(value_at(end_time_ * (static_cast<double>(i) / intervals))));
  for (int i = 1; i <= intervals; ++i) {
    const double to = end_time_ * (static_cast<double>(i) / intervals);
    const double at_to = value_at(to);
    refine(from, at_from, to, at_to, 0);
    from = to;
    at_from = at_to;
  }
  return curve_;
}

}  // namespace

model::Curve sample_function(const RawCurve& raw, double end_time, Report& report) {
  return FunctionSampler(raw, end_time, report).run();
}

}  // namespace crumple::deck
