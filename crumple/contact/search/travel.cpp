// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/travel.hpp"

#include <algorithm>
#include <cmath>

#include "contact/search/search_calls.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {

void Travel::start(std::span<const Vec3> position, std::span<const Index> nodes) {
  earlier_legs_ = leg_ = measured_ = since_ = steps_ = 0;
  tracker_.start(view(position), nodes);
}

void Travel::update(std::span<const Vec3> position, double step_way) {
  const double way = step_way + tracker_.rounding();
  if (!std::isfinite(way)) {
    measure(position);
    // Steps that were legs already have been counted, and say where the last one began.
    if (steps_as_legs_ > 0) leg_ += steps_;
    if (steps_as_legs_ > 0 || leg_ > leg_limit_) end_leg(position);
    return;
  }
  steps_ += way;
  if (steps_as_legs_ > 0) {
    earlier_legs_ += way;
    if (--steps_as_legs_ == 0) end_leg(position);
    return;
  }
  since_ += way;
  if (measured_ + since_ <= leg_limit_) {
    leg_ = std::max(leg_, measured_ + since_);
    return;
  }
  measure(position);
  if (measured_ <= tolerances::ended_leg * leg_limit_) return;
  const bool worth_it = measured_ < tolerances::worth_measuring * steps_;
  end_leg(position);
  if (!worth_it) steps_as_legs_ = tolerances::steps_per_sample;
}

void Travel::measure(std::span<const Vec3> position) {
  tracker_.update(view(position));
  const cellsearch::Point& moved = tracker_.motion();
  measured_ = norm(Vec3{moved[0], moved[1], moved[2]});
  leg_ = std::max(leg_, measured_);
  since_ = 0;
}

void Travel::end_leg(std::span<const Vec3> position) {
  earlier_legs_ += leg_;
  leg_ = measured_ = since_ = steps_ = 0;
  steps_as_legs_ = 0;
  tracker_.start_again(view(position));
}

}  // namespace crumple::contact
