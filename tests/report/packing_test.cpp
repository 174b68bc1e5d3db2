// SPDX-License-Identifier: BSD-3-Clause
#include "report/packing.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <limits>
#include <random>

namespace crumple::report::packing_test {
namespace {

/// Reads frames back from the description of the format alone.
class Unpacker {
 public:
  Unpacker(int bits, std::size_t count) : bits_(bits), count_(count) {}

  std::vector<std::uint16_t> next(const std::string& bytes) {
    const auto byte = [&](std::size_t at) {
      return static_cast<unsigned>(static_cast<unsigned char>(bytes.at(at)));
    };
    const unsigned prediction = byte(0);
    const unsigned mask = bits_ == 8 ? 0xffU : 0xffffU;
    std::vector<std::uint16_t> codes(count_);
    unsigned left = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const unsigned folded = byte(1 + i) | (bits_ == 16 ? byte(1 + count_ + i) << 8U : 0U);
      unsigned rest = (folded >> 1U) ^ (0U - (folded & 1U));
      if ((prediction & FramePacker::FromNeighbour) != 0) rest += left;
      left = rest;
      if ((prediction & 3U) == FramePacker::FromBefore) rest += before_[i];
      if ((prediction & 3U) == FramePacker::FromMotion) rest += 2U * before_[i] - before_that_[i];
      codes[i] = static_cast<std::uint16_t>(rest & mask);
    }
    before_that_ = before_;
    before_ = codes;
    return codes;
  }

 private:
  int bits_;
  std::size_t count_;
  std::vector<std::uint16_t> before_;
  std::vector<std::uint16_t> before_that_;
};

TEST(FramePacker, GivesBackWhatWasPacked) {
  std::mt19937 random(3);
  for (const int bits : {8, 16}) {
    const unsigned largest = (1U << static_cast<unsigned>(bits)) - 1;
    const std::size_t count = 500;
    FramePacker packer(bits);
    Unpacker unpacker(bits, count);
    for (int frame = 0; frame < 12; ++frame) {
      std::vector<std::uint16_t> codes(count);
      for (std::size_t i = 0; i < count; ++i) {
        const unsigned smooth = 3 * static_cast<unsigned>(i) + 11 * static_cast<unsigned>(frame);
        // Straight motion, then noise over all codes, then the extremes.
        codes[i] = static_cast<std::uint16_t>(frame < 5    ? smooth & largest
                                              : frame < 9  ? random() & largest
                                              : i % 2 == 0 ? 0
                                                           : largest);
      }
      std::string bytes;
      packer.add(codes, bytes);
      EXPECT_EQ(bytes.size(), 1 + count * bits / 8);
      EXPECT_EQ(unpacker.next(bytes), codes) << bits << " bits, frame " << frame;
    }
  }
}

TEST(FramePacker, PredictsStraightMotionExactly) {
  FramePacker packer(16);
  std::string bytes;
  for (unsigned frame = 0; frame < 3; ++frame) {
    bytes.clear();
    std::vector<std::uint16_t> codes(100);
    for (unsigned i = 0; i < 100; ++i) codes[i] = static_cast<std::uint16_t>(7 * i * i + (13 + i) * frame);
    packer.add(codes, bytes);
  }
  EXPECT_EQ(bytes[0], FramePacker::FromMotion);
  EXPECT_EQ(bytes.find_first_not_of('\0', 1), std::string::npos);
}

TEST(PackIntegers, FoldsAndGroups) {
  EXPECT_EQ(pack_integers(std::vector<std::int64_t>{}), "");
  // 5, then -1 and +64 from there.
  EXPECT_EQ(pack_integers(std::vector<std::int64_t>{5, 4, 68}), std::string("\x0a\x01\x80\x01", 4));
}

TEST(PackIntegers, GivesBackWhatWasPacked) {
  const std::vector<std::int64_t> values = {0, 1, -1,        127, 128, -5000000000, 9007199254740991,
                                            3, 3, 2147483647};
  const std::string bytes = pack_integers(values);
  std::vector<std::int64_t> back;
  std::int64_t before = 0;
  for (std::size_t i = 0; i < bytes.size();) {
    std::uint64_t folded = 0;
    unsigned shift = 0;
    unsigned char byte = 0;
    do {
      byte = static_cast<unsigned char>(bytes[i++]);
      folded |= static_cast<std::uint64_t>(byte & 127U) << shift;
      shift += 7;
    } while ((byte & 128U) != 0);
    before += static_cast<std::int64_t>(folded >> 1U) ^ -static_cast<std::int64_t>(folded & 1U);
    back.push_back(before);
  }
  EXPECT_EQ(back, values);
}

std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned group = 0;
  int bits = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    group = (group << 6U) | static_cast<unsigned>(digits.find(letter));
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes.push_back(static_cast<char>((group >> static_cast<unsigned>(bits)) & 255U));
    }
  }
  return bytes;
}

TEST(DeflatedBase64, GivesBackTexts) {
  for (const std::size_t size : {0U, 1U, 2U, 3U, 1000U}) {
    std::string text(size, '\0');
    for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i * i % 251);
    const std::string packed = deflated_base64(text);
    EXPECT_EQ(packed.size() % 4, 0U);
    const std::string bytes = decoded(packed);
    std::string back(size + 1, '\0');
    uLongf length = back.size();
    ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(back.data()), &length,
                         reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
              Z_OK);
    EXPECT_EQ(back.substr(0, length), text);
  }
}

}  // namespace
}  // namespace crumple::report::packing_test
