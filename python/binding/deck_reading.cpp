// SPDX-License-Identifier: BSD-3-Clause
#include "binding/deck_reading.hpp"

#include <sstream>

#include "app/console/console.hpp"
#include "app/preparation/preparation.hpp"
#include "deck/format/parameters.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::python {

namespace {

void require_parameters(const app::Options& options) {
  for (const auto& [name, value] : options.parameters)
    if (!deck::Parameters().preset(name, value)) {
      std::string text = name;
      text += "=" + value + " is not the name of a parameter, = and a number";
      throw InputError(text);
    }
}

/// The lines behind those of the diagnostics.
std::vector<std::string> other_lines(const deck::ReadResult& result, const std::string& console) {
  std::istringstream text(console);
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t number = 0; std::getline(text, line); ++number)
    if (number >= result.diagnostics.size()) lines.push_back(line);
  return lines;
}

}  // namespace

std::shared_ptr<const DeckReading> read_deck(app::Options options) {
  require_parameters(options);
  auto reading = std::make_shared<DeckReading>();
  reading->options = std::move(options);
  std::ostringstream text;
  reading->result = app::read_with_options(reading->options, {text, text});
  reading->console = text.str();
  if (!reading->console.empty()) reading->console.pop_back();  // the end of the last line
  reading->faults = other_lines(reading->result, reading->console);
  return reading;
}

std::string fault_at_start(const DeckReading& deck) {
  try {
    const model::Model& model = *deck.result.model;
    timeloop::Simulation simulation(model, app::choose_execution(deck.options, model));
    simulation.start();
  } catch (const Error& fault) {
    return deck.options.deck.string() + ": error: " + fault.what();
  }
  return {};
}

}  // namespace crumple::python
