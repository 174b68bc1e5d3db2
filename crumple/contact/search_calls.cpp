// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search_calls.hpp"

#include <string>

#include "base/error.hpp"

namespace crumple::contact {

cellsearch::Positions view(std::span<const Vec3> values) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return std::span<const double>(&values.front().x, 3 * values.size());
}

void rethrow(const cellsearch::Error& error, const Surface& surface) {
  if (error.kind() != cellsearch::ErrorKind::NonFiniteCoordinate) throw Error(error.what());
  throw NumericalError("The position of node " +
                       std::to_string(surface.node_id[surface.place[error.index()]]) +
                       " is not a finite number any more.");
}

}  // namespace crumple::contact
