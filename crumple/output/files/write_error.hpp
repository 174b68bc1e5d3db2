// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/error.hpp"

namespace crumple::output {

/// A result could not be written. The message names the file and the operating system's reason.
class WriteError : public Error {
 public:
  explicit WriteError(const std::string& message) : Error(message) {}
};

}  // namespace crumple::output
