// SPDX-License-Identifier: BSD-3-Clause
#include "app/program.hpp"

#include <exception>
#include <new>
#include <ostream>

#include "app/arguments/command_line.hpp"
#include "app/commands/bench_command.hpp"
#include "app/commands/check_command.hpp"
#include "app/commands/compare_command.hpp"
#include "app/commands/keywords_command.hpp"
#include "app/commands/report_command.hpp"
#include "app/commands/run_command.hpp"
#include "app/commands/scatter_command.hpp"
#include "app/console/print.hpp"
#include "base/error.hpp"
#include "base/isa.hpp"

namespace crumple::app {

namespace {

/// True if the kernels that CRUMPLE_ISA names can be used, or it is not asked. It belongs to the call, not to
/// the deck, whose reader would report it otherwise.
bool has_kernels(const CommandLine& line, const Console& console) {
  const bool computes = line.command == Command::Run || line.command == Command::Check ||
                        line.command == Command::Scatter || line.command == Command::Bench;
  if (!computes || line.options.isa) return true;
  try {
    default_isa();
    return true;
  } catch (const Error& fault) {
    print(console.err, "crumple: error: CRUMPLE_ISA in the environment: {}\n", fault.what());
    return false;
  }
}

ExitCode run_command(const std::vector<std::string>& arguments, const Console& console) {
  try {
    const CommandLine line = parse_command_line(arguments);
    if (!has_kernels(line, console)) return ExitCode::Usage;
    switch (line.command) {
      case Command::Help:
        console.out << line.text << std::flush;
        return ExitCode::Normal;
      case Command::Mistake:
        console.err << line.text << std::flush;
        return ExitCode::Usage;
      case Command::Check:
        return check_deck(line.options, console);
      case Command::Scatter:
        return scatter_deck(line.options, console);
      case Command::Bench:
        return bench_machine(line.options, console);
      case Command::Report:
        return report_results(line.report, console);
      case Command::Compare:
        return compare_results(line.compare, console);
      case Command::Keywords:
        return list_keywords(line.keywords, console);
      case Command::Run:
        return run_deck(line.options, console);
    }
  } catch (const std::bad_alloc&) {
    print(console.err, "crumple: error: There is not enough memory.\n");
  } catch (const std::exception& fault) {
    // What comes this far is no input error, which the commands report themselves, but a bug.
    print(console.err, "crumple: internal error: {}\n", fault.what());
  }
  return ExitCode::Numerical;
}

}  // namespace

ExitCode run_program(const std::vector<std::string>& arguments, const Console& console) {
  const ExitCode code = run_command(arguments, console);
  console.out.flush();
  if (console.out || code != ExitCode::Normal) return code;
  print(console.err, "crumple: error: What was printed could not be written to the standard output.\n");
  return ExitCode::Output;
}

}  // namespace crumple::app
