// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/time_warp.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace crumple::compare {

namespace {

enum class Step : std::uint8_t { First, Second, Both };

/// The costs of one sample of the first curve with those of the second that are in the band, and the steps
/// that lead there. Column k of row i is sample i - (band - 1) + k of the second curve.
class Table {
 public:
  Table(std::span<const double> first, std::span<const double> second, std::size_t band)
      : first_(first),
        second_(second),
        reach_(std::clamp<std::size_t>(band, 1, first.size()) - 1),
        width_(2 * reach_ + 1),
        steps_(first.size() * width_, Step::Both) {
    std::vector<double> before(width_ + 1, infinity);
    std::vector<double> now(width_ + 1, infinity);
    for (std::size_t row = 0; row < first.size(); ++row) {
      fill(row, before, now);
      std::swap(before, now);
    }
  }

  Step step_to(std::size_t row, std::size_t sample) const {
    return steps_[row * width_ + sample + reach_ - row];
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void fill(std::size_t row, const std::vector<double>& before, std::vector<double>& now) {
    std::fill(now.begin(), now.end(), infinity);
    const std::size_t begin = row > reach_ ? row - reach_ : 0;
    const std::size_t end = std::min(first_.size(), row + reach_ + 1);
    for (std::size_t sample = begin; sample < end; ++sample) {
      const std::size_t column = sample + reach_ - row;
      const double difference = first_[row] - second_[sample];
      // A row further on, the same sample of the second curve is one column further back.
      const double by_first = row > 0 ? before[column + 1] : infinity;
      const double by_second = column > 0 ? now[column - 1] : infinity;
      const double by_both = row > 0 && sample > 0 ? before[column] : infinity;
      double least = by_first;
      Step step = Step::First;
      if (by_second < least) {
        least = by_second;
        step = Step::Second;
      }
      if (by_both < least) {
        least = by_both;
        step = Step::Both;
      }
      if (row == 0 && sample == 0) least = 0;
      now[column] = least + difference * difference;
      steps_[row * width_ + column] = step;
    }
  }

  std::span<const double> first_;
  std::span<const double> second_;
  std::size_t reach_;
  std::size_t width_;
  std::vector<Step> steps_;
};

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> warping_path(std::span<const double> first,
                                                              std::span<const double> second,
                                                              std::size_t band) {
  const Table table(first, second, band);
  std::size_t row = first.size() - 1;
  std::size_t sample = second.size() - 1;
  std::vector<std::pair<std::size_t, std::size_t>> path{{row, sample}};
  while (row > 0 || sample > 0) {
    Step step = table.step_to(row, sample);
    if (row == 0) step = Step::Second;
    if (sample == 0) step = Step::First;
    if (step != Step::Second) --row;
    if (step != Step::First) --sample;
    path.emplace_back(row, sample);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace crumple::compare
