// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/verify.hpp"

#include <algorithm>
#include <span>

namespace cellsearch {

std::string Difference::describe() const {
  if (node < 0)
    return "The results have different numbers of segments; one ends before segment " +
           std::to_string(segment) + ".";
  return "Segment " + std::to_string(segment) + ": node " + std::to_string(node) +
         (missing ? " is a candidate but was not found." : " was found but is no candidate.");
}

std::optional<Difference> first_difference(const Candidates& found, const Candidates& expected) {
  const Index shorter = std::min(found.segments(), expected.segments());
  for (Index segment = 0; segment < shorter; ++segment) {
    const std::span<const Index> got = found.of(segment);
    const std::span<const Index> want = expected.of(segment);
    const auto [got_at, want_at] = std::mismatch(got.begin(), got.end(), want.begin(), want.end());
    if (got_at == got.end() && want_at == want.end()) continue;
    // Rows ascend, so the smaller of the two numbers is the one that the other row lacks.
    const bool missing = got_at == got.end() || (want_at != want.end() && *want_at < *got_at);
    return Difference{segment, missing ? *want_at : *got_at, missing};
  }
  if (found.segments() != expected.segments()) return Difference{shorter, -1, false};
  return std::nullopt;
}

std::optional<Difference> verify(const Candidates& found, const Scene& scene, const Settings& settings) {
  Settings oracle_settings = settings;
  oracle_settings.method = Method::BruteForce;
  Search oracle(oracle_settings);
  return first_difference(found, oracle.find(scene));
}

}  // namespace cellsearch
