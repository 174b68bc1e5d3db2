// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/compare_command.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "app/console/print.hpp"
#include "base/error.hpp"
#include "compare/comparison.hpp"
#include "compare/comparison_json.hpp"
#include "compare/comparison_page.hpp"
#include "compare/comparison_text.hpp"
#include "compare/open_results.hpp"
#include "output/files/atomic_file.hpp"
#include "output/files/write_error.hpp"
#include "report/page.hpp"

namespace crumple::app {

namespace {

/// What one unit of time of the results is, for the filter [s]. Throws Error if nobody says.
double seconds_per_unit(const CompareOptions& options) {
  if (options.time_unit == "s") return 1;
  if (options.time_unit == "ms") return 1e-3;
  if (options.time_unit == "us") return 1e-6;
  const double of_reference = compare::guessed_seconds(options.reference);
  const double of_other = compare::guessed_seconds(options.other);
  if (of_reference == 0 && of_other == 0)
    throw Error("The filter needs the unit of time: --time-unit s, ms or us (no run.json tells it).");
  if (of_reference != 0 && of_other != 0 && of_reference != of_other)
    throw Error(
        "By their run.json the two results have different units of time: --time-unit says which one holds.");
  return std::max(of_reference, of_other);
}

compare::ComparisonSettings settings_of(const CompareOptions& options) {
  compare::ComparisonSettings settings;
  settings.quantities = options.quantities;
  for (const std::string& pair : options.pairs) {
    const std::size_t equals = pair.find('=');
    settings.pairs.emplace_back(pair.substr(0, equals), pair.substr(equals + 1));
  }
  settings.cfc = options.cfc;
  if (options.cfc != 0) settings.seconds_per_unit = seconds_per_unit(options);
  settings.interval = options.interval;
  settings.floor = options.floor;
  return settings;
}

/// `rwforc   normal fx fy fz   [1 2]`: one line for each group, as histories of many nodes have many names.
void print_names(const compare::CurveSet& set, const Console& console) {
  print(console.out, "{}:\n", set.source);
  std::vector<std::string> groups;
  for (const compare::Curve& curve : set.curves)
    if (std::find(groups.begin(), groups.end(), curve.group) == groups.end()) groups.push_back(curve.group);
  const auto add_once = [](std::vector<std::string>& list, const std::string& name) {
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  };
  for (const std::string& group : groups) {
    std::vector<std::string> quantities;
    std::vector<std::string> items;
    for (const compare::Curve& curve : set.curves) {
      if (curve.group != group) continue;
      add_once(quantities, curve.quantity);
      if (!curve.item.empty()) add_once(items, curve.item);
    }
    print(console.out, "  {}.\n", group);
    for (const std::string& quantity : quantities) print(console.out, "    {}\n", quantity);
    if (items.empty()) continue;
    print(console.out, "    each of");
    for (const std::string& item : items) print(console.out, " [{}]", item);
    print(console.out, "\n");
  }
}

void print_notes(const compare::CurveSet& set, const Console& console) {
  for (const std::string& note : set.notes) print(console.err, "crumple: warning: {}\n", note);
}

/// One line that is written over on a terminal; nothing elsewhere.
compare::CompareProgress progress_on(const Console& console, bool quiet) {
  return [&console, quiet](std::size_t done, std::size_t all) {
    if (quiet || !console.terminal || (done % 64 != 0 && done != all)) return;
    print(console.out, "\rcurve {} of {}\x1b[K{}", done, all, done == all ? "\r\x1b[K" : "");
    console.out.flush();
  };
}

std::filesystem::path page_of(const CompareOptions& options) {
  return options.template_file.empty() ? compare::find_comparison_template() : options.template_file;
}

struct Sides {
  compare::CurveSet reference;
  compare::CurveSet other;
};

void write_files(const CompareOptions& options, const compare::Comparison& comparison, const Sides& sides,
                 const compare::ComparisonSettings& settings) {
  if (options.json)
    output::write_atomically(*options.json,
                             compare::comparison_json(comparison, sides.reference, sides.other, settings)
                                     .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
                                 "\n");
  if (!options.html) return;
  const report::PageTemplate page(page_of(options));
  output::write_atomically(
      *options.html, page.with(compare::comparison_payload(comparison, sides.reference, sides.other, settings,
                                                           options.tolerance)));
}

ExitCode compare_sides(const CompareOptions& options, const Sides& sides, const Console& console) {
  const compare::ComparisonSettings settings = settings_of(options);
  const compare::Comparison comparison =
      compare::compare(sides.reference, sides.other, settings, progress_on(console, options.quiet));
  if (!options.quiet)
    console.out << compare::comparison_table(comparison, sides.reference, sides.other,
                                             {options.rows, options.tolerance, options.cfc})
                << std::flush;
  write_files(options, comparison, sides, settings);
  if (comparison.curves.empty() && comparison.negligible.empty()) {
    print(console.err,
          "crumple: error: The two have no curve in common{}. --list shows what they have, --pair "
          "brings curves "
          "of different names together.\n",
          options.quantities.empty() ? "" : " among those asked for");
    return ExitCode::Input;
  }
  return options.tolerance && !comparison.within(*options.tolerance) ? ExitCode::Input : ExitCode::Normal;
}

}  // namespace

ExitCode compare_results(const CompareOptions& options, const Console& console) {
  try {
    // That there is a page is better known before the work than after it.
    if (options.html) {
      const report::PageTemplate page(page_of(options));
    }
    const Sides sides{compare::open_results(options.reference), compare::open_results(options.other)};
    print_notes(sides.reference, console);
    print_notes(sides.other, console);
    if (options.list) {
      print_names(sides.reference, console);
      print_names(sides.other, console);
      return ExitCode::Normal;
    }
    return compare_sides(options, sides, console);
  } catch (const output::WriteError& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Output;
  } catch (const Error& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Usage;
  }
}

}  // namespace crumple::app
