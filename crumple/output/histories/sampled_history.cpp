// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/sampled_history.hpp"

namespace crumple::output {

void SampledHistory::take_rest(const View&, Sample&) {}

void SampledHistory::take_columns(const View& view) {
  if (!items_) items_ = find_items(view);
  sample_.start(view.domain.clock.time, view.domain.clock.cycle);
  take(view, sample_);
}

void SampledHistory::measure(const View& view) {
  take_columns(view);
  if (is_complete_) take_rest(view, sample_);
}

void SampledHistory::add_rows(const View& view, CsvFile& table) {
  take_columns(view);
  std::string row;
  const std::size_t rows = items_->of_model ? 1 : items_->ids.size();
  for (std::size_t item = 0; item < rows; ++item) {
    row.clear();
    const auto add = [&](const auto& value) { fmt::format_to(std::back_inserter(row), ",{}", value); };
    if (!items_->of_model) add(items_->ids[item]);
    if (!items_->words.empty()) add(items_->words[item]);
    for (std::size_t i = 0; i < sample_.variables().size(); ++i)
      if (!sample_.variables()[i].column.empty()) add(sample_.of(i)[item]);
    table.add_row(fmt::format("{}{}", sample_.time(), row));
  }
  if (is_complete_) take_rest(view, sample_);
}

}  // namespace crumple::output
