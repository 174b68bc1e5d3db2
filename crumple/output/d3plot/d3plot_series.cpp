// SPDX-License-Identifier: BSD-3-Clause
#include "output/d3plot/d3plot_series.hpp"

#include <chrono>

#include "output/d3plot/d3plot_geometry.hpp"

namespace crumple::output {

namespace {

std::int64_t seconds_since_1970() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::seconds>(now).count();
}

}  // namespace

D3plotSeries::D3plotSeries(const std::filesystem::path& folder, const View& view, std::size_t file_words,
                           Opening opening)
    : family_(folder, d3plot_geometry(view, seconds_since_1970()), file_words, opening), state_(view) {}

}  // namespace crumple::output
