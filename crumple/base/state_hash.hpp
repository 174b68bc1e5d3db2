// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace crumple {

/// A 64-bit fingerprint of state arrays: equal bits in, equal number out. Not cryptographic. Each 8-byte word
/// goes through the finaliser of the splitmix64 generator (Steele, Lea & Flood, OOPSLA 2014, fig. 16).
class StateHash {
 public:
  void add(std::span<const std::byte> bytes) {
    std::size_t at = 0;
    for (; at + sizeof(std::uint64_t) <= bytes.size(); at += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data() + at, sizeof(word));
      mix(word);
    }
    std::uint64_t rest = 0;
    if (at < bytes.size()) std::memcpy(&rest, bytes.data() + at, bytes.size() - at);
    mix(rest ^ (bytes.size() << 8));
  }

  std::uint64_t value() const { return value_; }

 private:
  void mix(std::uint64_t word) {
    std::uint64_t z = value_ ^ word;
    z += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    value_ = z ^ (z >> 31);
  }

  std::uint64_t value_ = 0;
};

}  // namespace crumple
