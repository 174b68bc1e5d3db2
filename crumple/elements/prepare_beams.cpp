// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "base/error.hpp"
#include "elements/line/beam_task.hpp"
#include "elements/line/section_frequency.hpp"
#include "elements/prepare.hpp"
#include "materials/common/shell_material.hpp"
#include "math/to_vec3.hpp"

namespace crumple::elements {
namespace {

using domain::BeamBlock;
using math::to_vec3;
using math::Vec3;

void take_elastic(double young, double poisson, const model::BeamSection& section, BeamConstants& c) {
  const double shear_modulus = young / (2 * (1 + poisson));
  c.area = section.area;
  c.youngs_modulus = young;
  c.bending_s = young * section.inertia_s;
  c.bending_t = young * section.inertia_t;
  c.twisting = shear_modulus * section.torsion;
  c.shear_stiffness = shear_modulus * section.shear_area;
}

void take_plastic(const model::PlasticKinematic& law, BeamConstants& c) {
  const double young = law.youngs_modulus;
  const double modulus = young * law.tangent_modulus / (young - law.tangent_modulus);
  c.plastic = 1;
  c.yield_stress = law.yield_stress;
  c.isotropic = law.isotropic_fraction * modulus;
  c.kinematic = (1 - law.isotropic_fraction) * modulus;
  c.rate = law.cowper_symonds_rate;
  if (c.rate > 0) c.rate_exponent = 1 / law.cowper_symonds_exponent;
  c.failure_strain = law.failure_strain;
}

/// Elastic-perfectly plastic hinges at the ends, plastic moments of the rectangle with this area and these
/// moments of area: Z = A h / 4, h = sqrt(12 I / A).
void take_hinges(const model::ResultantPlasticity& law, const model::BeamSection& section, BeamConstants& c) {
  c.plastic = 1;
  c.yield_stress = law.yield_stress;
  c.plastic_force = law.yield_stress * section.area;
  c.plastic_moment_s = law.yield_stress * 0.5 * std::sqrt(3 * section.area * section.inertia_s);
  c.plastic_moment_t = law.yield_stress * 0.5 * std::sqrt(3 * section.area * section.inertia_t);
}

/// A round bar or tube, whose diameters are known by A and I: D^2, d^2 = 8 I / A +- 2 A / pi. The whole
/// section yields under A, A / sqrt(3), pi (D^3 - d^3) / (12 sqrt(3)) and (D^3 - d^3) / 6 times the yield
/// stress.
void take_weld(const model::SpotWeldLaw& law, const model::BeamSection& section, BeamConstants& c) {
  const double mean = 8 * section.inertia_s / section.area;
  const double half = 2 * section.area / std::numbers::pi;
  const double cubes = std::pow(mean + half, 1.5) - std::pow(std::max(mean - half, 0.0), 1.5);
  const double shear = section.area / std::numbers::sqrt3;
  const double torsion = std::numbers::pi * cubes / (12 * std::numbers::sqrt3);
  c.plastic = 1;
  c.yield_stress = law.yield_stress;
  c.isotropic = law.hardening;
  c.failure_strain = law.failure_strain;
  c.failure_time = law.failure_time;
  c.capacity = {section.area, shear, shear, torsion, cubes / 6, cubes / 6};
  c.strength = {law.tension_strength, law.shear_strength_t,   law.shear_strength_s,
                law.torsion_strength, law.bending_strength_s, law.bending_strength_t};
}

/// Of one point a criterion of plastic strain is the failure of the law, the smaller limit counting.
void take_erosion(const model::Material& material, const model::Part& part, BeamConstants& c) {
  if (!material.erosion) return;
  model::ErosionCriteria rest = *material.erosion;
  const std::optional<double> limit = rest.effective_plastic_strain;
  rest.effective_plastic_strain.reset();
  require(!rest.any() && rest.conditions == 1, part,
          "of the criteria of erosion these beams know the plastic strain alone");
  if (limit && c.plastic != 0)
    c.failure_strain = c.failure_strain > 0 ? std::min(c.failure_strain, *limit) : *limit;
}

/// Stresses are those of the material at the points of the section.
BeamConstants integrated_constants(const model::Material& material, const model::Part& part,
                                   const model::BeamSection& section) {
  BeamConstants c;
  const int kind = materials::section_material_kind(material.law);
  require(kind >= 0, part, "its material cannot be used with integrated beams");
  require(!section.points.empty(), part, "the section of an integrated beam has no points");
  require(section.shear_factor > 0, part, "the shear factor must be above zero");
  c.area = section.area;
  c.youngs_modulus = materials::elastic_constants(material).youngs_modulus;
  c.shear_root = std::sqrt(section.shear_factor);
  c.section_points = static_cast<double>(section.points.size());
  c.section_material = kind;
  c.section_fails = materials::can_fail(material) ? 1 : 0;
  return c;
}

BeamConstants constants_of(const model::Model& model, const BeamBlock& block) {
  const model::Part& part = model.parts[block.part];
  const model::BeamSection& section = model.beam_sections[part.beam_section];
  const model::ConstitutiveLaw& law = model.materials[part.material].law;
  const bool truss = block.formulation == model::BeamFormulation::Truss;
  if (block.formulation == model::BeamFormulation::Integrated)
    return integrated_constants(model.materials[part.material], part, section);
  BeamConstants c;
  if (block.formulation == model::BeamFormulation::SpotWeld) {
    const auto* weld = std::get_if<model::SpotWeldLaw>(&law);
    require(weld != nullptr, part, "spot weld beams need the material of spot welds");
    require(section.shear_area > 0 && section.inertia_s == section.inertia_t, part,
            "spot weld beams need a round section with a shear area");
    take_elastic(weld->youngs_modulus, weld->poissons_ratio, section, c);
    take_weld(*weld, section, c);
    take_erosion(model.materials[part.material], part, c);
    return c;
  }
  if (const auto* elastic = std::get_if<model::Elastic>(&law)) {
    take_elastic(elastic->youngs_modulus, elastic->poissons_ratio, section, c);
  } else if (const auto* hinged = std::get_if<model::ResultantPlasticity>(&law); hinged && !truss) {
    take_elastic(hinged->youngs_modulus, hinged->poissons_ratio, section, c);
    take_hinges(*hinged, section, c);
  } else {
    const auto* plastic = std::get_if<model::PlasticKinematic>(&law);
    require(truss && plastic != nullptr, part, "its material cannot be used with these beams");
    require(!plastic->viscoplastic, part, "VP = 1 of its material cannot be used with trusses");
    take_elastic(plastic->youngs_modulus, plastic->poissons_ratio, section, c);
    take_plastic(*plastic, c);
  }
  if (truss) take_erosion(model.materials[part.material], part, c);
  return c;
}

void declare_items(bool plastic, BeamBlock& block) {
  domain::add_item(block, "active", "-", 1);
  domain::add_item(block, "stable_step", "time", 1);
  domain::add_item(block, "reference_length", "length", 1);
  if (block.formulation == model::BeamFormulation::Truss) {
    domain::add_item(block, "length", "length", 1);
    domain::add_item(block, "stress", "stress", 1);
    domain::add_item(block, "plastic_strain", "-", 1);
    domain::add_item(block, "back_stress", "stress", 1);
    domain::add_item(block, "energy", "energy", 2);
  } else {
    domain::add_item(block, "axes", "-", 12);
    domain::add_item(block, "deformation", "length and rad", 6);
    domain::add_item(block, "resultant", "force and moment", 6);
    if (block.formulation == model::BeamFormulation::SpotWeld) {
      domain::add_item(block, "plastic_deformation", "length and rad", weld_modes);
      domain::add_item(block, "plastic_strain", "-", 1);
      domain::add_item(block, "energy", "energy", 2);
      domain::add_item(block, "failure_time", "time", 1);
    } else if (block.formulation == model::BeamFormulation::Integrated) {
      domain::add_item(block, "energy", "energy", 2);
    } else if (plastic) {
      domain::add_item(block, "plastic_deformation", "length and rad", 5);
    }
  }
}

/// Stresses, the law's history and the places of the points.
void declare_section(const model::Model& model, BeamConstants& c, BeamBlock& block) {
  const model::Part& part = model.parts[block.part];
  const model::Material& material = model.materials[part.material];
  c.stress = domain::add_item(block, "stress", "stress", materials::section_components * block.points);
  c.history = materials::declare_section_history(material.law, block);
  block.material_constants = materials::section_material_constants(material);
}

void append_places(const model::BeamSection& section, std::vector<double>& numbers) {
  for (const model::SectionPoint& point : section.points)
    numbers.insert(numbers.end(), {point.s, point.t, point.area});
}

/// The direction s of a beam along `r`: towards the orientation node or along the orientation vector, across
/// the beam; without either any direction.
Vec3 direction_s(const model::Model& model, const model::BeamElement& beam, const Vec3& r) {
  Vec3 towards = to_vec3(beam.orientation);
  if (beam.orientation_node != no_index)
    towards =
        to_vec3(model.nodes.position[beam.orientation_node]) - to_vec3(model.nodes.position[beam.node[0]]);
  Vec3 s = towards - dot(towards, r) * r;
  constexpr double parallel = 1e-6;
  if (norm(s) > parallel * norm(towards)) return normalised(s);
  if (norm(towards) > 0)
    throw Error("Beam " + std::to_string(beam.id) + " is parallel to what gives its orientation.");
  // The axis that is least along the beam.
  int least = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::fabs(r[axis]) < std::fabs(r[least])) least = axis;
  towards = {};
  towards[least] = 1;
  return normalised(towards - dot(towards, r) * r);
}

/// What a beam adds to each of its nodes.
struct BeamMass {
  double mass = 0;     ///< [mass]
  double inertia = 0;  ///< [mass length^2]
};

/// Half the beam as a rod of its length and cross section (Belytschko & Tsay 1982, as LS-DYNA's theory manual
/// has it).
BeamMass nodal_mass(double density, double length, const model::BeamSection& section, bool truss) {
  const double mass = 0.5 * density * section.area * length;
  if (truss) return {mass, 0};
  // A section that twists more stiffly than it bends needs more.
  const double bending = std::max(section.inertia_s, section.inertia_t);
  return {mass,
          0.5 * density * length * std::max(bending, 0.5 * section.torsion) + mass * length * length / 12};
}

/// 2 / the highest frequency of the free integrated beam; no limit if it has no stiffness.
double integrated_step(const model::Material& material, const model::BeamSection& section,
                       const BeamMass& nodal, double length) {
  const materials::ElasticConstants elastic = materials::elastic_constants(material);
  constexpr double no_limit = 1e30;
  if (!materials::has_stiffness(material.law)) return no_limit;
  return 2 / std::sqrt(highest_frequency_squared(section, {length, nodal.mass, nodal.inertia,
                                                           elastic.youngs_modulus, elastic.shear_modulus()}));
}

/// 2 / the highest frequency of the free element. Bending: both ends turn alike against the chord, or
/// opposite to each other.
double stable_step_of(const BeamConstants& c, const BeamMass& nodal, double length) {
  const double axial = 2 * c.youngs_modulus * c.area / (length * nodal.mass);
  double highest = axial;
  if (nodal.inertia > 0) {
    const double per_inertia = 1 / nodal.inertia;
    for (const double bending : {c.bending_s, c.bending_t}) {
      const double shear = c.shear_stiffness > 0 ? 12 * bending / (c.shear_stiffness * length * length) : 0.0;
      const double chord = 2 / (nodal.mass * length * length);
      highest = std::max(highest, 12 * bending / (length * (1 + shear)) * (0.5 * per_inertia + chord));
      highest = std::max(highest, 2 * bending / length * per_inertia);
    }
    highest = std::max(highest, 2 * c.twisting / length * per_inertia);
  }
  return 2 / std::sqrt(highest);
}

/// Factor on the mass of a beam for DT2MS, and of a weld for the step that its material asks for.
double factor_of(const model::Model& model, const BeamBlock& block, double step) {
  if (block.rigid) return 1;
  const double factor = mass_factor(model.control.mass_scaling_step, step);
  const model::Part& part = model.parts[block.part];
  const auto* weld = std::get_if<model::SpotWeldLaw>(&model.materials[part.material].law);
  return weld == nullptr ? factor : std::max(factor, mass_factor(-weld->least_step, step));
}

void set_axes(BeamBlock& block, Index place, const Vec3& r, const Vec3& s) {
  for (int end = 0; end < 2; ++end)
    for (int axis = 0; axis < 3; ++axis) {
      const Index item = resultant_state::axes + 6 * end + axis;
      block.set_state(place, item, r[axis]);
      block.set_state(place, item + 3, s[axis]);
    }
}

void prepare_element(const model::Model& model, domain::Domain& domain, BeamBlock& block,
                     const BeamConstants& c, Index place) {
  const model::BeamElement& beam = model.beams[block.element[std::min(place, block.elements - 1)]];
  const model::Part& part = model.parts[block.part];
  const std::array<Index, 2> node = block.nodes_of(place);
  const Vec3 span = domain.nodes.position[node[1]] - domain.nodes.position[node[0]];
  const double length = norm(span);
  if (!(length > 0)) throw Error("Beam " + std::to_string(beam.id) + " has no length.");
  const bool truss = block.formulation == model::BeamFormulation::Truss;
  const model::Material& material = model.materials[part.material];
  const model::BeamSection& section = model.beam_sections[part.beam_section];
  const BeamMass nodal = nodal_mass(material.density, length, section, truss);
  const double step = block.formulation == model::BeamFormulation::Integrated
                          ? integrated_step(material, section, nodal, length)
                          : stable_step_of(c, nodal, length);
  const double factor = factor_of(model, block, step);
  block.set_state(place, beam_state::active, place < block.elements ? 1 : 0);
  block.set_state(place, beam_state::stable_step, step * std::sqrt(factor));
  block.set_state(place, beam_state::reference_length, length);
  if (truss) {
    block.set_state(place, truss_state::length, length);
  } else {
    const Vec3 r = normalised(span);
    set_axes(block, place, r, direction_s(model, beam, r));
  }
  if (place >= block.elements) return;
  for (const Index end : node) {
    add_mass(domain, block.part, end, factor * nodal.mass);
    domain.nodes.inertia[end] += factor * nodal.inertia;
  }
  domain.added_mass += 2 * (factor - 1) * nodal.mass;
  if (scales_mass(model, domain, block))
    block.scaled.push_back({2 * factor * nodal.mass, 2 * factor * nodal.inertia});
}

}  // namespace

void prepare_beams(const model::Model& model, domain::Domain& domain) {
  for (BeamBlock& block : domain.beams) {
    const model::Part& part = model.parts[block.part];
    const bool damps = block.formulation != model::BeamFormulation::Discrete &&
                       block.formulation != model::BeamFormulation::Integrated;
    require(damps || !part.damping, part,
            "*DAMPING_PART_STIFFNESS acts on beams with ELFORM 2, 3 and 9 only, not with 1, 4, 5 and 6");
    if (block.formulation == model::BeamFormulation::Discrete) {
      prepare_discrete_beams(model, domain, block);
      continue;
    }
    BeamConstants constants = constants_of(model, block);
    declare_items(constants.plastic != 0, block);
    if (!block.rigid) block.damping = model.parts[block.part].damping;
    if (block.damping)
      domain::add_item(block, "damping", "force and moment",
                       block.formulation == model::BeamFormulation::Truss ? 1 : 6);
    const bool integrated = block.formulation == model::BeamFormulation::Integrated;
    if (integrated) declare_section(model, constants, block);
    block.allocate(Precision::Double);
    block.element_constants = to_numbers(constants);
    if (integrated)
      append_places(model.beam_sections[model.parts[block.part].beam_section], block.element_constants);
    for (Index place = 0; place < block.groups() * lanes; ++place)
      prepare_element(model, domain, block, constants, place);
  }
}

}  // namespace crumple::elements
