// SPDX-License-Identifier: BSD-3-Clause
#include "app/arguments/command_line.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cellsearch/method.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <sstream>

#include "app/arguments/compare_arguments.hpp"
#include "app/arguments/foreign_arguments.hpp"
#include "base/error.hpp"
#include "base/isa.hpp"
#include "deck/format/parameters.hpp"

namespace crumple::app {

namespace {

constexpr const char* bench_words = R"(What it runs:
  - the time step without contact, for every shell formulation: a curved sheet of 1 000 and of 100 000 shells (in the
    cache of the processor and out of it), plastic with 3 points through the thickness, one fifth of them yielding, in
    mixed and in double precision
  - the search for contact candidates, for every method but brute force: two sheets of 100 000 segments each

How long it takes: about half a minute, with -t a minute, as everything is then measured on one thread and on that
many. Nothing is read or written.

How to read it: nanoseconds per shell and cycle, or per segment and search; less is faster. A run takes about
  shells x cycles x nanoseconds / 1e9 seconds
and contact on top of that; "crumple check" says how many cycles. Every figure is the shortest of many, so that other
programs matter little on one thread. Twice the threads halve a figure at best: at 1k they wait for each other, at 100k
for memory. Where two threads take much longer than one, other programs keep the cores busy: run on one.

Example:
  crumple bench -t 2 --isa avx2      the kernels for AVX2, on one and on two threads)";

constexpr const char* examples = R"(Examples:
  crumple run deck.k                        results in ./deck.out
  crumple run deck.k -o results -t 4        results in ./results, on 4 threads
  crumple run deck.k --restart-every 30min  restart files in ./deck.out/restart
  crumple run --restart deck.out --end 0.02 take the run up again, to a later end
  crumple run deck.k --contact auto         contact of everything with everything
  crumple run deck.k --search brute-force   another method of the contact search
  crumple check deck.k                      what is read, ignored, wrong; masses and time steps
  crumple report deck.out                   deck.out/report.html: animation, curves, tables
  crumple report deck.out --png             and pictures of it
  crumple run deck.k --serve 8000           the same while it runs, in a browser
  crumple scatter deck.k --runs 8           the scatter band of perturbed runs
  crumple compare ref.out deck.out          how far two results are apart, curve by curve
  crumple keywords MAT_024                  cards and fields of a keyword
  crumple bench -t 2                        how fast this machine is, about a minute
  crumple i=deck.k ncpu=4 memory=200m       as LS-DYNA is called

Exit codes:
  0 normal termination    1 faulty deck, nothing written    2 wrong command line
  3 the run went wrong or reached a limit set in the deck   4 results could not be written
  5 stopped by sw1 in d3kil    129 by SIGHUP (the terminal was closed), 130 by Ctrl-C, 143 by SIGTERM

While it runs: Ctrl-C ends with the last state written; a file named d3kil, in the working folder or in that of
the results, holding sw1 (stop), sw2 (status line), sw3 (write a restart file) or sw4 (write a frame) does as in LS-DYNA. Whatever
stops a run writes a restart file; SIGUSR1 writes one and the run goes on.)";

std::vector<std::string> search_names() {
  std::vector<std::string> names;
  for (const cellsearch::Method method : cellsearch::methods()) names.emplace_back(name_of(method));
  return names;
}

std::vector<std::string> isa_names() {
  std::vector<std::string> names;
  for (const Isa isa : available_isas()) names.emplace_back(isa_name(isa));
  return names;
}

/// What to type instead where the subcommand was left out before a deck; empty if that is not the mistake.
std::string forgotten_command(const CLI::App& program, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0].starts_with('-')) return {};
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    if (command->get_name() == arguments[0]) return {};
  std::error_code ignored;
  const std::filesystem::path deck = arguments[0];
  if (!deck.has_extension() && !std::filesystem::is_regular_file(deck, ignored)) return {};
  std::string text = "To run the deck: crumple run";
  for (const std::string& argument : arguments) text += " " + argument;
  return text + "\n";
}

/// CLI11's own checks let "nan" pass. `fits` says what the number must be in words if it is not that.
CLI::Validator number_that(const std::string& words, const std::function<bool(double)>& fits) {
  return CLI::Validator(
      [words, fits](const std::string& text) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && fits(value);
        return good ? std::string() : text + " is not " + words;
      },
      "");
}

/// `thickness=1.5`.
CLI::Validator parameter_setting() {
  return CLI::Validator(
      [](const std::string& text) {
        const std::size_t equals = text.find('=');
        const bool good = equals != std::string::npos &&
                          deck::Parameters().preset(text.substr(0, equals), text.substr(equals + 1));
        return good ? std::string() : text + " is not the name of a parameter, = and a number";
      },
      "NAME=NUMBER");
}

CLI::Validator port_number() {
  return CLI::Range(0, 65535).description("PORT");
}

void add_token_option(CLI::App& command, bool& token) {
  command
      .add_flag_callback(
          "--no-token", [&token] { token = false; },
          "Leave the token out of the address of --serve: all users of this machine can read along")
      ->needs("--serve");
}

/// Options of both commands.
void add_reading_options(CLI::App& command, Options& options, bool& automatic) {
  command.add_option("deck", options.deck, "LS-DYNA keyword deck");
  command
      .add_option_function<std::vector<std::string>>(
          "-P,--parameter",
          [&options](const std::vector<std::string>& settings) {
            for (const std::string& setting : settings) {
              const std::size_t equals = setting.find('=');
              options.parameters.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
            }
          },
          "NAME=NUMBER: value of a parameter (&NAME) that the deck uses, before that of *PARAMETER; may be\n"
          "repeated")
      ->allow_extra_args(false)
      ->check(parameter_setting());
  command.add_flag("--allow-unsupported", options.allow_unsupported,
                   "Leave out, with a warning, what is not supported instead of refusing the deck");
  command.add_flag("--ls-dyna-defaults", options.ls_dyna_defaults,
                   "For decks without *CONTROL_SHELL or *CONTROL_HOURGLASS: shells of constant thickness,\n"
                   "viscous hourglass control. Otherwise the thickness follows the strain, shells resist\n"
                   "hourglassing with the stiffness of their material, and hexahedra by assumed strains");
  command
      .add_option_function<std::string>(
          "--contact", [&automatic](const std::string&) { automatic = true; },
          "auto: contact over all parts, for a deck without *CONTACT")
      ->check(CLI::IsMember({"auto"}));
}

/// Options of running and measuring.
void add_machine_options(CLI::App& command, Options& options) {
  command
      .add_option("-t,--threads", options.threads, "Threads; results are bitwise the same for any number [1]")
      ->check(CLI::Range(1, 1024));
  command.add_option("--isa", options.isa, "Instruction set of the kernels [the fastest of this processor]")
      ->check(CLI::IsMember(isa_names()));
}

void add_run_options(CLI::App& run, Options& options) {
  run.add_option("-o,--output", options.folder, "Folder of the results [the deck's name with .out, here]");
  run.add_flag("--d3plot", options.d3plot,
               "Write the frames as LS-DYNA's d3plot files, too; these take about three times the room");
  run.add_flag("--all-fields", options.all_fields,
               "Write stress tensors, and of shells plastic strain by surface and change of thickness, into\n"
               "ParaView's frames, too; these take about twice the room");
  run.add_flag(
      "--dynain", options.dynain,
      "Write dynain at the end: nodes, shells, solids, their stresses and velocities for another run");
  add_machine_options(run, options);
  run.add_option("--precision", options.precision, "Arithmetic of elements and contact [double]")
      ->check(CLI::IsMember({"mixed", "double"}));
  run.add_option("--search", options.search, "Method of the contact search [production]")
      ->check(CLI::IsMember(search_names()));
  run.add_option(
         "--local-search", options.local_search,
         "How contact is found among the candidates [inside-outside]: nodes against segments, or balls\n"
         "embedded in the segments against each other")
      ->check(CLI::IsMember({"inside-outside", "pinballs"}));
  run.add_flag(
      "--move-apart", options.move_apart,
      "Move nodes that overlap other surfaces at the start; otherwise their contact begins where they are");
  run.add_flag("--allow-negative-contact-energy", options.allow_negative_contact_energy,
               "Go on where a contact has given more energy than it took, by 10 % of the internal energy");
  run.add_flag("--trace-energy{512}", options.trace_energy,
               "Follow the energy balance by part and contact: energy_residual.csv, run.json; with =16\n"
               "(32, 64 ... 512) by groups of so many elements, in a run whose last digits differ")
      ->check(CLI::IsMember({16, 32, 64, 128, 256, 512}));
  run.add_option("--verify-search", options.verify_search,
                 "Compare the contact search with brute force every so many cycles; stop on a difference")
      ->check(CLI::NonNegativeNumber);
  run.add_option("--end", options.end_time, "End time, instead of the deck's")
      ->check(number_that("a positive number", [](double value) { return value > 0; }));
  run.add_option("--perturb", options.perturbation,
                 "Move all nodes at random by up to this fraction of the model's size, to see the scatter")
      ->check(number_that("a number from 0 to 1", [](double value) { return value >= 0 && value <= 1; }));
  run.add_option("--seed", options.seed, "Which of the random perturbations [1]");
  run.add_flag("--report", options.report, "Write report.html, a page that shows the result, at the end");
  run.add_option(
         "--serve", options.serve,
         "Show the run while it goes on: a page for browsers of this machine alone, at an address with a\n"
         "random token, which is printed; port 0 takes any free one")
      ->check(port_number());
  add_token_option(run, options.token);
  run.add_flag("-q,--quiet", options.quiet, "Print warnings, errors and the kind of termination only");
}

void add_restart_options(CLI::App& run, Options& options) {
  CLI::Option* const restart = run.add_option(
      "--restart", options.restart,
      "Take up a run from a restart file, or from the newest one in a folder of results; a deck then\n"
      "may hold new *CONTROL_TERMINATION and *DATABASE cards");
  run.add_option_function<std::string>(
         "--restart-every",
         [&options](const std::string& text) { options.restart_every = *parse_restart_interval(text); },
         "Write a restart file every so many cycles (500), or after so much time (90s, 30min, 2h)")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return parse_restart_interval(text) ? std::string() : text + " is not as 500, 90s, 30min or 2h";
          },
          "INTERVAL"));
  // What the run so far was computed with stays.
  for (const char* const fixed :
       {"--precision", "--search", "--local-search", "--move-apart", "--perturb", "--seed", "--parameter",
        "--allow-unsupported", "--ls-dyna-defaults", "--contact", "--trace-energy"})
    run.get_option(fixed)->excludes(restart);
}

/// Those of a run that several runs of the same deck have in common, and how many runs.
void add_scatter_options(CLI::App& scatter, Options& options, double& perturbation) {
  scatter.footer(
      "Runs the deck as it is (run_000) and with nodes moved at random, nodes at one place alike, and "
      "writes\n"
      "bands.csv: median, 5th and 95th percentile of every history over the runs.");
  scatter.add_option("-o,--output", options.folder,
                     "Folder of the results [the deck's name with .scatter, here]");
  scatter.add_option("-t,--threads", options.threads, "Runs at once, each on one thread [1]")
      ->check(CLI::Range(1, 1024));
  scatter.add_option("--runs", options.scatter_runs, "Runs, with the unperturbed one [8]")
      ->check(CLI::Range(2, 1000));
  scatter.add_option("--perturb", perturbation, "Largest move of a node over the model's size [1e-6]")
      ->check(number_that("a positive number up to 1", [](double value) { return value > 0 && value <= 1; }));
  scatter.add_option("--seed", options.seed, "Seed of run_001; the others follow [1]");
  scatter.add_option("--precision", options.precision, "Arithmetic of elements and contact [double]")
      ->check(CLI::IsMember({"mixed", "double"}));
  scatter.add_option("--end", options.end_time, "End time, instead of the deck's")
      ->check(number_that("a positive number", [](double value) { return value > 0; }));
  scatter.add_flag("--report", options.report,
                   "Write report.html, a page of the unperturbed run with the bands, at the end");
  scatter.add_flag("-q,--quiet", options.quiet, "Print warnings and errors only");
}

/// `12`, `40%` or `last`.
CLI::Validator frame_choice() {
  return CLI::Validator(
      [](const std::string& text) {
        const std::string digits = text.ends_with('%') ? text.substr(0, text.size() - 1) : text;
        const bool number = !digits.empty() && digits.size() < 7 &&
                            digits.find_first_not_of("0123456789") == std::string::npos;
        return number || text == "last" ? std::string() : text + " is not a number, a share as 40% or last";
      },
      "FRAME");
}

void add_report_options(CLI::App& report, ReportOptions& options) {
  report.add_option("folder", options.folder, "Folder of a run's results, or of crumple scatter")->required();
  report.add_option("-o,--output", options.file, "The file to write [report.html in that folder]");
  report.add_option("--template", options.template_file,
                    "The page to put the result into [the one of the build]");
  PictureOptions& pictures = options.pictures;
  report.add_flag("--png", pictures.wanted, "Draw pictures of it as well (with chromium): report_1.png, ...");
  report
      .add_option("--frame", pictures.frames,
                  "Frame of a picture: a number, 40% of the run, or last; may be repeated [0% 50% 100%]")
      ->allow_extra_args(false)
      ->check(frame_choice());
  report.add_option("--field", pictures.field, "Fringe of the pictures, as von_mises; none colours by part");
  report.add_option("--view", pictures.view, "Side that pictures are seen from")
      ->check(CLI::IsMember({"iso", "+x", "-x", "+y", "-y", "+z", "-z"}));
  report.add_option("--width", pictures.width, "Width of the pictures in pixels [1200]")
      ->check(CLI::Range(200, 8000));
  report.add_option("--height", pictures.height, "Height of the pictures in pixels [750]")
      ->check(CLI::Range(200, 8000));
  report
      .add_option(
          "--serve", options.serve,
          "Write no file but show the folder, to which a run may still be adding, until Ctrl-C, at an\n"
          "address with a random token, which is printed; port 0 takes any free one")
      ->check(port_number())
      ->excludes("--output")
      ->excludes("--png");
  add_token_option(report, options.token);
  report.add_flag("-q,--quiet", options.quiet, "Print errors only");
}

void require_deck(const Options& options) {
  if (options.deck.empty()) throw CLI::RequiredError("deck");
}

}  // namespace

std::optional<RestartInterval> parse_restart_interval(const std::string& text) {
  struct Unit {
    std::string_view name;
    double seconds;
  };
  constexpr Unit units[] = {{"", 0}, {"s", 1}, {"min", 60}, {"m", 60}, {"h", 3600}};
  const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
  for (const Unit& unit : units) {
    double value = 0;
    if (text.substr(end) != unit.name || !CLI::detail::lexical_cast(text.substr(0, end), value)) continue;
    if (!(value > 0) || value > 1e9) return std::nullopt;
    if (unit.seconds > 0) return RestartInterval{0, value * unit.seconds};
    const long cycles = std::lround(value);
    if (static_cast<double>(cycles) == value) return RestartInterval{cycles, 0};
  }
  return std::nullopt;
}

std::string program_version() {
  return "crumple " CRUMPLE_VERSION;
}

CommandLine parse_command_line(const std::vector<std::string>& arguments) {
  CommandLine line;
  CLI::App program("crumple: explicit finite element solver for crash and contact-impact", "crumple");
  program.set_version_flag("-V,--version", program_version());
  program.footer(examples);
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  CLI::App* run = program.add_subcommand("run", "Run an LS-DYNA keyword deck");
  CLI::App* check =
      program.add_subcommand("check", "Read a deck, say what it holds and what is wrong with it");
  CLI::App* bench =
      program.add_subcommand("bench", "Measure this machine: the time step of shells, the contact search");
  bench->footer(bench_words);
  add_machine_options(*bench, line.options);
  CLI::App* report = program.add_subcommand("report", "Write one HTML file that shows the result of a run");
  add_report_options(*report, line.report);
  CLI::App* compare =
      program.add_subcommand("compare", "Rate the histories of two results against each other");
  add_compare_arguments(*compare, line.compare);
  CLI::App* keywords =
      program.add_subcommand("keywords", "List the keywords that decks may have, or the cards of some");
  keywords->add_option("names", line.keywords.names, "Keywords to show with cards and fields");
  keywords->add_flag("--json", line.keywords.json, "Everything, for programs");
  bool automatic_contact = false;
  add_reading_options(*run, line.options, automatic_contact);
  add_run_options(*run, line.options);
  add_restart_options(*run, line.options);
  add_reading_options(*check, line.options, automatic_contact);
  check->add_flag(
      "--json", line.options.json,
      "Print the answer for programs: whether the deck can be run, what has no effect, what is missing");
  CLI::App* scatter =
      program.add_subcommand("scatter", "Run a deck several times, perturbed: how far results scatter");
  double scatter_perturbation = 1e-6;
  add_reading_options(*scatter, line.options, automatic_contact);
  add_scatter_options(*scatter, line.options, scatter_perturbation);
  try {
    std::vector<std::string> own = translate_foreign_arguments(arguments, line.options.notes);
    // CLI11 takes its arguments from the back of the list.
    std::reverse(own.begin(), own.end());
    program.parse(own);
    if ((run->parsed() && line.options.restart.empty()) || check->parsed() || scatter->parsed())
      require_deck(line.options);
  } catch (const CLI::ParseError& stop) {
    std::ostringstream out;
    std::ostringstream err;
    const int code = program.exit(stop, out, err);
    line.command = code == 0 ? Command::Help : Command::Mistake;
    line.text = out.str() + err.str();
    if (code != 0) line.text += forgotten_command(program, arguments);
    return line;
  } catch (const Error& mistake) {
    line.text = fmt::format("{}\nRun with --help for more information.\n", mistake.what());
    return line;
  }
  line.options.automatic_contact = automatic_contact;
  line.options.command = arguments;
  if (scatter->parsed()) line.options.perturbation = scatter_perturbation;
  line.command = run->parsed()        ? Command::Run
                 : check->parsed()    ? Command::Check
                 : scatter->parsed()  ? Command::Scatter
                 : report->parsed()   ? Command::Report
                 : compare->parsed()  ? Command::Compare
                 : keywords->parsed() ? Command::Keywords
                                      : Command::Bench;
  return line;
}

}  // namespace crumple::app
