// SPDX-License-Identifier: BSD-3-Clause
#include "production/kernels.hpp"

#include <algorithm>

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
  std::sort(begin, end);
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
