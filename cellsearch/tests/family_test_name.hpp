// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "scenes.hpp"

namespace cellsearch::scenes {

/// The name of a test with one of families(), as GoogleTest allows it.
inline std::string test_name(const testing::TestParamInfo<Family>& family) {
  std::string name = family.param.name;
  for (char& letter : name) letter = letter == '-' ? '_' : letter;
  return name;
}

}  // namespace cellsearch::scenes
