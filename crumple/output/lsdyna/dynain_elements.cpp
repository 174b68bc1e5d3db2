// SPDX-License-Identifier: BSD-3-Clause
#include "output/lsdyna/dynain_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "domain/shell_side.hpp"
#include "model/initial_stress.hpp"
#include "output/lsdyna/dynain.hpp"
#include "output/results/point_results.hpp"
#include "output/results/shell_axes.hpp"

namespace crumple::output {
namespace {

using math::Vec3;
using BackStress = std::array<double, 5>;

constexpr std::size_t columns = 16;
constexpr std::size_t numbers_in_line = 5;

void append_lines(const std::vector<double>& numbers, std::string& text) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += number_in_columns(numbers[i], columns);
    if (i % numbers_in_line == numbers_in_line - 1 || i + 1 == numbers.size()) text += '\n';
  }
}

/// With what rounding has left out of the sum.
double whole_plastic_strain(const domain::ElementBlock& block, Index place, Index point) {
  double sum = plastic_strain_of(block, place, point);
  for (const domain::StateItem& item : block.items) {
    if (item.name != "plastic_strain_rest") continue;
    const Index at = item.point_of(point);
    if (at != no_index && at < item.count) sum += block.state(place, item.first + at);
  }
  return sum;
}

/// Those of the block, in lamina axes, in axes whose first is along a side of the element.
BackStress turned_to_side(const BackStress& b, const Vec3& side, const ShellAxes& axes) {
  const Vec3 first = normalised(side - dot(side, axes.e3) * axes.e3);
  const double c = dot(first, axes.e1);
  const double s = dot(first, axes.e2);
  return {c * c * b[0] + s * s * b[1] + 2 * c * s * b[2], s * s * b[0] + c * c * b[1] - 2 * c * s * b[2],
          c * s * (b[1] - b[0]) + (c * c - s * s) * b[2], c * b[3] - s * b[4], c * b[4] + s * b[3]};
}

/// Of a block without layers.
bool writes_back_stress(const model::Model& model, const domain::ElementBlock& block, bool layered) {
  const Index material = model.parts[static_cast<std::size_t>(block.part)].material;
  return !layered && model::has_back_stress(model.materials[static_cast<std::size_t>(material)].law) &&
         block.find("back_stress") != nullptr;
}

/// The largest plastic strain decides with some laws whether they can go on.
model::InitialStress likeness(const domain::ElementBlock& block, bool back_stress) {
  model::InitialStress stress;
  stress.has_back_stress = back_stress;
  stress.points.resize(1);
  for (Index place = 0; place < block.elements; ++place)
    for (Index point = 0; point < block.points; ++point)
      stress.points[0].plastic_strain =
          std::max(stress.points[0].plastic_strain, plastic_strain_of(block, place, point));
  return stress;
}

/// LS-DYNA's points of a solid in the order of its nodes, as places in the block.
Index place_of_point(Index point, Index points) {
  constexpr std::array<Index, 8> by_node = {0, 1, 3, 2, 4, 5, 7, 6};
  return points == 8 ? by_node[static_cast<std::size_t>(point)] : point;
}

BackStress back_stress_of(const domain::StateItem& item, const domain::ElementBlock& block, Index place,
                          Index point, bool solid) {
  constexpr std::array<Index, 5> of_six = {0, 1, 3, 4, 5};
  BackStress back{};
  for (std::size_t k = 0; k < back.size(); ++k)
    back[k] =
        block.state(place, item.first + (solid ? 6 * point + of_six[k] : 5 * point + static_cast<Index>(k)));
  return back;
}

}  // namespace

void append_shell_stress(const View& view, const domain::ShellBlock& block, Index place, std::string& text) {
  const model::ShellElement& shell = view.model.shells[static_cast<std::size_t>(block.element[place])];
  const bool back_stress = writes_back_stress(view.model, block, block.layup != no_index);
  fmt::format_to(std::back_inserter(text), "{:10}{:10}{:10}{:10}{:10}{:10}\n", shell.id, block.plane_points,
                 block.thickness_points, back_stress ? 5 : 0, 0, 1);
  const ShellAxes axes = shell_axes(block, view.domain.nodes, place);
  const Vec3 side = domain::first_side(view.domain.nodes, shell);
  for (Index layer = 0; layer < block.thickness_points; ++layer)
    for (Index plane = 0; plane < block.plane_points; ++plane) {
      const Index point = plane * block.thickness_points + layer;
      const Tensor s = in_global_axes(axes, stress_of<5>(block, place, point));
      std::vector<double> numbers = {
          block.point_place[static_cast<std::size_t>(layer)], s[0], s[1], s[2], s[3], s[4], s[5],
          whole_plastic_strain(block, place, point)};
      if (back_stress) {
        const BackStress back = turned_to_side(
            back_stress_of(*block.find("back_stress"), block, place, point, false), side, axes);
        numbers.insert(numbers.end(), back.begin(), back.end());
      }
      append_lines(numbers, text);
    }
}

void append_solid_stress(const View& view, const domain::SolidBlock& block, Index place, std::string& text) {
  const bool back_stress = writes_back_stress(view.model, block, false);
  constexpr int volume_flag = 1;
  fmt::format_to(std::back_inserter(text), "{:10}{:10}{:10}{:10}{:10}\n",
                 view.model.solids[static_cast<std::size_t>(block.element[place])].id, block.points,
                 back_stress ? 6 : 1, 1, volume_flag);
  const double volume = block.state(place, block.find("reference_volume")->first);
  for (Index k = 0; k < block.points; ++k) {
    const Index point = place_of_point(k, block.points);
    const std::array<double, 6> s = stress_of<6>(block, place, point);
    std::vector<double> numbers(s.begin(), s.end());
    numbers.push_back(whole_plastic_strain(block, place, point));
    if (back_stress) {
      const BackStress back = back_stress_of(*block.find("back_stress"), block, place, point, true);
      numbers.insert(numbers.end(), back.begin(), back.end());
    }
    numbers.push_back(volume);
    append_lines(numbers, text);
  }
}

std::string refusal_of_stress(const model::Model& model, const domain::ShellBlock& block) {
  const model::Part& part = model.parts[static_cast<std::size_t>(block.part)];
  const bool layered = block.layup != no_index;
  return model::refusal_of_initial_stress(model, part, block.layup,
                                          likeness(block, writes_back_stress(model, block, layered)));
}

std::string refusal_of_stress(const model::Model& model, const domain::SolidBlock& block) {
  const model::Part& part = model.parts[static_cast<std::size_t>(block.part)];
  return model::refusal_of_initial_stress(model, part, no_index,
                                          likeness(block, writes_back_stress(model, block, false)));
}

}  // namespace crumple::output
