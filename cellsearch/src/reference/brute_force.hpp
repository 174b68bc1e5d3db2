// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "finder.hpp"

namespace cellsearch {

/// Every participating node against every segment: the definition of a candidate pair in code, with nothing
/// that could go wrong. The oracle of all tests and of `verify`.
class BruteForce final : public Finder {
 public:
  void build(const FinderInput& input) override;
  void query(Index begin, Index end, FoundRows& rows) const override;
  Offset cells() const override { return 0; }
  Offset bytes() const override { return 0; }
  Offset nodes_in_domain() const override { return nodes_in_domain_; }

 private:
  bool counts(Index node) const;

  FinderInput input_;
  Offset nodes_in_domain_ = 0;
};

}  // namespace cellsearch
