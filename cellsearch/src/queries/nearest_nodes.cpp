// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/nearest_nodes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "cellsearch/box.hpp"
#include "checks.hpp"
#include "neighbour_lists.hpp"
#include "parallel.hpp"
#include "queries/point_grid.hpp"
#include "queries/spatial_order.hpp"

namespace cellsearch {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A power of two that brings the coordinates below 1, so that squares neither overflow nor vanish.
double scale_of(const Box& nodes) {
  double most = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    most = std::max({most, std::fabs(nodes.lo[axis]), std::fabs(nodes.hi[axis])});
  }
  // The exponent as stored in a double; that of 1 is 1023. The range keeps the scale and its inverse normal.
  const int exponent = static_cast<int>((std::bit_cast<std::uint64_t>(most) >> 52) & 0x7ff);
  const std::uint64_t inverse = static_cast<std::uint64_t>(std::clamp(2045 - exponent, 30, 2016));
  return std::bit_cast<double>(inverse << 52);
}

double square_of_distance(const double* a, const double* b) {
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return (x * x + y * y) + z * z;
}

/// Contains all points of which square_of_distance() to `xyz` is at most `square`.
Box box_around(const double* xyz, double square) {
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  const double reach = std::sqrt(square) * (1.0 + rounding) + 1e-150;  // smaller distances have no square
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const double slack = rounding * (std::fabs(xyz[axis]) + reach);
    box.lo[axis] = (xyz[axis] - reach) - slack;
    box.hi[axis] = (xyz[axis] + reach) + slack;
  }
  return box;
}

}  // namespace

/// The search itself, among scaled points in spatial order ("places"), and its memory.
class NearestSearch::Rows {
 public:
  void build(const Scene& scene, const Box& nodes, const NearestSettings& settings);
  void find(const NearestSettings& settings, NearestNodes& nearest);
  Offset visits() const;
  Offset bytes() const;

 private:
  struct Entry {
    double square;  // scaled
    Index node;

    bool operator<(const Entry& other) const {
      return square != other.square ? square < other.square : node < other.node;
    }
  };

  struct Neighbour {
    double distance;
    Index node;
  };

  /// What one block of places found, and its scratch.
  struct Found {
    Array<Index> near;
    Array<Entry> nearby;
    Array<Neighbour> rows;  // one after another
    Array<Index> lengths;   // of the rows
    Offset visits = 0;
  };

  const double* point(Index place) const { return points_.data() + 3 * static_cast<std::size_t>(place); }
  Index node_at(Index place) const { return nodes_[static_cast<std::size_t>(place)]; }
  bool eligible(Index node, Index other) const {
    return node != other && !(apart_ && neighbours_.connected(scene_.segments, node, other));
  }
  void find_block(BlockRange range, Found& found) const;
  void find_row(Index place, Found& found) const;
  double first_guess(Index place, Found& found) const;
  void copy_rows(BlockRange range, const Found& found, NearestNodes& nearest) const;

  Scene scene_;
  bool apart_ = false;
  std::size_t k_ = 1;
  double scale_ = 1.0;
  double largest_distance_ = infinity;
  double largest_square_ = infinity;  // scaled, rounded up
  double whole_square_ = 0.0;         // from any point, everything is within this
  Array<double> unsorted_;
  Array<double> points_;
  Array<Index> nodes_;
  SpatialOrder order_;
  queries::PointGrid grid_;
  NeighbourLists neighbours_;
  std::vector<Found> found_;
};

void NearestSearch::Rows::build(const Scene& scene, const Box& nodes, const NearestSettings& settings) {
  scene_ = scene;
  apart_ = settings.exclude_connected;
  k_ = static_cast<std::size_t>(settings.neighbours);
  neighbours_.build(scene, apart_);
  scale_ = scale_of(nodes);
  largest_distance_ = settings.largest_distance;
  const double largest = largest_distance_ * scale_ * (1.0 + 1e-12) + 1e-150;
  largest_square_ = largest * largest;
  whole_square_ = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = nodes.empty() ? 0.0 : nodes.hi[axis] * scale_ - nodes.lo[axis] * scale_;
    whole_square_ += 1.01 * extent * extent;
  }
  const Index count = static_cast<Index>(scene.participants());
  unsorted_.resize(3 * static_cast<std::size_t>(count));
  for (Index place = 0; place < count; ++place) {
    const double* xyz = scene.positions[scene.participant(place)];
    double* copy = unsorted_.data() + 3 * static_cast<std::size_t>(place);
    for (int axis = 0; axis < 3; ++axis) copy[axis] = xyz[axis] * scale_;
  }
  const std::span<const Index> order = order_.sort(unsorted_);
  points_.resize(unsorted_.size());
  nodes_.resize(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    nodes_[place] = scene.participant(order[place]);
    std::copy_n(unsorted_.data() + 3 * static_cast<std::size_t>(order[place]), 3, points_.data() + 3 * place);
  }
  grid_.build(points_, settings.threads);
}

/// The square of a distance within which there are k others, or so: the k-th nearest of those that are near
/// in the spatial order.
double NearestSearch::Rows::first_guess(Index place, Found& found) const {
  constexpr std::size_t widest = 256;
  if (k_ > widest && largest_square_ < infinity) return largest_square_;
  const Index count = static_cast<Index>(nodes_.size());
  const Index reach = static_cast<Index>(std::min(k_ + 3, widest));
  found.nearby.clear();
  double farthest = 0.0;
  for (Index other = std::max(0, place - reach); other < std::min(count, place + reach + 1); ++other) {
    const double square = square_of_distance(point(place), point(other));
    farthest = std::max(farthest, square);
    if (eligible(node_at(place), node_at(other))) found.nearby.push_back({square, node_at(other)});
  }
  found.visits += 2 * reach;
  if (found.nearby.size() < k_) return farthest > 0.0 ? 4.0 * farthest : 1e-12 * whole_square_;
  const auto kth = found.nearby.begin() + static_cast<std::ptrdiff_t>(k_ - 1);
  std::nth_element(found.nearby.begin(), kth, found.nearby.end());
  return kth->square;
}

void NearestSearch::Rows::find_row(Index place, Found& found) const {
  const Index node = node_at(place);
  double square = std::min(first_guess(place, found), largest_square_);
  for (;;) {
    found.near.clear();
    found.nearby.clear();
    grid_.collect(box_around(point(place), square), found.near);
    found.visits += static_cast<Offset>(found.near.size());
    for (const Index other : found.near) {
      const double its = square_of_distance(point(place), point(other));
      if (its <= square && eligible(node, node_at(other))) found.nearby.push_back({its, node_at(other)});
    }
    // Nothing nearer is missing, so k are enough; else look farther, if there is anything.
    if (found.nearby.size() >= k_ || square >= largest_square_ || square >= whole_square_) break;
    square = std::min(4.0 * square + 1e-300, largest_square_);
  }
  const std::size_t kept = std::min(k_, found.nearby.size());
  const auto end = found.nearby.begin() + static_cast<std::ptrdiff_t>(kept);
  std::partial_sort(found.nearby.begin(), end, found.nearby.end());
  Index length = 0;
  for (auto entry = found.nearby.begin(); entry != end; ++entry) {
    const double distance = std::sqrt(entry->square) / scale_;
    if (!(distance <= largest_distance_)) break;
    found.rows.push_back({distance, entry->node});
    ++length;
  }
  found.lengths.push_back(length);
}

void NearestSearch::Rows::find_block(BlockRange range, Found& found) const {
  found.rows.clear();
  found.lengths.clear();
  found.visits = 0;
  for (Index place = range.begin; place < range.end; ++place) find_row(place, found);
}

void NearestSearch::Rows::find(const NearestSettings& settings, NearestNodes& nearest) {
  const Index count = static_cast<Index>(nodes_.size());
  const int threads = settings.threads;
  const int blocks = threads == 1 ? 1 : std::max(1, std::min(4 * threads, count / 64));
  found_.resize(std::max(found_.size(), static_cast<std::size_t>(blocks)));
  for (Found& found : found_) found.visits = 0;
  for_blocks(threads, blocks, [&](int block) {
    find_block(BlockRange(count, block, blocks), found_[static_cast<std::size_t>(block)]);
  });
  nearest.first.assign(scene_.positions.count() + 1, 0);
  for (int block = 0; block < blocks; ++block) {
    const BlockRange range(count, block, blocks);
    for (Index place = range.begin; place < range.end; ++place) {
      nearest.first[static_cast<std::size_t>(node_at(place)) + 1] =
          found_[static_cast<std::size_t>(block)].lengths[static_cast<std::size_t>(place - range.begin)];
    }
  }
  for (std::size_t row = 1; row < nearest.first.size(); ++row) nearest.first[row] += nearest.first[row - 1];
  nearest.node.resize(static_cast<std::size_t>(nearest.first.back()));
  nearest.distance.resize(nearest.node.size());
  for_blocks(threads, blocks, [&](int block) {
    copy_rows(BlockRange(count, block, blocks), found_[static_cast<std::size_t>(block)], nearest);
  });
}

void NearestSearch::Rows::copy_rows(BlockRange range, const Found& found, NearestNodes& nearest) const {
  const Neighbour* entry = found.rows.data();
  for (Index place = range.begin; place < range.end; ++place) {
    std::size_t to = static_cast<std::size_t>(nearest.first[static_cast<std::size_t>(node_at(place))]);
    const Index length = found.lengths[static_cast<std::size_t>(place - range.begin)];
    for (Index rank = 0; rank < length; ++rank, ++entry, ++to) {
      nearest.node[to] = entry->node;
      nearest.distance[to] = entry->distance;
    }
  }
}

Offset NearestSearch::Rows::visits() const {
  Offset sum = 0;
  for (const Found& found : found_) sum += found.visits;
  return sum;
}

Offset NearestSearch::Rows::bytes() const {
  Offset sum = static_cast<Offset>((unsorted_.size() + points_.size()) * sizeof(double) +
                                   nodes_.size() * sizeof(Index)) +
               order_.bytes() + grid_.bytes() + neighbours_.bytes();
  for (const Found& found : found_) {
    sum += static_cast<Offset>((found.near.size() + found.lengths.size()) * sizeof(Index) +
                               found.nearby.size() * sizeof(Entry) + found.rows.size() * sizeof(Neighbour));
  }
  return sum;
}

NearestSearch::NearestSearch(const NearestSettings& settings)
    : settings_(settings), rows_(std::make_unique<Rows>()) {
  check_threads(settings.threads);
  const auto fail = [](const char* message) { throw Error(ErrorKind::BadSetting, -1, message); };
  if (settings.neighbours < 1) fail("The number of nearest nodes must be at least 1.");
  if (!(settings.largest_distance >= 0.0)) fail("The largest distance of a nearest node must be >= 0.");
}

NearestSearch::~NearestSearch() = default;
NearestSearch::NearestSearch(NearestSearch&&) noexcept = default;
NearestSearch& NearestSearch::operator=(NearestSearch&&) noexcept = default;

const NearestNodes& NearestSearch::find(const Scene& scene) {
  nearest_.first.clear();
  nearest_.node.clear();
  nearest_.distance.clear();
  Scene points;
  points.positions = scene.positions;
  points.nodes = scene.nodes;
  if (settings_.exclude_connected) {
    points.segments = scene.segments;
    points.segment_active = scene.segment_active;
  }
  const SceneSummary summary = check_scene(points, settings_.threads);
  rows_->build(points, summary.nodes, settings_);
  rows_->find(settings_, nearest_);
  return nearest_;
}

Offset NearestSearch::visits() const {
  return rows_->visits();
}

Offset NearestSearch::bytes() const {
  return rows_->bytes();
}

}  // namespace cellsearch
