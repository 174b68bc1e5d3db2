// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/check_command.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "app/console/print.hpp"
#include "app/preparation/left_out.hpp"
#include "app/preparation/model_summary.hpp"
#include "app/preparation/preparation.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "elements/elements.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::app {

namespace {

void print_steps(std::ostream& out, const timeloop::Simulation& simulation) {
  const model::Model& model = simulation.model();
  print(out, "\nTime steps (factor {:g} included)\n", model.control.step_scale);
  std::vector<double> steps(model.parts.size(), std::numeric_limits<double>::infinity());
  for (const domain::ShellBlock& block : simulation.domain().shells)
    steps[block.part] = std::min(steps[block.part], elements::stable_step(simulation.domain(), block));
  for (const domain::SolidBlock& block : simulation.domain().solids)
    steps[block.part] = std::min(steps[block.part], elements::stable_step(simulation.domain(), block));
  for (const domain::BeamBlock& block : simulation.domain().beams)
    steps[block.part] = std::min(steps[block.part], elements::stable_step(simulation.domain(), block));
  for (const domain::DiscreteBlock& block : simulation.domain().discretes)
    steps[block.part] = std::min(steps[block.part], elements::stable_step(simulation.domain(), block));
  for (std::size_t part = 0; part < steps.size(); ++part)
    if (model::is_rigid(model, model.parts[part]))
      print(out, "  part {:<8} rigid\n", model.parts[part].id);
    else if (std::isfinite(steps[part]))
      print(out, "  part {:<8} {:.4e}\n", model.parts[part].id, model.control.step_scale * steps[part]);
  const domain::ControllingElement controlling = elements::controlling_element(model, simulation.domain());
  // DTINIT is the first step alone; those behind it grow to what the elements allow.
  const double usual = std::max(simulation.next_step(),
                                model.control.initial_step > 0
                                    ? model.control.step_scale * simulation.domain().clock.element_limit
                                    : 0.0);
  const double cycles = std::ceil(model.control.end_time / usual);
  print(out, "  first step {:.4e}, controlled by {} {} of part {}; about {:.0f} {} to the end time\n",
        simulation.next_step(), controlling.kind, controlling.element, controlling.part, cycles,
        cycles == 1 ? "cycle" : "cycles");
}

nlohmann::json json_of(const output::LeftOut& item) {
  return {{"name", item.name}, {"count", item.count}, {"place", item.place}};
}

nlohmann::json json_of(const deck::Diagnostic& diagnostic) {
  const char* const severity = diagnostic.severity == deck::Severity::Error     ? "error"
                               : diagnostic.severity == deck::Severity::Warning ? "warning"
                                                                                : "note";
  return {{"severity", severity},          {"file", diagnostic.file},  {"line", diagnostic.line},
          {"keyword", diagnostic.keyword}, {"card", diagnostic.card},  {"field", diagnostic.field},
          {"message", diagnostic.message}, {"count", diagnostic.count}};
}

nlohmann::json parameters_of(const deck::ReadResult& deck) {
  nlohmann::json json = nlohmann::json::object();
  for (const deck::SetParameter& parameter : deck.parameters)
    json[parameter.name] = {{"value", parameter.value},
                            {"source", parameter.is_preset ? "command line" : "deck"}};
  return json;
}

/// What is left out, by reason, and how many cards that are in all.
void add_left_out_lists(const deck::ReadResult& deck, nlohmann::json& json) {
  using Reason = output::LeftOutReason;
  constexpr std::pair<Reason, const char*> lists[] = {{Reason::WithoutEffect, "without_effect"},
                                                      {Reason::OnRequest, "left_out"},
                                                      {Reason::NotSupported, "missing"}};
  for (const auto& [reason, name] : lists) {
    int count = 0;
    nlohmann::json items = nlohmann::json::array();
    for (const output::LeftOut& item : left_out_of(deck)) {
      if (item.reason != reason) continue;
      items.push_back(json_of(item));
      count += item.count;
    }
    json[name] = items;
    json["counts"][name] = count;
  }
}

/// The reading, then a start of the run, as a deck may be refused by either.
ExitCode check_for_programs(const Options& options, const Console& console) {
  std::ostringstream messages;
  const deck::ReadResult deck = read_with_options(options, {messages, messages});
  nlohmann::json json;
  json["deck"] = options.deck.string();
  std::string fault;
  if (deck.model) {
    try {
      timeloop::Simulation simulation(*deck.model, choose_execution(options, *deck.model));
      simulation.start();
    } catch (const Error& error) {
      fault = error.what();
    }
  }
  const bool can_run = deck.model && fault.empty();
  json["can_run"] = can_run;
  json["errors"] = can_run ? 0 : std::max(1, deck::error_count(deck.diagnostics));
  json["fault"] = fault;
  json["files"] = nlohmann::json::array();
  for (const auto& file : deck.files) json["files"].push_back(file.string());
  json["parameters"] = parameters_of(deck);
  json["deck_hash"] = fmt::format("{:016x}", deck.text_hash);
  json["deck_hash_with_parameters"] = fmt::format("{:016x}", deck::hash_with_parameters(deck));
  add_left_out_lists(deck, json);
  json["messages"] = nlohmann::json::array();
  for (const deck::Diagnostic& diagnostic : deck.diagnostics) json["messages"].push_back(json_of(diagnostic));
  console.out << json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  return can_run ? ExitCode::Normal : ExitCode::Input;
}

}  // namespace

ExitCode check_deck(const Options& options, const Console& console) {
  if (options.json) return check_for_programs(options, console);
  const deck::ReadResult deck = read_with_options(options, console);
  print(console.out, "{}\n", program_version());
  print_reading(console.out, deck);
  if (deck.model) {
    try {
      timeloop::Simulation simulation(*deck.model, choose_execution(options, *deck.model));
      simulation.start();
      warn_of_ties(console.err, *deck.model, simulation.domain());
      print_model(console.out, *deck.model, simulation.domain());
      print_steps(console.out, simulation);
      const auto warnings = deck.diagnostics.size();
      print(console.out, "\nThe deck can be run{}.\n",
            warnings > 0 ? fmt::format(", with {}{}", counted(warnings, "warning"),
                                       warnings == 1 ? " or note" : " or notes")
                         : "");
      return ExitCode::Normal;
    } catch (const Error& fault) {
      print(console.err, "{}: error: {}\n", options.deck.string(), fault.what());
    }
  }
  print(console.out, "\nThe deck cannot be run: {}.\n",
        counted(std::max(1, deck::error_count(deck.diagnostics)), "error"));
  return ExitCode::Input;
}

}  // namespace crumple::app
