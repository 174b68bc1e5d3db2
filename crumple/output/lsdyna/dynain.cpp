// SPDX-License-Identifier: BSD-3-Clause
#include "output/lsdyna/dynain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

#include "output/lsdyna/dynain_elements.hpp"
#include "output/results/block_places.hpp"
#include "output/results/shell_results.hpp"

namespace crumple::output {
namespace {

using math::Vec3;

/// The widest id of the 8 columns of *NODE and *ELEMENT.
constexpr UserId largest_id = 99'999'999;

template <class Block>
bool is_alive(const Block& block, Index place) {
  const domain::StateItem* const active = block.find("active");
  return active == nullptr || block.state(place, active->first) != 0;
}

/// Velocities at time n from those half a step before and behind it.
Vec3 at_time(const Vec3& before, const Vec3& behind, const View& view) {
  const double both = view.domain.clock.step + view.next_step;
  return both > 0 ? behind - (view.next_step / both) * (behind - before) : behind;
}

class Writer {
 public:
  Writer(const View& view, const DynainRequest& request)
      : view_(view),
        request_(request),
        shells_(block_places(view.domain.shells, view.model.shells.size())),
        solids_(block_places(view.domain.solids, view.model.solids.size())),
        node_is_written_(view.model.nodes.id.size(), request.all ? 1 : 0) {}

  Dynain write() {
    result_.text =
        fmt::format("{} of a run at time {:.9g}; use it in place of nodes and elements\n*KEYWORD\n",
                    dynain_mark, view_.domain.clock.time);
    if (widest_id() > largest_id) {
      result_.notes.emplace_back(
          "dynain: ids of more than 8 digits do not fit into its columns; it is empty.");
      return std::move(result_);
    }
    write_shells();
    write_solids();
    const std::string elements = std::move(result_.text);
    result_.text.clear();
    write_nodes();
    result_.text.insert(0, elements);
    write_stresses();
    if (request_.velocities) write_velocities();
    result_.text += "*END\n";
    note_lines(view_.domain.beams);
    note_lines(view_.domain.discretes);
    if (failed_ > 0)
      result_.notes.push_back(fmt::format("dynain: {} elements have failed and are left out.", failed_));
    return std::move(result_);
  }

 private:
  UserId widest_id() const {
    UserId widest = 0;
    const auto look = [&](const auto& items) {
      for (const auto& item : items) widest = std::max(widest, item.id);
    };
    look(view_.model.shells);
    look(view_.model.solids);
    look(view_.model.parts);
    for (const UserId id : view_.model.nodes.id) widest = std::max(widest, id);
    return widest;
  }

  bool has_part(Index part) const {
    const std::vector<Index>& parts = request_.springback.parts;
    return request_.all || std::binary_search(parts.begin(), parts.end(), part);
  }

  /// Counts failed elements out.
  template <class Block>
  bool takes(const Block& block, Index place) {
    if (!has_part(block.part)) return false;
    if (is_alive(block, place)) return true;
    ++failed_;
    return false;
  }

  void write_element(UserId id, Index part, std::span<const Index> nodes) {
    fmt::format_to(std::back_inserter(result_.text), "{:8}{:8}", id,
                   view_.model.parts[static_cast<std::size_t>(part)].id);
    for (const Index node : nodes) {
      fmt::format_to(std::back_inserter(result_.text), "{:8}",
                     view_.model.nodes.id[static_cast<std::size_t>(node)]);
      node_is_written_[static_cast<std::size_t>(node)] = 1;
    }
    result_.text += '\n';
  }

  /// Ten nodes on a card of their own.
  void write_quadratic(const model::SolidElement& solid, Index part) {
    fmt::format_to(std::back_inserter(result_.text), "{:8}{:8}\n", solid.id,
                   view_.model.parts[static_cast<std::size_t>(part)].id);
    const auto write = [&](Index node) {
      fmt::format_to(std::back_inserter(result_.text), "{:8}",
                     view_.model.nodes.id[static_cast<std::size_t>(node)]);
      node_is_written_[static_cast<std::size_t>(node)] = 1;
    };
    for (const std::size_t corner : model::corners_of_tetrahedron) write(solid.node[corner]);
    for (std::size_t side = 0; side < model::SolidNodes::middles; ++side) write(solid.node.middle(side));
    result_.text += '\n';
  }

  void write_shells() {
    bool first = true;
    int layered = 0;
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      const auto [b, place] = shells_[i];
      const domain::ShellBlock& block = view_.domain.shells[static_cast<std::size_t>(b)];
      if (!takes(block, place)) continue;
      const model::ShellElement& shell = view_.model.shells[i];
      if (shell.layup != no_index) {
        ++layered;
        continue;
      }
      if (std::exchange(first, false)) result_.text += "*ELEMENT_SHELL_THICKNESS\n";
      write_element(shell.id, block.part, shell.node);
      const std::string thickness = number_in_columns(ShellResults(view_.model, block).thickness(place), 16);
      for (int k = 0; k < 4; ++k) result_.text += thickness;
      if (shell.material_angle != 0) result_.text += number_in_columns(shell.material_angle * degrees, 16);
      result_.text += '\n';
    }
    if (layered > 0)
      result_.notes.push_back(
          fmt::format("dynain: {} shells of *ELEMENT_SHELL_COMPOSITE are left out.", layered));
  }

  void write_solids() {
    bool first = true;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
      const auto [b, place] = solids_[i];
      const domain::SolidBlock& block = view_.domain.solids[static_cast<std::size_t>(b)];
      if (!takes(block, place)) continue;
      if (std::exchange(first, false)) result_.text += "*ELEMENT_SOLID\n";
      const model::SolidElement& solid = view_.model.solids[i];
      if (solid.node.has_middles())
        write_quadratic(solid, block.part);
      else
        write_element(solid.id, block.part, solid.node);
    }
  }

  void write_nodes() {
    std::vector<std::array<int, 2>> held(node_is_written_.size(), {0, 0});
    for (const auto& hold : request_.springback.holds)
      held[static_cast<std::size_t>(hold.node)] = {hold.translation, hold.rotation};
    result_.text += "*NODE\n";
    for (std::size_t i = 0; i < node_is_written_.size(); ++i) {
      if (node_is_written_[i] == 0) continue;
      const Vec3& x = view_.domain.nodes.position[view_.domain.nodes.domain_node[i]];
      fmt::format_to(std::back_inserter(result_.text), "{:8}{}{}{}", view_.model.nodes.id[i],
                     number_in_columns(x.x, 16), number_in_columns(x.y, 16), number_in_columns(x.z, 16));
      if (held[i][0] != 0 || held[i][1] != 0)
        fmt::format_to(std::back_inserter(result_.text), "{:8}{:8}", held[i][0], held[i][1]);
      result_.text += '\n';
    }
  }

  /// Whether elements of a block get stresses; where they do not, says so once.
  template <class Block>
  bool has_stresses(const Block& block) {
    if (block.rigid || !has_part(block.part)) return false;
    const std::string refusal = refusal_of_stress(view_.model, block);
    if (!refusal.empty())
      result_.notes.push_back(fmt::format("dynain: no stresses of part {}: {}.",
                                          view_.model.parts[static_cast<std::size_t>(block.part)].id,
                                          refusal));
    return refusal.empty();
  }

  template <class Blocks, class Append>
  void write_stresses_of(const Blocks& blocks, const BlockPlaces& places, const char* keyword,
                         const Append& append) {
    std::vector<char> wanted;
    wanted.reserve(blocks.size());
    for (const auto& block : blocks) wanted.push_back(has_stresses(block) ? 1 : 0);
    bool first = true;
    for (const auto& [b, place] : places) {
      const auto& block = blocks[static_cast<std::size_t>(b)];
      if (wanted[static_cast<std::size_t>(b)] == 0 || !is_alive(block, place)) continue;
      if (std::exchange(first, false)) result_.text += keyword;
      append(view_, block, place, result_.text);
    }
  }

  void write_stresses() {
    write_stresses_of(view_.domain.shells, shells_, "*INITIAL_STRESS_SHELL\n",
                      [](const View& view, const domain::ShellBlock& block, Index place, std::string& text) {
                        if (!block.has_own_layup) append_shell_stress(view, block, place, text);
                      });
    write_stresses_of(view_.domain.solids, solids_, "*INITIAL_STRESS_SOLID\n", append_solid_stress);
  }

  /// Beams, springs and dampers stay in the deck.
  template <class Blocks>
  void note_lines(const Blocks& blocks) {
    for (const auto& block : blocks)
      if (has_part(block.part) && !block.rigid)
        result_.notes.push_back(fmt::format("dynain: elements and forces of part {} are left out.",
                                            view_.model.parts[static_cast<std::size_t>(block.part)].id));
  }

  void write_velocities() {
    const domain::NodeFields& nodes = view_.domain.nodes;
    result_.text += "*INITIAL_VELOCITY_NODE+\n";
    for (std::size_t i = 0; i < node_is_written_.size(); ++i) {
      if (node_is_written_[i] == 0) continue;
      const Index node = nodes.domain_node[i];
      const auto at = static_cast<std::size_t>(node);
      const bool known = !view_.earlier_velocity.empty();
      Vec3 v = nodes.velocity[node];
      Vec3 w = nodes.angular_velocity[node];
      if (known) {
        v = at_time(view_.earlier_velocity[at], v, view_);
        w = at_time(view_.earlier_angular_velocity[at], w, view_);
      }
      fmt::format_to(std::back_inserter(result_.text), "{:20}", view_.model.nodes.id[i]);
      for (const double number : {v.x, v.y, v.z, w.x, w.y, w.z})
        result_.text += number_in_columns(number, 20);
      result_.text += '\n';
    }
  }

  static constexpr double degrees = 180 / std::numbers::pi;

  const View& view_;
  const DynainRequest& request_;
  BlockPlaces shells_, solids_;
  std::vector<char> node_is_written_;  ///< by model node
  int failed_ = 0;
  Dynain result_;
};

}  // namespace

std::string number_in_columns(double value, std::size_t columns) {
  std::array<char, 40> digits{};
  for (int precision = 17; precision > 0; --precision) {
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::general, precision)
                         .ptr;
    const auto length = static_cast<std::size_t>(end - digits.data());
    if (length <= columns) return std::string(columns - length, ' ') + std::string(digits.data(), length);
  }
  return std::string(columns, '*');
}

Dynain dynain_of(const View& view, const DynainRequest& request) {
  return Writer(view, request).write();
}

}  // namespace crumple::output
