// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/held_step.hpp"

#include <algorithm>

namespace crumple::timeloop {
namespace {

/// An element at its limit vibrates in four to six steps, its slower modes in twenty.
constexpr long window = 20;
/// The step rises when this much more is allowed, and leaves a part of it.
constexpr double clearly_more = 1.02;
constexpr double used = 0.99;

}  // namespace

double HeldStep::next(long cycle, double last, double allowed) {
  if (last == 0) before_ = least_ = allowed;
  if (cycle % window == 0) {
    before_ = least_;
    least_ = allowed;
  }
  least_ = std::min(least_, allowed);
  if (last == 0 || allowed < last) return allowed;
  const double least = std::min(before_, least_);
  return least > clearly_more * last ? used * least : last;
}

void HeldStep::declare(domain::StateList& list) {
  list.add("least_step", "time", domain::Entity::Run, 1, std::span(&least_, 1));
  list.add("least_step_before", "time", domain::Entity::Run, 1, std::span(&before_, 1));
}

}  // namespace crumple::timeloop
