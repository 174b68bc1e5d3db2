// SPDX-License-Identifier: BSD-3-Clause
#include "app/preparation/preparation.hpp"

#include <cellsearch/method.hpp>
#include <ostream>

#include "app/console/print.hpp"
#include "app/preparation/perturbation.hpp"
#include "base/error.hpp"
#include "base/lanes.hpp"

namespace crumple::app {

namespace {

void apply_options(const Options& options, model::Model& model) {
  if (options.end_time) model.control.end_time = *options.end_time;
  if (options.search) model.search.method = *options.search;
  if (options.local_search)
    model.search.local = *options.local_search == "pinballs" ? model::LocalSearchKind::Pinballs
                                                             : model::LocalSearchKind::InsideOutside;
  if (options.perturbation > 0) perturb_coordinates(model, options.perturbation, options.seed);
}

deck::ReadOptions reading_of(const Options& options) {
  deck::ReadOptions reading;
  reading.allow_unsupported = options.allow_unsupported;
  reading.end_time = options.end_time;
  reading.parameters = options.parameters;
  reading.automatic_contact = options.automatic_contact;
  reading.ls_dyna_defaults = options.ls_dyna_defaults;
  reading.keep_texts = true;
  for (const cellsearch::Method method : cellsearch::methods())
    reading.search_methods.emplace_back(name_of(method));
  return reading;
}

/// Tells what is wrong, and puts what the command line asks for into the model.
deck::ReadResult with_options(deck::ReadResult deck, const Options& options, const Console& console) {
  for (const deck::Diagnostic& diagnostic : deck.diagnostics)
    if (!options.quiet || diagnostic.severity != deck::Severity::Note)
      print(console.err, "{}\n", deck::to_string(diagnostic));
  if (!deck.model) return deck;
  apply_options(options, *deck.model);
  const std::vector<std::string> faults = model::faults(*deck.model);
  for (const std::string& fault : faults) print(console.err, "{}: error: {}\n", options.deck.string(), fault);
  if (!faults.empty()) deck.model.reset();
  return deck;
}

}  // namespace

deck::ReadResult read_with_options(const Options& options, const Console& console) {
  return with_options(deck::read_deck(options.deck, reading_of(options)), options, console);
}

deck::ReadResult read_again(const Options& options, const std::filesystem::path& changes,
                            const std::vector<deck::RecordedText>& texts, const Console& console) {
  const deck::ReadOptions reading = reading_of(options);
  if (changes.empty()) return with_options(deck::read_recorded_deck(texts, reading), options, console);
  return with_options(deck::read_recorded_deck(texts, reading, changes), options, console);
}

domain::Execution choose_execution(const Options& options, const model::Model& model) {
  domain::Execution execution;
  const std::string precision =
      options.precision.value_or(model.run.precision.empty() ? "double" : model.run.precision);
  if (precision != "mixed" && precision != "double")
    throw Error(fmt::format("Precision \"{}\" does not exist: mixed and double do.", precision));
  execution.precision = precision == "mixed" ? Precision::Mixed : Precision::Double;
  execution.isa = options.isa ? parse_isa(*options.isa) : default_isa();
  // Not all cores: threads that wait for each other every cycle are slower than one where the machine has
  // other work too, so whoever has it for himself says so.
  execution.threads = options.threads.value_or(1);
  if (options.trace_energy > 0)
    execution.groups_per_chunk = std::min(options.trace_energy, largest_traced_group) / lanes;
  return execution;
}

}  // namespace crumple::app
