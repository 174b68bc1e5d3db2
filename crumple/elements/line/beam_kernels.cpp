// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>

#include "base/isa_variants.hpp"
#include "elements/line/beam_kernel_list.hpp"
#include "elements/line/belytschko_schwer.hpp"
#include "elements/line/discrete_beam.hpp"
#include "elements/line/integrated_beam.hpp"
#include "elements/line/spot_weld_beam.hpp"
#include "elements/line/truss.hpp"

namespace crumple::elements {
namespace {

/// Visits every number in the order in which it is stored.
template <class Constants, class Visit>
void for_each_number(Constants& c, const Visit& visit) {
  for (auto* number : {&c.area,
                       &c.youngs_modulus,
                       &c.bending_s,
                       &c.bending_t,
                       &c.twisting,
                       &c.shear_stiffness,
                       &c.plastic,
                       &c.yield_stress,
                       &c.isotropic,
                       &c.kinematic,
                       &c.rate,
                       &c.rate_exponent,
                       &c.failure_strain,
                       &c.plastic_force,
                       &c.plastic_moment_s,
                       &c.plastic_moment_t,
                       &c.failure_time,
                       &c.section_points,
                       &c.section_material,
                       &c.section_fails,
                       &c.shear_root,
                       &c.stress,
                       &c.history,
                       &c.first_share})
    visit(*number);
  for (auto* list : {&c.capacity, &c.strength})
    for (auto& number : *list) visit(number);
  for (auto& number : c.held_turn) visit(number);
}

}  // namespace

std::vector<double> to_numbers(const BeamConstants& constants) {
  std::vector<double> numbers;
  for_each_number(constants, [&](double value) { numbers.push_back(value); });
  return numbers;
}

BeamConstants beam_constants(const std::vector<double>& numbers) {
  BeamConstants constants;
  std::size_t next = 0;
  for_each_number(constants, [&](double& value) { value = numbers[next++]; });
  return constants;
}

const double* section_places(const std::vector<double>& numbers) {
  std::size_t fixed = 0;
  BeamConstants constants;
  for_each_number(constants, [&](double&) { ++fixed; });
  return numbers.data() + fixed;
}

BeamKernel beam_kernel(Isa isa, model::BeamFormulation formulation) {
  return visit_isa(isa, [&]<Isa Variant>() { return beam_formulation_kernel<Variant>(formulation); });
}

const char* beam_name(model::BeamFormulation formulation) {
  if (formulation == model::BeamFormulation::Truss) return Truss::name;
  if (formulation == model::BeamFormulation::Integrated) return IntegratedBeam::name;
  if (formulation == model::BeamFormulation::Discrete) return DiscreteBeam::name;
  return formulation == model::BeamFormulation::SpotWeld ? SpotWeldBeam::name : BelytschkoSchwer::name;
}

}  // namespace crumple::elements
