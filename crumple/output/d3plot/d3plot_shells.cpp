// SPDX-License-Identifier: BSD-3-Clause
#include "output/d3plot/d3plot_shells.hpp"

#include <algorithm>
#include <cmath>

#include "output/results/part_masses.hpp"
#include "output/results/point_results.hpp"

namespace crumple::output {

namespace {

struct PlaneTensor {
  double xx = 0, yy = 0, xy = 0;
};

/// Along axes turned by the angle of that cosine and sine.
PlaneTensor turned(const PlaneTensor& t, double c, double s) {
  return {c * c * t.xx + s * s * t.yy + 2 * c * s * t.xy, s * s * t.xx + c * c * t.yy - 2 * c * s * t.xy,
          c * s * (t.yy - t.xx) + (c * c - s * s) * t.xy};
}

}  // namespace

D3plotShells::D3plotShells(const View& view, const domain::ShellBlock& block)
    : view_(&view),
      block_(&block),
      section_(&view.model.shell_sections[view.model.parts[block.part].section]),
      results_(view.model, block),
      history_(block),
      layout_(view.model.output.extent),
      energy_(block.find("energy")) {}

double D3plotShells::history(Index place, Index layer, int variable) const {
  double mean = 0;
  const Index planes = block_->plane_points;
  for (Index plane = 0; plane < planes; ++plane)
    mean += history_.value(place, plane * results_.layers() + layer, variable) / planes;
  return mean;
}

void D3plotShells::add_layer(D3plotWords& words, const ShellAxes& axes, Index place, Index below,
                             Index above) const {
  ShellResults::Stress local = results_.stress(place, below);
  const ShellResults::Stress other = results_.stress(place, above);
  for (std::size_t c = 0; c < local.size(); ++c) local[c] = 0.5 * (local[c] + other[c]);
  if (layout_.stresses)
    for (const double component : in_global_axes(axes, local)) words.real(component);
  if (layout_.plastic_strain)
    words.real(0.5 * (results_.plastic_strain(place, below) + results_.plastic_strain(place, above)));
  for (int i = 0; i < layout_.shell_history; ++i)
    words.real(0.5 * (history(place, below, i) + history(place, above, i)));
}

/// From the first node of the deck to the next that is not the same.
math::Vec3 D3plotShells::first_side(Index place) const {
  const domain::NodeFields& nodes = view_->domain.nodes;
  const std::array<Index, 4>& node = view_->model.shells[block_->element[place]].node;
  const auto at = [&](std::size_t k) { return nodes.position[nodes.domain_node[node[k]]]; };
  return node[0] == node[1] ? at(2) - at(1) : at(1) - at(0);
}

void D3plotShells::add_resultants(D3plotWords& words, const ShellAxes& axes, Index place) const {
  const double thickness = results_.thickness(place);
  PlaneTensor force;
  PlaneTensor moment;
  double shear1 = 0;
  double shear2 = 0;
  for (Index layer = 0; layer < static_cast<Index>(block_->point_place.size()); ++layer) {
    const auto [xx, yy, xy, yz, zx] = results_.stress(place, layer);
    const double weight = thickness * block_->point_weight[static_cast<std::size_t>(layer)];
    const double arm = 0.5 * thickness * block_->point_place[static_cast<std::size_t>(layer)] * weight;
    force = {force.xx + weight * xx, force.yy + weight * yy, force.xy + weight * xy};
    moment = {moment.xx + arm * xx, moment.yy + arm * yy, moment.xy + arm * xy};
    // The stress that the formulations keep has the root of the factor once, their forces have it twice.
    shear1 += std::sqrt(section_->shear_factor) * weight * zx;
    shear2 += std::sqrt(section_->shear_factor) * weight * yz;
  }
  const math::Vec3 side = first_side(place);
  const double along = dot(side, axes.e1);
  const double across = dot(side, axes.e2);
  const double length = std::hypot(along, across);
  const double c = length > 0 ? along / length : 1;
  const double s = length > 0 ? across / length : 0;
  const PlaneTensor m = turned(moment, c, s);
  const PlaneTensor n = turned(force, c, s);
  for (const double value :
       {m.xx, m.yy, m.xy, c * shear1 + s * shear2, c * shear2 - s * shear1, n.xx, n.yy, n.xy})
    words.real(value);
}

double D3plotShells::energy_density(Index place) const {
  if (energy_ == nullptr) return 0;
  const model::ShellElement& shell = view_->model.shells[block_->element[place]];
  const double density = model::material_of(view_->model, shell).density;
  const double volume = shell_mass(*view_, shell) / density;
  return volume > 0 ? block_->state(place, energy_->first) / volume : 0;
}

void D3plotShells::add_shell(D3plotWords& words, Index place) const {
  const ShellAxes axes = shell_axes(*block_, view_->domain.nodes, place);
  if (layout_.layers == D3plotLayout::surfaces) {
    add_layer(words, axes, place, (results_.layers() - 1) / 2, results_.layers() / 2);
    for (const Index layer : {0, results_.layers() - 1}) add_layer(words, axes, place, layer, layer);
  } else {
    const int present = std::min(layout_.layers, results_.layers());
    for (Index layer = 0; layer < present; ++layer) add_layer(words, axes, place, layer, layer);
    words.zeros((layout_.layers - present) * layout_.layer_values());
  }
  if (layout_.resultants) add_resultants(words, axes, place);
  if (!layout_.energy) return;
  words.real(results_.thickness(place));
  words.zeros(2);
  words.real(energy_density(place));
}

}  // namespace crumple::output
