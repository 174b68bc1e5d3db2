// SPDX-License-Identifier: BSD-3-Clause
#include "queries/box_pairs.hpp"

#include <cstddef>

namespace cellsearch {

void BoxPairs::join(int blocks, int threads, Pairs& pairs) {
  const Index count = static_cast<Index>(boxes_.size());
  Array<Offset>& first = pairs.first;
  first[0] = 0;
  // Row lengths: what the box itself found is known, what others found for it is counted here.
  ends_.assign(boxes_.size(), 0);
  visits_ = 0;
  for (int block = 0; block < blocks; ++block) {
    const Found& found = found_[static_cast<std::size_t>(block)];
    visits_ += found.visits;
    for (const PairOf& pair : found.of_others) ++ends_[static_cast<std::size_t>(pair.i)];
  }
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    first[i + 1] += first[i] + ends_[i];
    ends_[i] = first[i];
  }
  pairs.second.resize(static_cast<std::size_t>(first[boxes_.size()]));
  for (int block = 0; block < blocks; ++block) {
    for (const PairOf& pair : found_[static_cast<std::size_t>(block)].of_others) {
      pairs.second[static_cast<std::size_t>(ends_[static_cast<std::size_t>(pair.i)]++)] = pair.j;
    }
  }
  for_blocks(threads, blocks, [&](int block) {
    const Index* own = found_[static_cast<std::size_t>(block)].own.data();
    const BlockRange range(count, block, blocks);
    for (std::size_t i = static_cast<std::size_t>(range.begin); i < static_cast<std::size_t>(range.end);
         ++i) {
      const Offset missing = first[i + 1] - ends_[i];
      std::copy_n(own, missing, pairs.second.begin() + ends_[i]);
      own += missing;
      std::sort(pairs.second.begin() + first[i], pairs.second.begin() + first[i + 1]);
    }
  });
}

Offset BoxPairs::bytes() const {
  Offset sum =
      static_cast<Offset>(boxes_.size() * sizeof(Box) + ends_.size() * sizeof(Offset)) + classes_.bytes();
  for (const Found& found : found_) {
    sum += static_cast<Offset>((found.near.size() + found.own.size()) * sizeof(Index) +
                               found.of_others.size() * sizeof(PairOf));
  }
  return sum;
}

}  // namespace cellsearch
