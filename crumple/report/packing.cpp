// SPDX-License-Identifier: BSD-3-Clause
#include "report/packing.hpp"

#include <zlib.h>

#include <cstdlib>
#include <limits>

#include "base/error.hpp"

namespace crumple::report {

namespace {

/// Differences of codes, with the number of bits that the codes have.
class Differences {
 public:
  Differences(int bits, std::span<const std::uint16_t> codes, const std::vector<std::uint16_t>& before,
              const std::vector<std::uint16_t>& before_that)
      : shift_(32 - bits), codes_(codes), before_(before), before_that_(before_that) {}

  /// Calls `take` with every difference from the prediction, from minus half to half of the codes' range.
  template <class Take>
  void each(unsigned prediction, const Take& take) const {
    const unsigned in_time = prediction & 3U;
    const bool neighbour = (prediction & FramePacker::FromNeighbour) != 0;
    std::uint32_t left = 0;
    for (std::size_t i = 0; i < codes_.size(); ++i) {
      std::uint32_t rest = codes_[i];
      if (in_time == FramePacker::FromBefore) rest -= before_[i];
      if (in_time == FramePacker::FromMotion) rest -= 2U * before_[i] - before_that_[i];
      take(wrapped(neighbour ? rest - left : rest));
      left = rest;
    }
  }

  double size(unsigned prediction) const {
    double sum = 0;
    each(prediction, [&](std::int32_t difference) { sum += std::abs(difference); });
    return sum;
  }

 private:
  std::int32_t wrapped(std::uint32_t number) const {
    return static_cast<std::int32_t>(number << shift_) >> shift_;
  }

  int shift_;
  std::span<const std::uint16_t> codes_;
  const std::vector<std::uint16_t>& before_;
  const std::vector<std::uint16_t>& before_that_;
};

}  // namespace

void FramePacker::add(std::span<const std::uint16_t> codes, std::string& bytes) {
  const Differences differences(bits_, codes, before_, before_that_);
  const unsigned kinds = !before_that_.empty() ? 3 : !before_.empty() ? 2 : 1;
  unsigned best = FromNothing;
  double smallest = std::numeric_limits<double>::infinity();
  for (unsigned in_time = 0; in_time < kinds; ++in_time)
    for (const unsigned prediction : {in_time, in_time + FromNeighbour})
      if (const double size = differences.size(prediction); size < smallest) {
        smallest = size;
        best = prediction;
      }
  bytes.push_back(static_cast<char>(best));
  const std::size_t start = bytes.size();
  bytes.resize(start + codes.size() * (bits_ / 8));
  std::size_t i = start;
  differences.each(best, [&](std::int32_t difference) {
    const auto folded =
        (static_cast<std::uint32_t>(difference) << 1U) ^ static_cast<std::uint32_t>(difference >> 31);
    bytes[i] = static_cast<char>(folded & 255U);
    if (bits_ == 16) bytes[i + codes.size()] = static_cast<char>((folded >> 8U) & 255U);
    ++i;
  });
  before_that_ = std::move(before_);
  before_.assign(codes.begin(), codes.end());
}

std::string pack_integers(std::span<const std::int64_t> values) {
  std::string bytes;
  std::uint64_t before = 0;
  for (const std::int64_t value : values) {
    const auto difference = static_cast<std::int64_t>(static_cast<std::uint64_t>(value) - before);
    auto folded =
        (static_cast<std::uint64_t>(difference) << 1U) ^ static_cast<std::uint64_t>(difference >> 63);
    for (; folded > 127; folded >>= 7U) bytes.push_back(static_cast<char>(128U | (folded & 127U)));
    bytes.push_back(static_cast<char>(folded));
    before = static_cast<std::uint64_t>(value);
  }
  return bytes;
}

std::string deflated_base64(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw Error("zlib could not compress: out of memory.");
  packed.resize(size);
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((size + 2) / 3 * 4);
  for (std::size_t i = 0; i < size; i += 3) {
    std::uint32_t group = 0;
    const std::size_t present = std::min<std::size_t>(3, size - i);
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8U | (j < present ? static_cast<unsigned char>(packed[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text.push_back(j <= present ? digits[(group >> (18U - 6U * j)) & 63U] : '=');
  }
  return text;
}

}  // namespace crumple::report
