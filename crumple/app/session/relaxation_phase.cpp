// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/relaxation_phase.hpp"

#include <ostream>

#include "app/console/print.hpp"
#include "app/session/status_line.hpp"

namespace crumple::app {

namespace {

constexpr double seconds_between_checks_shown = 2;

constexpr const char* relaxation_columns =
    "cycle,time,step,ratio,factor,distortional_energy,kinetic,internal,hourglass,contact,damping,external_"
    "work,total,energy_error";

}  // namespace

RelaxationPhase::RelaxationPhase(const model::Model& model, const domain::Execution& execution,
                                 const Console& console, bool quiet)
    : relaxation_(model, execution), console_(console), quiet_(quiet) {
  relaxation_.start();
}

void RelaxationPhase::open(const std::filesystem::path& folder) {
  table_.emplace(folder / relaxation_file, relaxation_columns);
  if (!quiet_) print(console_.out, "\nDynamic relaxation\n");
  since_start_.restart();
}

void RelaxationPhase::step() {
  if (!relaxation_.step()) return;
  add_row();
  if (quiet_ || since_start_.seconds() < next_line_seconds_) return;
  print_line();
  next_line_seconds_ = since_start_.seconds() + seconds_between_checks_shown;
}

void RelaxationPhase::add_row() {
  const domain::Domain& domain = relaxation_.simulation().domain();
  const domain::EnergyLedger& energy = domain.energy;
  table_->add_row(domain.clock.cycle, domain.clock.time, domain.clock.step, relaxation_.ratio(),
                  relaxation_.factor(), relaxation_.distortional_energy(), energy.kinetic, energy.internal,
                  energy.hourglass, energy.contact, energy.damping, energy.external_work, energy.total(),
                  energy.error());
  table_->flush();
}

void RelaxationPhase::print_line() {
  const domain::Clock& clock = relaxation_.simulation().domain().clock;
  line_cycle_ = clock.cycle;
  print(console_.out, "  dynamic relaxation: cycle {}, time {:.6g}, ratio {:.4g}\n", clock.cycle, clock.time,
        relaxation_.ratio());
  console_.out.flush();
}

void RelaxationPhase::close() {
  const long cycle = relaxation_.simulation().domain().clock.cycle;
  if (cycle > 0 && !relaxation_.converged()) add_row();
  if (!quiet_ && line_cycle_ != cycle) print_line();
}

output::RelaxationRecord RelaxationPhase::record() const {
  const domain::Domain& domain = relaxation_.simulation().domain();
  return {.cycles = domain.clock.cycle,
          .converged = relaxation_.converged() ? 1 : 0,
          .time = domain.clock.time,
          .ratio = relaxation_.ratio(),
          .factor = relaxation_.factor(),
          .energy_error = domain.energy.error(),
          .seconds = since_start_.seconds()};
}

void print_relaxation(const Console& console, const output::RelaxationRecord& record) {
  print(console.out,
        "\nDynamic relaxation: {} after {} cycles, to its time {:.6g} in {}; ratio {:.4g}, energy error "
        "{:.4f} %\n",
        record.converged != 0 ? "converged" : "not converged", record.cycles, record.time,
        format_duration(record.seconds), record.ratio, 100 * record.energy_error);
}

}  // namespace crumple::app
