// SPDX-License-Identifier: BSD-3-Clause
// Keywords without a reader: those that change nothing of what is computed, and those of the format itself.
#include <algorithm>

#include "deck/keywords/keywords.hpp"

namespace crumple::deck {

namespace {

constexpr std::string_view is_output = "an output that is not written";
constexpr std::string_view is_definition =
    "such definitions are not supported; what refers to this one is reported";
constexpr std::string_view is_mesh_check = "the mesh is always checked";
constexpr std::string_view is_of_threads =
    "a run has one process; its threads are chosen with -t N on the command line";
constexpr std::string_view is_of_other_elements = "it is about elements that are not supported";
constexpr std::string_view is_of_strain =
    "strains at time zero are for output alone; laws go on from the stress";
constexpr std::string_view is_thermal = "there is no thermal solution";

constexpr IgnoredRow ignored_rows[] = {
    {"COMMENT", false, "a remark"},
    {"KEYWORD_", true, "it names LS-DYNA's files"},
    {"CONTROL_OUTPUT", false, "it is about LS-DYNA's listings"},
    {"CONTROL_PARALLEL", false, is_of_threads},
    {"CONTROL_MPP_", true, is_of_threads},
    {"CONTROL_CPU", false, "the run has no limit of computing time"},
    {"CONTROL_REQUIRE_REVISION", false, "it is about LS-DYNA's versions"},
    {"CONTROL_STRUCTURED", true, "it is about a file that LS-DYNA writes"},
    {"CONTROL_UNITS", false, "it names the units, which have to agree in any case"},
    {"CONTROL_CHECK", true, is_mesh_check},
    {"CONTROL_DEBUG", false, "it is about LS-DYNA's listings"},
    {"CONTROL_LSDA", false, "it is about files that LS-DYNA writes"},
    {"CONTROL_RIGID", false, "it is about joints and outputs of rigid bodies"},
    {"CONTROL_ALE", false, is_of_other_elements},
    {"CONTROL_SPH", true, is_of_other_elements},
    {"CONTROL_DISCRETE_ELEMENT", false, is_of_other_elements},
    {"CONTROL_EFG", false, is_of_other_elements},
    {"CONTROL_THERMAL_", true, is_thermal},
    {"CONTROL_IMPLICIT_", true, "the run is explicit"},
    {"ELEMENT_PLOTEL", false, "lines to look at"},
    {"RIGIDWALL_FORCE_TRANSDUCER", true, is_output},
    {"MAT_ADD_FATIGUE", true, "lives are not computed"},
    {"MAT_ADD_PERMEABILITY", true, "there is no pore water"},
    {"MAT_ADD_THERMAL_EXPANSION", true, is_thermal},
    {"CONTROL_ADAPSTEP", false, "the mesh is not refined, as ADPOPT of *PART would have it"},
    {"CONTROL_ADAPTIVE", false, "the mesh of parts with ADPOPT is refined by it, and such parts are refused"},
    {"CONTROL_SUBCYCLE", true, "all elements take the smallest step"},
    {"DEFINE_BOX_", true, is_definition},
    {"DEFINE_COORDINATE_", true, is_definition},
    {"DEFINE_TABLE", true, is_definition},
    {"DEFINE_VECTOR", true, is_definition},
    {"SENSOR_DEFINE_", true, is_definition},
    {"INTERFACE_SPRINGBACK_NASTRAN", true, is_output},
    {"INTERFACE_COMPONENT_", true, is_output},
    {"INITIAL_STRAIN_SHELL", false, is_of_strain},
    {"INITIAL_STRAIN_SHELL_SET", false, is_of_strain},
    {"INITIAL_STRAIN_SOLID", false, is_of_strain},
    {"INITIAL_STRAIN_SOLID_SET", false, is_of_strain},
    {"SET_BEAM", true, is_definition},
    {"SET_DISCRETE", true, is_definition},
    {"SET_SEGMENT", true, is_definition},
    {"SET_SHELL", true, is_definition},
    {"SET_SOLID", true, is_definition},
    {"DATABASE_ABSTAT_", true, is_output},
    {"DATABASE_ACEOUT", true, is_output},
    {"DATABASE_ADAMS", true, is_output},
    {"DATABASE_ALE", true, is_output},
    {"DATABASE_ATDOUT", true, is_output},
    {"DATABASE_AVSFLT", true, is_output},
    {"DATABASE_BEARING", true, is_output},
    {"DATABASE_BINARY_BLSTFOR", true, is_output},
    {"DATABASE_BINARY_CPMFOR", true, is_output},
    {"DATABASE_BINARY_CPMPCF", true, is_output},
    {"DATABASE_BINARY_D3CRACK", true, is_output},
    {"DATABASE_BINARY_D3DAT", true, is_output},
    {"DATABASE_BINARY_D3DRLF", true, is_output},
    {"DATABASE_BINARY_D3MAX", true, is_output},
    {"DATABASE_BINARY_D3MEAN", true, is_output},
    {"DATABASE_BINARY_D3PART", true, is_output},
    {"DATABASE_BINARY_D3PBM", true, is_output},
    {"DATABASE_BINARY_D3PROP", true, is_output},
    {"DATABASE_BINARY_D3THDT", true, is_output},
    {"DATABASE_BINARY_DEMFOR", true, is_output},
    {"DATABASE_BINARY_DEMRCF", true, is_output},
    {"DATABASE_BINARY_FSIFOR", true, is_output},
    {"DATABASE_BINARY_FSILNK", true, is_output},
    {"DATABASE_BINARY_INTFOR", true, is_output},
    {"DATABASE_BINARY_ISPHFOR", true, is_output},
    {"DATABASE_BINARY_PBMFOR", true, is_output},
    {"DATABASE_BINARY_XTFILE", true, is_output},
    {"DATABASE_BNDOUT", true, is_output},
    {"DATABASE_CABLE", true, is_output},
    {"DATABASE_CPM_SENSOR", true, is_output},
    {"DATABASE_CURVOUT", true, is_output},
    {"DATABASE_D3FTG", true, is_output},
    {"DATABASE_D3MAX", true, is_output},
    {"DATABASE_DCFAIL", true, is_output},
    {"DATABASE_DEBOND", true, is_output},
    {"DATABASE_DEFGEO", true, is_output},
    {"DATABASE_DEFRAGMENT", true, is_output},
    {"DATABASE_DEMASSFLOW", true, is_output},
    {"DATABASE_DEMFOR", true, is_output},
    {"DATABASE_DESTAT", true, is_output},
    {"DATABASE_DISBOUT", true, is_output},
    {"DATABASE_ENVELOPE", true, is_output},
    {"DATABASE_EXTENT_AVS", true, is_output},
    {"DATABASE_EXTENT_BINARY_COMP", true, is_output},
    {"DATABASE_EXTENT_D3PART", true, is_output},
    {"DATABASE_EXTENT_INTFOR", true, is_output},
    {"DATABASE_EXTENT_MOVIE", true, is_output},
    {"DATABASE_EXTENT_MPGS", true, is_output},
    {"DATABASE_EXTENT_SSSTAT", true, is_output},
    {"DATABASE_FATIGUE", true, is_output},
    {"DATABASE_FATXML", true, is_output},
    {"DATABASE_FORMAT", true, is_output},
    {"DATABASE_FREQUENCY", true, is_output},
    {"DATABASE_FSI", true, is_output},
    {"DATABASE_GCEOUT", true, is_output},
    {"DATABASE_GLSTAT_DR", true, is_output},
    {"DATABASE_GLSTAT_MASS_PROPERTIES", true, is_output},
    {"DATABASE_H3OUT", true, is_output},
    {"DATABASE_HISTORY_ACOUSTIC", true, is_output},
    {"DATABASE_HISTORY_CPM", true, is_output},
    {"DATABASE_HISTORY_DES", true, is_output},
    {"DATABASE_HISTORY_SEATBELT", true, is_output},
    {"DATABASE_HISTORY_SPH", true, is_output},
    {"DATABASE_HISTORY_TSHELL", true, is_output},
    {"DATABASE_ICVOUT", true, is_output},
    {"DATABASE_ISPHHTC", true, is_output},
    {"DATABASE_MASSOUT", true, is_output},
    {"DATABASE_MATSUM_DR", true, is_output},
    {"DATABASE_MATSUM_FILTER", true, is_output},
    {"DATABASE_MAX", true, is_output},
    {"DATABASE_MOVIE", true, is_output},
    {"DATABASE_MPGS", true, is_output},
    {"DATABASE_NCFORC_FILTER", true, is_output},
    {"DATABASE_NODAL_FORCE_GROUP", true, is_output},
    {"DATABASE_NODFOR", true, is_output},
    {"DATABASE_PAP_OUTPUT", true, is_output},
    {"DATABASE_PBLAST_SENSOR", true, is_output},
    {"DATABASE_PBSTAT", true, is_output},
    {"DATABASE_PLLYOUT", true, is_output},
    {"DATABASE_POWER", true, is_output},
    {"DATABASE_PROFILE", true, is_output},
    {"DATABASE_PRTUBE", true, is_output},
    {"DATABASE_PWP_FLOW", true, is_output},
    {"DATABASE_PWP_OUTPUT", true, is_output},
    {"DATABASE_PYRO", true, is_output},
    {"DATABASE_RCFORC_DR", true, is_output},
    {"DATABASE_RCFORC_MOMENT", true, is_output},
    {"DATABASE_RECOVER_NODE", true, is_output},
    {"DATABASE_RVE", true, is_output},
    {"DATABASE_SALE", true, is_output},
    {"DATABASE_SBTOUT", true, is_output},
    {"DATABASE_SECFORC_FILTER", true, is_output},
    {"DATABASE_SLEOUT_DR", true, is_output},
    {"DATABASE_SNSROUT", true, is_output},
    {"DATABASE_SPGCPL", true, is_output},
    {"DATABASE_SPH", true, is_output},
    {"DATABASE_SPHFLOW", true, is_output},
    {"DATABASE_SPHMASSFLOW", true, is_output},
    {"DATABASE_SPHOUT", true, is_output},
    {"DATABASE_SPRING_FORWARD", true, is_output},
    {"DATABASE_SSSTAT", true, is_output},
    {"DATABASE_SUPERPLASTIC_FORMING", true, is_output},
    {"DATABASE_TPRINT", true, is_output},
    {"DATABASE_TRACER", true, is_output},
    {"DATABASE_TRHIST", true, is_output},
};

constexpr IgnoredRow format_rows[] = {
    {"KEYWORD", false, "begins a deck: LONG=Y, I10=Y"},
    {"END", false, "ends its file"},
    {"INCLUDE", false, "reads other files in this place, their names on the lines below"},
    {"INCLUDE_PATH", false, "folders in which included files are looked for, one on a line"},
    {"INCLUDE_PATH_RELATIVE", false, "the same, relative to the folder of this file"},
    {"INCLUDE_TRANSFORM", false, "reads a file with offsets of its ids and in another place: docs/deck.md"},
    {"PARAMETER", false,
     "defines numbers (R, I) and texts (C), type and name in one field, value in the next; &name stands for "
     "them"},
    {"PARAMETER_LOCAL", false, "the same for this file and those that it includes"},
    {"PARAMETER_MUTABLE", false, "the same; a later value replaces it"},
    {"PARAMETER_EXPRESSION_MUTABLE", false, "the same with expressions"},
    {"PARAMETER_EXPRESSION", false, "the same as *PARAMETER with an expression, one on a line"},
    {"PARAMETER_EXPRESSION_LOCAL", false, "both"},
    {"PARAMETER_DUPLICATION", false, "DFLAG: what a second value of a parameter does"},
};

template <std::size_t Count>
const IgnoredRow* find_row(const IgnoredRow (&rows)[Count], std::string_view name) {
  const auto found = std::find_if(std::begin(rows), std::end(rows), [&](const IgnoredRow& row) {
    if (!name.starts_with(row.name)) return false;
    const std::string_view rest = name.substr(row.name.size());
    if (!row.is_prefix) return rest.empty() || rest == "_TITLE";
    return rest.empty() || row.name.ends_with('_') || rest.starts_with('_');
  });
  return found == std::end(rows) ? nullptr : found;
}

}  // namespace

std::span<const IgnoredRow> ignored_table() {
  return ignored_rows;
}

const IgnoredRow* find_ignored(std::string_view name) {
  return find_row(ignored_rows, name);
}

const IgnoredRow* find_format_keyword(std::string_view name) {
  return find_row(format_rows, name);
}

}  // namespace crumple::deck
