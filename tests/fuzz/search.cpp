// SPDX-License-Identifier: BSD-3-Clause
// Any mesh at all through cellsearch's interface in C: a status, or the candidates of brute force. Numbers in
// the input choose nodes, segments and settings, also ones that must be refused.
#include <cellsearch/cellsearch.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>

namespace {

class Source {
 public:
  Source(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  int byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  int below(int count) { return byte() % count; }
  bool chance() { return below(32) == 1; }
  /// Mostly on a coarse grid, where boxes touch exactly; now and then huge, tiny or none.
  double coordinate() {
    const int kind = below(64);
    if (kind == 1) return std::ldexp(byte() - 128.0, byte() * 8 - 1000);
    if (kind == 2) return byte() % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : HUGE_VAL;
    return 0.25 * (byte() % 32);
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Source source(data, size);
  cellsearch_handle* const handle = cellsearch_create();
  if (handle == nullptr) return 0;
  const int base = source.chance() ? source.below(4) : source.below(2);
  cellsearch_set_index_base(handle, base);
  cellsearch_set_method(handle, cellsearch_method_name(source.below(cellsearch_method_count())));
  cellsearch_set_threads(handle, 1);
  if (source.chance()) cellsearch_set_cell_edge(handle, source.coordinate());
  if (source.chance()) cellsearch_set_cell_factor(handle, source.coordinate());
  if (source.chance()) cellsearch_set_cells_per_node(handle, source.coordinate());
  cellsearch_set_exclude_neighbours(handle, source.below(2));
  cellsearch_set_expansion(handle, source.chance() ? source.coordinate() : 0.125 * source.below(16));
  const int nodes = source.below(40);
  const int segments = source.below(40);
  std::vector<double> xyz(3 * static_cast<std::size_t>(nodes) + 3);
  for (double& value : xyz) value = source.coordinate();
  std::vector<std::int32_t> corners(4 * static_cast<std::size_t>(segments) + 4);
  for (std::int32_t& corner : corners)
    corner =
        source.chance() ? source.byte() - 128 : (nodes > 0 ? source.below(nodes) : 0) + (base == 1 ? 1 : 0);
  std::vector<double> radius(static_cast<std::size_t>(nodes) + 1);
  for (double& value : radius) value = source.chance() ? source.coordinate() : 0.125 * source.below(4);
  std::vector<std::uint8_t> active(static_cast<std::size_t>(segments) + 1);
  for (std::uint8_t& flag : active) flag = source.chance() ? 0 : 1;
  cellsearch_set_positions(handle, nodes, xyz.data(), 3);
  cellsearch_set_segments(handle, segments, corners.data());
  if (source.below(2) == 1) cellsearch_set_node_radius(handle, radius.data());
  if (source.below(2) == 1) cellsearch_set_active(handle, active.data());
  if (source.chance()) {
    const double low[3] = {source.coordinate(), source.coordinate(), source.coordinate()};
    const double high[3] = {source.coordinate(), source.coordinate(), source.coordinate()};
    const std::int32_t cells[3] = {source.below(20), source.below(20), source.below(20)};
    cellsearch_set_domain(handle, low, high, cells);
  }
  const std::int64_t* first = nullptr;
  const std::int32_t* node = nullptr;
  std::int64_t pairs = 0;
  if (cellsearch_find(handle, &first, &node, &pairs) == CELLSEARCH_OK) {
    std::int64_t segment = 0;
    std::int64_t other = 0;
    if (cellsearch_verify(handle, &segment, &other) != CELLSEARCH_OK || segment != base - 1) std::abort();
    if (first[segments] - base != pairs) std::abort();
    for (std::int64_t i = 0; i < pairs; ++i)
      if (node[i] < base || node[i] >= base + nodes) std::abort();
  } else if (cellsearch_error_code(handle) == CELLSEARCH_INTERNAL_ERROR ||
             std::strlen(cellsearch_error_message(handle)) == 0) {
    std::abort();
  }
  cellsearch_destroy(handle);
  return 0;
}
