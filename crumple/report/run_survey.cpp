// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_survey.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace crumple::report {

namespace {

using Section = VtuReader::Section;

bool is_shell(std::int64_t type) {
  return type == 5 || type == 9;
}
bool is_line(std::int64_t type) {
  return type == 1 || type == 3;
}

/// Frames hold a zero where a kind of element has no such result: that is not a value.
bool has_value(const std::string& field, std::int64_t type) {
  if (field == "thickness") return is_shell(type);
  if (field == "pressure") return !is_shell(type) && !is_line(type);
  const bool resultant = field == "axial_force" || field == "torsion" || field.starts_with("shear_") ||
                         field.starts_with("first_moment") || field.starts_with("second_moment");
  return !resultant || is_line(type);
}

std::vector<Field> fields_of(const VtuReader& frame) {
  std::vector<Field> fields;
  for (const VtuReader::Array& array : frame.arrays()) {
    // Displacements follow from the positions.
    if (array.type != "Float32" || array.name == "displacement") continue;
    if (array.section == Section::CellData && array.components == 1)
      fields.push_back({array.name, false, {}});
    if (array.section == Section::PointData && array.components == 3)
      fields.push_back({array.name, true, {}});
  }
  return fields;
}

/// First frame in which each cell has failed. Elements do not come back, so that the last frame says whether
/// the others must be looked at.
std::vector<Index> deaths(const ResultFolder& results, const VtuReader& first, const Progress& progress) {
  const auto frames = static_cast<Index>(results.frames.size());
  std::vector<Index> death(first.cells(), frames);
  if (first.find(Section::CellData, "alive") == nullptr) return death;
  const auto note = [&](Index frame) {
    const auto alive = VtuReader(results.frames[frame].grid).integers(Section::CellData, "alive");
    if (alive.size() != death.size()) throw Error("The frames have different numbers of cells.");
    bool all = true;
    for (std::size_t cell = 0; cell < death.size(); ++cell)
      if (alive[cell] == 0) {
        all = false;
        death[cell] = std::min(death[cell], frame);
      }
    return all;
  };
  if (note(frames - 1)) return death;
  for (Index frame = 0; frame < frames; ++frame) {
    note(frame);
    progress("Looking for failed elements", frame + 1, frames);
  }
  return death;
}

std::vector<Index> node_deaths(const Surface& surface, const std::vector<Index>& cell_death) {
  std::vector<Index> death(surface.nodes.size(), 0);
  for (const auto* list : {&surface.faces, &surface.lines})
    for (const Face& face : *list)
      for (const Index node : face.node) death[node] = std::max(death[node], cell_death[face.cell]);
  return death;
}

void add_frame(const VtuReader& frame, Index number, RunSurvey& survey) {
  const std::vector<float> positions = frame.reals(Section::Points, "position", 3);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<float> values = coordinates(positions, survey.surface, axis);
    for (std::size_t node = 0; node < values.size(); ++node)
      if (number < survey.node_death[node]) survey.box[axis].add(static_cast<double>(values[node]));
  }
  for (Field& field : survey.fields) {
    const std::vector<float> values = field_values(frame, survey, field);
    const std::vector<Index>& death = field.by_node ? survey.node_death : survey.cell_death;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (number < death[i]) field.range.add(static_cast<double>(values[i]));
  }
}

}  // namespace

std::vector<float> coordinates(const std::vector<float>& positions, const Surface& surface, int axis) {
  std::vector<float> values(surface.nodes.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = positions[3 * static_cast<std::size_t>(surface.nodes[i]) + axis];
  return values;
}

std::vector<float> field_values(const VtuReader& frame, const RunSurvey& survey, const Field& field) {
  const std::vector<Index>& places = field.by_node ? survey.surface.nodes : survey.surface.cells;
  const std::vector<float> all =
      frame.reals(field.by_node ? Section::PointData : Section::CellData, field.name, field.by_node ? 3 : 1);
  std::vector<float> values(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto place = static_cast<std::size_t>(places[i]);
    if (field.by_node)
      values[i] = std::hypot(all[3 * place], all[3 * place + 1], all[3 * place + 2]);
    else
      values[i] =
          has_value(field.name, survey.cell_types[i]) ? all[place] : std::numeric_limits<float>::quiet_NaN();
  }
  return values;
}

RunSurvey survey_run(const ResultFolder& results, const Progress& progress) {
  const VtuReader first(results.frames.front().grid);
  const CellList cells{first.integers(Section::Cells, "connectivity"),
                       first.integers(Section::Cells, "offsets"), first.integers(Section::Cells, "types"),
                       deaths(results, first, progress)};
  RunSurvey survey;
  survey.surface = make_surface(cells, first.points());
  survey.all_nodes = first.points();
  survey.all_cells = first.cells();
  for (const Index cell : survey.surface.cells) {
    survey.cell_types.push_back(cells.types[cell]);
    survey.cell_death.push_back(cells.death[cell]);
  }
  survey.node_death = node_deaths(survey.surface, survey.cell_death);
  survey.fields = fields_of(first);
  for (std::size_t i = 0; i < results.frames.size(); ++i) {
    const VtuReader frame(results.frames[i].grid);
    if (frame.points() != first.points() || frame.cells() != first.cells())
      throw Error(
          fmt::format("{} has other nodes or cells than the first frame.", results.frames[i].grid.string()));
    add_frame(frame, static_cast<Index>(i), survey);
    progress("Reading", i + 1, results.frames.size());
  }
  // A field that never has a value, such as the pressure where there are no solids, is not worth a choice.
  std::erase_if(survey.fields, [](const Field& field) { return field.range.empty; });
  return survey;
}

}  // namespace crumple::report
