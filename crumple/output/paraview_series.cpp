// SPDX-License-Identifier: BSD-3-Clause
#include "output/paraview_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <system_error>

#include "output/atomic_file.hpp"
#include "output/shell_results.hpp"

namespace crumple::output {

namespace {

constexpr std::uint8_t vtk_triangle = 5;
constexpr std::uint8_t vtk_quad = 9;

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

}  // namespace

ParaviewSeries::ParaviewSeries(std::filesystem::path folder, std::string name, const View& view)
    : folder_(std::move(folder)), name_(std::move(name)) {
  make_folder(folder_ / "vtu");
  remove_earlier_frames();
  place_.resize(view.model.shells.size());
  for (Index b = 0; b < static_cast<Index>(view.domain.shells.size()); ++b) {
    const domain::ShellBlock& block = view.domain.shells[b];
    for (Index place = 0; place < block.elements; ++place) place_[block.element[place]] = {b, place};
  }
  pack_constant_arrays(view);
}

void ParaviewSeries::remove_earlier_frames() const {
  std::error_code ignored;
  std::filesystem::remove(collection(), ignored);
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "vtu", ignored)) {
    const std::string file = entry.path().filename().string();
    const std::string frame = file.substr(0, file.find_last_of('_'));
    if (frame == name_ && entry.path().extension() == ".vtu") std::filesystem::remove(entry.path(), ignored);
  }
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

std::vector<VtuArray> ParaviewSeries::cell_fields(const View& view) {
  std::vector<ShellResults> results;
  for (const domain::ShellBlock& block : view.domain.shells) results.emplace_back(view.model, block);
  const auto make = [&](const std::string& name, auto value) {
    std::vector<float> values;
    values.reserve(place_.size());
    for (const auto& [block, place] : place_)
      values.push_back(static_cast<float>((results[block].*value)(place)));
    return packer_.array<float>(name, 1, values);
  };
  std::vector<VtuArray> fields;
  fields.push_back(make("plastic_strain", &ShellResults::plastic_strain));
  fields.push_back(make("von_mises", &ShellResults::von_mises));
  fields.push_back(make("von_mises_mid", &ShellResults::mid_von_mises));
  fields.push_back(make("thickness", &ShellResults::thickness));
  std::vector<std::uint8_t> alive;
  for (const auto& [block, place] : place_) alive.push_back(results[block].alive(place) ? 1 : 0);
  fields.push_back(packer_.array<std::uint8_t>("alive", 1, alive));
  return fields;
}

std::string ParaviewSeries::frame_name(int frame) const {
  return fmt::format("vtu/{}_{:06}.vtu", name_, frame);
}

std::string ParaviewSeries::collection_text() const {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  for (int frame = 0; frame < frames(); ++frame)
    fmt::format_to(std::back_inserter(text), "    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n",
                   times_[frame], frame_name(frame));
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
  grid.cells = static_cast<Index>(place_.size());
  grid.positions = {&positions};
  for (const VtuArray& array : topology_) grid.topology.push_back(&array);
  grid.point_data = {&node_id_};
  for (const VtuArray& array : points) grid.point_data.push_back(&array);
  grid.cell_data = {&part_id_, &element_id_};
  for (const VtuArray& array : cells) grid.cell_data.push_back(&array);
  write_atomically(folder_ / frame_name(frames()), vtu_text(grid));
  times_.push_back(grid.time);
  write_atomically(collection(), collection_text());
}

}  // namespace crumple::output
