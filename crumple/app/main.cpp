// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <cstdlib>
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

/// Threads that wait for others spin for some 20 us, which outlasts most serial parts of a step, and then
/// sleep. The runtime's own choice is milliseconds: where anything else computes, those that spin then keep
/// the processor from the one that they wait for, and two threads become ten times slower than one. The
/// runtime reads this before main() begins, so that the program has to start once more. What the user has
/// chosen stays, and so does a program inside of another one: of a loader, whose name is not the program's,
/// or of valgrind and the like, which preload a library.
void wait_briefly(char** values) {
  for (const char* chosen : {"GOMP_SPINCOUNT", "OMP_WAIT_POLICY", "LD_PRELOAD"})
    if (std::getenv(chosen) != nullptr) return;
  const char* const threads = std::getenv("OMP_NUM_THREADS");
  if (threads != nullptr && std::string(threads) == "1") return;
  std::array<char, PATH_MAX> program{};
  if (readlink("/proc/self/exe", program.data(), program.size() - 1) <= 0) return;
  const auto name_of = [](const std::string& path) { return path.substr(path.rfind('/') + 1); };
  if (values[0] == nullptr || name_of(program.data()) != name_of(values[0])) return;
  if (setenv("GOMP_SPINCOUNT", "1000", 0) == 0) execv(program.data(), values);
}

}  // namespace

int main(int count, char** values) {
  wait_briefly(values);
  if (!has_stack()) return static_cast<int>(crumple::app::ExitCode::Usage);
  const std::vector<std::string> arguments(values + 1, values + count);
  const crumple::app::Console console{std::cout, std::cerr, isatty(STDOUT_FILENO) == 1};
  return static_cast<int>(crumple::app::run_program(arguments, console));
}
