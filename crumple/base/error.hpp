// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace crumple {

/// Something the user can mend: bad input, a folder that cannot be written, an unknown option. The message
/// is a whole sentence that names the item and says what was expected.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

/// The run went wrong numerically (not-a-number, runaway velocity, negative volume). The message names the
/// first node, element and part concerned.
class NumericalError : public Error {
 public:
  explicit NumericalError(const std::string& message) : Error(message) {}
};

}  // namespace crumple
