// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>
#include <unistd.h>

#include <iostream>
#include <string>
#include <vector>

#include "app/program.hpp"

namespace {

/// What the deepest calls take, and those of the threads, whose stacks have the same limit [bytes].
constexpr rlim_t least_stack = rlim_t{1} << 20U;

/// Beyond its limit the program would end without a word.
bool has_stack() {
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= least_stack) return true;
  std::cerr << "crumple: error: The stack is limited to " << (limit.rlim_cur >> 10U) << " kB, "
            << (least_stack >> 10U) << " are needed: ulimit -s " << (least_stack >> 10U) << ".\n";
  return false;
}

}  // namespace

int main(int count, char** values) {
  if (!has_stack()) return static_cast<int>(crumple::app::ExitCode::Usage);
  const std::vector<std::string> arguments(values + 1, values + count);
  const crumple::app::Console console{std::cout, std::cerr, isatty(STDOUT_FILENO) == 1};
  return static_cast<int>(crumple::app::run_program(arguments, console));
}
