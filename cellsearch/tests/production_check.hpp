// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "cellsearch/search.hpp"
#include "cellsearch/verify.hpp"

namespace cellsearch {

/// Finds the candidates of `scene` with `search` and says how they differ from `expected`; "" if they do not.
inline std::string difference_from(const Candidates& expected, Search& search, const Scene& scene) {
  const Candidates& found = search.find(scene);
  const std::optional<Difference> difference = first_difference(found, expected);
  if (difference) return difference->describe();
  return found == expected ? "" : "The rows are the same, but not the arrays.";
}

/// What brute force finds; oracle_test.cpp holds it to the definition.
inline Candidates by_brute_force(const Scene& scene, const Settings& like = {}) {
  Search search({.method = Method::BruteForce, .domain = like.domain});
  search.find(scene);
  return search.take();
}

/// The same of both at once.
inline std::string difference_from_brute_force(Search& search, const Scene& scene) {
  return difference_from(by_brute_force(scene, search.settings()), search, scene);
}

}  // namespace cellsearch
