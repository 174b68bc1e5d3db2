// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/motion_tracker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "cellsearch/error.hpp"
#include "cellsearch/instruction_set.hpp"
#include "cellsearch/search_interval.hpp"
#include "parallel.hpp"
#include "production/kernels.hpp"

namespace cellsearch {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Point unknown{infinity, infinity, infinity};
constexpr std::size_t most = static_cast<std::size_t>(std::numeric_limits<Index>::max());

// The blocks do not depend on the number of threads, and neither does the order in which they are joined.
constexpr int most_blocks = 64;
constexpr Index block_nodes = 4096;

int blocks_for(std::size_t count) {
  return static_cast<int>(
      std::clamp<std::size_t>(count / static_cast<std::size_t>(block_nodes), 1, most_blocks));
}

bool is_finite(const double* xyz) {
  return std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]);
}

/// Nodes that may be read as one array, which must not be too long for the nearest memory; coordinates follow
/// each other without gaps only where nothing else is in the records.
std::size_t longest_piece(const Positions& values) {
  return values.stride() == 3 ? 256 : 1;
}

double largest_component(const Point& a) {
  return std::max({a[0], a[1], a[2]});
}

}  // namespace

/// Smallest and largest of what was included, by axis.
struct MotionTracker::Range : production::ValueRange {
  void include(const Range& other) {
    for (int axis = 0; axis < 3; ++axis) {
      lo[axis] = std::min(lo[axis], other.lo[axis]);
      hi[axis] = std::max(hi[axis], other.hi[axis]);
    }
    bad |= other.bad;
  }

  double largest() const { return std::max({0.0, -lo[0], -lo[1], -lo[2], hi[0], hi[1], hi[2]}); }
};

MotionTracker::MotionTracker(double expansion, double contact_distance, int threads)
    : room_(expansion - contact_distance),
      lengths_(expansion + contact_distance),
      threads_(threads),
      set_(instruction_sets().back()),
      motion_(unknown) {
  const auto is_length = [](double length) { return length >= 0.0 && std::isfinite(length); };
  if (!is_length(expansion) || !is_length(contact_distance)) {
    throw Error(ErrorKind::BadSetting, -1, "Expansion and contact distance must be finite and >= 0.");
  }
  if (threads < 1) throw Error(ErrorKind::BadSetting, -1, "The number of threads must be at least 1.");
}

/// Whatever a failing start() leaves behind must look as before the first one.
void MotionTracker::forget() {
  started_ = false;
  motion_ = unknown;
  count_ = second_ = 0;
  highest_ = -1;
}

void MotionTracker::start(const Positions& positions) {
  forget();
  if (positions.count() > most) {
    throw Error(ErrorKind::BadLayout, -1, "There are more than 2147483647 nodes.");
  }
  nodes_.clear();
  count_ = second_ = positions.count();
  two_lists_ = false;
  highest_ = static_cast<Index>(count_) - 1;
  find_runs();
  remember(positions);
}

void MotionTracker::start(const Positions& positions, std::span<const Index> nodes) {
  watch(positions, nodes, {});
  two_lists_ = false;
  remember(positions);
}

void MotionTracker::start(const Positions& positions, std::span<const Index> nodes,
                          std::span<const Index> segment_nodes) {
  watch(positions, nodes, segment_nodes);
  two_lists_ = true;
  remember(positions);
}

void MotionTracker::start(const Scene& scene) {
  if (!scene.nodes) {
    start(scene.positions);
    return;
  }
  forget();
  const std::size_t nodes = scene.positions.count();
  of_segment_.assign(nodes, 0);
  for (std::size_t s = 0; s < scene.segments.count(); ++s) {
    const Index segment = static_cast<Index>(s);
    if (!scene.active(segment)) continue;
    for (const Index node : std::span(scene.segments[segment], 4)) {
      if (node < 0 || static_cast<std::size_t>(node) >= nodes) {
        throw Error(ErrorKind::BadConnectivity, segment,
                    "Segment " + std::to_string(segment) + " names node " + std::to_string(node) +
                        ", which does not exist.");
      }
      of_segment_[static_cast<std::size_t>(node)] = 1;
    }
  }
  segment_nodes_.clear();
  for (std::size_t node = 0; node < nodes; ++node) {
    if (of_segment_[node] != 0) segment_nodes_.push_back(static_cast<Index>(node));
  }
  start(scene.positions, *scene.nodes, segment_nodes_);
}

/// Copies the lists and checks them.
void MotionTracker::watch(const Positions& positions, std::span<const Index> nodes,
                          std::span<const Index> segment_nodes) {
  forget();
  if (nodes.size() + segment_nodes.size() > most || positions.count() > most) {
    throw Error(ErrorKind::BadLayout, -1, "There are more than 2147483647 nodes.");
  }
  nodes_.resize(nodes.size() + segment_nodes.size());
  std::copy(segment_nodes.begin(), segment_nodes.end(),
            std::copy(nodes.begin(), nodes.end(), nodes_.begin()));
  Index highest = -1;
  const Index existing = static_cast<Index>(positions.count());
  for (std::size_t place = 0; place < nodes_.size(); ++place) {
    const Index node = nodes_[place];
    if (node < 0 || node >= existing) {
      throw Error(ErrorKind::BadNodeList, static_cast<Index>(place),
                  "Entry " + std::to_string(place) + " of the watched nodes is " + std::to_string(node) +
                      ", but there are " + std::to_string(existing) + " nodes, numbered from 0.");
    }
    highest = std::max(highest, node);
  }
  highest_ = highest;
  second_ = nodes.size();
  count_ = nodes_.size();
  find_runs();
}

void MotionTracker::start_again(const Positions& positions) {
  if (!started_) return;
  check_layout(positions);
  started_ = false;
  motion_ = unknown;
  remember(positions);
}

/// Lists of nodes mostly follow the numbering over long stretches, which are read as one piece of memory.
void MotionTracker::find_runs() {
  runs_.clear();
  for (std::size_t place = 0; place < count_; ++place)
    if (place == 0 || watched(place) != watched(place - 1) + 1) runs_.push_back(static_cast<Index>(place));
}

/// Calls visit(begin, end) for the places from `begin` to `end`, in pieces of one run each of at most
/// `longest` places.
template <class Visit>
void MotionTracker::visit_runs(std::size_t begin, std::size_t end, std::size_t longest,
                               const Visit& visit) const {
  auto next = std::upper_bound(runs_.begin(), runs_.end(), static_cast<Index>(begin));
  for (std::size_t place = begin; place < end;) {
    const std::size_t run_end = next == runs_.end() ? end : std::min(end, static_cast<std::size_t>(*next));
    const std::size_t piece_end = std::min(run_end, place + longest);
    visit(place, piece_end);
    place = piece_end;
    if (next != runs_.end() && static_cast<std::size_t>(*next) <= place) ++next;
  }
}

/// Copies the positions; from now on nothing has moved.
void MotionTracker::remember(const Positions& positions) {
  reference_.resize(3 * count_);
  const production::Kernels& kernels = production::kernels(set_);
  std::array<Range, most_blocks> parts;
  const int blocks = blocks_for(count_);
  for_blocks(threads_, blocks, [&](int block) {
    const BlockRange places(static_cast<Index>(count_), block, blocks);
    Range& part = parts[static_cast<std::size_t>(block)];
    visit_runs(static_cast<std::size_t>(places.begin), static_cast<std::size_t>(places.end),
               longest_piece(positions), [&](std::size_t from, std::size_t to) {
                 const double* now = positions[watched(from)];
                 kernels.include(now, nullptr, to - from, part);
                 std::copy_n(now, 3 * (to - from),
                             reference_.begin() + 3 * static_cast<std::ptrdiff_t>(from));
               });
  });
  Range all;
  for (int block = 0; block < blocks; ++block) all.include(parts[static_cast<std::size_t>(block)]);
  if (all.bad) throw_if_bad_node(positions);
  largest_reference_ = all.largest();
  started_ = true;
  motion_ = {0.0, 0.0, 0.0};
  rounding_ = 0x1p-49 * (2.0 * largest_reference_ + lengths_);
}

void MotionTracker::check_layout(const Positions& values) const {
  if (static_cast<std::size_t>(highest_ + 1) > values.count()) {
    throw Error(ErrorKind::BadLayout, -1,
                "There are " + std::to_string(values.count()) + " nodes now, but node " +
                    std::to_string(highest_) + " is watched.");
  }
}

/// Range of the displacements since the start, or of the values themselves, over places begin..end-1.
MotionTracker::Range MotionTracker::range(const Positions& values, bool since_start, std::size_t begin,
                                          std::size_t end) const {
  const production::Kernels& kernels = production::kernels(set_);
  std::array<Range, most_blocks> parts;
  const int blocks = blocks_for(end - begin);
  for_blocks(threads_, blocks, [&](int block) {
    const BlockRange places(static_cast<Index>(end - begin), block, blocks);
    Range part;
    visit_runs(begin + static_cast<std::size_t>(places.begin), begin + static_cast<std::size_t>(places.end),
               longest_piece(values), [&](std::size_t from, std::size_t to) {
                 kernels.include(values[watched(from)], since_start ? reference_.data() + 3 * from : nullptr,
                                 to - from, part);
               });
    parts[static_cast<std::size_t>(block)] = part;
  });
  Range whole;
  for (int block = 0; block < blocks; ++block) whole.include(parts[static_cast<std::size_t>(block)]);
  return whole;
}

/// Largest difference between a node of the first list and one of the second, or between two of the only
/// one. `largest`: the largest absolute value; `bad`: something was not finite, and the result means nothing.
Point MotionTracker::largest_difference(const Positions& values, bool since_start, double& largest,
                                        bool& bad) const {
  const Range nodes = range(values, since_start, 0, second_);
  const Range others = two_lists_ ? range(values, since_start, second_, count_) : nodes;
  largest = std::max(nodes.largest(), others.largest());
  bad = nodes.bad || others.bad;
  Point difference{0.0, 0.0, 0.0};
  if (second_ == 0 || (two_lists_ && second_ == count_)) return difference;  // nobody to meet
  for (int axis = 0; axis < 3; ++axis) {
    difference[axis] = std::max(nodes.hi[axis] - others.lo[axis], others.hi[axis] - nodes.lo[axis]);
  }
  return difference;
}

void MotionTracker::update(const Positions& positions) {
  motion_ = unknown;
  if (!started_) return;
  check_layout(positions);
  double largest = 0.0;
  bool bad = false;
  const Point motion = largest_difference(positions, true, largest, bad);
  if (bad) {
    throw_if_bad_node(positions);
    return;  // displacements beyond the range of numbers
  }
  motion_ = motion;
  // With u = 2^-53, M the largest coordinate then or now: at most 8 u M in the differences of displacements,
  // u (M + 2 c) in the territory, u c in c - h, u (3 M + h) in a test whether the node is within h now.
  rounding_ = 0x1p-49 * (2.0 * largest_reference_ + largest + lengths_);
}

double MotionTracker::used() const {
  return largest_component(motion_);
}

bool MotionTracker::due() const {
  // Written so that NaN or infinity ends in a search.
  return !(used() + rounding_ <= room_);
}

Point MotionTracker::relative_speed(const Positions& velocities) const {
  if (!started_) return unknown;
  check_layout(velocities);
  double largest = 0.0;
  bool bad = false;
  const Point speed = largest_difference(velocities, false, largest, bad);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return bad ? Point{nan, nan, nan} : speed;
}

int MotionTracker::predicted_steps(const Positions& velocities, double largest_step, int cap) const {
  if (due()) return 1;
  return search_interval(room_, used(), largest_component(relative_speed(velocities)), largest_step, cap);
}

void MotionTracker::throw_if_bad_node(const Positions& positions) const {
  Index worst = -1;
  for (std::size_t place = 0; place < count_; ++place) {
    const Index node = watched(place);
    if (!is_finite(positions[node]) && (worst < 0 || node < worst)) worst = node;
  }
  if (worst >= 0) {
    throw Error(ErrorKind::NonFiniteCoordinate, worst,
                "Watched node " + std::to_string(worst) + " has a coordinate that is not finite.");
  }
}

}  // namespace cellsearch
