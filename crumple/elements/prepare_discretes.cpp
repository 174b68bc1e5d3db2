// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "elements/line/body_response.hpp"
#include "elements/line/discrete_elements.hpp"
#include "elements/prepare.hpp"
#include "math/to_vec3.hpp"

namespace crumple::elements {
namespace {

using domain::DiscreteBlock;
using math::Vec3;

void declare_items(DiscreteBlock& block) {
  const char* const length = block.torsional ? "rad" : "length";
  const char* const force = block.torsional ? "force*length" : "force";
  domain::add_item(block, "axis", "-", 3);
  domain::add_item(block, "grounded", "-", 1);
  domain::add_item(block, "reference", "length", 1);
  domain::add_item(block, "scale", "-", 1);
  domain::add_item(block, "stable_step", "time", 1);
  domain::add_item(block, "deformation", length, 1);
  domain::add_item(block, "force", force, 1);
  domain::add_item(block, "plastic_deformation", length, 1);
  domain::add_item(block, "hardening", length, 1);
}

/// Brings an element from no deformation to its first one, that it has the history and the energy of the
/// way. Returns the work.
double stretch(const DiscreteLaw& law, DiscreteBlock& block, Index place, double offset) {
  constexpr int steps = 1000;
  DiscreteHistory history;
  const double scale = block.state(place, discrete_state::scale);
  double before = scale * law.force({}, history);
  double work = 0;
  for (int i = 1; i <= steps; ++i) {
    const double force =
        scale * law.force({.deformation = offset * i / steps, .change = offset / steps}, history);
    work += 0.5 * (before + force) * offset / steps;
    before = force;
  }
  block.set_state(place, discrete_state::deformation, offset);
  block.set_state(place, discrete_state::plastic, history.plastic);
  block.set_state(place, discrete_state::hardening, history.hardening);
  return work;
}

void prepare_element(const model::DiscreteElement& discrete, const domain::Domain& domain,
                     DiscreteBlock& block, Index place) {
  const auto [first, second] = block.nodes_of(place);
  const auto& x = domain.nodes.position;
  const Vec3 axis = math::to_vec3(discrete.axis);
  const bool oriented = dot(axis, axis) > 0;
  const Vec3 span = (discrete.grounded ? Vec3{} : x[second]) - x[first];
  const double distance = oriented ? dot(span, axis) : norm(span);
  if (!oriented && (discrete.grounded || !(distance > 0)))
    throw Error("Discrete element " + std::to_string(discrete.id) +
                " has no direction: its ends coincide or one is grounded, and it has no orientation vector.");
  for (int i = 0; i < 3; ++i) block.set_state(place, discrete_state::axis + i, axis[i]);
  block.set_state(place, discrete_state::grounded, discrete.grounded ? 1 : 0);
  block.set_state(place, discrete_state::reference, distance - discrete.offset);
  block.set_state(place, discrete_state::scale, discrete.scale);
}

/// What all springs and dampers at a node have together, forces or moments.
struct Sums {
  std::vector<double> stiffness;
  std::vector<double> damping;

  explicit Sums(Index nodes) : stiffness(nodes), damping(nodes) {}
};

/// Whether a node cannot move, or turn, in any direction.
bool is_held(const domain::NodeFields& nodes, Index node, bool turning) {
  const unsigned bits = turning ? nodes.fixed[node] >> 3U : nodes.fixed[node];
  return (bits & 7U) == 7U;
}

Index moving_ends(const DiscreteBlock& block, Index place) {
  return block.state(place, discrete_state::grounded) != 0 ? 1 : 2;
}

/// What the ends of springs have to move.
struct Ends {
  const model::Model& model;
  const domain::NodeFields& nodes;
  BodyResponse bodies;
};

/// Half the mass of a node, the other half being the other elements', is shared by its springs as their
/// stiffness, and by its dampers likewise; in the place of a node without mass stands the rigid body that it
/// belongs to. Returns the sum of 1 / mass over both ends.
double per_mass(const Ends& ends, const DiscreteBlock& block, Index place, const std::vector<double>& sum,
                double own) {
  const domain::NodeFields& nodes = ends.nodes;
  const auto& masses = block.torsional ? nodes.inertia : nodes.mass;
  double result = 0;
  for (Index end = 0; end < moving_ends(block, place); ++end) {
    const Index node = block.node_of(place, end);
    if (is_held(nodes, node, block.torsional)) continue;
    if (masses[node] > 0) {
      result += 2 * sum[node] / (own * masses[node]);
      continue;
    }
    const double response = ends.bodies.at(node, block.torsional);
    if (!(response > 0))
      throw Error("Node " + std::to_string(ends.model.nodes.id[nodes.model_node[node]]) +
                  " of discrete element " + std::to_string(ends.model.discretes[block.element[place]].id) +
                  (block.torsional ? " has no rotary inertia: give it one with *ELEMENT_INERTIA, or hold it."
                                   : " has no mass: give it one with *ELEMENT_MASS, or hold it."));
    result += 2 * sum[ends.bodies.shared_node(node, block.torsional)] / own * response;
  }
  return result;
}

void add_to_sums(const Ends& ends, const DiscreteBlock& block, const DiscreteLaw& law, Sums& sums) {
  for (Index place = 0; place < block.elements; ++place) {
    const double scale = std::fabs(block.state(place, discrete_state::scale));
    for (Index end = 0; end < moving_ends(block, place); ++end) {
      const Index node = ends.bodies.shared_node(block.node_of(place, end), block.torsional);
      sums.stiffness[node] += scale * law.stiffness();
      sums.damping[node] += scale * law.damping();
    }
  }
}

/// 2 / frequency of a spring between its shares of the masses; of a damper the time in which half the
/// relative velocity of the ends would be gone.
double stable_step_of(const Ends& ends, const DiscreteBlock& block, Index place, const Sums& sums) {
  const DiscreteLaw law(block.material_constants);
  const double scale = std::fabs(block.state(place, discrete_state::scale));
  double step = 1e30;
  if (const double k = scale * law.stiffness(); k > 0) {
    const double inverse = per_mass(ends, block, place, sums.stiffness, k);
    if (inverse > 0) step = std::min(step, 2 / std::sqrt(k * inverse));
  }
  if (const double c = scale * law.damping(); c > 0) {
    const double inverse = per_mass(ends, block, place, sums.damping, c);
    if (inverse > 0) step = std::min(step, 1 / (c * inverse));
  }
  return step;
}

}  // namespace

void prepare_discretes(const model::Model& model, domain::Domain& domain) {
  const Ends ends{model, domain.nodes, BodyResponse(model, domain)};
  Sums forces(domain.nodes.count());
  Sums moments(domain.nodes.count());
  for (DiscreteBlock& block : domain.discretes) {
    declare_items(block);
    block.allocate(Precision::Double);
    const model::Part& part = model.parts[block.part];
    block.material_constants = discrete_law_numbers(model.spring_materials[part.spring_material].law, model);
    const DiscreteLaw law(block.material_constants);
    for (Index place = 0; place < block.elements; ++place) {
      const model::DiscreteElement& discrete = model.discretes[block.element[place]];
      prepare_element(discrete, domain, block, place);
      if (discrete.offset != 0) block.add_internal_energy(place, stretch(law, block, place, discrete.offset));
    }
    add_to_sums(ends, block, law, block.torsional ? moments : forces);
  }
  for (DiscreteBlock& block : domain.discretes)
    for (Index place = 0; place < block.elements; ++place)
      block.set_state(place, discrete_state::stable_step,
                      stable_step_of(ends, block, place, block.torsional ? moments : forces));
}

}  // namespace crumple::elements
