// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace crumple::compare {

/// One history of one quantity. Units are those of the file it comes from.
struct Curve {
  std::string group;     ///< kind of file: "glstat", "rwforc", ...; "th" for OpenRadioss
  std::string quantity;  ///< by our own names: "kinetic", "fx", ...
  std::string item;      ///< number of the node, wall, part, ..., with the side of an interface; else empty
  bool derived = false;  ///< computed of others of the same file
  std::vector<double> times = {};   ///< strictly ascending [time]
  std::vector<double> values = {};  ///< as many as times
};

/// `rwforc.fx[3]`: what a curve is called on the command line and in tables.
std::string name_of(const Curve& curve);

/// Adds a point. Points of the same or a later time are dropped first, as a restarted run writes them anew.
/// Numbers that are not finite are left out.
void append_point(Curve& curve, double time, double value);

/// What was read of one side of a comparison.
struct CurveSet {
  std::string source;              ///< as the user named it
  std::vector<std::string> files;  ///< names of the files that were read
  std::vector<std::string> notes;  ///< sentences on what could not be read
  std::vector<Curve> curves;
};

/// Point in the middle of a curve by straight lines between its points; constant beyond the ends. The curve
/// must have a point.
double value_at(const Curve& curve, double time);

}  // namespace crumple::compare
