// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/arguments/compare_options.hpp"

namespace crumple::app {

/// How often restart files are written besides what the deck says.
struct RestartInterval {
  long cycles = 0;     ///< 0: not by cycles
  double seconds = 0;  ///< wall time; 0: not by wall time [s]
};

/// "500" are cycles; "90s", "30min", "2h" are wall time. Empty if it is neither.
std::optional<RestartInterval> parse_restart_interval(const std::string& text);

/// Elements in the largest group of `--trace-energy`.
inline constexpr int largest_traced_group = 512;

/// What the user asks for on the command line. What is absent is left to the deck, then to the program.
struct Options {
  std::filesystem::path deck;     ///< of a restart that of the changes, if any
  std::filesystem::path restart;  ///< file or folder to take a run up from; empty begins a new one
  RestartInterval restart_every;
  std::filesystem::path folder;             ///< of the results; empty is the deck's name with ".out", here
  std::optional<int> threads;               ///< at least 1
  std::optional<std::string> precision;     ///< "mixed" or "double"
  std::optional<std::string> isa;           ///< one of base's available_isas
  std::optional<std::string> search;        ///< one of cellsearch's methods
  std::optional<std::string> local_search;  ///< "inside-outside" or "pinballs"
  std::optional<double> end_time;           ///< [time]
  std::vector<std::pair<std::string, std::string>> parameters;  ///< names and values, before the deck's
  bool automatic_contact = false;
  bool ls_dyna_defaults = false;  ///< for what the deck leaves open about elements
  bool allow_unsupported = false;
  bool allow_negative_contact_energy = false;
  bool quiet = false;
  bool json = false;                 ///< of `crumple check`: the answer for programs
  bool report = false;               ///< write a report at the end of the run
  std::optional<int> serve;          ///< port of a live page; 0 is any free one
  bool token = true;                 ///< its address has a random token
  bool d3plot = false;               ///< write d3plot files beside ParaView's
  bool all_fields = false;           ///< stress tensors and more in ParaView's frames
  bool dynain = false;               ///< write a deck that goes on from the end of the run
  bool accelerations = false;        ///< keep those of the nodes, for a caller that looks at them
  int trace_energy = 0;              ///< follow the energy balance by groups of so many elements; 0: not
  bool move_apart = false;           ///< move nodes that overlap at the start
  long verify_search = 0;            ///< cycles between comparisons with brute force; 0 is never
  double perturbation = 0;           ///< of the coordinates, relative to the model's size [-]
  std::uint64_t seed = 1;            ///< of the perturbation
  int scatter_runs = 8;              ///< of `crumple scatter`, with the unperturbed one
  std::vector<std::string> command;  ///< the arguments as they were given
  std::vector<std::string> notes;    ///< on arguments that were accepted without effect
};

enum class Command { Run, Check, Scatter, Bench, Report, Compare, Keywords, Help, Mistake };

/// Pictures of a report.
struct PictureOptions {
  bool wanted = false;
  std::vector<std::string> frames = {"0%", "50%", "100%"};  ///< numbers, "last" or shares of the run
  std::optional<std::string>
      field;         ///< name of a field; empty colours by part; the page's own choice if absent
  std::string view;  ///< side to look from; empty is the page's own choice
  int width = 1200;  ///< [pixels]
  int height = 750;  ///< [pixels]
};

/// What `crumple report` is asked for.
struct ReportOptions {
  std::filesystem::path folder;         ///< of a run's results
  std::filesystem::path file;           ///< to write; empty is report.html in the folder
  std::filesystem::path template_file;  ///< empty looks for the one that was built
  std::optional<int> serve;             ///< port of a live page, instead of a file; 0 is any free one
  bool token = true;                    ///< its address has a random token
  PictureOptions pictures;
  bool quiet = false;
};

/// What `crumple keywords` is asked for.
struct KeywordsOptions {
  std::vector<std::string> names;  ///< show the cards of these; empty lists all names
  bool json = false;               ///< everything, for programs
};

struct CommandLine {
  Command command = Command::Mistake;
  Options options;  ///< for all but Help and Mistake
  ReportOptions report;
  CompareOptions compare;
  KeywordsOptions keywords;
  std::string text;  ///< for Help and Mistake: what to tell the user
};

/// Understands crumple's own form (`run deck.k -t 4`), LS-DYNA's (`i=deck.k ncpu=4 memory=200m`) and
/// OpenRadioss's (`-i deck.k -nt 4`). Throws nothing but lack of memory.
CommandLine parse_command_line(const std::vector<std::string>& arguments);

/// "crumple 0.1.0".
std::string program_version();

}  // namespace crumple::app
