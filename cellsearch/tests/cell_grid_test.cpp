// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/cell_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>

#include "cellsearch/error.hpp"
#include "scenes.hpp"

namespace cellsearch::cell_grid_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Box cube(double lo, double hi) {
  return Box{{lo, lo, lo}, {hi, hi, hi}};
}

// The paper's first example: 60 x 8 x 8 cells of 5 mm; cell numbers worked out by hand from eq. (5), (6).
TEST(CellGrid, NumbersCellsByEquations5And6) {
  const CellGrid grid({Box{{0.0, 0.0, 0.0}, {0.30, 0.04, 0.04}}, {60, 8, 8}});
  EXPECT_EQ(grid.count(), 60 * 8 * 8);
  const Point first{0.0026, 0.0026, 0.0026};
  EXPECT_EQ(grid.cell_of(first.data()), 0);
  const Point inner{0.0526, 0.0176, 0.0326};  // Ix = 10, Iy = 3, Iz = 6
  EXPECT_EQ(grid.axis_cell(0, inner[0]), 10);
  EXPECT_EQ(grid.axis_cell(1, inner[1]), 3);
  EXPECT_EQ(grid.axis_cell(2, inner[2]), 6);
  EXPECT_EQ(grid.cell_of(inner.data()), 6 * 60 * 8 + 3 * 60 + 10);
  EXPECT_EQ(grid.cell_number(59, 7, 7), grid.count() - 1);
}

TEST(CellGrid, ClampsTheUpperFaceIntoTheLastCell) {
  const CellGrid grid({cube(-1.0, 1.0), {4, 5, 6}});
  const Point corner{1.0, 1.0, 1.0};
  EXPECT_EQ(grid.axis_cell(0, 1.0), 3);
  EXPECT_EQ(grid.axis_cell(1, 1.0), 4);
  EXPECT_EQ(grid.axis_cell(2, 1.0), 5);
  EXPECT_EQ(grid.cell_of(corner.data()), grid.count() - 1);
}

TEST(CellGrid, ClampsWhatLiesOutside) {
  const CellGrid grid({cube(0.0, 1.0), {10, 1, 1}});
  EXPECT_EQ(grid.axis_cell(0, -0.5), 0);
  EXPECT_EQ(grid.axis_cell(0, -infinity), 0);
  EXPECT_EQ(grid.axis_cell(0, 1.5), 9);
  EXPECT_EQ(grid.axis_cell(0, 1e300), 9);
  EXPECT_EQ(grid.axis_cell(0, infinity), 9);
  EXPECT_EQ(grid.axis_cell(0, nan), 0);
  EXPECT_EQ(grid.axis_cell(1, 1e300), 0);
}

TEST(CellGrid, PutsInnerFacesIntoTheUpperCell) {
  const CellGrid grid({cube(0.0, 2.0), {8, 8, 8}});
  for (int face = 0; face < 8; ++face) {
    EXPECT_EQ(grid.axis_cell(0, 0.25 * face), face);
    EXPECT_EQ(grid.axis_cell(0, std::nextafter(0.25 * face, -1.0)), std::max(0, face - 1));
  }
}

// What exactness rests on: the cell of a point inside a box is within the cells of the box.
TEST(CellGrid, CoversEveryPointOfABox) {
  scenes::Random random(7);
  for (int round = 0; round < 2000; ++round) {
    const double lo = random.uniform(-1.0, 1.0);
    const Index cells = 1 + random.below(50);
    const CellGrid grid({cube(lo, lo + random.uniform(0.01, 3.0)), {cells, cells, cells}});
    Box box;
    const Point from{random.uniform(-2.0, 5.0), random.uniform(-2.0, 5.0), random.uniform(-2.0, 5.0)};
    const Point to{random.uniform(-2.0, 5.0), random.uniform(-2.0, 5.0), random.uniform(-2.0, 5.0)};
    box.include(from.data());
    box.include(to.data());
    const CellRange range = grid.cells_of(box);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double share : {0.0, 0.1, 0.5, 1.0}) {
        const double x = std::min(box.hi[axis], box.lo[axis] + share * (box.hi[axis] - box.lo[axis]));
        EXPECT_LE(range.first[axis], grid.axis_cell(axis, x));
        EXPECT_GE(range.last[axis], grid.axis_cell(axis, x));
      }
    }
  }
}

TEST(CellGrid, AllowsAnAxisOfNoExtentWithOneCell) {
  const CellGrid grid({Box{{0.0, 0.0, 5.0}, {1.0, 1.0, 5.0}}, {4, 4, 1}});
  const Point p{0.3, 0.9, 5.0};
  EXPECT_EQ(grid.cell_of(p.data()), 3 * 4 + 1);
}

struct BadDomain {
  const char* name;
  CellDomain domain;
  Index axis;
};

std::ostream& operator<<(std::ostream& stream, const BadDomain& bad) {
  return stream << bad.name;
}

class CellGridErrors : public testing::TestWithParam<BadDomain> {};

TEST_P(CellGridErrors, AreNamedWithTheAxis) {
  try {
    const CellGrid grid(GetParam().domain);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadDomain);
    EXPECT_EQ(error.index(), GetParam().axis);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Domains, CellGridErrors,
    testing::Values(BadDomain{"empty", {Box{}, {1, 1, 1}}, 0},
                    BadDomain{"inverted", {Box{{0, 2, 0}, {1, 1, 1}}, {2, 2, 2}}, 1},
                    BadDomain{"flat", {Box{{0, 0, 0}, {1, 1, 0}}, {2, 2, 2}}, 2},
                    BadDomain{"nan", {Box{{0, 0, nan}, {1, 1, 1}}, {2, 2, 2}}, 2},
                    BadDomain{"infinite", {Box{{0, 0, 0}, {1, infinity, 1}}, {2, 2, 2}}, 1},
                    BadDomain{"no cell", {Box{{0, 0, 0}, {1, 1, 1}}, {0, 2, 2}}, 0},
                    BadDomain{"negative cells", {Box{{0, 0, 0}, {1, 1, 1}}, {2, 2, -3}}, 2},
                    BadDomain{"too long", {Box{{-1.7e308, 0, 0}, {1.7e308, 1, 1}}, {2, 1, 1}}, 0},
                    BadDomain{"too thin", {Box{{0, 0, 0}, {5e-324, 1, 1}}, {2, 1, 1}}, 0},
                    BadDomain{"too many cells", {Box{{0, 0, 0}, {1, 1, 1}}, {2000, 2000, 2000}}, -1}));

TEST(AutomaticDomain, HasTheEdgeThatWasAskedFor) {
  const CellDomain domain = automatic_domain(Box{{0.0, 0.0, 0.0}, {6.0, 4.1, 1.0}}, 0.5, 1000000);
  EXPECT_EQ(domain.cells, (std::array<Index, 3>{12, 8, 2}));
  EXPECT_EQ(domain.box.hi, (Point{6.0, 4.1, 1.0}));
}

TEST(AutomaticDomain, CoarsensSparseScenes) {
  for (const Offset most : {1, 2, 10, 1000, 4000000}) {
    const CellDomain domain = automatic_domain(cube(0.0, 1e9), 0.001, most);
    const Offset cells = Offset{domain.cells[0]} * domain.cells[1] * domain.cells[2];
    EXPECT_LE(cells, most);
    // and not much more than needed: a cube of n^3 cells with the largest n, less one for rounding
    const double along = std::floor(std::cbrt(static_cast<double>(most)) / 1.05);
    EXPECT_GE(static_cast<double>(cells), std::pow(std::max(1.0, along), 3.0));
    EXPECT_NO_THROW(CellGrid{domain});
  }
}

TEST(AutomaticDomain, TakesAnyBoxAndEdge) {
  const Box boxes[] = {Box{},
                       cube(3.0, 3.0),
                       cube(-1e308, 1e308),
                       cube(0.0, 5e-324),
                       cube(-1e300, 1e300),
                       Box{{0, 0, 0}, {1e300, 1e-300, 0.0}},
                       Box{{0, 0, 0}, {1.7e308, 1.0, 1.0}}};
  for (const Box& box : boxes) {
    for (const double edge : {0.0, -1.0, nan, infinity, 1e-320, 1e-10, 1.0, 1e308}) {
      const CellDomain domain = automatic_domain(box, edge, 100);
      EXPECT_NO_THROW(CellGrid{domain});
      EXPECT_LE(Offset{domain.cells[0]} * domain.cells[1] * domain.cells[2], 100);
    }
  }
}

}  // namespace
}  // namespace cellsearch::cell_grid_test
