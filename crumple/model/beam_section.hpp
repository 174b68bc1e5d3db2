// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Integration points of the cross sections of beams (docs/theory/integrated_beams.md). Coordinates are along
// s and t from the line of the nodes. Every rule has the exact area and, but for a single point, the exact
// second moments of area of its shape. Order of calls: points of a shape, move_nodes(), set_points().

#include <vector>

#include "model/section.hpp"

namespace crumple::model {

/// Rules of a rectangle: their points by area.
enum class SectionRule {
  OnePoint = 1,
  Gauss2 = 2,    ///< 2 x 2
  Gauss3 = 3,    ///< 3 x 3
  Lobatto3 = 4,  ///< 3 x 3, with points in the corners
  Gauss4 = 5,    ///< 4 x 4
};

/// A rectangle, `s` wide along s and `t` along t.
std::vector<SectionPoint> rectangle_points(double s, double t, SectionRule rule);

/// A circle or a tube: rings of equal points at equal angles, one ring of four, two of eight (Lobatto: on the
/// surfaces) or two of sixteen. The rings are the points of the rule in the square of the radius, for which
/// area and moments are exact (A.H. Stroud, Approximate Calculation of Multiple Integrals, 1971, product
/// rules of the circle).
std::vector<SectionPoint> tube_points(double outer_diameter, double inner_diameter, SectionRule rule);

/// A rectangular part of a cross section that is made of plates, with its middle.
struct SectionPlate {
  double s = 0;
  double t = 0;
  double width_s = 0;
  double width_t = 0;
};

/// Two Gauss points across each plate and 2 (2 + refinement) along it.
std::vector<SectionPoint> plate_points(const std::vector<SectionPlate>& plates, int refinement);

/// Standard shapes made of plates, by the numbers of *INTEGRATION_BEAM: `width` is along s, `depth` along t,
/// flanges are along s. The origin is the centre of the area.
std::vector<SectionPlate> i_plates(double width, double flange, double depth, double web);
std::vector<SectionPlate> channel_plates(double width, double flange, double depth, double web);
std::vector<SectionPlate> angle_plates(double width, double flange, double depth, double web);
std::vector<SectionPlate> tee_plates(double width, double flange, double depth, double web);
std::vector<SectionPlate> box_plates(double width, double flange, double depth, double web);

/// The nodes lie at (s, t) of the shape's coordinates.
void move_nodes(std::vector<SectionPoint>& points, double s, double t);

/// Gives the section its points, and area, moments and polar moment of area about the line of the nodes.
void set_points(BeamSection& section, std::vector<SectionPoint> points);

/// A section that bends in the same way about all axes needs no orientation.
bool is_round(const BeamSection& section);

}  // namespace crumple::model
