// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "model/output_requests.hpp"

namespace crumple::output {

/// A variable of a history: what it is called in our table and in LS-DYNA's files; either may be empty.
struct Variable {
  std::string_view column;
  std::string_view name;
  bool whole = false;  ///< a whole number
};

/// What a history's numbers belong to; the same over a whole run.
struct HistoryItems {
  bool of_model = false;           ///< one row a time, without an id
  std::vector<UserId> ids;         ///< one row a time for each
  std::vector<std::string> words;  ///< beside the ids in our table; may be empty
  std::vector<std::string> titles;
  bool own_ids = false;  ///< binout has the ids among the marks or the variables instead
  /// What else binout says of them.
  std::vector<std::pair<std::string_view, std::vector<std::int64_t>>> marks;
  std::vector<std::pair<std::string_view, std::string>> texts;
};

/// The numbers of a history at one time: what its table, LS-DYNA's text file and binout all show.
class Sample {
 public:
  explicit Sample(std::span<const Variable> variables);

  /// Forgets the numbers.
  void start(double time, long cycle);
  /// Appends one to each of the variables from this one on.
  void add_item(std::initializer_list<double> values, std::size_t first = 0);

  /// Of one variable by its name in LS-DYNA's files, which it must have; one for each item unless it says so.
  std::vector<double>& of(std::string_view name);
  const std::vector<double>& of(std::string_view name) const;
  const std::vector<double>& of(std::size_t variable) const { return values_[variable]; }

  double time() const { return time_; }
  long cycle() const { return cycle_; }
  std::span<const Variable> variables() const { return variables_; }

 private:
  std::size_t place_of(std::string_view name) const;

  std::span<const Variable> variables_;
  std::vector<std::vector<double>> values_;  ///< by variable
  double time_ = 0;                          ///< [time]
  long cycle_ = 0;
};

/// How LS-DYNA calls and prints a history.
struct HistoryForm {
  model::HistoryFile file;
  std::string_view name;     ///< of the text file
  std::string_view branch;   ///< of binout, without the first slash
  std::string_view heading;  ///< lines of the text file before the first time
  void (*print)(const HistoryItems& items, const Sample& sample, std::string& text);
};

}  // namespace crumple::output
