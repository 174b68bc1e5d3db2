// SPDX-License-Identifier: BSD-3-Clause
// Intel Embree 3: two scenes of user geometries, the nodes as points and the territories as boxes, both built
// anew by the quickest builder, and collided by rtcCollide. Embree works in single precision: boxes are
// rounded outwards, and each pair gets the exact test.
#include <embree3/rtcore.h>

#include <mutex>
#include <stdexcept>
#include <string>

#include "peers/exact_pairs.hpp"
#include "peers/peers.hpp"

namespace cellsearch::bench {
namespace {

class Embree : public Contestant {
 public:
  explicit Embree(int threads) : threads_(threads), device_(rtcNewDevice(configuration(threads).c_str())) {
    if (device_ == nullptr) throw std::runtime_error("Embree gives no device.");
    nodes_ = new_tree(&node_bounds);
    segments_ = new_tree(&segment_bounds);
  }
  ~Embree() override {
    for (const Tree& tree : {nodes_, segments_}) {
      rtcReleaseGeometry(tree.geometry);
      rtcReleaseScene(tree.scene);
    }
    rtcReleaseDevice(device_);
  }

  void build(const Scene& scene) override {
    pairs_.reset(scene);
    commit(nodes_, scene.positions.count());
    commit(segments_, scene.segments.count());
  }

  const Candidates& query() override {
    pairs_.clear();
    rtcCollide(segments_.scene, nodes_.scene, threads_ == 1 ? &collect : &collect_in_parallel, this);
    return pairs_.rows();
  }

 private:
  struct Tree {
    RTCScene scene = nullptr;
    RTCGeometry geometry = nullptr;
  };

  /// Without the 128 MiB that it takes by default for the tessellation of subdivision surfaces.
  static std::string configuration(int threads) {
    return "threads=" + std::to_string(threads) + ",tessellation_cache_size=0.1";
  }

  Tree new_tree(RTCBoundsFunction bounds) {
    Tree tree{rtcNewScene(device_), rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER)};
    rtcSetSceneBuildQuality(tree.scene, RTC_BUILD_QUALITY_LOW);
    rtcSetSceneFlags(tree.scene, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetGeometryBuildQuality(tree.geometry, RTC_BUILD_QUALITY_LOW);
    rtcSetGeometryUserData(tree.geometry, this);
    rtcSetGeometryBoundsFunction(tree.geometry, bounds, nullptr);
    rtcAttachGeometry(tree.scene, tree.geometry);
    return tree;
  }

  static void commit(const Tree& tree, std::size_t count) {
    rtcSetGeometryUserPrimitiveCount(tree.geometry, static_cast<unsigned>(count));
    rtcCommitGeometry(tree.geometry);
    rtcCommitScene(tree.scene);
  }

  static void set(RTCBounds& bounds, const double* lo, const double* hi) {
    bounds.lower_x = at_most(lo[0]);
    bounds.lower_y = at_most(lo[1]);
    bounds.lower_z = at_most(lo[2]);
    bounds.upper_x = at_least(hi[0]);
    bounds.upper_y = at_least(hi[1]);
    bounds.upper_z = at_least(hi[2]);
  }

  static void node_bounds(const RTCBoundsFunctionArguments* arguments) {
    const Embree& self = *static_cast<const Embree*>(arguments->geometryUserPtr);
    const double* p = self.pairs_.scene().positions[static_cast<Index>(arguments->primID)];
    set(*arguments->bounds_o, p, p);
  }

  static void segment_bounds(const RTCBoundsFunctionArguments* arguments) {
    const Embree& self = *static_cast<const Embree*>(arguments->geometryUserPtr);
    const Box& box = self.pairs_.territory_of(static_cast<Index>(arguments->primID));
    set(*arguments->bounds_o, box.lo.data(), box.hi.data());
  }

  static void collect(void* self, RTCCollision* collisions, unsigned count) {
    ExactPairs& pairs = static_cast<Embree*>(self)->pairs_;
    for (unsigned k = 0; k < count; ++k) {
      pairs.add(static_cast<Index>(collisions[k].primID0), static_cast<Index>(collisions[k].primID1));
    }
  }

  static void collect_in_parallel(void* user, RTCCollision* collisions, unsigned count) {
    Embree& self = *static_cast<Embree*>(user);
    std::vector<ExactPairs::Pair> found;
    for (unsigned k = 0; k < count; ++k) {
      const Index segment = static_cast<Index>(collisions[k].primID0);
      const Index node = static_cast<Index>(collisions[k].primID1);
      if (self.pairs_.is_candidate(segment, node)) found.push_back({segment, node});
    }
    const std::scoped_lock lock(self.adding_);
    self.pairs_.append(found);
  }

  int threads_;
  RTCDevice device_;
  Tree nodes_;
  Tree segments_;
  ExactPairs pairs_;
  std::mutex adding_;
};

}  // namespace

ContestantKind embree_contestant() {
  return {.name = "embree",
          .setup =
              "Embree " RTC_VERSION_STRING
              ": rtcCollide on two scenes of user geometry, low-quality (quickest) build, committed anew",
          .peer = true,
          .threaded = true,
          .make = [](int threads) { return std::make_unique<Embree>(threads); }};
}

}  // namespace cellsearch::bench
