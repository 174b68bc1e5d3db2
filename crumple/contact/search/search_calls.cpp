// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/search_calls.hpp"

#include <string>

#include "base/error.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {

cellsearch::Positions view(std::span<const Vec3> values) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return std::span<const double>(&values.front().x, 3 * values.size());
}

std::vector<Vec3> positions_at_search(std::span<const Vec3> position, std::span<const Index> nodes,
                                      std::span<const double> searched) {
  std::vector<Vec3> found(position.begin(), position.end());
  for (std::size_t i = 0; i < nodes.size() && 3 * i + 2 < searched.size(); ++i)
    found[nodes[i]] = {searched[3 * i], searched[3 * i + 1], searched[3 * i + 2]};
  return found;
}

double margin_of(const Surface& surface, const model::SearchSettings& settings) {
  if (settings.expansion <= 0) return tolerances::margin_over_edge * surface.mean_edge;
  const double largest_distance = 2 * surface.largest_half_thickness;
  if (settings.expansion <= largest_distance)
    throw Error("The territory expansion of the contact search is " + std::to_string(settings.expansion) +
                ", but it must exceed the largest contact distance, " + std::to_string(largest_distance) +
                ".");
  return settings.expansion - largest_distance;
}

void rethrow(const cellsearch::Error& error, const Surface& surface) {
  if (error.kind() != cellsearch::ErrorKind::NonFiniteCoordinate) throw Error(error.what());
  throw NumericalError("The position of node " +
                       std::to_string(surface.node_id[surface.place[error.index()]]) +
                       " is not a finite number any more.");
}

}  // namespace crumple::contact
