// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "contestant.hpp"
#include "scenes.hpp"

namespace cellsearch::bench {

/// The figures of one method on one scene.
struct Measurement {
  int scene = 0;
  std::int64_t nodes = 0;
  std::int64_t segments = 0;
  std::string method{};
  int threads = 1;
  double build_ns = 0.0;        ///< per segment, median
  double query_ns = 0.0;        ///< per segment, median
  double bytes_per_node = 0.0;  ///< most held during a search, less the answer; < 0: not counted
  std::int64_t pairs = 0;
  std::uint64_t hash = 0;  ///< of the set of pairs
  int repeats = 0;         ///< measurements behind the medians

  double total_ns() const { return build_ns + query_ns; }
};

/// A method that refuses a scene.
struct Refusal {
  std::string method;
  std::string reason;
};

struct Results {
  std::vector<Measurement> measurements{};
  std::vector<Refusal> refusals{};
};

/// How to measure.
struct Protocol {
  int threads = 1;
  int repeats = 5;
  double seconds = 20.0;
  std::function<void(const std::string&)> progress{};  ///< told what runs
};

/// The answers of two methods differ, or one is not sorted: nothing that was measured means anything.
class WrongAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A number that depends on the set of pairs only. Throws WrongAnswer if rows are not strictly ascending.
std::uint64_t hash_of(const Candidates& candidates, const std::string& method);

/// Runs all `kinds` on the mesh. Each gets an object of its own, which it keeps, and two searches to find its
/// memory; then all are measured in turns, again and again. Throws WrongAnswer.
Results measure(const scenes::Mesh& mesh, int scene, const std::vector<ContestantKind>& kinds,
                const Protocol& protocol);

/// Fits total time = a N^k by least squares in logarithms. `nodes` and `times` have equal lengths, at
/// least 2.
double fitted_exponent(const std::vector<double>& nodes, const std::vector<double>& times);

}  // namespace cellsearch::bench
