// SPDX-License-Identifier: BSD-3-Clause
// What to take instead of a keyword that is not supported, and what would be different then.
#include "deck/keywords/nearest_keyword.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "deck/format/edit_distance.hpp"
#include "deck/keywords/keywords.hpp"

namespace crumple::deck {

namespace {

struct Substitute {
  std::string_view name;     ///< of keywords that begin with it
  std::string_view keyword;  ///< that is supported; empty if none is near
  std::string_view change;
};

// The first that fits counts.
constexpr Substitute substitutes[] = {
    {"MAT_ELASTIC_PLASTIC_HYDRO_STOCHASTIC", "MAT_ELASTIC_PLASTIC_HYDRO_SPALL",
     "strength and failure do not scatter"},
    {"MAT_010_STOCHASTIC", "MAT_ELASTIC_PLASTIC_HYDRO_SPALL", "strength and failure do not scatter"},
    {"ELEMENT_SOLID_TET4TOTET10", "ELEMENT_SOLID",
     "tetrahedra keep their four nodes, which are stiffer; take ELFORM 13 for them"},
    {"MAT_SOIL_AND_FOAM_FAILURE", "MAT_SOIL_AND_FOAM", "keeps its strength in tension at the cut-off"},
    {"MAT_014", "MAT_SOIL_AND_FOAM", "keeps its strength in tension at the cut-off"},
    {"MAT_STRAIN_RATE_DEPENDENT_PLASTICITY", "MAT_PIECEWISE_LINEAR_PLASTICITY",
     "yield over strain rate becomes a table in LCSS; modulus and failure do not depend on the rate"},
    {"MAT_019", "MAT_PIECEWISE_LINEAR_PLASTICITY",
     "yield over strain rate becomes a table in LCSS; modulus and failure do not depend on the rate"},
    {"MAT_FABRIC", "MAT_ORTHOTROPIC_ELASTIC", "the fabric also carries compression, and has no leakage"},
    {"MAT_034", "MAT_ORTHOTROPIC_ELASTIC", "the fabric also carries compression, and has no leakage"},
    {"MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC_", "MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC",
     "the modulus stays what it is, and nothing fails by a forming limit"},
    {"MAT_037_", "MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC",
     "the modulus stays what it is, and nothing fails by a forming limit"},
    {"MAT_3-PARAMETER_BARLAT_", "MAT_3-PARAMETER_BARLAT", "nothing fails by a forming limit"},
    {"MAT_036", "MAT_3-PARAMETER_BARLAT", "nothing fails by a forming limit"},
    {"MAT_LAMINATED_COMPOSITE_FABRIC_SOLID", "MAT_LAMINATED_COMPOSITE_FABRIC", "it is for shells"},
    {"MAT_058_", "MAT_LAMINATED_COMPOSITE_FABRIC", "it is for shells"},
    {"MAT_MODIFIED_CRUSHABLE_FOAM", "MAT_CRUSHABLE_FOAM", "the strength does not depend on the strain rate"},
    {"MAT_163", "MAT_CRUSHABLE_FOAM", "the strength does not depend on the strain rate"},
    {"MAT_SIMPLIFIED_RUBBER", "MAT_SIMPLIFIED_RUBBER/FOAM", "does not fail"},
    {"MAT_181_", "MAT_SIMPLIFIED_RUBBER/FOAM", "does not fail"},
    {"MAT_PLASTICITY_WITH_DAMAGE_STOCHASTIC", "MAT_PLASTICITY_WITH_DAMAGE",
     "yield stress and failure are the same in all elements"},
    {"MAT_081_", "MAT_PLASTICITY_WITH_DAMAGE", "yield stress and failure are the same in all elements"},
    {"MAT_PLASTICITY_WITH_DAMAGE_", "MAT_PLASTICITY_WITH_DAMAGE",
     "damage is the same in all directions, and grows with the plastic strain alone"},
    {"MAT_082", "MAT_PLASTICITY_WITH_DAMAGE",
     "damage is the same in all directions, and grows with the plastic strain alone"},
    {"MAT_SIMPLIFIED_JOHNSON_COOK_ORTHOTROPIC_DAMAGE", "MAT_SIMPLIFIED_JOHNSON_COOK",
     "there is no damage by direction"},
    {"MAT_099", "MAT_SIMPLIFIED_JOHNSON_COOK", "there is no damage by direction"},
    {"MAT_SPOTWELD_", "MAT_SPOTWELD", "welds fail by the resultants of card 2, without damage"},
    {"MAT_100_", "MAT_SPOTWELD", "welds fail by the resultants of card 2, without damage"},
    {"MAT_GURSON", "MAT_PIECEWISE_LINEAR_PLASTICITY", "no voids grow; failure is by plastic strain alone"},
    {"MAT_120", "MAT_PIECEWISE_LINEAR_PLASTICITY", "no voids grow; failure is by plastic strain alone"},
    {"MAT_PLASTICITY_COMPRESSION_TENSION_EOS", "MAT_PLASTICITY_COMPRESSION_TENSION",
     "the pressure is elastic"},
    {"MAT_155", "MAT_PLASTICITY_COMPRESSION_TENSION", "the pressure is elastic"},
    {"MAT_SAMP-1", "MAT_PIECEWISE_LINEAR_PLASTICITY", "yield does not depend on the pressure"},
    {"MAT_187", "MAT_PIECEWISE_LINEAR_PLASTICITY", "yield does not depend on the pressure"},
    {"MAT_TABULATED_JOHNSON_COOK", "MAT_JOHNSON_COOK", "hardening and failure by formulas instead of tables"},
    {"MAT_224", "MAT_JOHNSON_COOK", "hardening and failure by formulas instead of tables"},
    {"MAT_COHESIVE", "MAT_COHESIVE_MIXED_MODE",
     "the traction rises and falls in straight lines, and does not depend on the rate"},
    {"MAT_185", "MAT_COHESIVE_MIXED_MODE",
     "the traction rises and falls in straight lines, and does not depend on the rate"},
    {"MAT_186", "MAT_COHESIVE_MIXED_MODE",
     "the traction rises and falls in straight lines, and does not depend on the rate"},
    {"MAT_279", "MAT_COHESIVE_MIXED_MODE",
     "the traction rises and falls in straight lines, and does not depend on the rate"},
    {"MAT_ARUP_ADHESIVE", "MAT_COHESIVE_MIXED_MODE",
     "the traction rises and falls in straight lines, and does not depend on the rate"},
    {"MAT_169", "MAT_COHESIVE_MIXED_MODE",
     "the traction rises and falls in straight lines, and does not depend on the rate"},
    {"MAT_240", "MAT_COHESIVE_MIXED_MODE",
     "the traction rises and falls in straight lines, and does not depend on the rate"},
    {"MAT_ADD_DAMAGE_", "MAT_ADD_DAMAGE_GISSMO",
     "damage grows with the plastic strain, over triaxiality and Lode's parameter"},
    {"MAT_ADD_AIRBAG_POROSITY_LEAKAGE", "MAT_FABRIC", "its own FLC and FAC say how the fabric leaks"},
    {"MAT_ADD_", "", "the material lacks what that adds"},
    {"MAT_LINEAR_ELASTIC_DISCRETE_BEAM", "MAT_SPRING_ELASTIC",
     "one *ELEMENT_DISCRETE for each direction instead of one beam for six"},
    {"MAT_066", "MAT_SPRING_ELASTIC", "one *ELEMENT_DISCRETE for each direction instead of one beam for six"},
    {"MAT_NONLINEAR_", "MAT_SPRING_NONLINEAR_ELASTIC",
     "one *ELEMENT_DISCRETE for each direction instead of one beam for six"},
    {"MAT_067", "MAT_SPRING_NONLINEAR_ELASTIC",
     "one *ELEMENT_DISCRETE for each direction instead of one beam for six"},
    {"MAT_CABLE_DISCRETE_BEAM", "MAT_SPRING_NONLINEAR_ELASTIC",
     "the curve says that there is no force in compression"},
    {"MAT_071", "MAT_SPRING_NONLINEAR_ELASTIC", "the curve says that there is no force in compression"},
    {"MAT_SPRING_GENERAL_NONLINEAR", "MAT_SPRING_INELASTIC",
     "one direction alone, with a straight line of unloading"},
    {"MAT_S06", "MAT_SPRING_INELASTIC", "one direction alone, with a straight line of unloading"},
    {"MAT_SEATBELT", "MAT_SPRING_NONLINEAR_ELASTIC",
     "a spring instead of a belt, without retractor and slip ring"},
    {"MAT_B01", "MAT_SPRING_NONLINEAR_ELASTIC",
     "a spring instead of a belt, without retractor and slip ring"},
    {"ELEMENT_SEATBELT", "ELEMENT_DISCRETE", "a spring instead of a belt, without retractor and slip ring"},
    {"SECTION_SEATBELT", "SECTION_DISCRETE", "a spring instead of a belt, without retractor and slip ring"},
    {"ELEMENT_TSHELL", "ELEMENT_SOLID", "several solids through the thickness are needed for bending"},
    {"SECTION_TSHELL", "SECTION_SOLID", "several solids through the thickness are needed for bending"},
    {"ELEMENT_SHELL_", "ELEMENT_SHELL_THICKNESS", "its THIC and BETA are those of the elements"},
    {"ELEMENT_BEAM_", "ELEMENT_BEAM", "the section of the part holds for all of its beams"},
    {"ELEMENT_SOLID_", "ELEMENT_SOLID", "the axes of the material follow the element"},
    {"ELEMENT_DISCRETE_", "ELEMENT_DISCRETE", "the spring is straight between its nodes"},
    {"PART_COMPOSITE_", "PART_COMPOSITE", "layers of shells with one integration point each"},
    {"PART_", "PART", "the part lacks what the option adds"},
    {"INITIAL_STRESS_", "INITIAL_STRESS_SHELL", "stresses are given one by one, of shells and of solids"},
    {"INITIAL_STRAIN_", "", "the run begins without the stresses and strains of forming"},
    {"DAMPING_FREQUENCY_RANGE", "DAMPING_RELATIVE",
     "low frequencies are damped more than high ones; *DAMPING_PART_STIFFNESS does the opposite"},
    {"DAMPING_FREQUENCY_RANGE_DEFORM", "DAMPING_PART_STIFFNESS",
     "high frequencies are damped more than low ones"},
    {"DAMPING_", "",
     "nothing damps the motion but damping in proportion to mass and stiffness, contact, plasticity and bulk "
     "viscosity"},
    {"BOUNDARY_SPC_", "BOUNDARY_SPC_SET", "the nodes are those of a set"},
    {"BOUNDARY_PRESCRIBED_MOTION_", "BOUNDARY_PRESCRIBED_MOTION_SET",
     "the motion is along or about an axis or a vector fixed in space"},
    {"BOUNDARY_NON_REFLECTING_2D", "BOUNDARY_NON_REFLECTING",
     "the boundary is one of solids in space; there are no elements of plane problems"},
    {"CONSTRAINED_JOINT_SPHERICAL_", "CONSTRAINED_JOINT_SPHERICAL", "the joint does not fail"},
    {"CONSTRAINED_JOINT_REVOLUTE_", "CONSTRAINED_JOINT_REVOLUTE", "the joint does not fail"},
    {"CONSTRAINED_JOINT_CYLINDRICAL_", "CONSTRAINED_JOINT_CYLINDRICAL", "the joint does not fail"},
    {"CONSTRAINED_JOINT_TRANSLATIONAL_", "CONSTRAINED_JOINT_TRANSLATIONAL", "the joint does not fail"},
    {"CONSTRAINED_JOINT_UNIVERSAL_", "CONSTRAINED_JOINT_UNIVERSAL", "the joint does not fail"},
    {"CONSTRAINED_JOINT_LOCKING_", "CONSTRAINED_JOINT_LOCKING", "the joint does not fail"},
    {"CONSTRAINED_JOINT_STIFFNESS_", "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED",
     "moments over three rotations one after the other"},
    {"CONSTRAINED_JOINT_PLANAR", "CONSTRAINED_JOINT_TRANSLATIONAL",
     "the bodies slide along an axis instead of in a plane"},
    {"CONSTRAINED_JOINT_CONSTANT_VELOCITY", "CONSTRAINED_JOINT_UNIVERSAL",
     "the angular velocities are not always the same"},
    {"CONSTRAINED_JOINT_SCREW", "CONSTRAINED_JOINT_CYLINDRICAL",
     "turning and sliding along the axis are free of each other"},
    {"CONSTRAINED_JOINT_ROTATIONAL_MOTOR", "BOUNDARY_PRESCRIBED_MOTION_RIGID",
     "a body turns against the ground, not against another one"},
    {"CONSTRAINED_JOINT_", "CONSTRAINED_RIGID_BODIES", "the bodies do not move against each other"},
    {"CONSTRAINED_INTERPOLATION_LOCAL", "CONSTRAINED_INTERPOLATION",
     "degrees of freedom are those of global axes"},
    {"CONSTRAINED_TIED_NODES_FAILURE", "CONTACT_TIEBREAK_NODES_TO_SURFACE",
     "failure is by force instead of plastic strain"},
    {"CONSTRAINED_LINEAR", "CONSTRAINED_LINEAR_GLOBAL", "each term is one degree of freedom in global axes"},
    {"CONSTRAINED_SPOTWELD_", "CONSTRAINED_SPOTWELD", "failure is by the forces of single steps"},
    {"CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_", "CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE",
     "the penalty acts at nodes, not over the area of segments, and nothing is smoothed or tied"},
    {"CONTACT_AUTOMATIC_SINGLE_SURFACE_", "CONTACT_AUTOMATIC_SINGLE_SURFACE",
     "the penalty acts at nodes, not over the area of segments, and nothing is smoothed or tied"},
    {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_", "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE",
     "the penalty acts at nodes, not over the area of segments, and nothing is smoothed or tied"},
    {"CONTACT_TIED_SHELL_EDGE_", "CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET",
     "springs instead of constraints"},
    {"CONTACT_TIED_", "CONTACT_TIED_SURFACE_TO_SURFACE_OFFSET", "springs instead of constraints"},
    {"CONTACT_FORCE_TRANSDUCER_", "CONTACT_FORCE_TRANSDUCER_PENALTY",
     "forces of all contacts are summed, those by constraint too"},
    {"CONTACT_ENTITY", "RIGIDWALL_GEOMETRIC_SPHERE", "the shape is fixed in space or moves by a curve"},
    {"LOAD_BODY_", "LOAD_BODY_GENERALIZED", "the acceleration is the same at all places"},
    {"LOAD_BLAST_CLEARING", "LOAD_BLAST_SEGMENT_SET",
     "the reflected pressure does not fall earlier near the edges of a face"},
    {"LOAD_BLAST", "LOAD_BLAST_ENHANCED", "the segments are named by *LOAD_BLAST_SEGMENT"},
    {"LOAD_BRODE", "LOAD_BLAST_ENHANCED", "the wave is that of TNT, not of Brode's function"},
    {"LOAD_THERMAL_", "", "nothing expands with temperature"},
    {"LOAD_HEAT_", "", "there is no thermal solution"},
    {"LOAD_REMOVE_PART", "", "parts are there during the whole run"},
    {"LOAD_STIFFEN_PART", "", "parts are there during the whole run"},
    {"LOAD_", "LOAD_NODE_SET", "forces on nodes are given as curves over time"},
    {"RIGIDWALL_PLANAR_ORTHO", "RIGIDWALL_PLANAR", "friction is the same in all directions"},
    {"RIGIDWALL_PLANAR_", "RIGIDWALL_PLANAR", "the wall lacks what the option adds"},
    {"RIGIDWALL_GEOMETRIC_CYLINDER_INTERIOR", "RIGIDWALL_GEOMETRIC_CYLINDER",
     "nodes are kept out of it, not in it"},
    {"RIGIDWALL_", "RIGIDWALL_PLANAR", "the wall is a plane"},
    {"AIRBAG_", "AIRBAG_SIMPLE_AIRBAG_MODEL",
     "one gas of one temperature and pressure, which flows in by a curve and out through orifices"},
    {"DEFORMABLE_TO_RIGID_AUTOMATIC", "DEFORMABLE_TO_RIGID", "the part is rigid during the whole run"},
    {"DEFORMABLE_TO_RIGID_INERTIA", "DEFORMABLE_TO_RIGID", "mass and inertia are those of the elements"},
    {"RIGID_DEFORMABLE", "", "it is for restarts: no part becomes rigid or deformable during the run"},
    {"DEFINE_CURVE_", "DEFINE_CURVE", "the curve is given by points"},
    {"DEFINE_FUNCTION", "DEFINE_CURVE", "the function is given by points"},
    {"DEFINE_FRICTION_", "DEFINE_FRICTION", "friction is the same in all directions"},
    {"DEFINE_HAZ_", "", "material is the same near welds as elsewhere"},
    {"DEFINE_CONNECTION_PROPERTIES", "CONSTRAINED_SPOTWELD", "welds fail by normal and shear force"},
    {"DATABASE_D3PLOT", "DATABASE_BINARY_D3PLOT", ""},
    {"CASE", "", "the cards of all cases are read together, as of one run; make a deck for each case"},
    {"CONTROL_ADAPT", "", "the mesh is not refined during the run"},
    {"INTERFACE_", "DATABASE_HISTORY_NODE_SET",
     "motions are written as histories, and cannot drive another run"},
    {"SECTION_SPH", "", "there are no particles"},
    {"ELEMENT_SPH", "", "there are no particles"},
    {"SECTION_BEAM_", "SECTION_BEAM", "dimensions are given one by one"},
    {"SECTION_SOLID_", "SECTION_SOLID", "the elements move with the material"},
    {"SECTION_", "SECTION_SHELL", "its shells are of uniform material and thickness through the section"},
};

/// MAT_024 and MAT_S02 are numbers: the next one is another law.
bool is_numbered(std::string_view name) {
  return name.starts_with("MAT_") || name.starts_with("EOS_")
             ? name.size() == 7 && name.substr(5).find_first_not_of("0123456789") == std::string_view::npos
             : false;
}

/// The keyword whose name differs by at most a few letters; empty if there is none.
std::string_view mistyped(std::string_view name) {
  constexpr std::size_t letters_by_error = 8;
  std::size_t least = std::clamp<std::size_t>(name.size() / letters_by_error, 1, 2) + 1;
  std::string_view best;
  if (is_numbered(name)) return best;
  for (const Keyword& keyword : keyword_table()) {
    const std::size_t longer = std::max(keyword.name.size(), name.size());
    if (longer - std::min(keyword.name.size(), name.size()) >= least || is_numbered(keyword.name)) continue;
    const std::size_t distance = edit_distance(name, keyword.name);
    if (distance >= least) continue;
    least = distance;
    best = keyword.name;
  }
  return best;
}

/// The longest keyword of which the name is a form with more options; empty if there is none.
std::string_view without_options(std::string_view name) {
  std::string_view best;
  for (const Keyword& keyword : keyword_table())
    if (name.starts_with(keyword.name) && name.size() > keyword.name.size() &&
        name[keyword.name.size()] == '_' && keyword.name.size() > best.size())
      best = keyword.name;
  return best;
}

}  // namespace

NearestKeyword nearest_keyword(std::string_view name) {
  const std::string full = canonical_name(name);
  const bool has_heading = full.ends_with("_TITLE") || full.ends_with("_ID");
  const std::string_view bare =
      std::string_view(full).substr(0, has_heading ? full.rfind('_') : std::string_view::npos);
  // Names of laws and families come before likeness: MAT_025 is not a mistyped MAT_024.
  const auto found = std::find_if(std::begin(substitutes), std::end(substitutes), [&](const Substitute& row) {
    if (!bare.starts_with(row.name)) return false;
    return bare.size() == row.name.size() || row.name.ends_with('_') || bare[row.name.size()] == '_';
  });
  const bool is_broad = found != std::end(substitutes) && found->name.ends_with('_');
  if (found != std::end(substitutes) && !is_broad) return {found->keyword, std::string(found->change)};
  if (const std::string_view near = mistyped(bare); !near.empty()) return {near, {}};
  if (found != std::end(substitutes)) return {found->keyword, std::string(found->change)};
  if (const std::string_view near = without_options(bare); !near.empty())
    return {near, fmt::format("it is without what {} adds", bare.substr(near.size()))};
  return {};
}

std::string advice_on(std::string_view name) {
  const NearestKeyword nearest = nearest_keyword(name);
  if (nearest.keyword.empty())
    return nearest.change.empty() ? "" : fmt::format("; without it, {}", nearest.change);
  if (nearest.change.empty()) return fmt::format("; did you mean *{}?", nearest.keyword);
  return fmt::format("; nearest is *{}: {}", nearest.keyword, nearest.change);
}

}  // namespace crumple::deck
