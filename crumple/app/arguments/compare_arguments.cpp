// SPDX-License-Identifier: BSD-3-Clause
#include "app/arguments/compare_arguments.hpp"

#include <cmath>
#include <string>

namespace crumple::app {

namespace {

constexpr const char* words = R"(A is the reference. A and B are folders of results, or single files:
  our own tables (glstat.csv, rwforc.csv, ...), LS-DYNA's binout0000 ... and its text files glstat, matsum, rwforc,
  rcforc, nodout, time histories of OpenRadioss as CSV (th_to_csv), any CSV with the time in its first column

Examples:
  crumple compare old.out new.out                       all histories, the worst difference first
  crumple compare dyna/ deck.out --html compare.html    against LS-DYNA, with curves to look at in a browser
  crumple compare a.out b.out --quantity rwforc --cfc 60      forces on rigid walls, both through SAE CFC 60
  crumple compare a.out b.out --tolerance 0.02 -q       for scripts: exit code 1 if a curve differs by more than 2 %
  crumple compare a.out b.out --list                    names of the curves of both
  crumple compare runT01.csv deck.out --pair "th.wall 1 wall FNX=rwforc.fx[1]"

Scores: Sprague-Geers M (magnitude), P (phase), C (both), 0 is perfect; ISO/TS 18571 from 0 to 1, 1 is perfect:
excellent above 0.94, good above 0.80, fair above 0.58, else poor. docs/compare.md has the formulas.

Exit codes: 0 compared, and within --tolerance if given; 1 something differs beyond it, or nothing is common;
2 wrong command line, or A or B cannot be read; 4 a file cannot be written)";

CLI::Validator not_below(double least, bool may_be_least) {
  return CLI::Validator(
      [=](const std::string& text) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) &&
                          (value > least || (may_be_least && value == least));
        return good ? std::string()
                    : text + (may_be_least ? " is negative or no number" : " is no positive number");
      },
      "");
}

CLI::Validator name_pair() {
  return CLI::Validator(
      [](const std::string& text) {
        const std::size_t equals = text.find('=');
        const bool good = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
        return good ? std::string() : text + " is not the names of two curves with = between them";
      },
      "NAME=NAME");
}

}  // namespace

void add_compare_arguments(CLI::App& command, CompareOptions& options) {
  command.footer(words);
  command.add_option("A", options.reference, "Folder or file of the reference")->required();
  command.add_option("B", options.other, "Folder or file of what is compared with it")->required();
  command
      .add_option("--quantity", options.quantities,
                  "Only this quantity (fx), group (rwforc), rwforc.fx or rwforc.fx[1]; may be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--pair", options.pairs,
                  "Compare two curves of different names, the reference's and the other's; may be repeated")
      ->allow_extra_args(false)
      ->check(name_pair());
  command.add_option("--json", options.json, "Write all scores to this file");
  command.add_option("--html", options.html, "Write a page with the curves and the table to this file");
  command.add_option("--template", options.template_file, "The page to put them into [the one of the build]");
  command.add_option("--cfc", options.cfc, "Filter all curves by an SAE J211 channel frequency class")
      ->check(CLI::IsMember({60, 180, 600}));
  command
      .add_option("--time-unit", options.time_unit,
                  "Unit of the times, for --cfc [as run.json of A or B has it]")
      ->check(CLI::IsMember({"s", "ms", "us"}));
  command
      .add_option("--interval", options.interval,
                  "Time between the samples that are rated [101 to 2001 samples, as the finer curve has]")
      ->check(not_below(0, false));
  command
      .add_option("--tolerance", options.tolerance,
                  "Largest difference over the peak of the reference that is accepted, as 0.01")
      ->check(not_below(0, true));
  command
      .add_option("--floor", options.floor,
                  "Do not rate curves below this share of the largest of their kind on both sides [0.01]")
      ->check(not_below(0, true));
  command.add_option("--rows", options.rows, "Rows of the table, 0 for all [40]");
  command.add_flag("--list", options.list, "Print the names of the curves of A and B, compare nothing");
  command.add_flag("-q,--quiet", options.quiet, "Print errors only");
}

}  // namespace crumple::app
