// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace crumple::report {

/// The values that an array takes over a run.
struct Range {
  double low = 0;
  double high = 0;
  bool empty = true;

  /// Values that are not finite are passed over.
  void add(double value);
};

/// Reals as integers: code 0 says that there is no value, the codes from 1 on divide the range evenly. A
/// value inside the range comes back with an error of at most bound(); one outside is put on its end.
class Quantiser {
 public:
  /// `bits` is 8 or 16.
  Quantiser(const Range& range, int bits);

  std::uint16_t code(double value) const;
  /// Not for code 0.
  double value(std::uint16_t code) const;
  /// Half the distance of two codes, and the rounding of the arithmetic, in the unit of the values.
  double bound() const;

 private:
  double low_;
  double step_;  ///< between two codes; 0 if all values are the same
  int last_;     ///< largest code
};

}  // namespace crumple::report
