// SPDX-License-Identifier: BSD-3-Clause
#include "output/d3plot/d3plot_words.hpp"

#include <array>

namespace crumple::output {

void D3plotWords::text(std::string_view value, std::size_t words) {
  for (std::size_t word = 0; word < words; ++word) {
    std::array<char, sizeof(std::uint32_t)> characters{' ', ' ', ' ', ' '};
    for (std::size_t i = 0; i < characters.size(); ++i)
      if (const std::size_t at = characters.size() * word + i; at < value.size()) characters[i] = value[at];
    words_.push_back(std::bit_cast<std::uint32_t>(characters));
  }
}

}  // namespace crumple::output
