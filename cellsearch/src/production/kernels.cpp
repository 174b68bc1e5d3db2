// SPDX-License-Identifier: BSD-3-Clause
#include "production/kernels.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "production/kernel_tables.hpp"

namespace cellsearch::production {

const Kernels& kernels(InstructionSet set) {
  switch (set) {
#ifdef CELLSEARCH_X86
    case InstructionSet::Avx512:
      return avx512_kernels();
    case InstructionSet::Avx2:
      return avx2_kernels();
#endif
    default:
      return portable_kernels();
  }
}

Index* reserve(Array<Index>& numbers, std::size_t used, std::size_t more) {
  if (numbers.size() < used + more) numbers.resize(std::max(used + more, used + used / 2));
  return numbers.data() + used;
}

void trim(Array<Index>& numbers, std::size_t used) {
  numbers.resize(used);
}

void sort_row(Index* begin, Index* end) {
  constexpr std::size_t most_words = 512;
  const auto [least, most] = std::minmax_element(begin, end);
  const std::size_t count = static_cast<std::size_t>(end - begin);
  if (count == 0) return;
  const Index base = *least;
  const std::size_t words = (static_cast<std::size_t>(*most) - static_cast<std::size_t>(base)) / 64 + 1;
  // Nodes near each other often have near numbers: then setting bits is quicker than comparing.
  if (words > most_words || words > 8 * count) return std::sort(begin, end);
  std::array<std::uint64_t, most_words> bits;
  std::fill_n(bits.begin(), words, 0);
  for (const Index* node = begin; node != end; ++node) {
    const std::size_t place = static_cast<std::size_t>(*node - base);
    bits[place / 64] |= std::uint64_t{1} << (place % 64);
  }
  Index* to = begin;
  for (std::size_t word = 0; word < words; ++word) {
    for (std::uint64_t left = bits[word]; left != 0; left &= left - 1) {
      *to++ = base + static_cast<Index>(64 * word) + std::countr_zero(left);
    }
  }
}

Offset collect_rows(const QueryInput& input, Index at, std::span<const bool> helped, FoundRows& rows,
                    Offset from, Offset* ends) {
  const Offset count = static_cast<Offset>(helped.size());
  Array<Index>& nodes = *rows.nodes;
  const Array<Index> before(nodes.begin() + from, nodes.begin() + ends[count - 1]);
  Offset taken = 0;
  nodes.resize(static_cast<std::size_t>(from));
  for (Offset j = 0; j < count; ++j) {
    const Offset length = ends[j] - from;
    from = ends[j];
    if (helped[static_cast<std::size_t>(j)]) {
      input.help->collect(at + static_cast<Index>(j), rows);
      nodes.insert(nodes.end(), rows.spare->begin(), rows.spare->end());
    } else {
      nodes.insert(nodes.end(), before.begin() + taken, before.begin() + taken + length);
    }
    taken += length;
    ends[j] = static_cast<Offset>(nodes.size());
  }
  return static_cast<Offset>(nodes.size());
}

}  // namespace cellsearch::production
