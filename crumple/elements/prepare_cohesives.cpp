// SPDX-License-Identifier: BSD-3-Clause
#include "elements/prepare_cohesives.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "elements/line/body_response.hpp"
#include "elements/prepare.hpp"
#include "elements/solid/cohesive_hexahedron.hpp"
#include "elements/stable_steps.hpp"

namespace crumple::elements {
namespace {

using domain::Domain;
using domain::SolidBlock;
using math::Vec3;

/// Middle surface and pairs of an element in the present geometry.
struct Layer {
  CohesivePose<double> pose;
  CohesiveAxes<double> axes;
  std::array<double, 4> area{};  ///< of the points
  std::array<Vec3, 4> apart{};   ///< of the pairs, in the axes
  double whole = 0;              ///< area
};

Vec3 plain(const math::PackVec3<double>& v) {
  return {v.x, v.y, v.z};
}

Layer layer_of(const Domain& domain, const SolidBlock& block, Index place, double coordinate) {
  const std::array<Index, 8> node = block.nodes_of(place);
  const auto position = [&](int k) {
    const Vec3& x = domain.nodes.position[node[static_cast<std::size_t>(k)]];
    return std::array<double, 3>{x.x, x.y, x.z};
  };
  double row[cohesive_rows];
  cohesive_pose<double>(position, row);
  const auto vector = [&](int v) {
    return math::PackVec3<double>{row[3 * v], row[3 * v + 1], row[3 * v + 2]};
  };
  Layer layer;
  layer.pose = {{vector(0), vector(1)}, {vector(2), vector(3), vector(4), vector(5)}};
  layer.axes = cohesive_axes(layer.pose);
  std::array<Vec3, 4> middle;
  for (std::size_t k = 0; k < 4; ++k)
    middle[k] = 0.5 * (domain.nodes.position[node[k]] + domain.nodes.position[node[k + 4]]);
  const Vec3 twist = 0.25 * (middle[0] - middle[1] + middle[2] - middle[3]);
  for (int p = 0; p < cohesive::points; ++p) {
    const Vec3 first = plain(layer.pose.tangent[0]) + (cohesive::eta[p] * coordinate) * twist;
    const Vec3 second = plain(layer.pose.tangent[1]) + (cohesive::xi[p] * coordinate) * twist;
    const double area = dot(cross(first, second), plain(layer.axes.axis[2]));
    layer.area[static_cast<std::size_t>(p)] = area;
    layer.whole += area;
  }
  for (std::size_t k = 0; k < 4; ++k) layer.apart[k] = plain(in_axes(layer.axes, layer.pose.pair[k]));
  return layer;
}

/// Area that belongs to corner `k`.
double corner_area(const Layer& layer, int k, double coordinate) {
  double sum = 0;
  for (int p = 0; p < cohesive::points; ++p)
    sum += layer.area[static_cast<std::size_t>(p)] * cohesive::weight(p, k, coordinate);
  return sum;
}

/// Mean thickness; throws where the element has no area or its upper face lies below the lower one.
double checked_thickness(const Layer& layer, UserId solid) {
  const std::string name = "Cohesive solid " + std::to_string(solid);
  // Not a number where two nodes make an edge of the middle surface vanish.
  if (!(*std::min_element(layer.area.begin(), layer.area.end()) >= 0) || !(layer.whole > 0))
    throw Error(name +
                " has no area: N1 to N4 are the corners of one face in their order, N5 to N8 those of the "
                "other opposite to them.");
  double thickness = 0;
  for (const Vec3& apart : layer.apart) thickness += 0.25 * apart.z;
  if (thickness < -1e-9 * std::sqrt(layer.whole))
    throw Error(name + " is inside out: N1 to N4 run counter-clockwise seen from the side of N5 to N8.");
  return std::max(thickness, 0.0);
}

void set_reference(const Layer& layer, Index first, Index place, SolidBlock& block) {
  for (Index p = 0; p < cohesive::points; ++p)
    block.set_state(place, first + cohesive::area + p, layer.area[static_cast<std::size_t>(p)]);
  for (Index k = 0; k < 4; ++k)
    for (int axis = 0; axis < 3; ++axis)
      block.set_state(place, first + cohesive::separation + 3 * k + axis,
                      layer.apart[static_cast<std::size_t>(k)][axis]);
}

/// By what squares of frequencies follow from stiffnesses at nodes.
class Nodes {
 public:
  Nodes(const model::Model& model, const Domain& domain)
      : model_(model),
        nodes_(domain.nodes),
        bodies_(model, domain),
        stiffness_(static_cast<std::size_t>(domain.nodes.count()), 0.0),
        step_(stiffness_.size(), std::numeric_limits<double>::max()) {}

  void add(Index node, double stiffness) {
    stiffness_[static_cast<std::size_t>(bodies_.shared_node(node, false))] += stiffness;
  }
  void limit(Index node, double step) {
    double& least = step_[static_cast<std::size_t>(node)];
    least = std::min(least, step);
  }
  /// Shortest step of the other elements at the node.
  double step(Index node) const { return step_[static_cast<std::size_t>(node)]; }

  /// All that pulls at the node over its mass, or that of the rigid body that it belongs to.
  double frequency_square(Index node, UserId solid) const {
    if ((nodes_.fixed[node] & 7U) == 7U) return 0;
    const double response = nodes_.mass[node] > 0 ? 1 / nodes_.mass[node] : bodies_.at(node, false);
    if (!(response > 0))
      throw Error("Node " + std::to_string(model_.nodes.id[nodes_.model_node[node]]) + " of cohesive solid " +
                  std::to_string(solid) +
                  " has no mass: give its material a density, or other elements its nodes.");
    return stiffness_[static_cast<std::size_t>(bodies_.shared_node(node, false))] * response;
  }

 private:
  const model::Model& model_;
  const domain::NodeFields& nodes_;
  BodyResponse bodies_;
  std::vector<double> stiffness_;
  std::vector<double> step_;
};

double largest_stiffness(const model::Model& model, const SolidBlock& block) {
  const auto& law = std::get<model::Cohesive>(model.materials[model.parts[block.part].material].law);
  return std::max(law.youngs_modulus, law.shear_stiffness);
}

/// Turns of the axes bring shears with the thickness as their arm: their share of the frequency over that of
/// separations alone.
double turning_share(const Layer& layer) {
  double arm = 0;
  for (const Vec3& apart : layer.apart) arm = std::max(arm, norm(apart));
  const double first = norm(plain(layer.pose.tangent[0]));
  const double second = norm(plain(layer.pose.tangent[1]));
  const double between = 1 / layer.axes.per_area;
  return arm / (2 * std::min({first, between / first, between / second}));
}

double step_of(const Nodes& nodes, const SolidBlock& block, Index place, double turning, UserId solid) {
  double square = 0;
  double beside = std::numeric_limits<double>::max();
  for (Index k = 0; k < 4; ++k) {
    const Index lower = block.node_of(place, k);
    const Index upper = block.node_of(place, k + 4);
    square = std::max(square, nodes.frequency_square(lower, solid) + nodes.frequency_square(upper, solid));
    beside = std::min({beside, nodes.step(lower), nodes.step(upper)});
  }
  const double frequency = (1 + turning) * std::sqrt(square);
  if (!(frequency > 0)) return 1e30;
  const double alone = 2 / frequency;
  const double ratio = alone / beside;
  return alone / std::sqrt(1 + ratio * ratio);
}

template <class Block>
void limit_nodes(const Domain& domain, const Block& block, Nodes& nodes) {
  if (block.rigid) return;
  for_each_step(domain, block, 0, block.elements, [&](Index place, double step) {
    for (Index corner = 0; corner < block.corners; ++corner) nodes.limit(block.node_of(place, corner), step);
  });
}

}  // namespace

void prepare_cohesives(const model::Model& model, Domain& domain, SolidBlock& block) {
  const auto constants = from_numbers<SolidConstants<double>>(block.element_constants);
  const model::Material& material = model.materials[model.parts[block.part].material];
  const auto& law = std::get<model::Cohesive>(material.law);
  const Index own = constants.own;
  for (Index place = 0; place < block.groups() * lanes; ++place) {
    const Index index = block.element[std::min(place, block.elements - 1)];
    const Layer layer = layer_of(domain, block, place, constants.point_place);
    const double thickness = checked_thickness(layer, model.solids[index].id);
    block.set_state(place, own + solid_state::reference_volume, layer.whole);
    block.set_state(place, own + solid_state::active, place < block.elements ? 1 : 0);
    block.set_state(place, own + solid_state::step_scale, 1e30);
    set_reference(layer, own + solid_state::own, place, block);
    if (place >= block.elements) continue;
    const double mass = material.density * layer.whole * (law.mass_by_area ? 1 : thickness);
    for (Index corner = 0; corner < block.corners; ++corner)
      add_mass(domain, block.part, block.node_of(place, corner), mass * block.mass_share(corner));
  }
}

void set_cohesive_steps(const model::Model& model, Domain& domain) {
  const auto is_cohesive = [](const SolidBlock& block) { return model::is_cohesive(block.formulation); };
  if (std::none_of(domain.solids.begin(), domain.solids.end(), is_cohesive)) return;
  Nodes nodes(model, domain);
  for (const domain::ShellBlock& block : domain.shells) limit_nodes(domain, block, nodes);
  for (const domain::BeamBlock& block : domain.beams) limit_nodes(domain, block, nodes);
  const auto layer_at = [&](const SolidBlock& block, Index place) {
    const auto constants = from_numbers<SolidConstants<double>>(block.element_constants);
    return layer_of(domain, block, place, constants.point_place);
  };
  for (const SolidBlock& block : domain.solids) {
    if (!is_cohesive(block)) {
      limit_nodes(domain, block, nodes);
      continue;
    }
    const double stiffness = largest_stiffness(model, block);
    const auto constants = from_numbers<SolidConstants<double>>(block.element_constants);
    for (Index place = 0; place < block.elements; ++place) {
      const Layer layer = layer_at(block, place);
      for (Index corner = 0; corner < block.corners; ++corner)
        nodes.add(block.node_of(place, corner),
                  stiffness * corner_area(layer, corner % 4, constants.point_place));
    }
  }
  for (SolidBlock& block : domain.solids) {
    if (!is_cohesive(block)) continue;
    const Index item =
        from_numbers<SolidConstants<double>>(block.element_constants).own + solid_state::step_scale;
    for (Index place = 0; place < block.elements; ++place)
      block.set_state(place, item,
                      step_of(nodes, block, place, turning_share(layer_at(block, place)),
                              model.solids[block.element[place]].id));
  }
}

}  // namespace crumple::elements
