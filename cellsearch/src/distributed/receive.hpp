// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <string>

#include "cellsearch/distributed/transport.hpp"

namespace cellsearch {

[[noreturn]] inline void throw_long_message(const Incoming& slot, std::size_t length) {
  throw std::length_error("A message of " + std::to_string(length) + " bytes from rank " +
                          std::to_string(slot.from) + " came where " + std::to_string(slot.buffer.size()) +
                          " were expected.");
}

/// Copies a message to where it is expected.
inline void receive(Incoming& slot, std::span<const std::byte> message) {
  if (slot.grown != nullptr) slot.grown->resize(message.size());
  const std::span<std::byte> place =
      slot.grown != nullptr ? std::span<std::byte>(slot.grown->data(), slot.grown->size()) : slot.buffer;
  if (message.size() > place.size()) throw_long_message(slot, message.size());
  std::copy(message.begin(), message.end(), place.begin());
  slot.received = message.size();
}

}  // namespace cellsearch
