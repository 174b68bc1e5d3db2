// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <iostream>
#include <string>
#include <vector>

#include "app/program.hpp"

int main(int count, char** values) {
  const std::vector<std::string> arguments(values + 1, values + count);
  const crumple::app::Console console{std::cout, std::cerr, isatty(STDOUT_FILENO) == 1};
  return static_cast<int>(crumple::app::run_program(arguments, console));
}
