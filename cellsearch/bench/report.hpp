// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "measurement.hpp"

namespace cellsearch::bench {

/// The results as comma-separated values, one row per measurement. Rows are on disk as soon as they are
/// there: an interrupted run keeps what it has.
class CsvFile {
 public:
  /// Writes the heading. Throws std::runtime_error if the file cannot be written.
  explicit CsvFile(const std::string& name);

  /// Appends rows. Throws std::runtime_error if that fails.
  void write(const std::vector<Measurement>& measurements);

 private:
  void check() const;

  std::string name_;
  std::ofstream stream_;
};

/// The results of one scene as a table for people. Times are compared with the method linked-cell, if it is
/// among them.
std::string table(const std::string& title, const Results& results);

/// How the total time of each method grows with the number of nodes, for methods that were measured at two
/// sizes or more; empty if there is none.
std::string exponents(const std::vector<Measurement>& measurements);

/// The measurements of one method over the number of nodes, in the order in which methods first appear.
struct Curve {
  std::string method{};
  std::vector<double> nodes{};
  std::vector<double> ns_per_segment{};
  std::vector<double> bytes_per_node{};
  std::vector<double> seconds{};

  /// Of the total time against N; 0 for less than two points.
  double exponent() const;
};

/// The curves of a scene for a number of threads.
std::vector<Curve> curves(const std::vector<Measurement>& measurements, int scene, int threads);

}  // namespace cellsearch::bench
