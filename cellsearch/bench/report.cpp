// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <utility>

namespace cellsearch::bench {
namespace {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  std::array<char, 400> text{};
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text.data(), text.size(), pattern, arguments);
  va_end(arguments);
  return text.data();
}

const Measurement* reference_of(const Results& results) {
  for (const Measurement& measurement : results.measurements) {
    if (measurement.method == "linked-cell") return &measurement;
  }
  return nullptr;
}

}  // namespace

CsvFile::CsvFile(const std::string& name) : name_(name), stream_(name) {
  stream_ << "scene,nodes,segments,method,threads,build_ns,query_ns,bytes_per_node,pairs,hash\n"
          << std::flush;
  check();
}

void CsvFile::check() const {
  if (!stream_) throw std::runtime_error("The file " + name_ + " cannot be written.");
}

void CsvFile::write(const std::vector<Measurement>& measurements) {
  for (const Measurement& m : measurements) {
    stream_ << format("%d,%lld,%lld,%s,%d,%.3f,%.3f,%.2f,%lld,%016llx\n", m.scene,
                      static_cast<long long>(m.nodes), static_cast<long long>(m.segments), m.method.c_str(),
                      m.threads, m.build_ns, m.query_ns, m.bytes_per_node, static_cast<long long>(m.pairs),
                      static_cast<unsigned long long>(m.hash));
  }
  stream_ << std::flush;
  check();
}

std::string table(const std::string& title, const Results& results) {
  std::string text = title + "\n";
  if (!results.measurements.empty()) {
    const Measurement& first = results.measurements.front();
    text += format(
        "  %lld nodes, %lld segments, %lld pairs (%.3f per segment), hash %016llx\n",
        static_cast<long long>(first.nodes), static_cast<long long>(first.segments),
        static_cast<long long>(first.pairs),
        static_cast<double>(first.pairs) / static_cast<double>(std::max<std::int64_t>(1, first.segments)),
        static_cast<unsigned long long>(first.hash));
  }
  text += format("  %-18s %10s %10s %10s %12s %10s %8s\n", "ns per segment", "build", "query", "total",
                 "linked-cell/", "bytes/node", "repeats");
  const Measurement* reference = reference_of(results);
  for (const Measurement& m : results.measurements) {
    const std::string ratio = reference ? format("%.2f", reference->total_ns() / m.total_ns()) : "-";
    const std::string memory = m.bytes_per_node >= 0.0 ? format("%.1f", m.bytes_per_node) : "-";
    text += format("  %-18s %10.1f %10.1f %10.1f %12s %10s %8d\n", m.method.c_str(), m.build_ns, m.query_ns,
                   m.total_ns(), ratio.c_str(), memory.c_str(), m.repeats);
  }
  for (const Refusal& refusal : results.refusals) {
    text += format("  %-18s unsuited: %s\n", refusal.method.c_str(), refusal.reason.c_str());
  }
  return text;
}

double Curve::exponent() const {
  return nodes.size() < 2 ? 0.0 : fitted_exponent(nodes, seconds);
}

std::vector<Curve> curves(const std::vector<Measurement>& measurements, int scene, int threads) {
  std::vector<Curve> result;
  for (const Measurement& m : measurements) {
    if (m.scene != scene || m.threads != threads) continue;
    auto curve = std::find_if(result.begin(), result.end(),
                              [&](const Curve& other) { return other.method == m.method; });
    if (curve == result.end()) {
      result.emplace_back();
      curve = result.end() - 1;
      curve->method = m.method;
    }
    curve->nodes.push_back(static_cast<double>(m.nodes));
    curve->ns_per_segment.push_back(m.total_ns());
    curve->bytes_per_node.push_back(m.bytes_per_node);
    curve->seconds.push_back(1e-9 * m.total_ns() * static_cast<double>(m.segments));
  }
  return result;
}

std::string exponents(const std::vector<Measurement>& measurements) {
  std::set<std::pair<int, int>> groups;
  for (const Measurement& m : measurements) groups.insert({m.scene, m.threads});
  std::string text;
  for (const auto& [scene, threads] : groups) {
    for (const Curve& curve : curves(measurements, scene, threads)) {
      if (curve.nodes.size() < 2) continue;
      text += format("  %5d  %-18s %7d   N^%.3f   from %.0f to %.0f nodes\n", scene, curve.method.c_str(),
                     threads, curve.exponent(), *std::min_element(curve.nodes.begin(), curve.nodes.end()),
                     *std::max_element(curve.nodes.begin(), curve.nodes.end()));
    }
  }
  if (text.empty()) return text;
  return "Total time against the number of nodes, fitted:\n" +
         format("  %5s  %-18s %7s\n", "scene", "method", "threads") + text;
}

}  // namespace cellsearch::bench
