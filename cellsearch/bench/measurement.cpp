// SPDX-License-Identifier: BSD-3-Clause
#include "measurement.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "cellsearch/error.hpp"
#include "memory_counter.hpp"

namespace cellsearch::bench {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// A method that runs, with what it has shown so far.
struct Running {
  Measurement measurement{};
  std::unique_ptr<Contestant> contestant{};
  std::vector<double> build_seconds{};
  std::vector<double> query_seconds{};
  double used_seconds = 0.0;
};

std::int64_t bytes_of(const Candidates& candidates) {
  return static_cast<std::int64_t>(candidates.first.size() * sizeof(Offset) +
                                   candidates.node.size() * sizeof(Index));
}

/// Two searches that are not timed: the first finds the memory, the second shows how much is held at most
/// when the object has been used before.
void start(Running& running, const ContestantKind& kind, const Scene& scene, int threads) {
  MemoryCounter::start();
  try {
    running.contestant = kind.make(threads);
    for (int search = 0; search < 2; ++search) {
      MemoryCounter::reset_peak();
      running.contestant->build(scene);
      const Candidates& found = running.contestant->query();
      const std::int64_t working = MemoryCounter::peak() - bytes_of(found);
      Measurement& measurement = running.measurement;
      measurement.pairs = found.pairs();
      if (search == 0) measurement.hash = hash_of(found, kind.name);
      measurement.bytes_per_node = MemoryCounter::available()
                                       ? static_cast<double>(working) / static_cast<double>(measurement.nodes)
                                       : -1.0;
      running.contestant->forget();
    }
  } catch (...) {
    MemoryCounter::stop();
    throw;
  }
  MemoryCounter::stop();
}

void repeat(Running& running, const Scene& scene) {
  const double begin = now();
  running.contestant->build(scene);
  const double built = now();
  const Candidates& found = running.contestant->query();
  const double end = now();
  if (found.pairs() != running.measurement.pairs) {
    throw WrongAnswer("Method " + running.measurement.method + " found " +
                      std::to_string(running.measurement.pairs) + " pairs at first and " +
                      std::to_string(found.pairs()) + " when it was repeated.");
  }
  running.contestant->forget();
  running.build_seconds.push_back(built - begin);
  running.query_seconds.push_back(end - built);
  running.used_seconds += end - begin;
}

void check_agreement(const Measurement& first, const Measurement& other) {
  if (first.pairs == other.pairs && first.hash == other.hash) return;
  throw WrongAnswer("Scene " + std::to_string(first.scene) + " with " + std::to_string(first.nodes) +
                    " nodes: " + first.method + " finds " + std::to_string(first.pairs) + " pairs (hash " +
                    std::to_string(first.hash) + "), but " + other.method + " finds " +
                    std::to_string(other.pairs) + " (hash " + std::to_string(other.hash) + ").");
}

}  // namespace

std::uint64_t hash_of(const Candidates& candidates, const std::string& method) {
  std::uint64_t sum = 0;
  for (Index segment = 0; segment < candidates.segments(); ++segment) {
    Index last = -1;
    for (const Index node : candidates.of(segment)) {
      if (node <= last) {
        throw WrongAnswer("Method " + method + ": the row of segment " + std::to_string(segment) +
                          " is not strictly ascending.");
      }
      last = node;
      // Each pair is scrambled alone and all are added up, so that their order does not matter (the finalizer
      // of SplitMix64: Steele, Lea & Flood, OOPSLA 2014).
      std::uint64_t pair = (static_cast<std::uint64_t>(segment) << 32) + static_cast<std::uint64_t>(node);
      pair += 0x9E3779B97F4A7C15u;
      pair = (pair ^ (pair >> 30)) * 0xBF58476D1CE4E5B9u;
      pair = (pair ^ (pair >> 27)) * 0x94D049BB133111EBu;
      sum += pair ^ (pair >> 31);
    }
  }
  return sum;
}

Results measure(const scenes::Mesh& mesh, int scene_number, const std::vector<ContestantKind>& kinds,
                const Protocol& protocol) {
  const Scene scene = mesh.scene();
  Results results;
  std::vector<Running> all;
  for (const ContestantKind& kind : kinds) {
    Running running;
    running.measurement.scene = scene_number;
    running.measurement.nodes = static_cast<std::int64_t>(mesh.node_count());
    running.measurement.segments = static_cast<std::int64_t>(mesh.segment_count());
    running.measurement.method = kind.name;
    running.measurement.threads = protocol.threads;
    protocol.progress(kind.name + ", first search");
    try {
      start(running, kind, scene, protocol.threads);
    } catch (const Error& error) {
      results.refusals.push_back({kind.name, error.what()});
      continue;
    }
    if (!all.empty()) check_agreement(all.front().measurement, running.measurement);
    all.push_back(std::move(running));
  }
  for (int round = 0; round < protocol.repeats; ++round) {
    for (Running& running : all) {
      if (round > 0 && running.used_seconds > protocol.seconds) continue;
      protocol.progress(running.measurement.method + ", repeat " + std::to_string(round + 1) + " of " +
                        std::to_string(protocol.repeats));
      repeat(running, scene);
    }
  }
  for (Running& running : all) {
    Measurement& measurement = running.measurement;
    const double ns_per_segment = 1e9 / static_cast<double>(std::max<std::int64_t>(1, measurement.segments));
    measurement.build_ns = ns_per_segment * median(running.build_seconds);
    measurement.query_ns = ns_per_segment * median(running.query_seconds);
    measurement.repeats = static_cast<int>(running.build_seconds.size());
    results.measurements.push_back(measurement);
  }
  return results;
}

double fitted_exponent(const std::vector<double>& nodes, const std::vector<double>& times) {
  const double count = static_cast<double>(nodes.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    mean_x += std::log(nodes[k]) / count;
    mean_y += std::log(times[k]) / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double dx = std::log(nodes[k]) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(times[k]) - mean_y);
  }
  return xy / xx;
}

}  // namespace cellsearch::bench
