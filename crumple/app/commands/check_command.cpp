// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/check_command.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <vector>

#include "app/console/print.hpp"
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
  const double cycles = std::ceil(model.control.end_time / simulation.next_step());
  print(out, "  first step {:.4e}, controlled by {} {} of part {}; about {:.0f} {} to the end time\n",
        simulation.next_step(), controlling.kind, controlling.element, controlling.part, cycles,
        cycles == 1 ? "cycle" : "cycles");
}

}  // namespace

ExitCode check_deck(const Options& options, const Console& console) {
  const deck::ReadResult deck = read_with_options(options, console);
  print(console.out, "{}\n", program_version());
  print_reading(console.out, deck);
  if (deck.model) {
    try {
      timeloop::Simulation simulation(*deck.model, choose_execution(options, *deck.model));
      simulation.start();
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
