// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "output/histories/history.hpp"
#include "output/results/history_sample.hpp"

namespace crumple::output {

/// A history that LS-DYNA has, too: it says its numbers once, and the table, the text file and binout are
/// made of them. `variables` are those of the table in its order, then what only LS-DYNA's files show.
class SampledHistory : public History {
 public:
  SampledHistory(const HistoryForm& form, std::span<const Variable> variables)
      : form_(form), sample_(variables) {}

  void add_rows(const View& view, CsvFile& table) final;
  /// Takes a sample without a table.
  void measure(const View& view);
  std::vector<SampledHistory*> sampled() final { return {this}; }

  /// LS-DYNA's files are asked for: what only they show has to be found from now on.
  void complete() { is_complete_ = true; }
  bool is_complete() const { return is_complete_; }

  const HistoryForm& form() const { return form_; }
  /// What add_rows() or measure() was called for last.
  const HistoryItems& items() const { return *items_; }
  const Sample& sample() const { return sample_; }

 protected:
  virtual HistoryItems find_items(const View& view) = 0;
  /// Adds the numbers of the table's columns, item by item in the order of find_items().
  virtual void take(const View& view, Sample& sample) = 0;
  /// Adds the rest, which may cost more.
  virtual void take_rest(const View& view, Sample& sample);

 private:
  void take_columns(const View& view);

  HistoryForm form_;
  std::optional<HistoryItems> items_;
  Sample sample_;
  bool is_complete_ = false;
};

}  // namespace crumple::output
