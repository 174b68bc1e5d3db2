// SPDX-License-Identifier: BSD-3-Clause
#include "elements/initial_stress.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "domain/shell_side.hpp"
#include "elements/shell/shell_setup.hpp"
#include "elements/shell/shell_task.hpp"
#include "elements/solid/solid_task.hpp"
#include "materials/initial_stress.hpp"

namespace crumple::elements {
namespace {

using math::Vec3;
using model::InitialPointStress;
using model::InitialStress;

/// What each element begins with; nullptr for those that begin without stress. A later entry counts.
std::vector<const InitialStress*> by_element(const std::vector<InitialStress>& all, std::size_t count) {
  std::vector<const InitialStress*> found(count, nullptr);
  for (const InitialStress& one : all) found[static_cast<std::size_t>(one.element)] = &one;
  return found;
}

InitialPointStress mixed(const InitialPointStress& a, const InitialPointStress& b, double share) {
  InitialPointStress sum = a;
  for (std::size_t k = 0; k < 6; ++k) sum.stress[k] += share * (b.stress[k] - a.stress[k]);
  for (std::size_t k = 0; k < 5; ++k) sum.back_stress[k] += share * (b.back_stress[k] - a.back_stress[k]);
  sum.plastic_strain = std::max(0.0, a.plastic_strain + share * (b.plastic_strain - a.plastic_strain));
  return sum;
}

/// Linear through the thickness between the points of one plane, whose places ascend, and on beyond the outer
/// ones.
InitialPointStress at_place(const InitialPointStress* points, std::size_t count, double place) {
  if (count == 1) return points[0];
  std::size_t above = 1;
  while (above + 1 < count && points[above].place < place) ++above;
  const InitialPointStress& low = points[above - 1];
  const InitialPointStress& high = points[above];
  const double share = (place - low.place) / (high.place - low.place);
  // Where the points are the element's own nothing is to be rounded.
  constexpr double same = 1e-4;
  if (share < same && share > -same) return low;
  if (share > 1 - same && share < 1 + same) return high;
  return mixed(low, high, share);
}

/// Stress of a plane of the element at a place: of the same plane, of the only one, or the mean of all.
InitialPointStress of_plane(const InitialStress& given, Index plane, Index planes, double place) {
  const auto given_planes = static_cast<std::size_t>(given.planes);
  const std::size_t layers = given.points.size() / given_planes;
  const auto at = [&](std::size_t k) { return at_place(given.points.data() + k * layers, layers, place); };
  if (given_planes == 1) return at(0);
  if (given.planes == planes) return at(static_cast<std::size_t>(plane));
  InitialPointStress mean = at(0);
  for (std::size_t k = 1; k < given_planes; ++k) mean = mixed(mean, at(k), 1.0 / static_cast<double>(k + 1));
  return mean;
}

struct ShellFrame {
  Vec3 e1, e2, e3;
};

/// The lamina axes at time zero.
ShellFrame frame_of(const ShellCorners& corner) {
  const Vec3 r31 = corner[2] - corner[0];
  const Vec3 r42 = corner[3] - corner[1];
  ShellFrame frame;
  frame.e1 = normalised(r31 - r42);
  frame.e3 = normalised(cross(r31, r42));
  frame.e2 = cross(frame.e3, frame.e1);
  return frame;
}

/// xx, yy, xy, yz, zx in these axes of a tensor in global ones.
std::array<double, 5> in_lamina(const std::array<double, 6>& s, const ShellFrame& axes) {
  const auto on = [&](const Vec3& n) {
    return Vec3{s[0] * n.x + s[3] * n.y + s[5] * n.z, s[3] * n.x + s[1] * n.y + s[4] * n.z,
                s[5] * n.x + s[4] * n.y + s[2] * n.z};
  };
  return {dot(axes.e1, on(axes.e1)), dot(axes.e2, on(axes.e2)), dot(axes.e1, on(axes.e2)),
          dot(axes.e2, on(axes.e3)), dot(axes.e3, on(axes.e1))};
}

/// From axes whose first is along a side of the element.
std::array<double, 5> turned_from_side(const std::array<double, 5>& b, const Vec3& side,
                                       const ShellFrame& axes) {
  const Vec3 first = normalised(side - dot(side, axes.e3) * axes.e3);
  const double c = dot(first, axes.e1);
  const double s = dot(first, axes.e2);
  return {c * c * b[0] + s * s * b[1] - 2 * c * s * b[2], s * s * b[0] + c * c * b[1] + 2 * c * s * b[2],
          c * s * (b[0] - b[1]) + (c * c - s * s) * b[2], c * b[3] + s * b[4], c * b[4] - s * b[3]};
}

const model::ConstitutiveLaw& law_of(const model::Model& model, const domain::ShellBlock& block,
                                     Index layer) {
  const Index material = block.layup == no_index ? model.parts[static_cast<std::size_t>(block.part)].material
                                                 : model.layups[static_cast<std::size_t>(block.layup)]
                                                       .layers[static_cast<std::size_t>(layer)]
                                                       .material;
  return model.materials[static_cast<std::size_t>(material)].law;
}

void set_shell(const model::Model& model, const domain::Domain& domain, const InitialStress& given,
               domain::ShellBlock& block, Index element) {
  const model::ShellElement& shell = model.shells[static_cast<std::size_t>(given.element)];
  const auto constants = from_numbers<ShellConstants<double>>(block.element_constants);
  const ShellFrame axes = frame_of(corners_of(domain, block.nodes_of(element)));
  const Vec3 side = domain::first_side(domain.nodes, shell);
  if (given.planes != 1 && given.planes != block.plane_points && block.plane_points != 1)
    throw Error("Shell " + std::to_string(shell.id) + ": initial stresses at " +
                std::to_string(given.planes) + " points in plane for " + std::to_string(block.plane_points) +
                ".");
  for (Index plane = 0; plane < block.plane_points; ++plane)
    for (Index layer = 0; layer < block.thickness_points; ++layer) {
      const double place = block.point_place[static_cast<std::size_t>(layer)];
      const InitialPointStress point = of_plane(given, plane, block.plane_points, place);
      const std::array<double, 5> stress = in_lamina(point.stress, axes);
      const std::array<double, 5> back = turned_from_side(point.back_stress, side, axes);
      materials::set_initial_stress(law_of(model, block, layer), {stress, point.plastic_strain, back}, block,
                                    constants.history, element, plane * block.thickness_points + layer);
    }
}

/// The back stress is a deviator.
std::array<double, 6> six_of(const std::array<double, 5>& back) {
  return {back[0], back[1], -back[0] - back[1], back[2], back[3], back[4]};
}

/// LS-DYNA's points come in the order of the nodes, ours by the sides that the bits of their number say.
Index number_of_point(Index point) {
  constexpr std::array<Index, 8> by_node = {0, 1, 3, 2, 4, 5, 7, 6};
  return by_node[static_cast<std::size_t>(point)];
}

void set_solid(const model::Model& model, const InitialStress& given, domain::SolidBlock& block,
               Index element) {
  const model::Part& part = model.parts[static_cast<std::size_t>(block.part)];
  const auto& law = model.materials[static_cast<std::size_t>(part.material)].law;
  const auto constants = from_numbers<SolidConstants<double>>(block.element_constants);
  const auto count = static_cast<Index>(given.points.size());
  if (count != 1 && count != block.points && block.points != 1)
    throw Error("Solid " + std::to_string(model.solids[static_cast<std::size_t>(given.element)].id) +
                ": initial stresses at " + std::to_string(count) + " points for " +
                std::to_string(block.points) + ".");
  InitialPointStress mean = given.points.front();
  for (std::size_t k = 1; k < given.points.size(); ++k)
    mean = mixed(mean, given.points[k], 1.0 / static_cast<double>(k + 1));
  for (Index point = 0; point < block.points; ++point) {
    const bool own = count == block.points && count > 1;
    const InitialPointStress& start = own ? given.points[static_cast<std::size_t>(point)] : mean;
    const std::array<double, 6> back = six_of(start.back_stress);
    materials::set_initial_stress(law, {start.stress, start.plastic_strain, back}, block, constants.history,
                                  element, block.points == 8 ? number_of_point(point) : point);
  }
}

}  // namespace

void set_initial_stresses(const model::Model& model, domain::Domain& domain) {
  if (!model.shell_stresses.empty()) {
    const auto given = by_element(model.shell_stresses, model.shells.size());
    for (domain::ShellBlock& block : domain.shells)
      for (Index element = 0; element < block.elements; ++element)
        if (const InitialStress* one = given[static_cast<std::size_t>(block.element[element])])
          set_shell(model, domain, *one, block, element);
  }
  if (model.solid_stresses.empty()) return;
  const auto given = by_element(model.solid_stresses, model.solids.size());
  for (domain::SolidBlock& block : domain.solids)
    for (Index element = 0; element < block.elements; ++element)
      if (const InitialStress* one = given[static_cast<std::size_t>(block.element[element])])
        set_solid(model, *one, block, element);
}

}  // namespace crumple::elements
