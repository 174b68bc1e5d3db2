// SPDX-License-Identifier: BSD-3-Clause
// CGAL: box_intersection_d of the nodes (as points) and the territories, closed boxes in double precision. It
// sorts and streams its boxes, so that "build" only fills them in.
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

#include <cstddef>

#include "peers/exact_pairs.hpp"
#include "peers/peers.hpp"

namespace cellsearch::bench {
namespace {

/// A box in the form that CGAL asks for. Its number orders boxes with equal faces: all must differ.
class NumberedBox {
 public:
  using NT = double;
  using ID = std::size_t;

  NumberedBox() = default;
  NumberedBox(const double* lo, const double* hi, std::size_t number)
      : lo_{lo[0], lo[1], lo[2]}, hi_{hi[0], hi[1], hi[2]}, number_(number) {}

  static int dimension() { return 3; }
  ID id() const { return number_; }
  NT min_coord(int axis) const { return lo_[static_cast<std::size_t>(axis)]; }
  NT max_coord(int axis) const { return hi_[static_cast<std::size_t>(axis)]; }

 private:
  Point lo_{};
  Point hi_{};
  std::size_t number_ = 0;
};

class Cgal : public Contestant {
 public:
  void build(const Scene& scene) override {
    pairs_.reset(scene);
    const std::size_t node_count = scene.positions.count();
    nodes_.resize(node_count);
    for (std::size_t node = 0; node < node_count; ++node) {
      const double* p = scene.positions[static_cast<Index>(node)];
      nodes_[node] = NumberedBox(p, p, 2 * node);
    }
    const std::size_t segment_count = scene.segments.count();
    segments_.resize(segment_count);
    for (std::size_t segment = 0; segment < segment_count; ++segment) {
      const Box& box = pairs_.territory_of(static_cast<Index>(segment));
      segments_[segment] = NumberedBox(box.lo.data(), box.hi.data(), 2 * segment + 1);
    }
  }

  const Candidates& query() override {
    pairs_.clear();
    CGAL::box_intersection_d(
        segments_.begin(), segments_.end(), nodes_.begin(), nodes_.end(),
        [this](const NumberedBox& segment, const NumberedBox& node) {
          pairs_.add(static_cast<Index>(segment.id() / 2), static_cast<Index>(node.id() / 2));
        },
        std::ptrdiff_t{100}, CGAL::Box_intersection_d::CLOSED);
    return pairs_.rows();
  }

 private:
  std::vector<NumberedBox> nodes_;
  std::vector<NumberedBox> segments_;
  ExactPairs pairs_;
};

}  // namespace

ContestantKind cgal_contestant() {
  return {.name = "cgal",
          .setup = "CGAL " CGAL_VERSION_STR ": box_intersection_d, closed boxes by value, cutoff 100",
          .peer = true,
          .most_nodes = 2e6,
          .make = [](int) { return std::make_unique<Cgal>(); }};
}

}  // namespace cellsearch::bench
