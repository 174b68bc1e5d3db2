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
  std::size_t not_finite = 0;       ///< points that were left out, as they are no numbers
};

/// `rwforc.fx[3]`: what a curve is called on the command line and in tables.
std::string name_of(const Curve& curve);

/// A curve without points that name_of() calls so.
Curve curve_named(const std::string& name);

/// Adds a point. Points of the same or a later time are dropped first, as a restarted run writes them anew.
/// Numbers that are not finite are left out, and counted.
void append_point(Curve& curve, double time, double value);

/// Range of a history over several runs of one model (`crumple scatter`). Values have the unit of the curve.
struct Band {
  std::string name;           ///< as name_of the curve
  std::size_t runs = 0;       ///< that have the curve
  std::vector<double> times;  ///< of the first run, as far as all have values [time]
  std::vector<double> first;  ///< the first run's own values
  std::vector<double> median;
  std::vector<double> p5;
  std::vector<double> p95;
};

/// What was read of one side of a comparison.
struct CurveSet {
  std::string source;              ///< as the user named it
  std::vector<std::string> files;  ///< names of the files that were read
  std::vector<std::string> notes;  ///< sentences on what could not be read
  std::vector<Curve> curves;
  std::vector<Band> bands;  ///< of the curves, if these are medians of several runs; else none
};

/// Point in the middle of a curve by straight lines between its points; constant beyond the ends. The curve
/// must have a point.
double value_at(const Curve& curve, double time);

}  // namespace crumple::compare
