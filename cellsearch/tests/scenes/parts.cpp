// SPDX-License-Identifier: BSD-3-Clause
// Scenes made of many parts of fixed size: their number grows with the number of nodes, they do not.
#include <algorithm>
#include <cmath>

#include "shapes.hpp"

namespace cellsearch::scenes {
namespace {

/// The corner points of a square section, `side` elements a side, counted around from a corner: x and y
/// for a square of half width `reach`.
Point on_square(int place, int side, double reach) {
  const double along = reach * (2.0 * (place % side) / side - 1.0);
  switch (place / side) {
    case 0:
      return {along, -reach, 0.0};
    case 1:
      return {reach, along, 0.0};
    case 2:
      return {-along, reach, 0.0};
    default:
      return {-reach, -along, 0.0};
  }
}

/// Two flat plates 0.3 edges apart.
void add_flange(Mesh& mesh, Random& random, const Frame& frame, double edge) {
  for (const double gap : {-0.15, 0.15}) {
    add_patch(mesh, 13, 17, false, [&](int row, int column) {
      return frame(jittered({edge * (row - 6), edge * (column - 8), edge * gap}, 0.1 * edge, random));
    });
  }
}

void add_square_tube(Mesh& mesh, Random& random, const Frame& frame, double edge) {
  add_patch(mesh, 21, 24, true, [&](int row, int column) {
    Point p = on_square(column, 6, 3.0 * edge);
    p[2] = edge * (row - 10);
    return frame(jittered(p, 0.1 * edge, random));
  });
}

void add_round_tube(Mesh& mesh, Random& random, const Frame& frame, double edge) {
  const double radius = edge * 16.0 / 6.283185307179586;
  add_patch(mesh, 25, 16, true, [&](int row, int column) {
    const double turns = column / 16.0;
    return frame(
        jittered({radius * cosine(turns), radius * sine(turns), edge * (row - 12)}, 0.1 * edge, random));
  });
}

/// A box of 8 x 8 x 8 elements, its six faces joined.
void add_box(Mesh& mesh, Random& random, const Frame& frame, double edge) {
  const int side = 8;
  const Index ring = add_patch(mesh, side + 1, 4 * side, true, [&](int row, int column) {
    Point p = on_square(column, side, 0.5 * side * edge);
    p[2] = edge * (row - 0.5 * side);
    return frame(jittered(p, 0.1 * edge, random));
  });
  for (const int end : {0, side}) {
    std::vector<Index> nodes;
    for (int j = 0; j <= side; ++j) {
      for (int i = 0; i <= side; ++i) {
        const bool rim = i == 0 || i == side || j == 0 || j == side;
        // The way around the rim is that of on_square().
        const int around = j == 0 ? i : i == side ? side + j : j == side ? 3 * side - i : (4 * side - j);
        if (rim) {
          nodes.push_back(ring + end * 4 * side + around % (4 * side));
        } else {
          const Point p{edge * (i - 0.5 * side), edge * (j - 0.5 * side), edge * (end - 0.5 * side)};
          const Point q = frame(jittered(p, 0.1 * edge, random));
          nodes.push_back(mesh.add_node(q[0], q[1], q[2]));
        }
      }
    }
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const std::size_t corner = static_cast<std::size_t>(j * (side + 1) + i);
        mesh.add_segment(nodes[corner], nodes[corner + 1], nodes[corner + side + 2],
                         nodes[corner + side + 1]);
      }
    }
  }
}

/// A profile of L section.
void add_profile(Mesh& mesh, Random& random, const Frame& frame, double edge) {
  add_patch(mesh, 31, 9, false, [&](int row, int column) {
    const double y = edge * std::max(0, 4 - column);
    const double z = edge * std::max(0, column - 4);
    return frame(jittered({edge * (row - 15), y, z}, 0.1 * edge, random));
  });
}

/// An outer and an inner panel, bent in both directions.
void add_panel(Mesh& mesh, Random& random, const Frame& frame, double edge) {
  for (const double gap : {-0.15, 0.15}) {
    add_patch(mesh, 15, 15, false, [&](int row, int column) {
      const double x = row - 7.0;
      const double y = column - 7.0;
      const Point p{edge * x, edge * y, edge * (gap + 0.03 * x * x - 0.02 * y * y)};
      return frame(jittered(p, 0.1 * edge, random));
    });
  }
}

struct PartKind {
  void (*add)(Mesh&, Random&, const Frame&, double);
  double edge;
  Point turns;  ///< orientation
};

// One assembly: 2 461 nodes. Its parts stand askew, each in its own way.
constexpr PartKind assembly[] = {
    {add_flange, 1.0, {0.06, 0.09, 0.13}}, {add_square_tube, 1.0, {0.03, 0.21, 0.07}},
    {add_box, 0.5, {0.05, 0.08, 0.19}},    {add_profile, 0.7, {0.11, 0.17, 0.02}},
    {add_panel, 3.0, {0.08, 0.06, 0.04}},  {add_round_tube, 2.0, {0.13, 0.11, 0.05}},
};
constexpr int assembly_nodes = 442 + 504 + 386 + 279 + 450 + 400;

/// Calls place(number) for the origin of each part.
template <class Place>
void add_parts(Mesh& mesh, Random& random, int parts, const Place& place) {
  for (int part = 0; part < parts; ++part) {
    const PartKind& kind = assembly[static_cast<std::size_t>(part) % std::size(assembly)];
    Point turns = kind.turns;
    for (double& turn : turns) turn += random.uniform(-0.01, 0.01);
    const Point origin = place(part);
    kind.add(mesh, random, Frame::turned(origin, turns), kind.edge);
  }
  mesh.expansion = 0.1 * mesh.mean_edge();
}

/// Whole assemblies, so that the proportions are the same for any number of nodes; or a part of one.
int number_of_parts(int nodes) {
  const int parts = static_cast<int>(std::size(assembly));
  if (nodes < assembly_nodes) return std::clamp(nodes * parts / assembly_nodes, 1, parts);
  return parts * ((nodes + assembly_nodes / 2) / assembly_nodes);
}

}  // namespace

Mesh crushed_tube(int nodes, std::uint64_t seed) {
  Mesh mesh{.name = "crushed tube"};
  Random random(seed);
  const int side = 10;
  const int leg = 3;  // rows from crest to trough
  const double pitch = 0.35;
  const double spacing = 15.0;
  const int around = 4 * side;
  // As many tubes as make the bundle about as wide as it is high.
  const double nodes_per_volume = around * leg / pitch / (spacing * spacing);
  const int wide = std::max(1, static_cast<int>(std::lround(cube_root(nodes / nodes_per_volume) / spacing)));
  const int rows =
      std::max(2, static_cast<int>(std::lround(static_cast<double>(nodes) / (around * wide * wide))));
  for (int tube = 0; tube < wide * wide; ++tube) {
    const double x = spacing * (tube % wide);
    const int tube_row = tube / wide;
    const double y = spacing * tube_row;
    add_patch(mesh, rows, around, true, [&](int row, int column) {
      const double phase = (row + 0.3) / leg;
      const double fold = std::floor(phase);
      const double rise = phase - fold;
      const double depth = (std::fmod(fold, 2.0) == 0.0 ? rise : 1.0 - rise) - 0.5;
      Point p = on_square(column, side, 0.5 * side + leg * depth);
      // The folds are not straight: they wave around the tube.
      const double bulge = sine(3.0 * column / around) + 0.5 * sine(7.0 * column / around);
      p = {p[0] + x, p[1] + y, pitch * phase + bulge};
      return jittered(p, 0.12, random);
    });
  }
  mesh.rotate(0.057, 0.081);
  mesh.expansion = 0.1 * mesh.mean_edge();
  return mesh;
}

Mesh vehicle_parts(int nodes, std::uint64_t seed) {
  Mesh mesh{.name = "vehicle parts"};
  Random random(seed);
  const int parts = number_of_parts(nodes);
  // One part in a cube of 60 edges on average, the whole four times as long as high.
  const double size = 60.0 * (cube_root(1e9 * parts) / 1000.0);
  add_parts(mesh, random, parts, [&](int) {
    const Point place = random_point(random, size);
    return Point{2.0 * place[0], place[1], 0.5 * place[2]};
  });
  return mesh;
}

Mesh sparse_parts(int nodes, std::uint64_t seed) {
  Mesh mesh{.name = "sparse parts"};
  Random random(seed);
  const double part_size = 20.0;
  add_parts(mesh, random, number_of_parts(nodes), [&](int) { return random_point(random, 1e6 * part_size); });
  return mesh;
}

Mesh small_soup(int nodes, std::uint64_t seed) {
  Mesh mesh{.name = "small soup"};
  Random random(seed);
  // Cubes of 4 x 4 x 4 segments, each at a random place in a cube of its own: a soup without cubes would have
  // a larger share of its segments at its surface the smaller it is. Thirteen different ones take turns, or
  // chance alone would make small scenes differ from large ones by some percent.
  const std::uint64_t different_cubes = 13;
  const int side = 4;
  const int cube = side * side * side;
  const double pitch = 1.5;
  const int cubes = std::max(1, (nodes + 2 * cube) / (4 * cube));
  const int wide = cube_root(cubes);
  Point corner{};
  const auto on_lattice = [](int number, int width) {
    return std::array<int, 3>{number % width, number / width % width, number / width / width};
  };
  Random inside(seed);
  for (int segment = 0; segment < cubes * cube; ++segment) {
    if (segment % cube == 0) {
      const int number = segment / cube;
      const auto place = on_lattice(number, wide);
      for (std::size_t axis = 0; axis < 3; ++axis)
        corner[axis] = 8.0 * place[axis] + random.uniform(0.0, 1.0);
      inside = Random(seed + 1 + static_cast<std::uint64_t>(number) % different_cubes);
    }
    const auto place = on_lattice(segment % cube, side);
    Point middle = random_point(inside, pitch);
    for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += corner[axis] + pitch * place[axis];
    const double half = inside.uniform(0.5, 1.0);
    const Index first = static_cast<Index>(mesh.node_count());
    for (int node = 0; node < 4; ++node) {
      const Point p = jittered(middle, half, inside);
      mesh.add_node(p[0], p[1], p[2]);
    }
    // Every eighth is a triangle, its fourth node a free one.
    mesh.add_segment(first, first + 1, first + 2, segment % 8 == 0 ? first + 2 : first + 3);
  }
  mesh.expansion = 0.1 * mesh.mean_edge();
  return mesh;
}

}  // namespace cellsearch::scenes
