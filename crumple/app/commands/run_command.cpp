// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/run_command.hpp"
#include "app/console/print.hpp"
#include "contact/move_apart.hpp"

#include <memory>
#include <ostream>

#include "app/commands/report_command.hpp"
#include "app/preparation/model_summary.hpp"
#include "app/preparation/preparation.hpp"
#include "app/session/live_pages.hpp"
#include "app/session/run_session.hpp"
#include "app/session/stop_signals.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "output/files/write_error.hpp"

namespace crumple::app {

namespace {

constexpr const char* normal_termination = " N o r m a l    t e r m i n a t i o n";
constexpr const char* error_termination = " E r r o r    t e r m i n a t i o n";

ExitCode end_with(ExitCode code, const Console& console) {
  const bool good = code == ExitCode::Normal || code == ExitCode::Stopped || is_of_signal(code);
  print(console.out, "\n{}\n", good ? normal_termination : error_termination);
  console.out.flush();
  return code;
}

ExitCode run_model(const Options& options, const deck::ReadResult& deck, const Console& console,
                   const Stopwatch& wall, const Restart* restart, live::StatusBoard* board) {
  try {
    RunSession session(options, deck, console, wall, {.restart = restart, .board = board});
    return session.run();
  } catch (const output::WriteError& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Output;
  } catch (const NumericalError& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Numerical;
  } catch (const Error& fault) {
    print(console.err, "{}: error: {}\n", options.deck.string(), fault.what());
    return ExitCode::Input;
  }
}

void move_overlaps_apart(const Options& options, model::Model& model, const Console& console) {
  const contact::MovedApart moved = contact::move_apart(model, choose_execution(options, model));
  if (options.quiet) return;
  if (moved.nodes > 0)
    print(console.out, "Moved {} apart, by up to {:.4g} (node {})\n", counted(moved.nodes, "node"),
          moved.farthest, moved.farthest_node);
  else
    print(console.out, "No nodes had to be moved apart\n");
  if (moved.left > 0) print(console.out, "Overlaps of up to {:.4g} are left\n", moved.left);
}

/// `changes`: the deck of a small restart; empty if there is none.
ExitCode run_with(const Options& options, const std::filesystem::path& changes, const Restart* restart,
                  const Console& console) {
  const Stopwatch wall;
  if (!options.quiet)
    print(console.out, "{}: explicit finite element solver for crash and contact-impact\n\n",
          program_version());
  if (!options.quiet)
    for (const std::string& note : options.notes) print(console.err, "note: {}\n", note);
  deck::ReadResult deck = restart == nullptr ? read_with_options(options, console)
                                             : read_again(options, changes, restart->settings.texts, console);
  if (!deck.model) {
    print(console.err, "{} in the deck: nothing was run, nothing was written.\n",
          counted(std::max(1, deck::error_count(deck.diagnostics)), "error"));
    return end_with(ExitCode::Input, console);
  }
  if (!options.quiet) print_reading(console.out, deck);
  if (options.report && !report_can_be_made({}, console)) return end_with(ExitCode::Usage, console);
  live::StatusBoard board;
  std::unique_ptr<live::LivePage> page;
  if (options.serve) {
    page = open_live_page(
        result_folder(options), {}, {*options.serve, options.token}, [&board] { return board.read(); },
        console);
    if (!page) return end_with(ExitCode::Usage, console);
  }
  if (options.move_apart) move_overlaps_apart(options, *deck.model, console);
  ExitCode code = run_model(options, deck, console, wall, restart, page ? &board : nullptr);
  const bool has_results = code != ExitCode::Input && code != ExitCode::Output;
  if (options.report && has_results)
    code = end_with_report(result_folder(options), options.quiet, code, console);
  end_with(code, console);
  if (page) {
    // Where nothing could be run, the board does not know yet.
    if (board.read().state != live::RunState::Ended) board.end("error");
    page->wait_for_readers(is_of_signal(code));
  }
  return code;
}

}  // namespace

ExitCode run_deck(const Options& options, const Console& console) {
  const IgnoredUserSignal until_the_loop;
  if (options.restart.empty()) return run_with(options, {}, nullptr, console);
  try {
    const Restart restart = read_restart(options.restart);
    if (!restart.note.empty()) print(console.err, "warning: {}\n", restart.note);
    return run_with(continued_options(options, restart), options.deck, &restart, console);
  } catch (const Error& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return end_with(ExitCode::Input, console);
  }
}

}  // namespace crumple::app
