// SPDX-License-Identifier: BSD-3-Clause
#include "elements/common/constants.hpp"

#include <cstddef>
#include <type_traits>

#include "elements/shell/shell_task.hpp"
#include "elements/solid/solid_task.hpp"

namespace crumple::elements {
namespace {

// Visit every number in the order in which it is stored.

template <class Constants, class Visit>
void for_each_solid_number(Constants& constants, const Visit& visit) {
  visit(constants.points);
  visit(constants.formulation);
  visit(constants.material);
  visit(constants.history);
  visit(constants.own);
  visit(constants.can_fail);
  visit(constants.exact_volume);
  visit(constants.without_linear_part);
  visit(constants.viscous);
  visit(constants.assumed_strain);
  visit(constants.hourglass);
  visit(constants.bend_together);
  visit(constants.warp);
  visit(constants.density);
  visit(constants.shear_share);
  visit(constants.wave_speed);
  visit(constants.present_wave_speed);
  visit(constants.equation_of_state);
  visit(constants.interior_modulus);
  visit(constants.interior_volume);
  visit(constants.interior_speed_square);
  visit(constants.bulk_quadratic);
  visit(constants.bulk_linear);
  visit(constants.point_place);
}

template <class Constants, class Visit>
void for_each_shell_number(Constants& constants, const Visit& visit) {
  visit(constants.points);
  visit(constants.planes);
  visit(constants.formulation);
  visit(constants.material);
  visit(constants.history);
  visit(constants.own);
  visit(constants.viscous);
  visit(constants.thickness_change);
  visit(constants.can_fail);
  for (auto& place : constants.place) visit(place);
  for (auto& weight : constants.weight) visit(weight);
  visit(constants.shear_root);
  visit(constants.hourglass_membrane);
  visit(constants.hourglass_warping);
  visit(constants.hourglass_bending);
  visit(constants.slowness);
  visit(constants.poissons_ratio);
}

template <class Constants, class Visit>
void for_each_number(Constants& constants, const Visit& visit) {
  if constexpr (requires { constants.planes; })
    for_each_shell_number(constants, visit);
  else
    for_each_solid_number(constants, visit);
}

}  // namespace

template <class Constants>
std::vector<double> to_numbers(const Constants& constants) {
  std::vector<double> numbers;
  for_each_number(constants, [&](const auto& value) { numbers.push_back(double(value)); });
  return numbers;
}

template <class Constants>
Constants from_numbers(const std::vector<double>& numbers) {
  Constants constants;
  std::size_t next = 0;
  for_each_number(constants, [&]<class Number>(Number& value) {
    const double number = numbers[next++];
    if constexpr (std::is_same_v<Number, bool>)
      value = number != 0;
    else
      value = static_cast<Number>(number);
  });
  return constants;
}

template std::vector<double> to_numbers(const ShellConstants<double>& constants);
template std::vector<double> to_numbers(const SolidConstants<double>& constants);
template ShellConstants<float> from_numbers(const std::vector<double>& numbers);
template ShellConstants<double> from_numbers(const std::vector<double>& numbers);
template SolidConstants<float> from_numbers(const std::vector<double>& numbers);
template SolidConstants<double> from_numbers(const std::vector<double>& numbers);

}  // namespace crumple::elements
