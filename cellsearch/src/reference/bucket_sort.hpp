// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "finder.hpp"
#include "reference/axis_cells.hpp"

namespace cellsearch {

/// Buckets nested in x, y and z, the conventional method of DYNA3D and LS-DYNA (J. O. Hallquist; D. J. Benson
/// & J. O. Hallquist, CMAME 78 (1990) 141-163).
///
/// The nodes are sorted along x into slabs; the nodes of each slab along y into strips; those of each strip
/// along z into buckets. A segment looks into the slabs that its territory reaches, in each of them into the
/// strips, in each of these into the buckets.
///
/// The literature gives the nesting; the manual itself could not be read. Ours are: each slab and strip
/// divides the interval that its own nodes take up, into no more parts than it has nodes, so that there are
/// at most N of each kind however empty the space is; the width of a part is the cell edge of the settings,
/// as for the other methods (DYNA3D's, as far as we know, comes from the longest segments); the sorting is by
/// counting. O(N) time and memory for similar sizes.
class BucketSort final : public Finder {
 public:
  void build(const FinderInput& input) override;
  void query(Index begin, Index end, FoundRows& rows) const override;
  Offset cells() const override { return static_cast<Offset>(bucket_start_.size()) - 1; }
  Offset bytes() const override;
  Offset nodes_in_domain() const override { return static_cast<Offset>(order_.size()); }

  /// What a slab or a strip is divided into: along y into strips, along z into buckets.
  struct Division {
    AxisCells cells;
    Index first = 0;  ///< number of the first strip or bucket
  };

  /// For tests: the slabs along x, the division of one of them, and the division of one strip.
  const AxisCells& slabs() const { return slabs_; }
  const Division& strips_of(Index slab) const { return strips_of_slab_[static_cast<std::size_t>(slab)]; }
  const Division& buckets_of(Index strip) const { return buckets_of_strip_[static_cast<std::size_t>(strip)]; }

  /// For tests: the nodes in one bucket, ascending.
  std::span<const Index> bucket(Index number) const { return nodes_in(number, number); }

 private:
  AxisCells divide(int axis, Index begin, Index end, std::vector<Index>& starts);
  void divide_slab(Index begin, Index end);
  void visit_slab(const Division& strips, const Box& cull, Index segment, const Box& box,
                  FoundRows& rows) const;
  std::span<const Index> nodes_in(Index first_bucket, Index last_bucket) const;

  FinderInput input_;
  Point widths_{};
  AxisCells slabs_;
  std::vector<Division> strips_of_slab_;
  std::vector<Division> buckets_of_strip_;
  std::vector<Index> bucket_start_{
      0};                     // one more than buckets: bucket b is order_[start[b]] ... [start[b + 1] - 1]
  std::vector<Index> order_;  // node numbers, bucket by bucket
  std::vector<Index> slab_start_;  // the rest is needed while sorting
  std::vector<Index> strip_start_;
  std::vector<Index> unsorted_;
  std::vector<Index> part_;
};

}  // namespace cellsearch
