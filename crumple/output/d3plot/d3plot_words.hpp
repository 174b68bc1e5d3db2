// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "math/vec3.hpp"

namespace crumple::output {

/// Words of a d3plot file in the machine's byte order: integers, single precision numbers or four
/// characters, 32 bits each.
class D3plotWords {
 public:
  void integer(std::int64_t value) { words_.push_back(static_cast<std::uint32_t>(value)); }
  void real(double value) { words_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void vector(const math::Vec3& value) {
    real(value.x);
    real(value.y);
    real(value.z);
  }
  void zeros(std::size_t count) { words_.resize(words_.size() + count); }
  /// Text in so many words, cut or filled with blanks.
  void text(std::string_view value, std::size_t words);
  /// The number that ends the data of a file, and the first part of the first file.
  void end_mark() { real(-999999.0); }
  /// Fills the last block of 512 words.
  void pad() { zeros((block - words_.size() % block) % block); }

  void reserve(std::size_t count) { words_.reserve(count); }
  std::size_t size() const { return words_.size(); }
  /// The bytes as they stand in the file.
  std::string_view bytes() const {
    return {reinterpret_cast<const char*>(words_.data()), sizeof(std::uint32_t) * words_.size()};
  }

  /// Files are whole multiples of so many words.
  static constexpr std::size_t block = 512;

 private:
  std::vector<std::uint32_t> words_;
};

}  // namespace crumple::output
