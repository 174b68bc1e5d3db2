// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "production/kernel_tables.hpp"
#include "two_lanes.hpp"

// The loops in standard C++, one segment after another, for processors without loops of their own and as the
// reference of those that have them.
namespace cellsearch::production {
namespace {

NodeRange measure(const Positions& positions, Index begin, Index end) {
  NodeRange range;
  for (Index node = begin; node < end; ++node) {
    const double* xyz = positions[node];
    range.box.include(xyz);
    range.finite = range.finite && std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]);
  }
  return range;
}

std::uint32_t largest(std::span<const Index> numbers) {
  std::uint32_t most = 0;
  for (const Index number : numbers) most = std::max(most, static_cast<std::uint32_t>(number));
  return most;
}

std::int32_t to_lattice(double place) {
  // A coordinate that is not a number falls on the limit; such a node takes no part.
  if (!(place < lattice_limit)) return lattice_limit;
  return place > -lattice_limit ? static_cast<std::int32_t>(place) : -lattice_limit;
}

std::int32_t clamp(const Grid& grid, std::size_t axis, std::int32_t fine) {
  return std::clamp(fine, 0, grid.top[axis]);
}

NodeRange classify(const SortInput& input, Index begin, Index end, std::uint32_t* counts) {
  const Grid& grid = input.grid;
  for (Index node = begin; node < end; ++node) {
    const double* xyz = input.positions[node];
    NodeRecord& record = input.records[node];
    std::int32_t cell = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      record.fine[axis] = to_lattice(xyz[axis] * grid.scale[axis] + grid.offset[axis]);
      cell += (clamp(grid, axis, record.fine[axis]) >> grid.shift[axis]) * grid.step[axis];
    }
    record.place = static_cast<std::uint32_t>(cell);
    if (counts != nullptr) ++counts[cell];
  }
  return measure(input.positions, begin, end);
}

void place(const SortInput& input, const SortOutput& output, Index begin, Index end, std::uint32_t* next) {
  for (Index node = begin; node < end; ++node) {
    NodeRecord& record = input.records[node];
    if (record.place == no_place) continue;
    const std::uint32_t at = next[record.place]++;
    const auto byte = [&](std::size_t axis) {
      return static_cast<std::uint8_t>((clamp(input.grid, axis, record.fine[axis]) >> fine_bits) & 0xff);
    };
    output.x[at] = byte(0);
    output.y[at] = byte(1);
    output.z[at] = byte(2);
    output.nodes[at] = node;
    record.place = at;
  }
}

/// One segment after another.
class Query {
 public:
  Query(const QueryInput& input, FoundRows& rows) : input_(input), grid_(input.grids[0]), rows_(rows) {}

  void find(Index segment) {
    const std::size_t start = rows_.nodes->size();
    if (input_.active == nullptr || input_.active[segment] != 0) {
      set_territory(segment);
      if (!visit_rows(segment)) {
        rows_.nodes->resize(start);
        input_.help->collect(segment, rows_);
        rows_.nodes->insert(rows_.nodes->end(), rows_.spare->begin(), rows_.spare->end());
      }
      std::sort(rows_.nodes->begin() + static_cast<std::ptrdiff_t>(start), rows_.nodes->end());
    }
  }

 private:
  /// From the positions: nodes in cells that are divided further have records in the lattice of these.
  void set_territory(Index segment) {
    const Index* own = input_.connectivity + 4 * static_cast<std::size_t>(segment);
    double expansion = input_.expansion;
    if (input_.segment_expansion != nullptr) expansion += input_.segment_expansion[segment];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto fine = [&](int corner) {
        return to_lattice(input_.positions[own[corner]][axis] * grid_.scale[axis] + grid_.offset[axis]);
      };
      const std::int32_t out = to_lattice(expansion * grid_.scale[axis]) + grid_.margin[axis];
      lo_[axis] = std::min({fine(0), fine(1), fine(2), fine(3)}) - out;
      hi_[axis] = std::max({fine(0), fine(1), fine(2), fine(3)}) + out;
      first_[axis] = clamp(grid_, axis, lo_[axis]) >> grid_.shift[axis];
      last_[axis] = clamp(grid_, axis, hi_[axis]) >> grid_.shift[axis];
    }
  }

  /// False if the territory covers too many cells, or one with a grid of its own.
  bool visit_rows(Index segment) {
    const auto [run, second, third] = grid_.axis;
    const auto at = [](int axis) { return static_cast<std::size_t>(axis); };
    for (Index k = first_[at(third)]; k <= last_[at(third)]; ++k) {
      for (Index j = first_[at(second)]; j <= last_[at(second)]; ++j) {
        const Offset row = Offset{k} * grid_.step[at(third)] + Offset{j} * grid_.step[at(second)];
        const std::uint32_t begin = input_.table.starts[row + first_[at(run)]];
        const std::uint32_t end = input_.table.starts[row + last_[at(run)] + 1];
        if (has_child(row)) return false;
        rows_.cell_visits += last_[at(run)] - first_[at(run)] + 1;
        rows_.raw_visits += end - begin;
        for (std::uint32_t place = begin; place < end; ++place) test(segment, input_.table.nodes[place]);
      }
    }
    return true;
  }

  bool has_child(Offset row) const {
    if (input_.child == nullptr) return false;
    const std::size_t run = static_cast<std::size_t>(grid_.axis[0]);
    const auto divided = [](std::int32_t child) { return child >= 0; };
    return std::any_of(input_.child + row + first_[run], input_.child + row + last_[run] + 1, divided);
  }

  void test(Index segment, Index node) {
    bool near_face = !input_.plain;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t fine = input_.table.records[node].fine[axis];
      const std::int32_t nearest = std::min(fine - lo_[axis], hi_[axis] - fine);
      if (nearest < 0) return;
      near_face = near_face || nearest <= 2 * grid_.margin[axis] + 2;
    }
    const Index* own = input_.connectivity + 4 * static_cast<std::size_t>(segment);
    if (node == own[0] || node == own[1] || node == own[2] || node == own[3]) return;
    if (!near_face || input_.help->accepts(segment, node)) rows_.nodes->push_back(node);
  }

  const QueryInput& input_;
  const Grid& grid_;
  FoundRows& rows_;
  std::array<std::int32_t, 3> lo_{};
  std::array<std::int32_t, 3> hi_{};
  std::array<Index, 3> first_{};
  std::array<Index, 3> last_{};
};

void query(const QueryInput& input, Index begin, Index end, FoundRows& rows) {
  Query query(input, rows);
  rows.nodes->clear();
  for (Index segment = begin; segment < end; ++segment) {
    query.find(segment);
    rows.ends[segment - begin] = static_cast<Offset>(rows.nodes->size());
  }
}

void include_value(ValueRange& range, std::size_t axis, double value) {
  range.lo[axis] = std::min(range.lo[axis], value);
  range.hi[axis] = std::max(range.hi[axis], value);
  // Comparisons pass over NaN, so it is noticed apart.
  range.bad |= !(std::fabs(value) <= std::numeric_limits<double>::max());
}

/// Two nodes at a time fill three pairs of lanes.
void include(const double* now, const double* then, std::size_t nodes, ValueRange& range) {
  std::array<TwoLanes, 3> low;
  std::array<TwoLanes, 3> high;
  std::array<TwoLanes, 3> wrong;  // stays 0 until something is not finite
  low.fill(TwoLanes::both(std::numeric_limits<double>::infinity()));
  high.fill(TwoLanes::both(-std::numeric_limits<double>::infinity()));
  wrong.fill(TwoLanes::both(0.0));
  const TwoLanes zero = TwoLanes::both(0.0);
  std::size_t node = 0;
  for (; node + 2 <= nodes; node += 2)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = 3 * node + 2 * k;
      const TwoLanes value =
          then == nullptr ? TwoLanes::load(now + at) : TwoLanes::load(now + at) - TwoLanes::load(then + at);
      low[k] = min(value, low[k]);
      high[k] = max(value, high[k]);
      wrong[k] = wrong[k] + value * zero;
    }
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<std::array<double, 2>, 3> lanes;
    low[k].store(lanes[0].data());
    high[k].store(lanes[1].data());
    wrong[k].store(lanes[2].data());
    for (std::size_t lane = 0; lane < 2; ++lane) {
      const std::size_t axis = (2 * k + lane) % 3;
      range.lo[axis] = std::min(range.lo[axis], lanes[0][lane]);
      range.hi[axis] = std::max(range.hi[axis], lanes[1][lane]);
      range.bad |= lanes[2][lane] != 0.0;
    }
  }
  for (std::size_t axis = 0; node < nodes && axis < 3; ++axis) {
    const std::size_t at = 3 * node + axis;
    include_value(range, axis, now[at] - (then == nullptr ? 0.0 : then[at]));
  }
}

}  // namespace

const Kernels& portable_kernels() {
  static constexpr Kernels table{measure, largest, classify, place, query, include};
  return table;
}

}  // namespace cellsearch::production
