// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/search.hpp"

#include <algorithm>
#include <cstddef>

#include "checks.hpp"
#include "finder.hpp"
#include "neighbour_lists.hpp"
#include "parallel.hpp"
#include "production/quick_checks.hpp"

namespace cellsearch {

namespace {

/// A block of segments that begins at a multiple of what a method works on at a time: the counted visits must
/// not depend on where blocks begin.
BlockRange whole_batches(Index count, int block, int blocks) {
  constexpr Index batch = 64;
  const Index batches = count / batch + (count % batch == 0 ? 0 : 1);
  BlockRange range(batches, block, blocks);
  range.begin *= batch;
  range.end = range.end == batches ? count : range.end * batch;
  return range;
}

}  // namespace

Search::Search(const Settings& settings)
    : settings_(settings), neighbours_(std::make_unique<NeighbourLists>()), block_spare_(1) {
  check_settings(settings);
  instruction_set_ = instruction_set();
  finder_ = make_finder(settings.method, instruction_set_);
  if (finder_ == nullptr) throw Error(ErrorKind::BadSetting, -1, "There is no such search method.");
  if (settings.domain) grid_ = CellGrid(*settings.domain);
}

InstructionSet Search::instruction_set() const {
  const std::vector<InstructionSet> available = instruction_sets();
  if (!settings_.instruction_set) return available.back();
  if (std::find(available.begin(), available.end(), *settings_.instruction_set) == available.end()) {
    throw Error(ErrorKind::BadSetting, -1,
                "This processor does not have the instruction set \"" +
                    std::string(name_of(*settings_.instruction_set)) + "\".");
  }
  return *settings_.instruction_set;
}

Search::~Search() = default;
Search::Search(Search&&) noexcept = default;
Search& Search::operator=(Search&&) noexcept = default;

void Search::build(const Scene& scene) {
  // If a check throws there must be nothing to query.
  scene_ = Scene{};
  statistics_ = Statistics{};
  SceneSummary summary;
  // The production method looks at the coordinates itself, while it sorts the nodes.
  const bool production = settings_.method == Method::Production;
  const bool quick = production && production::quick_checks(scene, instruction_set_, settings_.threads);
  if (!quick) summary = check_scene(scene, settings_.threads);
  const Offset participants = static_cast<Offset>(scene.participants());
  const double edge = settings_.cell_edge.value_or(settings_.cell_factor * summary.mean_edge);
  if (!settings_.domain && !production) {
    const double limit = settings_.cells_per_node * static_cast<double>(participants);
    const Offset max_cells = static_cast<Offset>(std::clamp(limit, 1.0, 2147483647.0));
    grid_ = CellGrid(automatic_domain(summary.nodes, edge, max_cells));
  }
  neighbours_->build(scene);
  FinderInput input;
  input.scene = scene;
  input.test = CandidateTest(scene, neighbours_.get(), summary.largest_radius);
  input.grid = grid_;
  input.threads = settings_.threads;
  input.cell_edge = edge;
  input.asked_cell_edge = settings_.cell_edge.value_or(0.0);
  if (settings_.domain) input.limit = settings_.domain->box;
  finder_->build(input);
  scene_ = scene;
  statistics_.segments = segments();
  statistics_.participants = participants;
  statistics_.nodes_in_domain = finder_->nodes_in_domain();
  statistics_.cells = finder_->cells();
  statistics_.bytes = finder_->bytes() + neighbours_->bytes();
}

const Candidates& Search::query() {
  const Index count = segments();
  candidates_.first.resize(static_cast<std::size_t>(count) + 1);
  candidates_.first[0] = 0;
  candidates_.node.clear();
  // Several blocks per thread even out the load. The rows are joined in order, so the cut is never seen.
  const int blocks = settings_.threads == 1 ? 1 : std::max(1, std::min(4 * settings_.threads, count / 64));
  if (block_nodes_.size() < static_cast<std::size_t>(blocks - 1)) {
    block_nodes_.resize(static_cast<std::size_t>(blocks - 1));
  }
  block_rows_.resize(static_cast<std::size_t>(blocks));
  if (block_spare_.size() < block_rows_.size()) block_spare_.resize(block_rows_.size());
  const auto nodes_of = [&](int block) -> Array<Index>& {
    return block == 0 ? candidates_.node : block_nodes_[static_cast<std::size_t>(block - 1)];
  };
  for_blocks(settings_.threads, blocks, [&](int block) {
    const BlockRange range = whole_batches(count, block, blocks);
    Array<Index>& nodes = nodes_of(block);
    nodes.clear();
    FoundRows rows{candidates_.first.data() + range.begin + 1, &nodes};
    rows.spare = &block_spare_[static_cast<std::size_t>(block)];
    finder_->query(range.begin, range.end, rows);
    block_rows_[static_cast<std::size_t>(block)] = {0, rows.raw_visits, rows.cell_visits};
  });
  Offset pairs = 0;
  for (int block = 0; block < blocks; ++block) {
    BlockRows& rows = block_rows_[static_cast<std::size_t>(block)];
    rows.start = pairs;
    pairs += static_cast<Offset>(nodes_of(block).size());
    statistics_.raw_visits += rows.raw_visits;
    statistics_.cell_visits += rows.cell_visits;
  }
  candidates_.node.resize(static_cast<std::size_t>(pairs));
  for_blocks(settings_.threads, blocks, [&](int block) {
    if (block == 0) return;
    const Offset start = block_rows_[static_cast<std::size_t>(block)].start;
    const Array<Index>& nodes = nodes_of(block);
    std::copy(nodes.begin(), nodes.end(), candidates_.node.begin() + start);
    const BlockRange range = whole_batches(count, block, blocks);
    for (Index segment = range.begin; segment < range.end; ++segment) {
      candidates_.first[static_cast<std::size_t>(segment) + 1] += start;
    }
  });
  statistics_.candidates += candidates_.pairs();
  return candidates_;
}

Index Search::query_batch(Index begin) {
  const Index end = std::min(segments(), begin + batch_size);
  batch_nodes_.clear();
  FoundRows rows{batch_ends_.data(), &batch_nodes_};
  rows.spare = &block_spare_[0];
  finder_->query(begin, end, rows);
  statistics_.raw_visits += rows.raw_visits;
  statistics_.cell_visits += rows.cell_visits;
  statistics_.candidates += static_cast<Offset>(batch_nodes_.size());
  return end;
}

}  // namespace cellsearch
