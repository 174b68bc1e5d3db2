// SPDX-License-Identifier: BSD-3-Clause
// Small meshes, most of them adversarial, for tests against brute force.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "shapes.hpp"

namespace cellsearch::scenes {
namespace {

void add_flat_patch(Mesh& mesh, const Point& corner, int size, double edge) {
  add_patch(mesh, size, size, false, [&](int row, int column) {
    return Point{corner[0] + edge * row, corner[1] + edge * column, corner[2]};
  });
}

}  // namespace

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

Mesh exponential_spacing(Random& random) {
  // From 1e-12 to 1e12: whatever the size of the cells, most nodes share one.
  Mesh mesh{.name = "exponential spacing"};
  double place = 1e-12;
  for (int row = 0; row < 80; ++row) {
    for (int column = 0; column < 3; ++column) {
      mesh.add_node(place, place * random.uniform(0.0, 1.0), place * (0.5 * column));
    }
    place *= 2.0;
  }
  for (Index row = 0; row + 1 < 80; ++row) {
    for (Index column = 0; column < 2; ++column) {
      const Index corner = 3 * row + column;
      mesh.add_segment(corner, corner + 1, corner + 4, corner + 3);
    }
  }
  mesh.expansion = random.below(2) == 0 ? 0.0 : 1e-6;
  return mesh;
}

Mesh two_clusters(std::uint64_t seed) {
  Mesh mesh = random_soup(80, 0, seed);
  mesh.name = "two far clusters";
  Random random(seed);
  for (std::size_t node = 40; node < 80; ++node) {
    mesh.positions[3 * node] += 1e9;
    mesh.positions[3 * node + 2] -= 1e9;
  }
  for (int segment = 0; segment < 60; ++segment) {
    const Index base = segment % 2 == 0 ? 0 : 40;
    Index corners[4];
    for (Index& corner : corners) corner = base + random.below(40);
    // One segment spans the void between.
    if (segment == 7) corners[2] = 79;
    mesh.add_segment(corners[0], corners[1], corners[2], corners[3]);
  }
  mesh.expansion = 0.1;
  return mesh;
}

Mesh on_territory_faces(Random& random) {
  // Candidates on the faces of the one segment's territory, and one step of the last bit beside them.
  Mesh mesh{.name = "nodes on territory faces"};
  const double size = random.uniform(0.5, 2.0);
  const double c = random.uniform(0.0, 0.3);
  mesh.add_node(0.0, 0.0, 0.0);
  mesh.add_node(size, 0.0, 0.1);
  mesh.add_node(size, size, 0.0);
  mesh.add_node(0.0, size, 0.2);
  mesh.add_segment(0, 1, 2, 3);
  const Point lo{0.0 - c, 0.0 - c, 0.0 - c};
  const Point hi{size + c, size + c, 0.2 + c};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      const double face = upper ? hi[axis] : lo[axis];
      for (const double place : {face, std::nextafter(face, -1e9), std::nextafter(face, 1e9)}) {
        Point p{0.3 * size, 0.6 * size, 0.1};
        p[axis] = place;
        mesh.add_node(p[0], p[1], p[2]);
      }
    }
  }
  mesh.expansion = c;
  return mesh;
}

Mesh beyond_float(Random& random) {
  // Neighbours that single precision cannot tell apart, away from the origin.
  Mesh mesh{.name = "closer than float resolves"};
  const Point corner{1000.0 * random.uniform(1.0, 2.0), -777.0, 0.125};
  for (int node = 0; node < 200; ++node) {
    Point p = random_point(random, 1e-3);
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += corner[axis];
    mesh.add_node(p[0], p[1], p[2]);
  }
  for (int segment = 0; segment < 60; ++segment) {
    mesh.add_segment(random.below(200), random.below(200), random.below(200), random.below(200));
  }
  mesh.expansion = random.below(2) == 0 ? 0.0 : 1e-9;
  return mesh;
}

Mesh needles(Random& random) {
  // Long, thin segments askew: their territories are almost empty, and everywhere.
  Mesh mesh{.name = "needles"};
  for (int node = 0; node < 200; ++node) {
    const Point p = random_point(random, 10.0);
    mesh.add_node(p[0], p[1], p[2]);
  }
  for (int segment = 0; segment < 40; ++segment) {
    const Point from = random_point(random, 10.0);
    const Point to = random_point(random, 10.0);
    const Index first = mesh.add_node(from[0], from[1], from[2]);
    mesh.add_node(from[0] + 1e-3, from[1], from[2]);
    mesh.add_node(to[0] + 1e-3, to[1], to[2]);
    mesh.add_node(to[0], to[1], to[2]);
    mesh.add_segment(first, first + 1, first + 2, first + 3);
  }
  mesh.expansion = 0.01;
  return mesh;
}

Mesh crowd_and_outposts(std::uint64_t seed) {
  // All but a few nodes in one cell of automatic cells, too.
  Mesh mesh = random_soup(300, 60, seed);
  mesh.name = "crowd and outposts";
  for (double& coordinate : mesh.positions) coordinate *= 1e-6;
  mesh.expansion = 1e-7;
  for (const double far : {-1.0, 1.0}) {
    const Index first = mesh.add_node(far, far, far);
    mesh.add_node(far + 0.1, far, far);
    mesh.add_node(far, far + 0.1, far);
    mesh.add_node(far, far, far + 0.1);
    mesh.add_segment(first, first + 1, first + 2, first + 2);
    mesh.add_segment(first, first + 1, first + 2, first + 3);
  }
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
  if (random.below(3) == 0 && mesh.segment_expansion.empty()) {
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
    case 20:
      return refined_sheets(600, seed);
    case 21:
      return steeply_refined_sheets(700, seed);
    case 22:
      return vehicle_parts(1000, seed);
    case 23:
      return small_soup(nodes, seed);
    case 24:
      return sparse_parts(1000, seed);
    case 25:
      return exponential_spacing(random);
    case 26:
      return two_clusters(seed);
    case 27:
      return on_territory_faces(random);
    case 28:
      return beyond_float(random);
    case 29:
      return needles(random);
    case 30:
      return crowd_and_outposts(seed);
    case 31:
      return scaled_soup(seed, 1e-310, 0.0, "denormal coordinates");
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
  if (kind == 18 || kind == 19) cover_part(mesh, random);
  return mesh;
}

}  // namespace

int kinds() {
  return 32;
}

Mesh make_mesh(std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = make_kind(static_cast<int>(seed % static_cast<std::uint64_t>(kinds())), seed, random);
  vary(mesh, random);
  return mesh;
}

}  // namespace cellsearch::scenes
