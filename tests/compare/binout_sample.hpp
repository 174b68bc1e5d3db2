// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace crumple::compare {

/// Writes LSDA files for tests as the format's description has them, apart from whatever the program itself
/// writes.
class BinoutSample {
 public:
  enum Type { I1 = 1, I2, I4, I8, U1, U2, U4, U8, R4, R8 };

  explicit BinoutSample(std::size_t width = 8, bool little_endian = true)
      : width_(width), little_(little_endian) {
    const auto byte = static_cast<char>(width);
    bytes_ = {8, byte, byte, 1, 1, static_cast<char>(little_endian ? 1 : 0), 0, 0};
    put(2 * width + 1);
    put(7, 1);
    offset_at_ = bytes_.size();
    put(0);
  }

  void folder(const std::string& path) {
    put(width_ + 1 + path.size());
    put(2, 1);
    bytes_ += path;
    folder_ = path;
  }

  void write(const std::string& name, Type type, const std::vector<double>& numbers) {
    static constexpr std::size_t widths[] = {0, 1, 2, 4, 8, 1, 2, 4, 8, 4, 8};
    symbols_.push_back({folder_, name, type, bytes_.size(), numbers.size()});
    put(width_ + 3 + name.size() + numbers.size() * widths[type]);
    put(3, 1);
    put(type, 1);
    put(name.size(), 1);
    bytes_ += name;
    for (const double number : numbers) {
      std::uint64_t bits = 0;
      if (type == R4)
        bits = std::bit_cast<std::uint32_t>(static_cast<float>(number));
      else if (type == R8)
        bits = std::bit_cast<std::uint64_t>(number);
      else
        bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
      put(bits, widths[type]);
    }
  }

  /// A symbol table of what was written since the last one; the one before gets its offset.
  void table() {
    const std::size_t start = bytes_.size();
    patch(offset_at_, start);
    const std::size_t length_at = bytes_.size();
    put(0);
    put(5, 1);
    for (const Symbol& symbol : std::exchange(symbols_, {})) {
      put(width_ + 1 + symbol.folder.size());
      put(2, 1);
      bytes_ += symbol.folder;
      put(3 * width_ + 2 + symbol.name.size());
      put(4, 1);
      bytes_ += symbol.name;
      put(symbol.type, 1);
      put(symbol.offset);
      put(symbol.count);
    }
    put(2 * width_ + 1);
    put(6, 1);
    offset_at_ = bytes_.size();
    put(0);
    patch(length_at, bytes_.size() - start);
  }

  const std::string& bytes() const { return bytes_; }

 private:
  struct Symbol {
    std::string folder;
    std::string name;
    Type type;
    std::size_t offset;
    std::size_t count;
  };

  std::string text(std::uint64_t value, std::size_t width) const {
    std::string out(width, '\0');
    for (std::size_t i = 0; i < width; ++i)
      out[little_ ? i : width - 1 - i] = static_cast<char>(value >> 8 * i & 0xFFU);
    return out;
  }
  void put(std::uint64_t value, std::size_t width) { bytes_ += text(value, width); }
  void put(std::uint64_t value) { put(value, width_); }
  void patch(std::size_t place, std::uint64_t value) { bytes_.replace(place, width_, text(value, width_)); }

  std::size_t width_;
  bool little_;
  std::string bytes_;
  std::size_t offset_at_ = 0;
  std::string folder_;
  std::vector<Symbol> symbols_;
};

}  // namespace crumple::compare
