// SPDX-License-Identifier: BSD-3-Clause
#include "output/d3plot/d3plot_state.hpp"

#include "output/d3plot/d3plot_geometry.hpp"
#include "output/d3plot/d3plot_layout.hpp"
#include "output/d3plot/d3plot_shells.hpp"
#include "output/results/line_results.hpp"
#include "output/results/solid_results.hpp"

namespace crumple::output {

namespace {

using math::Vec3;

Vec3 mean_velocity(const domain::NodeFields& nodes) {
  Vec3 momentum;
  double mass = 0;
  for (Index node = 0; node < nodes.count(); ++node) {
    momentum += nodes.mass[node] * nodes.velocity[node];
    mass += nodes.mass[node];
  }
  return mass > 0 ? (1 / mass) * momentum : Vec3{};
}

void add_nodes(D3plotWords& words, const domain::NodeFields& nodes) {
  for (const auto* field : {&nodes.position, &nodes.velocity, &nodes.acceleration})
    for (const Index node : nodes.domain_node) words.vector((*field)[node]);
}

void add_line(D3plotWords& words, const LineResults& results, Index place) {
  const auto value = [&](Resultant which) { return results.resultant(place, which); };
  words.real(value(Resultant::AxialForce));
  words.real(value(Resultant::ShearS));
  words.real(value(Resultant::ShearT));
  // The moments of the two ends act on the beam: that in the section halfway is half their difference.
  words.real(0.5 * (value(Resultant::SecondMomentS) - value(Resultant::FirstMomentS)));
  words.real(0.5 * (value(Resultant::SecondMomentT) - value(Resultant::FirstMomentT)));
  words.real(value(Resultant::Torsion));
}

/// The number of its part for each element that is alive, 0 for the others.
template <class Elements>
void add_deletions(D3plotWords& words, const Elements& elements, const char* alive) {
  for (const auto& element : elements) words.real(*alive++ != 0 ? element.part + 1 : 0);
}

std::size_t state_words(const View& view) {
  const model::Model& model = view.model;
  const D3plotLayout layout(model.output.extent);
  const std::size_t lines = model.beams.size() + model.discretes.size();
  return 8 + 7 * model.parts.size() + d3plot_wall_values * view.domain.walls.size() +
         9 * model.nodes.id.size() +
         static_cast<std::size_t>(layout.solid_values() + 1) * model.solids.size() +
         (D3plotLayout::beam_values + 1) * lines +
         static_cast<std::size_t>(layout.shell_values() + 1) * model.shells.size();
}

}  // namespace

D3plotState::D3plotState(const View& view)
    : masses_(view),
      shell_place_(block_places(view.domain.shells, view.model.shells.size())),
      solid_place_(block_places(view.domain.solids, view.model.solids.size())),
      beam_place_(block_places(view.domain.beams, view.model.beams.size())),
      discrete_place_(block_places(view.domain.discretes, view.model.discretes.size())),
      wall_normal_impulse_(view.domain.walls.size()) {}

void D3plotState::add_globals(D3plotWords& words, const View& view) {
  const domain::EnergyLedger& energy = view.domain.energy;
  words.real(energy.kinetic);
  words.real(energy.internal);
  words.real(energy.total());
  words.vector(mean_velocity(view.domain.nodes));
  const Index parts = static_cast<Index>(view.model.parts.size());
  std::vector<double> internal(parts);
  std::vector<double> hourglass(parts);
  for (const domain::ElementBlock* block : view.domain.blocks()) {
    internal[block->part] += block->internal_energy;
    hourglass[block->part] += block->hourglass_energy;
  }
  std::vector<PartMasses::Motion> motions(parts);
  for (Index part = 0; part < parts; ++part) motions[part] = masses_.motion_with_body(view.domain, part);
  for (const double value : internal) words.real(value);
  for (const PartMasses::Motion& motion : motions) words.real(motion.kinetic_energy);
  for (const PartMasses::Motion& motion : motions) words.vector(motion.velocity);
  for (const PartMasses::Motion& motion : motions) words.real(motion.mass);
  for (const double value : hourglass) words.real(value);
}

void D3plotState::add_walls(D3plotWords& words, const View& view) {
  const std::vector<domain::WallReport>& walls = view.domain.walls;
  const double interval = view.domain.clock.time - time_;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    words.real(interval > 0 ? (walls[i].normal_impulse - wall_normal_impulse_[i]) / interval : 0);
    wall_normal_impulse_[i] = walls[i].normal_impulse;
  }
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto& [x, y, z] = view.model.rigid_walls[i].point;
    words.vector(Vec3{x, y, z} + walls[i].displacement_now);
  }
  time_ = view.domain.clock.time;
}

void D3plotState::add_solids(D3plotWords& words, const View& view) {
  const std::vector<SolidResults> results(view.domain.solids.begin(), view.domain.solids.end());
  const std::vector<PointHistory> histories(view.domain.solids.begin(), view.domain.solids.end());
  const D3plotLayout layout(view.model.output.extent);
  solid_alive_.clear();
  for (const auto& [block, place] : solid_place_) {
    for (const double component : results[block].mean_stress(place)) words.real(component);
    words.real(results[block].mean_plastic_strain(place));
    const Index points = view.domain.solids[block].points;
    for (int variable = 0; variable < layout.solid_history; ++variable) {
      double mean = 0;
      for (Index point = 0; point < points; ++point)
        mean += histories[block].value(place, point, variable) / points;
      words.real(mean);
    }
    solid_alive_.push_back(results[block].alive(place) ? 1 : 0);
  }
}

void D3plotState::add_lines(D3plotWords& words, const View& view) {
  std::vector<LineResults> beams;
  for (const domain::BeamBlock& block : view.domain.beams) beams.emplace_back(view.model, block);
  const std::vector<LineResults> discretes(view.domain.discretes.begin(), view.domain.discretes.end());
  line_alive_.clear();
  const auto add = [&](const BlockPlaces& places, const std::vector<LineResults>& results) {
    for (const auto& [block, place] : places) {
      add_line(words, results[block], place);
      line_alive_.push_back(results[block].alive(place) ? 1 : 0);
    }
  };
  add(beam_place_, beams);
  add(discrete_place_, discretes);
}

void D3plotState::add_shells(D3plotWords& words, const View& view) {
  std::vector<D3plotShells> results;
  for (const domain::ShellBlock& block : view.domain.shells) results.emplace_back(view, block);
  shell_alive_.clear();
  for (const auto& [block, place] : shell_place_) {
    results[block].add_shell(words, place);
    shell_alive_.push_back(results[block].alive(place) ? 1 : 0);
  }
}

D3plotWords D3plotState::words(const View& view) {
  D3plotWords words;
  words.reserve(state_words(view) + D3plotWords::block);
  words.real(view.domain.clock.time);
  add_globals(words, view);
  add_walls(words, view);
  add_nodes(words, view.domain.nodes);
  add_solids(words, view);
  add_lines(words, view);
  add_shells(words, view);
  add_deletions(words, view.model.solids, solid_alive_.data());
  add_deletions(words, view.model.shells, shell_alive_.data());
  add_deletions(words, view.model.beams, line_alive_.data());
  add_deletions(words, view.model.discretes, line_alive_.data() + view.model.beams.size());
  return words;
}

void D3plotState::declare(domain::StateList& list) {
  list.keep("d3plot_time", "time", domain::Entity::Run, time_);
  list.keep_list("d3plot_wall_impulse", "force*time", domain::Entity::Wall, 1, wall_normal_impulse_);
}

}  // namespace crumple::output
