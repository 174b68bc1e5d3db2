// SPDX-License-Identifier: BSD-3-Clause
// *TITLE and the *CONTROL keywords of run, time step, energies and hourglass control.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field termination_card[] = {
    real("ENDTIM", 0, not_negative),
    integer("ENDCYC", 0, not_negative),
    real("DTMIN", 0, not_negative),
    real("ENDENG", 0, not_negative),
    real("ENDMAS", 0, not_negative),
    unused("NOSOL"),  // for other solvers in the same run
};

constexpr Field timestep_card[] = {
    real("DTINIT", 0, not_negative),
    real_or_default("TSSFAC", 0.9, within(0, 1, "a factor on the stable time step")),
    harmless("ISDO", {0}, "the element length is area over the longest side or diagonal (ISDO=0)"),
    only("TSLIMT", {0}, "use DT2MS for a minimum time step"),
    real("DT2MS"),
    reference("LCTM", IdKind::Function),
    harmless("ERODE", {0, 1}, "elements are not deleted by their time step, except solids with 1"),
    only("MS1ST", {0, 1}, "mass is added whenever a time step needs it (0), or at the start alone (1)"),
};

constexpr Field timestep_card_2[] = {
    only("DT2MSF", {0}, "give the step itself in DT2MS"),
    only("DT2MSLC", {0}, "DT2MS is constant"),
    only("IMSCL", {0}, "selective mass scaling is not supported; DT2MS alone adds mass to the nodes"),
    unused("-"),
    unused("--"),
    only("RMSCL", {0}, "added mass takes part in everything"),
};

// Every energy is always computed here.
constexpr Field energy_card[] = {unused("HGEN"),  unused("RWEN"),  unused("SLNTEN"), unused("RYLEN"),
                                 unused("IRGEN"), unused("MATEN"), unused("DRLEN"),  unused("DISEN")};

constexpr Field hourglass_card[] = {
    only("IHQ", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, hourglass_forms),
    real_or_default("QH", 0.1, not_negative),
};

constexpr Field bulk_viscosity_card[] = {
    real_or_default("Q1", 1.5, not_negative),
    real_or_default("Q2", 0.06, not_negative),
    harmless("TYPE", {1, 0},
             "solids always have bulk viscosity, and its energy is counted; shells have none (-1, -2)"),
    unused("BTYPE"),
    unused("TSTYPE"),
};

constexpr Field accuracy_card[] = {
    unused("OSU"),  // strains are always taken at the middle of the step
    harmless("INN", {1, 0}, "the local axes of a shell follow its first side"),
    unused("PIDOSU"),
    unused("IACC"),
    unused("EXACC"),
};

constexpr Field solution_card[] = {
    only("SOLN", {0}, "there is the mechanical solution only"),
    unused("NLQ"),    // of composites
    unused("ISNAN"),  // numbers that are none always end the run
    unused("LCINT"),  // curves are taken as they are
    unused("LCACC"),
    unused("NCDCF"),
    unused("NOCOP"),
};

constexpr Field solid_card[] = {
    integer("ESORT"),
    unused("FMATRX"),  // deformation gradients are exact
    harmless("NIPTETS", {4, 0}, "tetrahedra with ten nodes have four points"),
    unused("SWLOCL"),  // of listings
    only("PSFAIL", {0}, "a solid that has turned inside out ends the run"),
    unused("T10JTOL"),
    unused("ICOH"),    // of cohesive elements
    unused("TET13K"),  // of implicit runs
};

constexpr Field implicit_card[] = {
    only("IMFLAG", {0}, "the run is explicit"),
    unused("DT0"),
    unused("IMFORM"),
    unused("NSBS"),
    unused("IGS"),
    unused("CNSTN"),
    unused("FORM"),
    unused("ZERO_V"),
};

}  // namespace

void read_title(Cards& cards, RawDeck& deck) {
  // Included files have titles of their own; the run's is the first one.
  std::string title = cards.text_line("the title of the run");
  if (deck.title.empty()) deck.title = std::move(title);
  cards.skip_rest();
}

void read_control_termination(Cards& cards, RawDeck& deck) {
  const Card card = cards.next(termination_card);
  deck.control.end_time = card.real("ENDTIM");
  deck.end_time_text = card.text("ENDTIM");
  deck.control.end_cycle = card.integer("ENDCYC");
  deck.control.minimum_step_factor = card.real("DTMIN");
  deck.control.end_energy_ratio = card.real("ENDENG");
  deck.control.end_mass_increase = card.real("ENDMAS");
  deck.termination = card.where();
  deck.end_time_is_faulty = !card.good("ENDTIM");
}

void read_control_timestep(Cards& cards, RawDeck& deck) {
  const Card card = cards.next_or_default(timestep_card);
  deck.control.initial_step = card.real("DTINIT");
  deck.control.step_scale = card.real("TSSFAC");
  constexpr double usual = 0.9;
  if (card.good("TSSFAC") && card.real("TSSFAC") > usual)
    cards.report().field_warning(
        card.where(), {"TSSFAC", std::string(card.text("TSSFAC")), "a factor up to 0.9",
                       "it is used, but leaves little of the stable step to contact, friction and damping",
                       "factor on the step"});
  deck.control.mass_scaling_step = card.real("DT2MS");
  deck.control.erodes_short_solids = card.real("ERODE") == 1;
  deck.control.scales_mass_once = card.real("MS1ST") == 1;
  if (card.good("LCTM") && card.integer("LCTM") != 0)
    deck.step_curve = RawStepCurve{card.integer("LCTM"), card.where()};
  if (cards.has_line()) cards.next(timestep_card_2);
}

void read_control_energy(Cards& cards, RawDeck&) {
  cards.next_or_default(energy_card);
}

void read_control_hourglass(Cards& cards, RawDeck& deck) {
  const Card card = cards.next_or_default(hourglass_card);
  deck.control_hourglass = card.where();
  model::HourglassControl& control = deck.control.hourglass;
  control.form = hourglass_form(static_cast<std::int64_t>(card.real("IHQ")));
  control.solid_form = solid_hourglass_form(static_cast<std::int64_t>(card.real("IHQ")));
  warn_of_hourglass_form(card, cards.report());
  warn_of_hourglass_coefficient(card, "QH", cards.report());
  control.coefficient = control.bending = control.warping = card.real("QH");
}

void read_control_bulk_viscosity(Cards& cards, RawDeck& deck) {
  const Card card = cards.next_or_default(bulk_viscosity_card);
  deck.control.bulk_quadratic = card.real("Q1");
  deck.control.bulk_linear = card.real("Q2");
}

void read_control_accuracy(Cards& cards, RawDeck&) {
  cards.next_or_default(accuracy_card);
}

void read_control_implicit_general(Cards& cards, RawDeck&) {
  cards.next_or_default(implicit_card);
}

void read_control_solution(Cards& cards, RawDeck&) {
  if (cards.has_line()) cards.next(solution_card);
}

/// The following cards only renumber output.
void read_control_solid(Cards& cards, RawDeck& deck) {
  if (!cards.has_line()) return;
  const Card card = cards.next(solid_card);
  if (card.good("ESORT") && card.integer("ESORT") != 0) deck.sorts_solids = card.where();
  cards.skip_rest();
}

}  // namespace crumple::deck
