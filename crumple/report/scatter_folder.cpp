// SPDX-License-Identifier: BSD-3-Clause
#include "report/scatter_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>

#include "files/input_file.hpp"
#include "report/text_file.hpp"

namespace crumple::report {

namespace {

/// Views into the table.
struct Row {
  std::string_view time;
  std::string_view curve;
  std::string_view band;  ///< median,p5,p95
};

struct HistoryRows {
  std::string_view history;
  std::vector<Row> rows;
  std::size_t bytes = 0;
};

/// Cuts off what stands before the first comma; all of the text if there is none.
std::string_view take_cell(std::string_view& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view cell = text.substr(0, comma);
  text.remove_prefix(std::min(comma + 1, text.size()));
  return cell;
}

std::string thinned_text(const HistoryRows& history, std::size_t every) {
  std::string text = "time,curve,median,p5,p95\n";
  std::size_t point = 0;
  for (std::size_t i = 0; i < history.rows.size(); ++i, ++point) {
    const Row& row = history.rows[i];
    if (i > 0 && history.rows[i - 1].curve != row.curve) point = 0;
    const bool last = i + 1 == history.rows.size() || history.rows[i + 1].curve != row.curve;
    if (point % every == 0 || last)
      fmt::format_to(std::back_inserter(text), "{},{},{}\n", row.time, row.curve, row.band);
  }
  return text;
}

/// The rows by history, in the order in which the table has them.
std::vector<HistoryRows> rows_by_history(std::string_view table, int& runs) {
  std::vector<HistoryRows> histories;
  while (table.find('\n') != std::string_view::npos) {
    std::string_view rest = table.substr(0, table.find('\n'));
    table.remove_prefix(rest.size() + 1);
    const std::size_t size = rest.size();
    if (std::ranges::count(rest, ',') != std::ranges::count(bands_header, ',')) continue;
    Row row;
    row.time = take_cell(rest);
    row.curve = take_cell(rest);
    const std::string_view count = take_cell(rest);
    std::from_chars(count.data(), count.data() + count.size(), runs);
    take_cell(rest);  // the unperturbed run's own value, which its histories have
    row.band = rest;
    const std::string_view name = row.curve.substr(0, row.curve.find('.'));
    auto place = std::ranges::find(histories, name, &HistoryRows::history);
    if (place == histories.end()) place = histories.insert(place, {name, {}, 0});
    place->rows.push_back(row);
    place->bytes += size;
  }
  return histories;
}

}  // namespace

std::string scatter_run_name(int number) {
  return fmt::format("run_{:03}", number);
}

bool is_scatter_folder(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder / scatter_run_name(0), ignored)) return false;
  return read_start(folder / bands_file, bands_header.size()) == bands_header;
}

std::optional<double> perturbation_of(const std::filesystem::path& folder) {
  // Any run may have failed before it could write its record.
  for (int number = 1;; ++number) {
    const std::filesystem::path run = folder / scatter_run_name(number);
    std::error_code ignored;
    if (!std::filesystem::is_directory(run, ignored)) return std::nullopt;
    if (!std::filesystem::is_regular_file(run / "run.json", ignored)) continue;
    const auto record = nlohmann::json::parse(read_file(run / "run.json"), nullptr, false);
    if (!record.is_object()) continue;
    const auto found = record.find("perturbation");
    if (found != record.end() && found->is_number() && found->get<double>() > 0) return found->get<double>();
  }
}

BandTable split_bands(std::string_view table, std::size_t most) {
  BandTable split;
  if (!table.starts_with(bands_header)) return split;
  table.remove_prefix(bands_header.size());
  for (const HistoryRows& history : rows_by_history(table, split.runs)) {
    const std::size_t every = std::max<std::size_t>(1, (history.bytes + most - 1) / most);
    split.histories.push_back(
        {std::string(history.history), thinned_text(history, every), static_cast<int>(every)});
  }
  return split;
}

}  // namespace crumple::report
