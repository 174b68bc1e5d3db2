// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crumple::report {

/// Writes the codes of one quantity frame by frame, each as its difference from a prediction: differences are
/// small numbers, which compress well. Differences wrap around, so nothing is lost. A frame is one byte that
/// names the prediction and then the differences, folded to be positive (0, -1, 1, -2, ...), their low bytes
/// first and then, with 16 bits, their high bytes.
class FramePacker {
 public:
  /// Sum of both: what a code is predicted from. Ahead of the others in the text of each frame.
  enum Prediction : std::uint8_t {
    FromNothing = 0,
    FromBefore = 1,     ///< the same place in the frame before
    FromMotion = 2,     ///< the straight continuation of the two frames before
    FromNeighbour = 4,  ///< added: what was left of the place before is taken off
  };

  /// `bits` is 8 or 16.
  explicit FramePacker(int bits) : bits_(bits) {}

  /// Appends the frame to `bytes`; chooses the prediction with the smallest differences.
  void add(std::span<const std::uint16_t> codes, std::string& bytes);

 private:
  int bits_;
  std::vector<std::uint16_t> before_;
  std::vector<std::uint16_t> before_that_;
};

/// Integers as differences from the one before, folded as above, in groups of seven bits from the lowest; the
/// eighth bit says that more follow.
std::string pack_integers(std::span<const std::int64_t> values);

/// zlib's stream of the bytes in base64.
std::string deflated_base64(std::string_view bytes);

}  // namespace crumple::report
