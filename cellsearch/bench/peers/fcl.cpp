// SPDX-License-Identifier: BSD-3-Clause
// FCL: two DynamicAABBTreeCollisionManagers in double precision, one of the nodes and one of the territories,
// both built anew from all objects at once (top down) and collided with each other.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/collision_geometry.h>
#include <fcl/narrowphase/collision_object.h>

#include <cstdint>

#include "peers/exact_pairs.hpp"
#include "peers/peers.hpp"

namespace cellsearch::bench {
namespace {

/// A geometry that is nothing but its box.
class BoxGeometry : public fcl::CollisionGeometry<double> {
 public:
  BoxGeometry(const double* lo, const double* hi) { set(lo, hi); }

  void set(const double* lo, const double* hi) {
    aabb_local = fcl::AABBd(fcl::Vector3d(lo[0], lo[1], lo[2]), fcl::Vector3d(hi[0], hi[1], hi[2]));
  }
  void computeLocalAABB() override {}
  fcl::OBJECT_TYPE getObjectType() const override { return fcl::OT_GEOM; }
  fcl::NODE_TYPE getNodeType() const override { return fcl::GEOM_BOX; }
};

/// Boxes, their objects and their tree. Objects are kept; the tree is built anew.
class Tree {
 public:
  template <class BoxOf>
  void build(std::size_t count, const BoxOf& box_of) {
    manager_.clear();
    if (objects_.size() != count) {
      objects_.clear();
      pointers_.clear();
      objects_.reserve(count);
      for (std::size_t k = 0; k < count; ++k) {
        const auto [lo, hi] = box_of(static_cast<Index>(k));
        objects_.emplace_back(std::make_shared<BoxGeometry>(lo, hi));
        objects_.back().setUserData(reinterpret_cast<void*>(k));
      }
      for (fcl::CollisionObjectd& object : objects_) pointers_.push_back(&object);
    } else {
      for (std::size_t k = 0; k < count; ++k) {
        const auto [lo, hi] = box_of(static_cast<Index>(k));
        // The object gives its geometry as constant only; it is ours.
        auto* geometry = const_cast<fcl::CollisionGeometryd*>(objects_[k].collisionGeometry().get());
        static_cast<BoxGeometry*>(geometry)->set(lo, hi);
        objects_[k].computeAABB();
      }
    }
    manager_.registerObjects(pointers_);
    manager_.setup();
  }

  fcl::DynamicAABBTreeCollisionManagerd& manager() { return manager_; }

 private:
  std::vector<fcl::CollisionObjectd> objects_;
  std::vector<fcl::CollisionObjectd*> pointers_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

Index number_of(const fcl::CollisionObjectd* object) {
  return static_cast<Index>(reinterpret_cast<std::uintptr_t>(object->getUserData()));
}

class Fcl : public Contestant {
 public:
  void build(const Scene& scene) override {
    struct Corners {
      const double* lo;
      const double* hi;
    };
    pairs_.reset(scene);
    nodes_.build(scene.positions.count(), [&](Index node) {
      return Corners{scene.positions[node], scene.positions[node]};
    });
    segments_.build(scene.segments.count(), [&](Index segment) {
      const Box& box = pairs_.territory_of(segment);
      return Corners{box.lo.data(), box.hi.data()};
    });
  }

  const Candidates& query() override {
    pairs_.clear();
    segments_.manager().collide(&nodes_.manager(), this, &collect);
    return pairs_.rows();
  }

 private:
  static bool collect(fcl::CollisionObjectd* segment, fcl::CollisionObjectd* node, void* self) {
    static_cast<Fcl*>(self)->pairs_.add(number_of(segment), number_of(node));
    return false;
  }

  Tree nodes_;
  Tree segments_;
  ExactPairs pairs_;
};

}  // namespace

ContestantKind fcl_contestant() {
  return {.name = "fcl",
          .setup = "FCL " FCL_VERSION
                   ": two DynamicAABBTreeCollisionManagers, objects kept, trees built anew from all at once",
          .peer = true,
          .most_nodes = 2e6,
          .make = [](int) { return std::make_unique<Fcl>(); }};
}

}  // namespace cellsearch::bench
