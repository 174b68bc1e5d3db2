// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cellsearch::scenes {

Scene Mesh::scene() const {
  Scene scene;
  scene.positions = Positions(positions, stride);
  scene.segments = Segments(segments);
  scene.expansion = expansion;
  scene.segment_expansion = segment_expansion;
  if (nodes) scene.nodes = *nodes;
  return scene;
}

Index Mesh::add_node(double x, double y, double z) {
  const Index node = static_cast<Index>(node_count());
  positions.insert(positions.end(), {x, y, z});
  positions.resize(positions.size() + stride - 3, -77.0);
  return node;
}

double Mesh::mean_edge() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const std::size_t next = k % 4 == 3 ? k - 3 : k + 1;
    const double* from = &positions[static_cast<std::size_t>(segments[k]) * stride];
    const double* to = &positions[static_cast<std::size_t>(segments[next]) * stride];
    sum += std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  }
  return segments.empty() ? 0.0 : sum / static_cast<double>(segments.size());
}

void Mesh::rotate(double about_z, double about_x) {
  for (std::size_t node = 0; node < node_count(); ++node) {
    double* p = &positions[node * stride];
    const double x = std::cos(about_z) * p[0] - std::sin(about_z) * p[1];
    const double y = std::sin(about_z) * p[0] + std::cos(about_z) * p[1];
    const double z = p[2];
    p[0] = x;
    p[1] = std::cos(about_x) * y - std::sin(about_x) * z;
    p[2] = std::sin(about_x) * y + std::cos(about_x) * z;
  }
}

namespace {

/// Adds rows x columns nodes at shape(row, column) and the quadrilaterals between them. If `closed`, the last
/// column is joined to the first.
template <class Shape>
void add_patch(Mesh& mesh, int rows, int columns, bool closed, const Shape& shape) {
  const Index base = static_cast<Index>(mesh.node_count());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Point p = shape(row, column);
      mesh.add_node(p[0], p[1], p[2]);
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns + (closed ? 1 : 0); ++column) {
      const Index right = (column + 1) % columns;
      mesh.add_segment(base + row * columns + column, base + row * columns + right,
                       base + (row + 1) * columns + right, base + (row + 1) * columns + column);
    }
  }
}

void add_flat_patch(Mesh& mesh, const Point& corner, int size, double edge) {
  add_patch(mesh, size, size, false, [&](int row, int column) {
    return Point{corner[0] + edge * row, corner[1] + edge * column, corner[2]};
  });
}

Point random_point(Random& random, double size) {
  const double x = random.uniform(0.0, size);
  const double y = random.uniform(0.0, size);
  return {x, y, random.uniform(0.0, size)};
}

}  // namespace

Mesh folded_sheets(int nodes, std::uint64_t seed) {
  Mesh mesh{.name = "folded sheets"};
  Random random(seed);
  const int size = std::max(2, static_cast<int>(std::sqrt(nodes / 2.0)));
  const double wave = std::max(8.0, std::min(64.0, size / 2.0));
  // A curve whose direction swings beyond 90 degrees to both sides folds back onto itself.
  std::vector<std::array<double, 4>> curve;  // x, z, and the direction there
  double x = 0.0;
  double z = 0.0;
  for (int row = 0; row < size; ++row) {
    const int steps = 16;
    for (int step = 0; step < steps; ++step) {
      const double along = row + (step + 0.5) / steps;
      const double direction = 2.15 * std::sin(2.0 * std::numbers::pi * along / wave);
      if (step == 0) curve.push_back({x, z, std::cos(direction), std::sin(direction)});
      x += std::cos(direction) / steps;
      z += std::sin(direction) / steps;
    }
  }
  for (int sheet = 0; sheet < 2; ++sheet) {
    add_patch(mesh, size, size, false, [&](int row, int column) {
      const auto& [cx, cz, tx, tz] = curve[static_cast<std::size_t>(row)];
      const double offset = 0.5 * sheet;
      const double jitter_x = random.uniform(-0.12, 0.12);
      const double jitter_y = random.uniform(-0.12, 0.12);
      return Point{cx - offset * tz + 0.8 * std::sin(0.27 * column) + jitter_x, column + jitter_y,
                   cz + offset * tx + 3.0 * std::sin(0.15 * column + 0.05 * row)};
    });
  }
  mesh.expansion = 0.1 * mesh.mean_edge();
  return mesh;
}

Mesh crushed_tube(int nodes, std::uint64_t seed) {
  Mesh mesh{.name = "crushed tube"};
  Random random(seed);
  const int side = std::max(2, static_cast<int>(std::sqrt(nodes / 3.0) / 4.0));
  const int around = 4 * side;
  const int rows = std::max(2, nodes / around);
  const double fold = std::max(2.0, side / 6.0);  // rows from crest to trough
  add_patch(mesh, rows, around, true, [&](int row, int column) {
    const double phase = row / fold;
    const int half = static_cast<int>(phase);
    const double rise = phase - half;
    const double depth = ((half % 2 != 0) ? 1.0 - rise : rise) - 0.5;
    const double reach = 0.5 * side + fold * depth;
    const double place = 2.0 * (column % side) / side - 1.0;
    const double bulge = std::sin(0.5 * std::numbers::pi * (place + 1.0));
    Point p{};
    switch (column / side) {
      case 0:
        p = {reach * place, -reach, 0.0};
        break;
      case 1:
        p = {reach, reach * place, 0.0};
        break;
      case 2:
        p = {-reach * place, reach, 0.0};
        break;
      default:
        p = {-reach, -reach * place, 0.0};
        break;
    }
    p[2] = 0.5 * phase + bulge * std::sin(0.37 * half);
    for (double& coordinate : p) coordinate += random.uniform(-0.12, 0.12);
    return p;
  });
  mesh.rotate(0.35, 0.5);
  mesh.expansion = 0.1 * mesh.mean_edge();
  return mesh;
}

Mesh random_soup(int nodes, int segments, std::uint64_t seed) {
  Mesh mesh{.name = "random soup"};
  Random random(seed);
  const double size = std::cbrt(static_cast<double>(nodes));
  for (int node = 0; node < nodes; ++node) {
    const Point p = random_point(random, size);
    mesh.add_node(p[0], p[1], p[2]);
  }
  const std::size_t count = static_cast<std::size_t>(nodes);
  for (int segment = 0; segment < segments; ++segment) {
    const Index a = random.below(count);
    const Index b = random.below(count);
    const Index c = random.below(count);
    mesh.add_segment(a, b, c, random.below(2) == 0 ? c : random.below(count));
  }
  mesh.expansion = random.uniform(0.0, 0.5);
  return mesh;
}

Mesh mixed_sizes(int nodes, double ratio, std::uint64_t seed) {
  Mesh mesh{.name = "mixed sizes"};
  Random random(seed);
  const int coarse = std::max(2, static_cast<int>(std::sqrt(nodes / 2.0)));
  add_flat_patch(mesh, {0.0, 0.0, 0.0}, coarse, 1.0);
  const int fine = 5;
  while (static_cast<int>(mesh.node_count()) < nodes) {
    Point corner = random_point(random, coarse);
    corner[2] = random.uniform(-0.3, 0.3);
    add_flat_patch(mesh, corner, fine, 1.0 / ratio);
  }
  mesh.expansion = 0.3;
  return mesh;
}

Mesh sparse_patches(int patches, double spread, std::uint64_t seed) {
  Mesh mesh{.name = "sparse patches"};
  Random random(seed);
  for (int patch = 0; patch < patches; ++patch) {
    Point corner = random_point(random, 3.0 * spread);
    add_flat_patch(mesh, corner, 3, 1.0);
    corner[2] += 0.2;
    add_flat_patch(mesh, corner, 3, 1.0);
  }
  mesh.expansion = 0.25;
  return mesh;
}

namespace {

Mesh flattened_soup(std::uint64_t seed, int axes_kept, const char* name) {
  Mesh mesh = random_soup(120, 80, seed);
  mesh.name = name;
  for (std::size_t node = 0; node < mesh.node_count(); ++node) {
    for (std::size_t axis = static_cast<std::size_t>(axes_kept); axis < 3; ++axis) {
      mesh.positions[node * mesh.stride + axis] = 1.5;
    }
  }
  return mesh;
}

/// Cells over part of the mesh, some with corners exactly at nodes.
void cover_part(Mesh& mesh, Random& random) {
  CellDomain domain;
  Box all;
  for (std::size_t node = 0; node < mesh.node_count(); ++node)
    all.include(&mesh.positions[node * mesh.stride]);
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = mesh.positions[static_cast<std::size_t>(random.below(mesh.node_count())) * mesh.stride +
                                     static_cast<std::size_t>(axis)];
    domain.box.lo[axis] = std::min(lo, 0.5 * (all.lo[axis] + all.hi[axis]));
    domain.box.hi[axis] =
        domain.box.lo[axis] + random.uniform(0.3, 0.8) * (all.hi[axis] - all.lo[axis]) + 0.01;
    domain.cells[axis] = 1 + random.below(9);
  }
  mesh.domain = domain;
}

Mesh lattice(Random& random) {
  // Nodes, territory faces and cell faces all coincide here: every comparison is an equality somewhere.
  Mesh mesh{.name = "lattice on cell faces"};
  for (int z = 0; z < 2; ++z) add_flat_patch(mesh, {0.0, 0.0, 0.25 * z}, 7, 0.25);
  mesh.expansion = 0.25 * random.below(3);
  if (random.below(2) == 0) mesh.domain = CellDomain{Box{{0.0, 0.0, 0.0}, {1.5, 1.5, 0.25}}, {6, 6, 1}};
  return mesh;
}

Mesh coincident(Random& random) {
  Mesh mesh{.name = "coincident nodes"};
  for (int node = 0; node < 40; ++node) mesh.add_node(0.1, -3.0, 7.0);
  for (int segment = 0; segment < 20; ++segment) {
    mesh.add_segment(random.below(40), random.below(40), random.below(40), random.below(40));
  }
  mesh.expansion = random.below(2) == 0 ? 0.0 : 0.1;
  return mesh;
}

Mesh territories_outside(std::uint64_t seed, Random& random) {
  // Only far nodes take part, so many territories lie beside the bounding box of the participants.
  Mesh mesh = random_soup(150, 60, seed);
  mesh.name = "territories outside";
  std::vector<Index> far;
  for (std::size_t node = 0; node < mesh.node_count(); ++node) {
    if (mesh.positions[node * mesh.stride] > 4.0) far.push_back(static_cast<Index>(node));
  }
  for (Index& node : mesh.segments) node = random.below(mesh.node_count());
  mesh.nodes = far;
  mesh.expansion = 0.05;
  return mesh;
}

Mesh scaled_soup(std::uint64_t seed, double scale, double shift, const char* name) {
  Mesh mesh = random_soup(100, 60, seed);
  mesh.name = name;
  for (double& coordinate : mesh.positions) coordinate = coordinate * scale + shift;
  mesh.expansion *= scale;
  return mesh;
}

Mesh one_segment(Random& random) {
  Mesh mesh{.name = "one segment"};
  add_flat_patch(mesh, {0.0, 0.0, 0.0}, 2, 1.0);
  for (int node = 0; node < 30; ++node) {
    const Point p = random_point(random, 1.5);
    mesh.add_node(p[0], p[1], p[2] - 0.75);
  }
  mesh.expansion = 0.4;
  return mesh;
}

/// Changes that suit any mesh: padding, expansion by segment, a list of nodes.
void vary(Mesh& mesh, Random& random) {
  if (random.below(3) == 0) {
    Mesh padded = mesh;
    padded.stride = 8;
    padded.positions.clear();
    for (std::size_t node = 0; node < mesh.node_count(); ++node) {
      const double* p = &mesh.positions[node * mesh.stride];
      padded.add_node(p[0], p[1], p[2]);
    }
    mesh = padded;
  }
  if (random.below(3) == 0) {
    const double most = 2.0 * mesh.expansion;
    for (std::size_t k = 0; k < mesh.segment_count(); ++k) {
      mesh.segment_expansion.push_back(random.uniform(0.0, most));
    }
  }
  if (!mesh.nodes && random.below(4) == 0) {
    mesh.nodes.emplace();
    for (std::size_t node = 0; node < mesh.node_count(); ++node) {
      if (random.below(3) != 0) mesh.nodes->push_back(static_cast<Index>(node));
    }
  }
}

Mesh make_kind(int kind, std::uint64_t seed, Random& random) {
  const int nodes = 50 + random.below(500);
  switch (kind) {
    case 0:
      return random_soup(nodes, nodes / 3, seed);
    case 1:
      return folded_sheets(nodes, seed);
    case 2:
      return crushed_tube(nodes, seed);
    case 3:
      return mixed_sizes(nodes, 1000.0, seed);
    case 4:
      return mixed_sizes(nodes, 8.0, seed);
    case 5:
      return sparse_patches(12, 1e7, seed);
    case 6:
      return flattened_soup(seed, 2, "coplanar");
    case 7:
      return flattened_soup(seed, 1, "collinear");
    case 8:
      return coincident(random);
    case 9:
      return one_segment(random);
    case 10:
      return territories_outside(seed, random);
    case 11:
      return lattice(random);
    case 12:
      return scaled_soup(seed, 1e300, -3e300, "huge coordinates");
    case 13:
      return scaled_soup(seed, 1e-300, 0.0, "tiny coordinates");
    case 14:
      return scaled_soup(seed, 1e-3, 1e9, "far from the origin");
    default:
      break;
  }
  Mesh mesh = random_soup(nodes, kind == 15 ? 0 : nodes / 3, seed);
  if (kind == 15) mesh.name = "no segment";
  if (kind == 16) {
    mesh.name = "all in one cell";
    mesh.domain = CellDomain{Box{{-50.0, -50.0, -50.0}, {1e4, 1e4, 1e4}}, {4, 4, 4}};
  }
  if (kind == 17) {
    mesh.name = "one far node";
    mesh.add_node(1e12, -1e12, 1e12);
  }
  if (kind == 18) {
    mesh = folded_sheets(nodes, seed);
    mesh.name = "folded sheets, partial domain";
  }
  if (kind == 19) mesh.name = "soup, partial domain";
  if (kind >= 18) cover_part(mesh, random);
  return mesh;
}

}  // namespace

int kinds() {
  return 20;
}

Mesh make_mesh(std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = make_kind(static_cast<int>(seed % static_cast<std::uint64_t>(kinds())), seed, random);
  vary(mesh, random);
  return mesh;
}

}  // namespace cellsearch::scenes
