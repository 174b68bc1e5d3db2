// SPDX-License-Identifier: BSD-3-Clause
#include "elements/solid/nodal_average.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "elements/solid/solid_task.hpp"
#include "math/vec3.hpp"

namespace crumple::elements {
namespace {

using math::Vec3;

constexpr Index piece = 1024;

template <class Body>
void for_each_in_pieces(std::size_t size, int threads, const Body& body) {
  const auto count = static_cast<Index>(size);
  parallel_for(pieces(count, piece), threads, [&](Index p) {
    for (Index i = p * piece; i < std::min((p + 1) * piece, count); ++i) body(i);
  });
}

template <class Real>
Vec3 vector_of(const Real (&v)[4]) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// Volume and its rate at the middle of the step.
template <class Real>
void measure(const domain::NodeRecord<Real>* records, double half_step, Index place,
             domain::SolidBlock& block) {
  Vec3 x[4];
  Vec3 v[4];
  for (Index k = 0; k < 4; ++k) {
    const domain::NodeRecord<Real>& node = records[block.node_of(place, k)];
    v[k] = vector_of(node.velocity);
    x[k] = vector_of(node.position) - half_step * v[k];
  }
  const Vec3 a = x[1] - x[0];
  const Vec3 b = x[2] - x[0];
  const Vec3 c = x[3] - x[0];
  const Vec3 across_a = cross(b, c);
  const double rate =
      dot(v[1] - v[0], across_a) + dot(v[2] - v[0], cross(c, a)) + dot(v[3] - v[0], cross(a, b));
  block.average.volume[place] = dot(a, across_a) / 6;
  block.average.volume_rate[place] = rate / 6;
}

template <class Real>
void average(const domain::NodeRecord<Real>* records, double step, int threads, Index own,
             domain::SolidBlock& block) {
  domain::NodalAverage& average = block.average;
  for_each_in_pieces(average.volume.size(), threads, [&](Index place) {
    average.volume[place] = average.volume_rate[place] = 0;
    if (block.state(place, own + solid_state::active) != 0) measure(records, 0.5 * step, place, block);
  });
  for_each_in_pieces(average.dilatation.size(), threads, [&](Index node) {
    double volume = 0;
    double rate = 0;
    for (Index i = average.first_element[node]; i < average.first_element[node + 1]; ++i) {
      volume += average.volume[average.element[i]];
      rate += average.volume_rate[average.element[i]];
    }
    average.dilatation[node] = volume > 0 ? rate / volume : 0;
  });
  for_each_in_pieces(average.volume.size(), threads, [&](Index place) {
    const Index* const node = average.node.data() + 4 * static_cast<std::ptrdiff_t>(place);
    const auto at = [&](int k) { return average.dilatation[node[k]]; };
    const bool active = average.volume[place] != 0;
    block.set_state(place, own + solid_state::own, active ? 0.25 * ((at(0) + at(1)) + (at(2) + at(3))) : 0);
  });
}

}  // namespace

void prepare_average(domain::SolidBlock& block) {
  domain::NodalAverage& average = block.average;
  std::vector<Index> nodes;
  nodes.reserve(4 * static_cast<std::size_t>(block.elements));
  for (Index place = 0; place < block.elements; ++place)
    for (Index k = 0; k < 4; ++k) nodes.push_back(block.node_of(place, k));
  average.node = nodes;
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (Index& node : average.node)
    node = static_cast<Index>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  average.first_element.assign(nodes.size() + 1, 0);
  for (const Index node : average.node) ++average.first_element[node + 1];
  for (std::size_t i = 0; i < nodes.size(); ++i) average.first_element[i + 1] += average.first_element[i];
  std::vector<Index> next(average.first_element.begin(), average.first_element.end() - 1);
  average.element.resize(average.node.size());
  for (std::size_t i = 0; i < average.node.size(); ++i)
    average.element[next[average.node[i]]++] = static_cast<Index>(i / 4);
  average.volume.resize(block.elements);
  average.volume_rate.resize(block.elements);
  average.dilatation.resize(nodes.size());
}

void average_dilatations(domain::Domain& domain) {
  const int threads = domain.execution.threads;
  for (domain::SolidBlock& block : domain.solids) {
    if (block.average.node.empty() || block.rigid) continue;
    const Index own = from_numbers<SolidConstants<double>>(block.element_constants).own;
    if (domain.execution.precision == Precision::Mixed)
      average(domain.nodes.float_records.data(), domain.clock.step, threads, own, block);
    else
      average(domain.nodes.double_records.data(), domain.clock.step, threads, own, block);
  }
}

}  // namespace crumple::elements
