// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/touch.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/prefetch.hpp"
#include "contact/enforcement/contact_pair.hpp"
#include "contact/surface/segment_shape.hpp"
#include "contact/surface/sides.hpp"
#include "contact/surface/surface.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {

double node_stiffness(const Surface& surface, const Configuration& x, const ContactPair& pair) {
  double sum = 0;
  for (const Index own : surface.topology.at_node(pair.node)) {
    if (surface.of_solid[own] == 0) return surface.node_stiffness[pair.node];
    const double share = surface.is_triangle(own) ? 1.0 / 3 : 0.25;
    const double opposed = -dot(normalised(area_normal(shape_of(surface, x, own))), pair.normal);
    sum += share * surface.stiffness[own] * std::max(0.0, opposed);
  }
  return sum > 0 ? sum : surface.node_stiffness[pair.node];
}

double most_penetration(const Surface& surface, const ContactPair& pair) {
  const double shells = std::max(pair.reach, 0.0) + surface.half_thickness[pair.segment];
  if (!surface.is_face(pair.segment)) return shells;
  return shells + tolerances::deepest_in_solid * surface.height[pair.segment];
}

Touch touch_of(const Surface& surface, const ContactPair& pair) {
  Touch touch;
  touch.add(pair.node, 1);
  const Index* segment = surface.segment(pair.segment);
  const int corners = surface.is_triangle(pair.segment) ? 3 : 4;
  for (int k = 0; k < corners; ++k) touch.add(surface.place[segment[k]], -pair.weight[k]);
  touch.normal = pair.normal;
  touch.penetration = pair.acts() ? pair.penetration() : 0;
  // Behind a face there is no mid-surface that a strong squeeze would reach.
  touch.reach = surface.is_face(pair.segment) ? std::numeric_limits<double>::max() : pair.reach;
  touch.most = most_penetration(surface, pair);
  touch.segment = pair.segment;
  touch.stiffness = std::min(surface.node_stiffness[pair.node], surface.stiffness[pair.segment]);
  touch.area = surface.area[pair.segment];
  touch.part = {surface.node_part[pair.node], surface.segment_part[pair.segment]};
  touch.share = pair.share;
  touch.fade = pair.fade;
  touch.starts_loaded = pair.fade < 1;
  touch.slip = pair.slip;
  touch.friction = pair.friction;
  touch.penalty = pair.penalty;
  touch.last_speed = pair.last_speed;
  return touch;
}

Vec3 force_on_first_side(const Surface& surface, std::span<const Touch> touches) {
  Vec3 sum;
  for (const Touch& touch : touches) {
    // Places on both sides belong to none, but where the other end does.
    std::uint8_t first = first_side | second_side;
    std::uint8_t second = first;
    for (int i = 0; i < touch.nodes; ++i)
      (touch.weight[i] > 0 ? first : second) &= surface.node_side[touch.place[i]];
    const bool forwards = (first & first_side) != 0 && (second & second_side) != 0;
    const bool backwards = (first & second_side) != 0 && (second & first_side) != 0;
    if (forwards != backwards) sum += (forwards ? 1.0 : -1.0) * touch.force();
  }
  return sum;
}

void prefetch_touch_after(const Surface& surface, std::span<const ContactPair> pairs, std::size_t i) {
  constexpr std::size_t ahead = 8;
  if (i + 2 * ahead < pairs.size()) {
    const ContactPair& pair = pairs[i + 2 * ahead];
    prefetch<false>(surface.segment(pair.segment), 4);
    prefetch<false>(&surface.stiffness[pair.segment], 1);
    prefetch<false>(&surface.area[pair.segment], 1);
    prefetch<false>(&surface.face[pair.segment], 1);
    prefetch<false>(&surface.node_stiffness[pair.node], 1);
    prefetch<false>(&surface.topology.first_at_node[pair.node], 1);
  }
  if (i + ahead < pairs.size()) {
    const ContactPair& pair = pairs[i + ahead];
    for (int k = 0; k < 4; ++k) prefetch<false>(&surface.place[surface.segment(pair.segment)[k]], 1);
    prefetch<false>(surface.topology.at_node(pair.node).data(), 1);
  }
}

}  // namespace crumple::contact
