// SPDX-License-Identifier: BSD-3-Clause
#include "production/node_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "parallel.hpp"

namespace cellsearch::production {
namespace {

/// Each thread beyond the first that sorts needs counters for all cells, so their number is bounded.
constexpr int most_sorting_threads = 4;

/// Cells of a divided cell per node in it, at most.
constexpr double cells_per_node = 2.0;

std::int32_t lattice_number(const Grid& grid, std::size_t axis, double coordinate) {
  const double place = coordinate * grid.scale[axis] + grid.offset[axis];
  if (!(place < lattice_limit)) return lattice_limit;
  return place > -lattice_limit ? static_cast<std::int32_t>(place) : -lattice_limit;
}

/// Largest edge of the cells of a grid [length].
double cell_edge(const Grid& grid) {
  double edge = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (grid.scale[axis] > 0.0) edge = std::max(edge, std::ldexp(1.0 / grid.scale[axis], grid.shift[axis]));
  }
  return edge;
}

/// Cell edges that divide `box`, which holds `nodes` nodes, with territories of about `size` [length] if
/// known.
CellEdges edges_within(const Box& box, double nodes, double size, int run_axis) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, 0.5 * box.hi[axis] - 0.5 * box.lo[axis]);
  CellEdges edges{run_axis, 0.0, 0.0};
  const auto set = [&](double cross) {
    edges.cross = cross;
    edges.run = 0.5 * cross;
  };
  // As fine as the territories ask for, if that divides the box at all; at most as fine as the nodes allow.
  const double wanted = size > 0.0 && size < 0.5 * largest ? 1.25 * size : largest / 1024.0;
  double cross = std::max(wanted, largest / 8192.0);
  for (set(cross); cells_for(box, edges) > cells_per_node * nodes && cross < largest; set(cross))
    cross *= 1.19;
  return edges;
}

}  // namespace

CoveredCells covered_cells(const Grid& grid, const Box& box) {
  CoveredCells covered;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // The lattice may be off by its margin where kernels round in another way.
    const std::int32_t margin = grid.margin[axis];
    const std::int32_t lo = lattice_number(grid, axis, box.lo[axis]) - margin;
    const std::int32_t hi = lattice_number(grid, axis, box.hi[axis]) + margin;
    covered.first[axis] = std::clamp(lo, 0, grid.top[axis]) >> grid.shift[axis];
    covered.last[axis] = std::clamp(hi, 0, grid.top[axis]) >> grid.shift[axis];
  }
  return covered;
}

NodeTable NodeGrid::table() const {
  return {records_.data(), coordinate_.data(), coordinate_.data() + stride_, coordinate_.data() + 2 * stride_,
          node_.data(),    starts_.data()};
}

Offset NodeGrid::bytes() const {
  const auto size = [](const auto& array) { return static_cast<Offset>(array.size() * sizeof(array[0])); };
  return size(grids_) + size(records_) + size(coordinate_) + size(node_) + size(starts_) + size(child_) +
         size(counts_) + size(spare_);
}

NodeRange NodeGrid::build(const NodeGridInput& input) {
  grids_.clear();
  grids_.push_back(make_grid(input.box, input.edges));
  return sort(input);
}

NodeRange NodeGrid::build_again(const NodeGridInput& input) {
  grids_.resize(1);
  return sort(input);
}

NodeRange NodeGrid::sort(const NodeGridInput& input) {
  const std::size_t all = input.positions.count();
  count_ = static_cast<Index>(input.nodes ? input.nodes->size() : all);
  records_.resize(all);
  // x, y and z are read together: they must not share the low bits of their addresses.
  stride_ = (static_cast<std::size_t>(count_) + padding + 4095) / 4096 * 4096 + 1344;
  coordinate_.resize(3 * stride_);
  node_.resize(static_cast<std::size_t>(count_) + padding);
  child_.clear();
  spare_.clear();
  starts_.resize(static_cast<std::size_t>(grids_[0].cell_count) + 1);
  const NodeRange range = sort_root(input);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::memset(coordinate_.data() + axis * stride_ + count_, 0, padding);
  }
  std::fill_n(node_.begin() + count_, padding, 0);
  return range;
}

NodeRange NodeGrid::sort_root(const NodeGridInput& input) {
  const Kernels& kernel = kernels(input.set);
  const Index all = static_cast<Index>(input.positions.count());
  const bool everybody = !input.nodes && !input.limit;
  const int blocks = everybody ? std::min(input.threads, most_sorting_threads) : 1;
  const std::size_t cells = static_cast<std::size_t>(grids_[0].cell_count);
  const SortInput sort{input.positions, grids_[0], records_.data()};
  const SortOutput output{coordinate_.data(), coordinate_.data() + stride_, coordinate_.data() + 2 * stride_,
                          node_.data()};
  // The last block counts where the starts will be: what it leaves behind are the starts of the next cells.
  counts_.resize(static_cast<std::size_t>(blocks - 1) * cells);
  const auto counts_of = [&](int block) {
    return block == blocks - 1 ? starts_.data() + 1
                               : counts_.data() + static_cast<std::size_t>(block) * cells;
  };
  std::array<NodeRange, most_sorting_threads> ranges;
  for_blocks(input.threads, blocks, [&](int block) {
    std::uint32_t* const counts = counts_of(block);
    std::memset(counts, 0, cells * sizeof(std::uint32_t));
    const BlockRange range(all, block, blocks);
    ranges[static_cast<std::size_t>(block)] =
        kernel.classify(sort, range.begin, range.end, everybody ? counts : nullptr);
  });
  for (int block = 1; block < blocks; ++block) {
    ranges[0].box.include(ranges[static_cast<std::size_t>(block)].box);
    ranges[0].finite = ranges[0].finite && ranges[static_cast<std::size_t>(block)].finite;
  }
  if (!everybody) choose_participants(input);
  count_ = static_cast<Index>(add_up(blocks, cells));
  for_blocks(input.threads, blocks, [&](int block) {
    const BlockRange range(all, block, blocks);
    kernel.place(sort, output, range.begin, range.end, counts_of(block));
  });
  return ranges[0];
}

/// Turns the counts of all blocks into first places, cell by cell and block by block. Returns the number of
/// nodes.
std::uint32_t NodeGrid::add_up(int blocks, std::size_t cells) {
  std::uint32_t* const last = starts_.data() + 1;
  starts_[0] = 0;
  std::uint32_t next = 0;
  std::uint32_t most = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const std::uint32_t first = next;
    for (int block = 0; block < blocks - 1; ++block) {
      std::uint32_t& count = counts_[static_cast<std::size_t>(block) * cells + cell];
      const std::uint32_t here = count;
      count = next;
      next += here;
    }
    const std::uint32_t here = last[cell];
    last[cell] = next;
    next += here;
    most = std::max(most, next - first);
  }
  crowded_ = most > most_in_cell;
  return next;
}

/// Counts those that take part and marks the others.
void NodeGrid::choose_participants(const NodeGridInput& input) {
  std::uint32_t* const counts = starts_.data() + 1;
  const Index all = static_cast<Index>(input.positions.count());
  Index node = 0;
  const auto leave_out = [&](Index end) {
    for (; node < end; ++node) records_[static_cast<std::size_t>(node)].place = no_place;
  };
  const std::size_t participants = input.nodes ? input.nodes->size() : input.positions.count();
  for (std::size_t i = 0; i < participants; ++i) {
    const Index participant = input.nodes ? (*input.nodes)[i] : static_cast<Index>(i);
    leave_out(participant);
    if (input.limit && !input.limit->contains(input.positions[participant])) {
      leave_out(participant + 1);
    } else {
      ++counts[records_[static_cast<std::size_t>(participant)].place];
      node = participant + 1;
    }
  }
  leave_out(all);
}

void NodeGrid::divide(const NodeGridInput& input, std::span<const float> sizes) {
  // The list of grids grows while it is worked off.
  for (std::size_t parent = 0; parent < grids_.size(); ++parent) {
    const Offset begin = grids_[parent].first_cell;
    const Offset end = begin + grids_[parent].cell_count;
    for (Offset cell = begin; cell < end; ++cell) {
      const std::size_t at = static_cast<std::size_t>(cell);
      if (starts_[at + 1] - starts_[at] > most_in_cell) divide_cell(input, sizes, parent, cell);
    }
  }
}

void NodeGrid::divide_cell(const NodeGridInput& input, std::span<const float> sizes, std::size_t parent,
                           Offset cell) {
  const std::uint32_t begin = starts_[static_cast<std::size_t>(cell)];
  const std::uint32_t end = starts_[static_cast<std::size_t>(cell) + 1];
  Box box;
  for (std::uint32_t place = begin; place < end; ++place) box.include(input.positions[node_[place]]);
  double size = 0.0;
  double sized = 0.0;
  for (std::uint32_t place = begin; place < end && !sizes.empty(); ++place) {
    const double here = static_cast<double>(sizes[static_cast<std::size_t>(node_[place])]);
    size += here;
    sized += here > 0.0 ? 1.0 : 0.0;
  }
  const double mean_size = sized > 0.0 ? size / sized : 0.0;
  const bool small = mean_size > 0.0 && mean_size < much_smaller * cell_edge(grids_[parent]);
  if (!small && end - begin <= most_in_any_cell) return;
  const CellEdges edges = edges_within(box, end - begin, mean_size, input.edges.run_axis);
  Grid grid = make_grid(box, edges);
  if (grid.cells == std::array<Index, 3>{1, 1, 1}) return;
  const Offset before = static_cast<Offset>(starts_.size());
  if (child_.empty()) child_.resize(starts_.size(), -1);
  grid.first_cell = before;
  child_[static_cast<std::size_t>(cell)] = static_cast<std::int32_t>(grids_.size());
  const std::size_t needed = starts_.size() + static_cast<std::size_t>(grid.cell_count) + 1;
  // Doubling would leave up to half of the memory unused.
  if (starts_.capacity() < needed) starts_.reserve(needed + needed / 8);
  if (child_.capacity() < needed) child_.reserve(needed + needed / 8);
  starts_.resize(needed);
  child_.resize(needed, -1);
  sort_child(input, grid, begin, end);
  grids_.push_back(grid);
}

void NodeGrid::sort_child(const NodeGridInput& input, const Grid& grid, std::uint32_t begin,
                          std::uint32_t end) {
  std::uint32_t* const counts = starts_.data() + grid.first_cell + 1;
  std::memset(counts - 1, 0, (static_cast<std::size_t>(grid.cell_count) + 1) * sizeof(std::uint32_t));
  spare_.assign(node_.begin() + begin, node_.begin() + end);
  const auto classify = [&](Index node) {
    NodeRecord& record = records_[static_cast<std::size_t>(node)];
    const double* xyz = input.positions[node];
    std::uint32_t cell = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      record.fine[axis] = lattice_number(grid, axis, xyz[axis]);
      const std::int32_t clamped = std::clamp(record.fine[axis], 0, grid.top[axis]);
      cell += static_cast<std::uint32_t>(clamped >> grid.shift[axis]) *
              static_cast<std::uint32_t>(grid.step[axis]);
    }
    record.place = cell;
  };
  for (const Index node : spare_) {
    classify(node);
    ++counts[records_[static_cast<std::size_t>(node)].place];
  }
  std::uint32_t next = begin;
  counts[-1] = begin;
  for (Offset cell = 0; cell < grid.cell_count; ++cell) {
    const std::uint32_t here = counts[cell];
    counts[cell] = next;
    next += here;
  }
  for (const Index node : spare_) {
    NodeRecord& record = records_[static_cast<std::size_t>(node)];
    const std::uint32_t place = counts[record.place]++;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t clamped = std::clamp(record.fine[axis], 0, grid.top[axis]);
      coordinate_[axis * stride_ + place] = static_cast<std::uint8_t>((clamped >> fine_bits) & 0xff);
    }
    node_[place] = node;
    record.place = place;
  }
}

}  // namespace cellsearch::production
