// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "elements/line/beam_task.hpp"
#include "elements/line/body_response.hpp"
#include "elements/line/discrete_beam_law.hpp"
#include "elements/prepare.hpp"
#include "math/to_vec3.hpp"

namespace crumple::elements {
namespace {

using domain::BeamBlock;
using math::Vec3;
using Kind = model::DiscreteBeamLaw::Kind;

const model::DiscreteBeamLaw& law_of(const model::Model& model, const BeamBlock& block) {
  const model::Part& part = model.parts[block.part];
  const auto* law = std::get_if<model::DiscreteBeamLaw>(&model.materials[part.material].law);
  require(law != nullptr, part, "discrete beams need a material of discrete beams");
  return *law;
}

bool has_limits(const model::DiscreteBeamLaw& law) {
  return std::any_of(law.direction.begin(), law.direction.end(), [](const model::DiscreteBeamDirection& one) {
    return one.tensile_limit > 0 || one.compressive_limit > 0;
  });
}

void declare_discrete_items(BeamBlock& block, bool remembers) {
  domain::add_item(block, "active", "-", 1);
  domain::add_item(block, "stable_step", "time", 1);
  domain::add_item(block, "reference_length", "length", 1);
  domain::add_item(block, "axes", "-", 6);
  domain::add_item(block, "reference", "length", 3);
  domain::add_item(block, "deformation", "length and rad", discrete_directions);
  domain::add_item(block, "resultant", "force and moment", discrete_directions);
  domain::add_item(block, "energy", "energy", 2);
  if (remembers)
    domain::add_item(block, "unloading", "length or force", discrete_directions * discrete_history);
}

/// The axes r, s, t at time zero: those that the section names, towards the orientation node, or global.
std::array<Vec3, 3> axes_at_start(const model::Model& model, const model::BeamElement& beam, const Vec3& span,
                                  const model::DiscreteBeamData& data) {
  if (data.axes)
    return {math::to_vec3((*data.axes)[0]), math::to_vec3((*data.axes)[1]), math::to_vec3((*data.axes)[2])};
  Vec3 towards = math::to_vec3(beam.orientation);
  if (beam.orientation_node != no_index)
    towards = math::to_vec3(model.nodes.position[beam.orientation_node]) -
              math::to_vec3(model.nodes.position[beam.node[0]]);
  if (!(norm(span) > 0) || !(norm(towards) > 0)) return {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  const Vec3 r = normalised(span);
  const Vec3 across = towards - dot(towards, r) * r;
  constexpr double parallel = 1e-6;
  if (!(norm(across) > parallel * norm(towards)))
    throw Error("Beam " + std::to_string(beam.id) + " is parallel to what gives its orientation.");
  const Vec3 s = normalised(across);
  return {r, s, cross(r, s)};
}

void set_vector(BeamBlock& block, Index place, Index item, const Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) block.set_state(place, item + axis, vector[axis]);
}

/// What a beam with preloads stores in its springs at time zero [energy].
double stored_energy(const model::DiscreteBeamLaw& law, const DiscreteBeamResponse& response,
                     double free_length) {
  double sum = 0;
  for (int i = 0; i < discrete_directions && !(law.ramp_time > 0); ++i) {
    const double preload = law.direction[static_cast<std::size_t>(i)].preload;
    const double stiffness = response.stiffness(i, free_length);
    if (stiffness > 0) sum += 0.5 * preload * preload / stiffness;
  }
  return sum;
}

void start_element(const model::Model& model, domain::Domain& domain, const model::DiscreteBeamLaw& law,
                   BeamBlock& block, Index place) {
  const model::Part& part = model.parts[block.part];
  const model::DiscreteBeamData& data = model.beam_sections[part.beam_section].discrete;
  const model::BeamElement& beam = model.beams[block.element[std::min(place, block.elements - 1)]];
  const std::array<Index, 2> node = block.nodes_of(place);
  const Vec3 span = domain.nodes.position[node[1]] - domain.nodes.position[node[0]];
  const double length = norm(span);
  block.set_state(place, beam_state::active, place < block.elements ? 1 : 0);
  block.set_state(place, beam_state::reference_length, length);
  const std::array<Vec3, 3> axes = axes_at_start(model, beam, span, data);
  set_vector(block, place, discrete_beam_state::axes, axes[0]);
  set_vector(block, place, discrete_beam_state::axes + 3, axes[1]);
  if (law.kind == Kind::Axes) {
    set_vector(block, place, discrete_beam_state::reference,
               {dot(span, axes[0]), dot(span, axes[1]), dot(span, axes[2])});
  } else {
    const double free = length - data.cable_offset;
    if (!(length > 0) || !(free > 0))
      throw Error("Beam " + std::to_string(beam.id) + " has no length, or its offset leaves none.");
    set_vector(block, place, discrete_beam_state::reference, {free, 0, 0});
  }
  if (place >= block.elements) return;
  const double energy = stored_energy(law, DiscreteBeamResponse(block.material_constants.data()),
                                      block.state(place, discrete_beam_state::reference));
  block.set_state(place, discrete_beam_state::energy, energy);
  block.add_internal_energy(place, energy);
  const double volume = data.volume > 0 ? data.volume : data.cable_area * length;
  for (const Index end : node) {
    add_mass(domain, block.part, end, 0.5 * model.materials[part.material].density * volume);
    domain.nodes.inertia[end] += 0.5 * data.inertia;
  }
}

/// What all discrete beams at a node have together.
struct NodeSums {
  std::vector<double> force_stiffness, force_damping, moment_stiffness, moment_damping;

  explicit NodeSums(Index nodes)
      : force_stiffness(nodes), force_damping(nodes), moment_stiffness(nodes), moment_damping(nodes) {}
};

/// Stiffness and damping of one beam, and the lever of its forces at both ends.
struct Demand {
  double force = 0;
  double moment = 0;
  double force_damping = 0;
  double moment_damping = 0;
  std::array<double, 2> lever{};
};

Demand demand_of(const BeamBlock& block, const DiscreteBeamResponse& law, const BeamConstants& constants,
                 Index place) {
  Demand demand;
  const double free = block.state(place, discrete_beam_state::reference);
  for (int i = 0; i < 3; ++i) {
    demand.force = std::max(demand.force, law.stiffness(i, free));
    demand.force_damping = std::max(demand.force_damping, law.damping(i));
    if (law.kind() != Kind::Axes) continue;
    demand.moment = std::max(demand.moment, law.stiffness(3 + i, free));
    demand.moment_damping = std::max(demand.moment_damping, law.damping(3 + i));
  }
  if (law.kind() != Kind::Axes) return demand;
  const double length = block.state(place, beam_state::reference_length);
  demand.lever = {constants.first_share * length, (1 - constants.first_share) * length};
  return demand;
}

class Steps {
 public:
  Steps(const model::Model& model, const domain::Domain& domain)
      : model_(model), nodes_(domain.nodes), bodies_(model, domain), sums_(domain.nodes.count()) {}

  void add(const BeamBlock& block, const Demand& demand, Index place) {
    for (Index end = 0; end < 2; ++end) {
      const double square = demand.lever[end] * demand.lever[end];
      const Index node = bodies_.shared_node(block.node_of(place, end), false);
      const Index turning = bodies_.shared_node(block.node_of(place, end), true);
      sums_.force_stiffness[node] += demand.force;
      sums_.force_damping[node] += demand.force_damping;
      sums_.moment_stiffness[turning] += demand.moment + square * demand.force;
      sums_.moment_damping[turning] += demand.moment_damping + square * demand.force_damping;
    }
  }

  /// 2 / frequency of the springs between their shares of the masses; of dampers the time in which half the
  /// relative velocity of the ends would be gone (as prepare_discretes.cpp).
  double step_of(const BeamBlock& block, const Demand& demand, Index place) const {
    double step = 1e30;
    const auto spring = [&](double inverse) {
      if (inverse > 0) step = std::min(step, 2 / std::sqrt(inverse));
    };
    const auto damper = [&](double inverse) {
      if (inverse > 0) step = std::min(step, 1 / inverse);
    };
    spring(share(block, place, false, demand.force > 0, sums_.force_stiffness) +
           share(block, place, true, demand.lever[0] + demand.lever[1] > 0 && demand.force > 0,
                 sums_.moment_stiffness, false));
    spring(share(block, place, true, demand.moment > 0, sums_.moment_stiffness));
    damper(share(block, place, false, demand.force_damping > 0, sums_.force_damping));
    damper(share(block, place, true, demand.moment_damping > 0, sums_.moment_damping));
    return step;
  }

 private:
  bool is_held(Index node, bool turning) const {
    const unsigned bits = turning ? nodes_.fixed[node] >> 3U : nodes_.fixed[node];
    return (bits & 7U) == 7U;
  }

  /// Half the mass of a node is shared by its discrete beams as their stiffness: stiffness times the sum of
  /// 1 / mass over both ends. Nodes that are not `needed` may have none.
  double share(const BeamBlock& block, Index place, bool turning, bool counts, const std::vector<double>& sum,
               bool needed = true) const {
    if (!counts) return 0;
    double result = 0;
    for (Index end = 0; end < 2; ++end) {
      const Index node = block.node_of(place, end);
      if (is_held(node, turning)) continue;
      const double mass = (turning ? nodes_.inertia : nodes_.mass)[node];
      const double response = mass > 0 ? 1 / mass : bodies_.at(node, turning);
      if (!(response > 0) && !needed) continue;
      if (!(response > 0))
        throw Error("Node " + std::to_string(model_.nodes.id[nodes_.model_node[node]]) +
                    " of discrete beam " + std::to_string(model_.beams[block.element[place]].id) +
                    (turning ? " has no rotary inertia: give the section one (INER), or hold the node."
                             : " has no mass: give the section a volume (VOL), or hold the node."));
      result += 2 * sum[bodies_.shared_node(node, turning)] * response;
    }
    return result;
  }

  const model::Model& model_;
  const domain::NodeFields& nodes_;
  BodyResponse bodies_;
  NodeSums sums_;
};

}  // namespace

void prepare_discrete_beams(const model::Model& model, domain::Domain& domain, BeamBlock& block) {
  const model::DiscreteBeamLaw& law = law_of(model, block);
  const model::Part& part = model.parts[block.part];
  const model::DiscreteBeamData& data = model.beam_sections[part.beam_section].discrete;
  BeamConstants constants;
  constants.section_fails = has_limits(law) ? 1 : 0;
  constants.first_share = 0.5 * (1 - data.place);
  for (std::size_t i = 0; i < 3; ++i) constants.held_turn[i] = data.held[i] ? 1 : 0;
  declare_discrete_items(block, law.unloading != model::DiscreteBeamLaw::Unloading::None);
  block.allocate(Precision::Double);
  block.element_constants = to_numbers(constants);
  block.material_constants = discrete_beam_numbers(law, model, data);
  for (Index place = 0; place < block.groups() * lanes; ++place)
    start_element(model, domain, law, block, place);
}

void set_discrete_beam_steps(const model::Model& model, domain::Domain& domain) {
  const auto is_discrete = [](const BeamBlock& block) {
    return block.formulation == model::BeamFormulation::Discrete;
  };
  if (std::none_of(domain.beams.begin(), domain.beams.end(), is_discrete)) return;
  Steps steps(model, domain);
  const auto visit = [&](const auto& work) {
    for (BeamBlock& block : domain.beams) {
      if (!is_discrete(block)) continue;
      const DiscreteBeamResponse law(block.material_constants.data());
      const BeamConstants constants = beam_constants(block.element_constants);
      for (Index place = 0; place < block.elements; ++place)
        work(block, demand_of(block, law, constants, place), place);
    }
  };
  visit([&](const BeamBlock& block, const Demand& demand, Index place) { steps.add(block, demand, place); });
  visit([&](BeamBlock& block, const Demand& demand, Index place) {
    block.set_state(place, beam_state::stable_step, steps.step_of(block, demand, place));
  });
}

}  // namespace crumple::elements
