// SPDX-License-Identifier: BSD-3-Clause
// nanoflann: a k-d tree of the nodes in double precision. Its own query is by radius, about the centre of the
// territory out to its corners; walking its tree with the box itself is quicker, so that is what is done.
#include <nanoflann.hpp>

#include <optional>

#include "peers/exact_pairs.hpp"
#include "peers/peers.hpp"

namespace cellsearch::bench {
namespace {

/// The nodes in the form that nanoflann reads.
struct Cloud {
  Positions positions{};

  std::size_t kdtree_get_point_count() const { return positions.count(); }
  double kdtree_get_pt(Index node, std::size_t axis) const { return positions[node][axis]; }
  template <class Bounds>
  bool kdtree_get_bbox(Bounds&) const {
    return false;
  }
};

class Nanoflann : public Contestant {
 public:
  void build(const Scene& scene) override {
    pairs_.reset(scene);
    cloud_.positions = scene.positions;
    const nanoflann::KDTreeSingleIndexAdaptorParams parameters(
        16, nanoflann::KDTreeSingleIndexAdaptorFlags::SkipInitialBuildIndex);
    if (!tree_) tree_.emplace(3, cloud_, parameters);
    tree_->buildIndex();
  }

  const Candidates& query() override {
    pairs_.start_rows();
    const Index segments = static_cast<Index>(pairs_.scene().segments.count());
    for (Index segment = 0; segment < segments; ++segment) {
      search(*tree_->root_node, segment, pairs_.territory_of(segment));
      pairs_.end_row();
    }
    return pairs_.finished_rows();
  }

 private:
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud, double, Index>,
                                                   Cloud, 3, Index>;

  void search(const Tree::Node& node, Index segment, const Box& box) {
    if (node.child1 == nullptr) {
      for (auto k = node.node_type.lr.left; k < node.node_type.lr.right; ++k) {
        pairs_.add_to_row(segment, tree_->vAcc[k]);
      }
      return;
    }
    const auto& split = node.node_type.sub;
    const std::size_t axis = static_cast<std::size_t>(split.divfeat);
    if (box.lo[axis] <= split.divlow) search(*node.child1, segment, box);
    if (box.hi[axis] >= split.divhigh) search(*node.child2, segment, box);
  }

  Cloud cloud_;
  std::optional<Tree> tree_;
  ExactPairs pairs_;
};

}  // namespace

ContestantKind nanoflann_contestant() {
  return {.name = "nanoflann",
          .setup = "nanoflann: k-d tree of the nodes, leaves of 16, its tree walked with each territory",
          .peer = true,
          .make = [](int) { return std::make_unique<Nanoflann>(); }};
}

}  // namespace cellsearch::bench
