// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/run_summary.hpp"

#include <algorithm>
#include <array>
#include <ostream>
#include <string_view>

#include "app/console/print.hpp"
#include "app/preparation/left_out.hpp"
#include "app/session/status_line.hpp"
#include "base/counted.hpp"
#include "base/isa.hpp"
#include "elements/elements.hpp"
#include "output/run_record.hpp"

namespace crumple::app {

namespace {

struct Stage {
  std::string_view name;
  double seconds;
};

void print_timings(std::ostream& out, const domain::Domain& domain, double loop_seconds) {
  const domain::StageTimes& times = domain.times;
  std::array<Stage, 8> stages{{{"elements", times.elements},
                               {"contact search (global)", times.contact_search},
                               {"contact search (local)", times.contact_local},
                               {"contact forces", times.contact_forces},
                               {"constraints", times.constraints},
                               {"integration", times.integrate},
                               {"output", times.output},
                               {"other", loop_seconds}}};
  for (std::size_t i = 0; i + 1 < stages.size(); ++i) stages.back().seconds -= stages[i].seconds;
  print(out, "\n{:<28} {:>10} {:>8} {:>22}\n", "Timings", "seconds", "share", "ns per element-cycle");
  const auto row = [&](std::string_view name, double seconds) {
    print(out, "  {:<26} {:>10.3f} {:>6.1f} % {:>22.2f}\n", name, seconds,
          loop_seconds > 0 ? 100 * seconds / loop_seconds : 0.0,
          output::nanoseconds_per_element_cycle(domain, seconds));
  };
  for (const Stage& stage : stages) row(stage.name, stage.seconds);
  row("total", loop_seconds);
}

void print_lost(std::ostream& out, const domain::LostContacts& lost, std::string_view what,
                std::string_view where) {
  if (lost.count > 0)
    print(out, "  {} without being released: {}, the first at node {} and element {} in cycle {}\n", where,
          counted(lost.count, what), lost.node, lost.segment, lost.cycle);
}

/// What sees the edges that a contact has let through.
std::string_view edges_left_out(const model::Model& model, UserId contact) {
  const auto found = std::ranges::find(model.contacts, contact, &model::Contact::id);
  if (found == model.contacts.end() || found->edges == model::ContactEdges::All) return "";
  return found->edges == model::ContactEdges::Free
             ? "\n  edges inside of a surface take no part: AUTOMATIC_GENERAL_INTERIOR sees them"
             : "\n  edges take no part: AUTOMATIC_GENERAL sees free ones, AUTOMATIC_GENERAL_INTERIOR all";
}

void print_worst_intersections(std::ostream& out, const domain::WorstIntersections& worst) {
  if (worst.count > 0)
    print(
        out,
        "\n  most of the run, without those of the start: {} in cycle {} at time {:.6g}, the first {} and {}",
        counted(worst.count, "pair"), worst.cycle, worst.time, worst.first_segment, worst.second_segment);
}

void print_inspection(std::ostream& out, const model::Model& model, const domain::ContactReport& contact) {
  const domain::ContactInspection& seen = contact.inspection;
  if (!contact.initial_overlaps.empty())
    print(out, "  {} overlapped at the start, by up to {:.4g}: the contact distance is reduced there\n",
          counted(contact.initial_overlaps.size(), "pair"), contact.initial_overlaps.front().depth);
  const domain::OverlapForces& pushed = contact.overlap_forces;
  if (pushed.overlap_impulse > 0)
    print(out,
          "  pairs with a reduced contact distance carried {:.3g} % of the impulse, at most the force {:.4g} "
          "(node {})\n",
          100 * pushed.share(), pushed.largest, pushed.node);
  if (!seen.made) return;
  print(out,
        "  depth at the end over that of the mid-surface, or of the whole solid: largest {:.3f}, 99th "
        "percentile {:.3f}; {} beyond it\n"
        "  mid-surfaces cut through each other at the end: {} of segments",
        seen.largest_depth, seen.percentile_99, counted(seen.nodes_beyond, "node"),
        counted(seen.intersections, "pair"));
  if (seen.initial_intersections > 0)
    print(out, ", {} of them where the undeformed ones do", seen.initial_intersections);
  if (seen.intersections > 0)
    print(out, ", the first{} {} and {}",
          seen.initial_intersections > 0 && seen.intersections > seen.initial_intersections ? " other" : "",
          seen.first_segment, seen.second_segment);
  print_worst_intersections(out, contact.worst_intersections);
  if (contact.worst_intersections.count > 0) print(out, "{}", edges_left_out(model, contact.id));
  if (seen.nodes_in_solids > 0)
    print(out, "\n  in solids without contact: {}, the first {}", counted(seen.nodes_in_solids, "node"),
          seen.node_in_solid);
  print(out, "\n");
}

/// Per element and cycle of the whole model, as in the table of all stages, so that they add up.
void print_contact_times(std::ostream& out, const domain::Domain& domain, const domain::ContactTimes& times) {
  const auto cost = [&](double seconds) { return output::nanoseconds_per_element_cycle(domain, seconds); };
  print(out, "  cost [ns/element-cycle]: global search {:.2f}, local search {:.2f}, forces {:.2f}\n",
        cost(times.search), cost(times.local), cost(times.forces));
}

void print_contacts(std::ostream& out, const output::View& view) {
  const domain::Domain& domain = view.domain;
  double work = 0;
  for (std::size_t i = 0; i < domain.contacts.size(); ++i) {
    const domain::ContactReport& contact = domain.contacts[i];
    const auto searches = static_cast<double>(std::max(contact.searches, 1L));
    work += searches * contact.segments;
    print(out,
          "\nContact {} ({}): {}, one in {:.1f} cycles; {}, {:.0f} candidates a search\n"
          "  pairs in contact now {}, worst penetration {:.4g} now, {:.4g} ever (node {})\n",
          contact.id, contact.method,
          contact.searches == 1 ? "1 search" : fmt::format("{} searches", contact.searches),
          static_cast<double>(domain.clock.cycle) / searches, counted(contact.segments, "segment"),
          static_cast<double>(contact.candidates) / searches, contact.active_pairs, contact.penetration,
          contact.worst_penetration, contact.worst_node);
    if (contact.withheld.count > 0)
      print(out,
            "  contact forces limited because they would have created energy: {} pair-cycles, the largest "
            "excess {:.4g} on node {} at element {} in cycle {}\n",
            contact.withheld.count, contact.withheld.largest, contact.withheld.node, contact.withheld.segment,
            contact.withheld.cycle);
    if (contact.deepest.share > 0)
      print(
          out,
          "  deepest of the run over the whole thickness of the shell, or half of the solid: {:.3f}, node {} "
          "at element {} in cycle {}\n",
          contact.deepest.share, contact.deepest.node, contact.deepest.segment, contact.deepest.cycle);
    print_lost(out, contact.lost_nodes, "node", "lost beyond a surface");
    print_lost(out, contact.lost_edges, "edge pair", "lost after they had gone through each other");
    print_inspection(out, view.model, contact);
    print_contact_times(out, domain, contact.times);
  }
  if (work > 0)
    print(out, "  global search: {:.1f} ns per segment and search\n",
          1e9 * domain.times.contact_search * domain.execution.threads / work);
}

void print_tied_nodes(std::ostream& out, const domain::Domain& domain) {
  for (const domain::Tie& tie : domain.ties) {
    print(out, "\nTied contact {}: {} tied", tie.id,
          counted(static_cast<Index>(tie.nodes.size()) - tie.released, "node"));
    if (tie.released > 0) print(out, ", {} released, {} of these broken", tie.released, tie.broken);
    print(out, "; energy {:.6e}\n", tie.energy);
  }
  for (const domain::Embedding& embedding : domain.embeddings)
    if (embedding.released > 0)
      print(out, "\n{}: {} released as solids eroded or the time was over; energy {:.6e}\n", embedding.name(),
            counted(embedding.released, "node"), embedding.lost);
}

void print_energies(std::ostream& out, const output::View& view, double error) {
  const domain::EnergyLedger& energy = view.domain.energy;
  print(out, "\nEnergies\n");
  const auto row = [&](std::string_view name, double value) {
    print(out, "  {:<26} {:>13.6e}\n", name, value);
  };
  row("kinetic", energy.kinetic);
  row("internal", energy.internal);
  row("hourglass", energy.hourglass);
  const double of_material = output::material_hourglass_energy(view);
  if (of_material != 0) row("  of it material stiffness", of_material);
  row("contact", energy.contact);
  if (energy.contact_dissipated != 0) row("  of it dissipated", energy.contact_dissipated);
  row("contact friction", energy.friction);
  row("rigid walls", energy.rigidwall);
  row("damping", energy.damping);
  row("eroded", energy.eroded);
  row("total", energy.total());
  row("initial total", energy.initial_total);
  row("external work", energy.external_work);
  print(out, "  {:<26} {:>13.8f}\n", "energy ratio", energy.ratio());
  print(out, "  {:<26} {:>13.4f} %  of what was absorbed or damped\n", "energy error", 100 * error);
  if (energy.internal > 0)
    print(out, "  {:<26} {:>13.4f} %  of internal\n", "hourglass", 100 * energy.hourglass / energy.internal);
}

std::string_view plural_of(model::ElementKind kind) {
  switch (kind) {
    case model::ElementKind::Shell:
      return "shells";
    case model::ElementKind::Solid:
      return "solids";
    case model::ElementKind::Beam:
      return "beams";
    case model::ElementKind::Discrete:
      return "discrete elements";
  }
  return "";
}

/// Which parts have lost elements, if any; few beams, which may be welds, by their numbers.
void print_eroded(std::ostream& out, const output::View& view) {
  constexpr Index named = 10;
  bool first = true;
  for (const domain::ElementBlock* const each : view.domain.blocks()) {
    const domain::ElementBlock& block = *each;
    if (block.eroded == 0) continue;
    if (first) print(out, "\nEroded elements\n");
    first = false;
    const model::Part& part = view.model.parts[block.part];
    const model::ElementKind kind = model::kind_of(part);
    print(out, "  part {:<21} {:>13} of {} {}, with the energy {:.6e}\n", part.id, block.eroded,
          block.elements, plural_of(kind), block.eroded_energy);
    const domain::StateItem* const active = block.find("active");
    if (kind != model::ElementKind::Beam || block.eroded > named || active == nullptr) continue;
    print(out, "    beams");
    for (Index e = 0; e < block.elements; ++e)
      if (block.state(e, active->first) == 0) print(out, " {}", view.model.beams[block.element[e]].id);
    print(out, "\n");
  }
}

/// Thick shells of a fine mesh that may touch themselves come closer than their thickness.
void print_thickness_cuts(std::ostream& out, const std::vector<domain::ContactReport>& contacts) {
  for (const domain::ContactReport& contact : contacts) {
    const domain::ThicknessCut& cut = contact.thickness_cut;
    if (cut.shells > 0)
      print(out,
            "  contact {}: {} with a contact thickness of 0.4 of the shortest edge, as the surface may touch "
            "itself; most at element {} of part {}, from {:.4g} to {:.4g}\n",
            contact.id, counted(cut.shells, "shell"), cut.shell, cut.part, cut.from, cut.to);
  }
}

/// With as many digits as it takes to see that it is beyond the limit.
std::string value_beside_limit(const output::Check& check) {
  const std::string value = fmt::format("{:.4g}", check.value);
  const bool alike = !check.pass && value == fmt::format("{:.4g}", check.limit);
  return alike ? fmt::format("{:.10g}", check.value) : value;
}

}  // namespace

void print_run_settings(std::ostream& out, const timeloop::Simulation& simulation,
                        const std::filesystem::path& folder) {
  const model::Model& model = simulation.model();
  const domain::Execution& execution = simulation.domain().execution;
  const domain::ControllingElement controlling = elements::controlling_element(model, simulation.domain());
  print(out, "\nRun\n");
  print(out, "  end time              {:.6g}\n", model.control.end_time);
  print(out, "  first step            {:.4e}, controlled by {} {} of part {}\n", simulation.next_step(),
        controlling.kind, controlling.element, controlling.part);
  print(out, "  arithmetic            {}, {}, {}\n",
        execution.precision == Precision::Mixed ? "mixed precision" : "double precision",
        isa_name(execution.isa), counted(execution.threads, "thread"));
  if (!model.contacts.empty()) print(out, "  contact search        {}\n", model.search.method);
  print_thickness_cuts(out, simulation.domain().contacts);
  print(out, "  results in            {}\n", folder.string());
  out.flush();
}

void print_summary(std::ostream& out, const output::View& view, const output::PeakValues& peaks,
                   double loop_seconds) {
  const domain::Domain& domain = view.domain;
  print(out, "\n{} to time {:.6g} in {}, {:.1f} ns per element-cycle\n", counted(domain.clock.cycle, "cycle"),
        domain.clock.time, format_duration(loop_seconds),
        output::nanoseconds_per_element_cycle(domain, loop_seconds));
  print_timings(out, domain, loop_seconds);
  print_contacts(out, view);
  print_tied_nodes(out, domain);
  print_energies(out, view, output::energy_error(view, peaks));
  print_eroded(out, view);
}

void print_checks(std::ostream& out, const std::vector<output::Check>& checks) {
  print(out, "\n{:<52} {:>11} {:>9} {:>9}         source\n", "Checks", "value", "limit", "source's");
  for (const output::Check& check : checks)
    print(out, "  {:<50} {:>11} {:>9.4g} {:>9}  {}   {}\n", check.name, value_beside_limit(check),
          check.limit, check.source_limit ? fmt::format("{:.4g}", *check.source_limit) : "-",
          check.pass ? "PASS" : "FAIL", check.source);
}

void print_failed_checks(std::ostream& err, const std::vector<output::Check>& checks) {
  for (const output::Check& check : checks)
    if (!check.pass)
      print(err, "warning: check failed: {} is {}, limit {:.4g}\n", check.name, value_beside_limit(check),
            check.limit);
}

void print_final_omissions(std::ostream& out, const std::vector<output::LeftOut>& list) {
  if (list.empty()) return;
  print(out, "\n");
  print_left_out(out, list);
}

void print_files(std::ostream& out, const std::filesystem::path& folder,
                 const std::vector<std::filesystem::path>& files) {
  print(out, "\nFiles\n");
  if (!files.empty()) print(out, "  {}   open in ParaView\n", files.front().string());
  for (std::size_t i = 1; i < files.size(); ++i) print(out, "  {}\n", files[i].string());
  print(out, "  {}\n", (folder / "run.json").string());
}

}  // namespace crumple::app
