// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/scatter_command.hpp"

#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <map>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

#include "app/commands/report_command.hpp"
#include "app/commands/run_command.hpp"
#include "app/console/print.hpp"
#include "app/preparation/preparation.hpp"
#include "app/session/stop_signals.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "compare/comparison.hpp"
#include "compare/open_results.hpp"
#include "compare/scatter_bands.hpp"
#include "output/files/atomic_file.hpp"
#include "output/files/own_file.hpp"
#include "output/files/write_error.hpp"
#include "report/scatter_folder.hpp"
#include "report/text_file.hpp"

namespace crumple::app {

namespace {

// A signal handler can reach nothing else.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t signal_seen = 0;

void remember_signal(int signal) {
  signal_seen = signal;
}

/// While this exists, SIGINT, SIGTERM and SIGHUP only interrupt the wait, so that they can be forwarded to
/// the runs, which have process groups of their own. A SIGHUP that is ignored stays so, as in StopSignals.
class NotedSignals {
 public:
  NotedSignals() {
    signal_seen = 0;
    struct sigaction action {};
    action.sa_handler = remember_signal;
    sigaction(SIGINT, &action, &interrupt_);
    sigaction(SIGTERM, &action, &terminate_);
    sigaction(SIGHUP, &action, &hangup_);
    if (hangup_.sa_handler == SIG_IGN) sigaction(SIGHUP, &hangup_, nullptr);
  }
  NotedSignals(const NotedSignals&) = delete;
  NotedSignals& operator=(const NotedSignals&) = delete;
  ~NotedSignals() {
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
    sigaction(SIGHUP, &hangup_, nullptr);
  }

 private:
  struct sigaction interrupt_ {};
  struct sigaction terminate_ {};
  struct sigaction hangup_ {};
};

struct PerturbedRun {
  std::filesystem::path folder;
  pid_t process = 0;  ///< 0 while it is not running
  bool started = false;
  int code = -1;  ///< exit code; 128 and the number of a signal that killed it
};

std::filesystem::path scatter_folder(const Options& options) {
  if (!options.folder.empty()) return options.folder;
  std::filesystem::path folder = options.deck.stem();
  return folder += ".scatter";
}

/// The run with the nodes as the deck has them is number 0.
Options options_of_run(const Options& options, int number, const std::filesystem::path& folder) {
  Options one = options;
  one.folder = folder;
  one.threads = 1;
  one.perturbation = number == 0 ? 0 : options.perturbation;
  one.seed = options.seed + static_cast<std::uint64_t>(number) - 1;
  one.quiet = true;
  one.report = false;
  return one;
}

/// A new file to print to.
class LogStream : private std::streambuf {
 public:
  explicit LogStream(const std::filesystem::path& path)
      : file_(output::OwnFile::create(path)), stream_(static_cast<std::streambuf*>(this)) {}
  std::ostream& out() { return stream_; }

 private:
  std::streamsize xsputn(const char* text, std::streamsize bytes) override {
    file_.write_at(bytes_, {text, static_cast<std::size_t>(bytes)});
    bytes_ += static_cast<std::uint64_t>(bytes);
    return bytes;
  }
  int_type overflow(int_type letter) override {
    const char text = traits_type::to_char_type(letter);
    return xsputn(&text, 1) == 1 ? letter : traits_type::eof();
  }

  output::OwnFile file_;
  std::uint64_t bytes_ = 0;
  std::ostream stream_;
};

/// In a process group of its own, so that Ctrl-C reaches it through its parent alone, once.
pid_t start_run(const Options& one) {
  const pid_t process = fork();
  if (process != 0) return process;
  setpgid(0, 0);
  std::filesystem::path log = one.folder;
  log += ".log";
  int code = static_cast<int>(ExitCode::Output);
  try {
    LogStream log_stream(log);
    code = static_cast<int>(run_deck(one, {log_stream.out(), log_stream.out(), false}));
  } catch (const output::WriteError&) {
    // Its parent prints the exit code.
  }
  _exit(code);
}

void note_end(std::vector<PerturbedRun>& runs, pid_t process, int status, const Console& console,
              bool quiet) {
  const auto run = std::ranges::find(runs, process, &PerturbedRun::process);
  if (run == runs.end()) return;
  run->process = 0;
  run->code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (!quiet) print(console.out, "{} ended with exit code {}\n", run->folder.string(), run->code);
  console.out.flush();
}

void forward_signal(const std::vector<PerturbedRun>& runs, int signal) {
  for (const PerturbedRun& run : runs)
    if (run.process > 0) kill(run.process, signal);
}

/// Starts all runs, `at_once` at a time; no run is started after a signal.
void run_all(const Options& options, std::vector<PerturbedRun>& runs, const Console& console) {
  const auto at_once = static_cast<std::size_t>(options.threads.value_or(1));
  std::size_t next = 0;
  std::size_t running = 0;
  int forwarded = 0;
  while (running > 0 || (next < runs.size() && signal_seen == 0)) {
    if (running < at_once && next < runs.size() && signal_seen == 0) {
      PerturbedRun& run = runs[next];
      console.out.flush();
      run.process = start_run(options_of_run(options, static_cast<int>(next), run.folder));
      run.started = run.process > 0;
      ++next;
      if (run.started)
        ++running;
      else
        run.process = 0;
      continue;
    }
    int status = 0;
    const pid_t ended = waitpid(-1, &status, 0);
    if (ended > 0) {
      note_end(runs, ended, status, console, options.quiet);
      --running;
    } else if (errno != EINTR) {
      break;
    }
    if (signal_seen != forwarded) forward_signal(runs, forwarded = signal_seen);
  }
}

/// The runs that terminated normally; failures are printed.
std::vector<compare::CurveSet> finished_results(const std::vector<PerturbedRun>& runs,
                                                const Console& console) {
  std::vector<compare::CurveSet> results;
  for (const PerturbedRun& run : runs) {
    if (run.code == 0)
      results.push_back(compare::open_results(run.folder));
    else if (!run.started)
      print(console.err, "warning: {} was not started and is not in the bands\n", run.folder.string());
    else
      print(console.err,
            "warning: {} failed or was stopped (exit code {}, see {}.log) and is not in the bands\n",
            run.folder.string(), run.code, run.folder.string());
  }
  return results;
}

/// Leaves out what is less than a hundredth of the largest of its kind, as crumple compare does: the scatter
/// of forces that should be zero is that of round-off.
void drop_negligible(std::vector<compare::Band>& bands) {
  const auto kind_of = [](const compare::Band& band) { return band.name.substr(0, band.name.find('[')); };
  std::map<std::string, double> largest;
  for (const compare::Band& band : bands) {
    double& size = largest[kind_of(band)];
    size = std::max(size, compare::largest_median(band));
  }
  const double floor = compare::ComparisonSettings().floor;
  std::erase_if(bands, [&](const compare::Band& band) {
    return compare::largest_median(band) < floor * largest[kind_of(band)];
  });
}

void print_widest(std::vector<compare::Band> bands, const Console& console) {
  drop_negligible(bands);
  const auto wider = [](const compare::Band& a, const compare::Band& b) {
    return compare::relative_width(a) > compare::relative_width(b);
  };
  std::ranges::stable_sort(bands, wider);
  print(console.out, "\nP95 - P5 over the largest median, the widest first\n");
  for (std::size_t i = 0; i < std::min<std::size_t>(bands.size(), 20); ++i)
    print(console.out, "  {:<40} {:10.3g} %\n", bands[i].name, 100 * compare::relative_width(bands[i]));
}

/// Bands of other runs, and their report, must not stand beside new ones. Throws WriteError if the file is
/// none of ours.
void remove_earlier_bands(const std::filesystem::path& table) {
  if (!std::filesystem::exists(table)) return;
  if (compare::read_bands(report::read_file(table)).empty())
    throw output::WriteError(
        fmt::format("{} is not a table of crumple scatter and is left as it is: move it, or choose another "
                    "folder with -o",
                    table.string()));
  std::filesystem::remove(table);
  std::filesystem::remove(table.parent_path() / "report.html");
}

/// False, and the reason on the console, if there are too few results for a band.
bool write_bands(const std::filesystem::path& file, const std::vector<compare::CurveSet>& results,
                 const Options& options, const Console& console) {
  if (results.size() < 2) {
    print(console.err, "crumple: error: {} terminated normally; a band needs two\n",
          counted(static_cast<int>(results.size()), "run"));
    return false;
  }
  const std::vector<compare::Band> bands = compare::bands_of(results);
  output::write_atomically(file, compare::bands_csv(bands));
  if (!options.quiet) {
    print_widest(bands, console);
    print(console.out, "\n{} of {} runs are in {}\n", results.size(), options.scatter_runs, file.string());
  }
  return true;
}

ExitCode scatter_good_deck(const Options& options, const Console& console) {
  const std::filesystem::path folder = scatter_folder(options);
  output::make_folder(folder);
  remove_earlier_bands(folder / report::bands_file);
  std::vector<PerturbedRun> runs(static_cast<std::size_t>(options.scatter_runs));
  for (std::size_t number = 0; number < runs.size(); ++number)
    runs[number].folder = folder / report::scatter_run_name(static_cast<int>(number));
  {
    const NotedSignals noted;
    run_all(options, runs, console);
  }
  const std::vector<compare::CurveSet> results = finished_results(runs, console);
  const bool has_bands = write_bands(folder / report::bands_file, results, options, console);
  const ExitCode code = signal_seen != 0                ? code_of_signal(signal_seen)
                        : results.size() == runs.size() ? ExitCode::Normal
                                                        : ExitCode::Numerical;
  return options.report && has_bands ? end_with_report(folder, options.quiet, code, console) : code;
}

}  // namespace

ExitCode scatter_deck(const Options& options, const Console& console) {
  try {
    const deck::ReadResult deck = read_with_options(options, console);
    if (!deck.model) {
      print(console.err, "{} in the deck: nothing was run, nothing was written.\n",
            counted(std::max(1, deck::error_count(deck.diagnostics)), "error"));
      return ExitCode::Input;
    }
    if (options.report && !report_can_be_made({}, console)) return ExitCode::Usage;
    return scatter_good_deck(options, console);
  } catch (const output::WriteError& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Output;
  } catch (const Error& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Numerical;
  }
}

}  // namespace crumple::app
