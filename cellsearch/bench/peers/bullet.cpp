// SPDX-License-Identifier: BSD-3-Clause
// Bullet: a dynamic bounding volume tree (btDbvt) of the nodes, asked with each territory. Bullet works in
// single precision: boxes are rounded outwards, and each pair gets the exact test.
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include "peers/exact_pairs.hpp"
#include "peers/peers.hpp"

namespace cellsearch::bench {
namespace {

btDbvtVolume rounded_outwards(const double* lo, const double* hi) {
  return btDbvtVolume::FromMM(btVector3(at_most(lo[0]), at_most(lo[1]), at_most(lo[2])),
                              btVector3(at_least(hi[0]), at_least(hi[1]), at_least(hi[2])));
}

class Bullet : public Contestant {
 public:
  void build(const Scene& scene) override {
    pairs_.reset(scene);
    tree_.clear();
    const Index count = static_cast<Index>(scene.positions.count());
    for (Index node = 0; node < count; ++node) {
      const double* p = scene.positions[node];
      btDbvtNode* leaf = tree_.insert(rounded_outwards(p, p), nullptr);
      leaf->dataAsInt = node;
    }
    // Below so many leaves it goes bottom up, at a cost of their square: 128 by default, best below 16.
    tree_.optimizeTopDown(8);
  }

  const Candidates& query() override {
    pairs_.start_rows();
    const Index segments = static_cast<Index>(pairs_.scene().segments.count());
    btAlignedObjectArray<const btDbvtNode*> stack;
    for (Index segment = 0; segment < segments; ++segment) {
      const Box& box = pairs_.territory_of(segment);
      Row row(pairs_, segment);
      tree_.collideTVNoStackAlloc(tree_.m_root, rounded_outwards(box.lo.data(), box.hi.data()), stack, row);
      pairs_.end_row();
    }
    return pairs_.finished_rows();
  }

 private:
  struct Row : btDbvt::ICollide {
    Row(ExactPairs& all_pairs, Index row_segment) : pairs(&all_pairs), segment(row_segment) {}
    void Process(const btDbvtNode* leaf) override { pairs->add_to_row(segment, leaf->dataAsInt); }
    ExactPairs* pairs;
    Index segment;
  };

  btDbvt tree_;
  ExactPairs pairs_;
};

}  // namespace

ContestantKind bullet_contestant() {
  return {.name = "bullet",
          .setup =
              "Bullet: btDbvt of the nodes, optimised top down (threshold 8), asked with each territory "
              "(collideTV)",
          .peer = true,
          .most_nodes = 2e6,
          .make = [](int) { return std::make_unique<Bullet>(); }};
}

}  // namespace cellsearch::bench
