// SPDX-License-Identifier: BSD-3-Clause
#include "output/d3plot/d3plot_geometry.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "output/d3plot/d3plot_layout.hpp"
#include "output/files/write_error.hpp"

namespace crumple::output {

namespace {

// Words as the LS-DYNA Database Binary Output Manual has them; what other programs make of them was tried.

constexpr int title_words = 10;
constexpr int title_words_of_list = 18;
constexpr int numbering_head_words = 16;
constexpr int part_number_lists = 3;

constexpr int file_is_d3plot = 1;
constexpr int three_dimensions_unpacked = 4;
constexpr int code_of_ls_dyna = 6;
constexpr int deletion_table = 10000;
// Switches for the contents of shells.
constexpr int written = 1000;
constexpr int left_out = 999;

constexpr int heading_follows = 90000;
constexpr int part_titles_follow = 90001;

struct Counts {
  std::int64_t nodes = 0, solids = 0, beams = 0, shells = 0, parts = 0;
  std::int64_t solid_parts = 0, beam_parts = 0, shell_parts = 0;

  explicit Counts(const model::Model& model)
      : nodes(model.nodes.count()),
        solids(std::ssize(model.solids)),
        beams(std::ssize(model.beams) + std::ssize(model.discretes)),
        shells(std::ssize(model.shells)),
        parts(std::ssize(model.parts)) {
    for (const model::Part& part : model.parts) {
      const model::ElementKind kind = model::kind_of(part);
      ++(kind == model::ElementKind::Solid   ? solid_parts
         : kind == model::ElementKind::Shell ? shell_parts
                                             : beam_parts);
    }
  }
  std::int64_t numbering_words() const {
    return numbering_head_words + nodes + solids + beams + shells + part_number_lists * parts;
  }
};

void integers(D3plotWords& words, std::initializer_list<std::int64_t> values) {
  for (const std::int64_t value : values) words.integer(value);
}

void add_control_block(D3plotWords& words, const View& view, std::int64_t run_time) {
  const Counts count(view.model);
  const D3plotLayout layout(view.model.output.extent);
  const auto choice = [](bool chosen) { return chosen ? written : left_out; };
  words.text(view.model.title, title_words);
  integers(words, {run_time, file_is_d3plot, 0});
  words.text("R11 ", 1);
  words.real(960.0);  // version: says that the numbers are IEEE's
  const std::int64_t global_values = 6 + 7 * count.parts + d3plot_wall_values * std::ssize(view.domain.walls);
  integers(words, {three_dimensions_unpacked, count.nodes, code_of_ls_dyna, global_values});
  integers(words, {0, 1, 1, 1});  // no temperatures; coordinates, velocities, accelerations
  integers(words, {count.solids, count.solid_parts, 0, 0, layout.solid_values()});
  integers(words, {count.beams, count.beam_parts, D3plotLayout::beam_values});
  integers(words, {count.shells, count.shell_parts, layout.shell_values()});
  integers(words, {layout.solid_history, layout.shell_history, -(deletion_table + layout.layers)});
  integers(words, {0, 0, count.numbering_words()});  // no particles
  // There are no thick shells, but readers work out their size.
  integers(words, {0, 0, layout.layers * (7 + layout.shell_history)});
  integers(words, {choice(layout.stresses), choice(layout.plastic_strain), choice(layout.resultants),
                   choice(layout.energy)});
  integers(words, {0, 0, 0, 0, count.parts, 0, 1});
  words.zeros(10);  // the word of a longer block among them, which makes ParaView 5.11 crash
}

/// Numbers count from 1 in the file.
void add_solids(D3plotWords& words, const model::Model& model) {
  for (const model::SolidElement& solid : model.solids) {
    // LS-DYNA repeats the fourth node of a tetrahedron, where ours repeat the third as well.
    constexpr std::array<std::size_t, 8> of_tetrahedron{0, 1, 2, 4, 4, 4, 4, 4};
    const bool tetrahedron = model::is_tetrahedron(solid);
    for (std::size_t k = 0; k < 8; ++k) words.integer(solid.node[tetrahedron ? of_tetrahedron[k] : k] + 1);
    words.integer(solid.part + 1);
  }
}

void add_lines(D3plotWords& words, const model::Model& model) {
  for (const model::BeamElement& beam : model.beams)
    // No orientation node is no_index, which becomes 0.
    integers(words, {beam.node[0] + 1, beam.node[1] + 1, beam.orientation_node + 1, 0, 0, beam.part + 1});
  for (const model::DiscreteElement& spring : model.discretes)
    integers(words, {spring.node[0] + 1, spring.node[1] + 1, 0, 0, 0, spring.part + 1});
}

void add_shells(D3plotWords& words, const model::Model& model) {
  for (const model::ShellElement& shell : model.shells) {
    for (const Index node : shell.node) words.integer(node + 1);
    words.integer(shell.part + 1);
  }
}

void add_nodes(D3plotWords& words, const domain::NodeFields& nodes) {
  for (const Index node : nodes.domain_node) words.vector(nodes.reference[node]);
}

/// A number that the user gave.
void add_id(D3plotWords& words, UserId id) {
  if (id > std::numeric_limits<std::int32_t>::max() || id < std::numeric_limits<std::int32_t>::min())
    throw WriteError(fmt::format("d3plot files cannot be written: the number {} has more than 32 bits.", id));
  words.integer(id);
}

template <class Items>
void add_ids(D3plotWords& words, const Items& items) {
  for (const auto& item : items) add_id(words, item.id);
}

void add_numbering(D3plotWords& words, const model::Model& model) {
  const Counts count(model);
  // Where the lists would lie in LS-DYNA's memory; the first is negative where the parts have numbers.
  const std::int64_t solids = 1 + count.nodes;
  const std::int64_t beams = solids + count.solids;
  const std::int64_t shells = beams + count.beams;
  const std::int64_t parts = shells + count.shells;
  integers(words, {-1, solids, beams, shells, parts});
  integers(words, {count.nodes, count.solids, count.beams, count.shells, 0});
  integers(words, {parts, parts + count.parts, parts + 2 * count.parts, count.parts, 0, count.parts});
  for (const UserId id : model.nodes.id) add_id(words, id);
  add_ids(words, model.solids);
  add_ids(words, model.beams);
  add_ids(words, model.discretes);
  add_ids(words, model.shells);
  std::vector<std::size_t> order(model.parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return model.parts[a].id < model.parts[b].id; });
  for (const std::size_t part : order) add_id(words, model.parts[part].id);
  add_ids(words, model.parts);
  for (const std::size_t part : order) words.integer(static_cast<std::int64_t>(part) + 1);
}

/// VTK 9.1 looks for the titles of the parts in the first place only.
void add_titles(D3plotWords& words, const model::Model& model) {
  integers(words, {part_titles_follow, std::ssize(model.parts)});
  for (const model::Part& part : model.parts) {
    add_id(words, part.id);
    words.text(part.title, title_words_of_list);
  }
  words.integer(heading_follows);
  words.text(model.title, title_words_of_list);
}

}  // namespace

D3plotWords d3plot_geometry(const View& view, std::int64_t run_time) {
  D3plotWords words;
  add_control_block(words, view, run_time);
  add_nodes(words, view.domain.nodes);
  add_solids(words, view.model);
  add_lines(words, view.model);
  add_shells(words, view.model);
  add_numbering(words, view.model);
  words.end_mark();
  add_titles(words, view.model);
  words.end_mark();
  words.pad();
  return words;
}

}  // namespace crumple::output
