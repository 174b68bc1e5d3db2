// SPDX-License-Identifier: BSD-3-Clause
#include "output/paraview/paraview_series.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <system_error>

#include "output/files/atomic_file.hpp"
#include "output/files/own_file.hpp"
#include "output/results/line_results.hpp"
#include "output/results/point_results.hpp"
#include "output/results/shell_axes.hpp"
#include "output/results/shell_results.hpp"
#include "output/results/solid_results.hpp"

namespace crumple::output {

namespace {

constexpr std::uint8_t vtk_vertex = 1;
constexpr std::uint8_t vtk_line = 3;
constexpr std::uint8_t vtk_triangle = 5;
constexpr std::uint8_t vtk_quad = 9;
constexpr std::uint8_t vtk_tetrahedron = 10;
constexpr std::uint8_t vtk_quadratic_tetrahedron = 24;
constexpr std::uint8_t vtk_hexahedron = 12;
constexpr std::uint8_t vtk_wedge = 13;
constexpr std::uint8_t vtk_pyramid = 14;

/// In the order of Resultant.
constexpr const char* resultant_names[] = {"axial_force",     "shear_s",        "shear_t",
                                           "torsion",         "first_moment_s", "first_moment_t",
                                           "second_moment_s", "second_moment_t"};

/// User ids as 32-bit numbers, or as 64-bit ones if any does not fit.
VtuArray make_id_array(VtuPacker& packer, const std::string& name, const std::vector<UserId>& ids) {
  constexpr UserId limit = std::numeric_limits<std::int32_t>::max();
  if (std::any_of(ids.begin(), ids.end(), [](UserId id) { return id > limit || id < -limit; }))
    return packer.array<std::int64_t>(name, 1, ids);
  std::vector<std::int32_t> narrow(ids.size());
  std::transform(ids.begin(), ids.end(), narrow.begin(),
                 [](UserId id) { return static_cast<std::int32_t>(id); });
  return packer.array<std::int32_t>(name, 1, narrow);
}

/// A vector field in the order of the model's nodes.
template <class Field>
VtuArray make_vector_array(VtuPacker& packer, const std::string& name, const domain::NodeFields& nodes,
                           const Field& field) {
  std::vector<float> values;
  values.reserve(3 * nodes.domain_node.size());
  for (const Index node : nodes.domain_node) {
    const math::Vec3 vector = field(node);
    for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(vector[axis]));
  }
  return packer.array<float>(name, 3, values);
}

bool is_triangle(const model::ShellElement& shell) {
  return shell.node[3] == shell.node[2];
}

/// Places of the nodes that a cell of VTK has; degenerate hexahedra are what they look like.
struct SolidCell {
  std::uint8_t type = vtk_hexahedron;
  std::vector<std::size_t> corner;
};
SolidCell cell_of(const model::SolidNodes& node) {
  if (node.has_middles()) return {vtk_quadratic_tetrahedron, {0, 1, 2, 4, 8, 9, 10, 11, 12, 13}};
  const auto same = [&](std::size_t a, std::size_t b) { return node[a] == node[b]; };
  const bool tip = same(4, 5) && same(5, 6) && same(6, 7);
  if (tip && same(2, 3)) return {vtk_tetrahedron, {0, 1, 2, 4}};
  if (tip) return {vtk_pyramid, {0, 1, 2, 3, 4}};
  // The two triangles of a wedge whose edge 5-7 lies over the quadrilateral 1 2 3 4.
  if (same(4, 5) && same(6, 7)) return {vtk_wedge, {0, 1, 4, 3, 2, 6}};
  return {vtk_hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}};
}

bool any_has_damage(const domain::Domain& domain) {
  const auto damaged = [](const domain::ElementBlock& block) { return has_damage(block); };
  return std::any_of(domain.shells.begin(), domain.shells.end(), damaged) ||
         std::any_of(domain.solids.begin(), domain.solids.end(), damaged);
}

/// The value of an attribute in XML: the deck may be called anything.
std::string as_attribute(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    if (letter == '&')
      safe += "&amp;";
    else if (letter == '<')
      safe += "&lt;";
    else if (letter == '>')
      safe += "&gt;";
    else if (letter == '"')
      safe += "&quot;";
    else
      safe += letter;
  }
  return safe;
}

}  // namespace

void remove_frames(const std::filesystem::path& folder, const std::string& name, int first) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "vtu", ignored)) {
    const std::string file = entry.path().stem().string();
    const std::size_t end = file.find_last_of('_');
    const std::string frame = file.substr(0, end);
    if ((frame != name && frame != name + "_walls") || entry.path().extension() != ".vtu") continue;
    if (std::atoi(file.c_str() + end + 1) >= first) std::filesystem::remove(entry.path(), ignored);
  }
}

ParaviewSeries::ParaviewSeries(std::filesystem::path folder, std::string name, const View& view,
                               Opening opening, bool all_fields)
    : folder_(std::move(folder)), name_(std::move(name)), all_fields_(all_fields), walls_(view) {
  make_subfolder(folder_ / "vtu");
  if (opening == Opening::New) remove_earlier_frames();
  place_ = block_places(view.domain.shells, view.model.shells.size());
  solid_place_ = block_places(view.domain.solids, view.model.solids.size());
  beam_place_ = block_places(view.domain.beams, view.model.beams.size());
  discrete_place_ = block_places(view.domain.discretes, view.model.discretes.size());
  pack_constant_arrays(view);
}

void ParaviewSeries::declare(domain::StateList& list) {
  list.keep_list("frame_times", "time", domain::Entity::Run, 1, times_);
}

void ParaviewSeries::resume() {
  std::error_code ignored;
  while (!times_.empty() && !std::filesystem::exists(folder_ / frame_name(frames() - 1), ignored))
    times_.pop_back();
  remove_unfinished_files(folder_ / "vtu");
  remove_frames(folder_, name_, frames());
  if (!times_.empty()) write_atomically(collection(), collection_text());
}

void ParaviewSeries::remove_earlier_frames() const {
  std::error_code ignored;
  std::filesystem::remove(collection(), ignored);
  remove_unfinished_files(folder_ / "vtu");
  remove_frames(folder_, name_);
}

void ParaviewSeries::pack_constant_arrays(const View& view) {
  std::vector<std::int32_t> connectivity;
  std::vector<std::int32_t> offsets;
  std::vector<std::uint8_t> types;
  std::vector<UserId> elements;
  std::vector<UserId> parts;
  for (const model::ShellElement& shell : view.model.shells) {
    const int corners = is_triangle(shell) ? 3 : 4;
    connectivity.insert(connectivity.end(), shell.node.begin(), shell.node.begin() + corners);
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    types.push_back(is_triangle(shell) ? vtk_triangle : vtk_quad);
    elements.push_back(shell.id);
    parts.push_back(view.model.parts[shell.part].id);
  }
  for (const model::SolidElement& solid : view.model.solids) {
    const SolidCell cell = cell_of(solid.node);
    for (const std::size_t corner : cell.corner) connectivity.push_back(solid.node[corner]);
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    types.push_back(cell.type);
    elements.push_back(solid.id);
    parts.push_back(view.model.parts[solid.part].id);
  }
  const auto add_lines = [&](const auto& lines) {
    for (const auto& line : lines) {
      // A spring that is held at its second end is a point.
      const bool point = line.node[0] == line.node[1];
      connectivity.insert(connectivity.end(), line.node.begin(), line.node.begin() + (point ? 1 : 2));
      offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
      types.push_back(point ? vtk_vertex : vtk_line);
      elements.push_back(line.id);
      parts.push_back(view.model.parts[line.part].id);
    }
  };
  add_lines(view.model.beams);
  add_lines(view.model.discretes);
  topology_.push_back(packer_.array<std::int32_t>("connectivity", 1, connectivity));
  topology_.push_back(packer_.array<std::int32_t>("offsets", 1, offsets));
  topology_.push_back(packer_.array<std::uint8_t>("types", 1, types));
  node_id_ = make_id_array(packer_, "node_id", view.model.nodes.id);
  element_id_ = make_id_array(packer_, "element_id", elements);
  part_id_ = make_id_array(packer_, "part", parts);
}

std::vector<VtuArray> ParaviewSeries::point_fields(const View& view) {
  const domain::NodeFields& nodes = view.domain.nodes;
  const auto& contact = view.domain.contact_force;
  std::vector<VtuArray> fields;
  fields.push_back(make_vector_array(packer_, "displacement", nodes, [&](Index node) {
    return nodes.position[node] - nodes.reference[node];
  }));
  fields.push_back(
      make_vector_array(packer_, "velocity", nodes, [&](Index node) { return nodes.velocity[node]; }));
  fields.push_back(make_vector_array(packer_, "contact_force", nodes, [&](Index node) {
    return contact.empty() ? math::Vec3{} : contact[node];
  }));
  return fields;
}

/// What the blocks show, in the order of the domain.
struct ParaviewSeries::CellResults {
  explicit CellResults(const View& view)
      : solids(view.domain.solids.begin(), view.domain.solids.end()),
        discretes(view.domain.discretes.begin(), view.domain.discretes.end()) {
    for (const domain::ShellBlock& block : view.domain.shells) shells.emplace_back(view.model, block);
    for (const domain::BeamBlock& block : view.domain.beams) beams.emplace_back(view.model, block);
  }
  std::vector<ShellResults> shells;
  std::vector<SolidResults> solids;
  std::vector<LineResults> beams;
  std::vector<LineResults> discretes;
};

/// An array of `Count` numbers for each cell in the order of the topology; the functions take results of a
/// block and a place there.
template <std::size_t Count, class Number, class OfShell, class OfSolid, class OfLine>
VtuArray ParaviewSeries::cell_array(const std::string& name, const CellResults& results, OfShell of_shell,
                                    OfSolid of_solid, OfLine of_line) {
  std::vector<Number> values;
  values.reserve(Count * cell_count());
  const auto add = [&](const auto& places, const auto& of, const auto& value) {
    for (const auto& [block, place] : places) {
      const auto found = value(of, static_cast<std::size_t>(block), place);
      if constexpr (Count == 1)
        values.push_back(static_cast<Number>(found));
      else
        for (const double number : found) values.push_back(static_cast<Number>(number));
    }
  };
  add(place_, results.shells, of_shell);
  add(solid_place_, results.solids, of_solid);
  add(beam_place_, results.beams, of_line);
  add(discrete_place_, results.discretes, of_line);
  return packer_.array<Number>(name, Count, values);
}

std::vector<VtuArray> ParaviewSeries::cell_fields(const View& view) {
  const CellResults results(view);
  const auto make = [&]<class Number>(const std::string& name, Number /*type*/, auto of_shell, auto of_solid,
                                      auto of_line) {
    const auto at = [](auto value) {
      return [value](const auto& of, std::size_t block, Index place) { return value(of[block], place); };
    };
    return cell_array<1, Number>(name, results, at(of_shell), at(of_solid), at(of_line));
  };
  const auto same = [&](const std::string& name, auto value) {
    return make(name, 0.0F, value, value, value);
  };
  const auto none = [](const auto&, Index) { return 0; };
  std::vector<VtuArray> fields;
  fields.push_back(
      same("plastic_strain", [](const auto& r, Index place) { return r.plastic_strain(place); }));
  fields.push_back(same("von_mises", [](const auto& r, Index place) { return r.von_mises(place); }));
  fields.push_back(make(
      "von_mises_mid", 0.0F, [](const ShellResults& r, Index place) { return r.mid_von_mises(place); },
      [](const SolidResults& r, Index place) { return r.mean_von_mises(place); },
      [](const LineResults& r, Index place) { return r.von_mises(place); }));
  if (!place_.empty())
    fields.push_back(make(
        "thickness", 0.0F, [](const ShellResults& r, Index place) { return r.thickness(place); }, none,
        none));
  if (!solid_place_.empty())
    fields.push_back(make(
        "pressure", 0.0F, [](const ShellResults& r, Index place) { return r.pressure(place); },
        [](const SolidResults& r, Index place) { return r.pressure(place); }, none));
  if (any_has_damage(view.domain))
    fields.push_back(cell_array<1, float>(
        "damage", results,
        [&](const auto&, std::size_t block, Index place) {
          return damage_of(view.domain.shells[block], place);
        },
        [&](const auto&, std::size_t block, Index place) {
          return damage_of(view.domain.solids[block], place);
        },
        [](const auto&, std::size_t, Index) { return 0; }));
  for (std::size_t i = 0; i < std::size(resultant_names) && has_lines(); ++i)
    fields.push_back(make(resultant_names[i], 0.0F, none, none, [i](const LineResults& r, Index place) {
      return r.resultant(place, static_cast<Resultant>(i));
    }));
  if (all_fields_) add_detailed_fields(results, view, fields);
  const auto alive = [](const auto& r, Index place) { return r.alive(place) ? 1 : 0; };
  fields.push_back(make("alive", std::uint8_t(0), alive, alive, alive));
  return fields;
}

void ParaviewSeries::add_detailed_fields(const CellResults& results, const View& view,
                                         std::vector<VtuArray>& fields) {
  using Surface = ShellResults::Surface;
  const auto no_tensor = [](const auto&, std::size_t, Index) { return Tensor{}; };
  const auto no_number = [](const auto&, std::size_t, Index) { return 0; };
  const auto of_shell = [&](Surface surface) {
    return [&, surface](const std::vector<ShellResults>& of, std::size_t block, Index place) {
      const ShellAxes axes = shell_axes(view.domain.shells[block], view.domain.nodes, place);
      return in_global_axes(axes, of[block].stress(place, surface));
    };
  };
  const auto of_solid = [](const std::vector<SolidResults>& of, std::size_t block, Index place) {
    return of[block].mean_stress(place);
  };
  fields.push_back(cell_array<6, float>("stress", results, of_shell(Surface::Middle), of_solid, no_tensor));
  if (place_.empty()) return;
  constexpr std::pair<Surface, const char*> surfaces[] = {{Surface::Inner, "inner"},
                                                          {Surface::Outer, "outer"}};
  for (const auto& [surface, name] : surfaces) {
    const auto strain = [surface = surface](const std::vector<ShellResults>& of, std::size_t block,
                                            Index place) { return of[block].plastic_strain(place, surface); };
    fields.push_back(cell_array<6, float>(fmt::format("stress_{}", name), results, of_shell(surface),
                                          no_tensor, no_tensor));
    fields.push_back(
        cell_array<1, float>(fmt::format("plastic_strain_{}", name), results, strain, no_number, no_number));
  }
  const auto change = [](const std::vector<ShellResults>& of, std::size_t block, Index place) {
    return of[block].thickness_change(place);
  };
  fields.push_back(cell_array<1, float>("thickness_change", results, change, no_number, no_number));
}

std::string ParaviewSeries::frame_name(int frame) const {
  return fmt::format("vtu/{}_{:06}.vtu", name_, frame);
}

std::string ParaviewSeries::walls_name(int frame) const {
  return fmt::format("vtu/{}_walls_{:06}.vtu", name_, frame);
}

std::string ParaviewSeries::collection_text() const {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  const auto add = [&](int frame, int part, const std::string& file) {
    fmt::format_to(std::back_inserter(text), "    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n",
                   times_[frame], part, as_attribute(file));
  };
  for (int frame = 0; frame < frames(); ++frame) {
    add(frame, 0, frame_name(frame));
    if (!walls_.empty()) add(frame, 1, walls_name(frame));
  }
  return text + "  </Collection>\n</VTKFile>\n";
}

void ParaviewSeries::write_frame(const View& view) {
  const domain::NodeFields& nodes = view.domain.nodes;
  const VtuArray positions =
      make_vector_array(packer_, "position", nodes, [&](Index node) { return nodes.position[node]; });
  const std::vector<VtuArray> points = point_fields(view);
  const std::vector<VtuArray> cells = cell_fields(view);
  VtuGrid grid;
  grid.time = view.domain.clock.time;
  grid.points = nodes.count();
  grid.cells = static_cast<Index>(cell_count());
  grid.positions = {&positions};
  for (const VtuArray& array : topology_) grid.topology.push_back(&array);
  grid.point_data = {&node_id_};
  for (const VtuArray& array : points) grid.point_data.push_back(&array);
  grid.cell_data = {&part_id_, &element_id_};
  for (const VtuArray& array : cells) grid.cell_data.push_back(&array);
  write_atomically(folder_ / frame_name(frames()), vtu_text(grid));
  if (!walls_.empty()) write_atomically(folder_ / walls_name(frames()), walls_.text(view));
  times_.push_back(grid.time);
  write_atomically(collection(), collection_text());
}

}  // namespace crumple::output
