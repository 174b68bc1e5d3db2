// SPDX-License-Identifier: BSD-3-Clause
#include "contact/travel.hpp"

#include <algorithm>

#include "contact/search_calls.hpp"

namespace crumple::contact {
void Travel::start(std::span<const Vec3> position, std::span<const Index> nodes) {
  earlier_legs_ = leg_ = 0;
  tracker_.start(view(position), nodes);
}

void Travel::update(std::span<const Vec3> position) {
  tracker_.update(view(position));
  const cellsearch::Point& moved = tracker_.motion();
  leg_ = std::max(leg_, norm(Vec3{moved[0], moved[1], moved[2]}));
  if (leg_ <= leg_limit_) return;
  earlier_legs_ += leg_;
  leg_ = 0;
  tracker_.start_again(view(position));
}

}  // namespace crumple::contact
