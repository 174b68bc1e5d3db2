// SPDX-License-Identifier: BSD-3-Clause
#include "report/history_text.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace crumple::report {

std::string whole_rows(std::string text) {
  text.resize(text.find_last_of('\n') + 1);
  return text;
}

ThinnedHistory thin_history(std::string text, std::size_t most) {
  if (text.size() <= most) return {std::move(text), 1};
  const std::string_view all = text;
  // Start of each moment's rows.
  std::vector<std::size_t> starts;
  std::string_view before;
  const std::size_t header = all.find('\n') + 1;
  for (std::size_t at = header; at != 0 && at < all.size(); at = all.find('\n', at) + 1) {
    const std::string_view time = all.substr(at, all.find(',', at) - at);
    if (starts.empty() || time != before) starts.push_back(at);
    before = time;
  }
  starts.push_back(all.size());
  const std::size_t every = (text.size() + most - 1) / most;
  ThinnedHistory thinned{text.substr(0, header), static_cast<int>(every)};
  for (std::size_t moment = 0; moment + 1 < starts.size(); ++moment)
    if (moment % every == 0 || moment + 2 == starts.size())
      thinned.text += all.substr(starts[moment], starts[moment + 1] - starts[moment]);
  return thinned;
}

}  // namespace crumple::report
