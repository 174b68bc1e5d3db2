// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/monitor.hpp"

#include <cmath>
#include <ostream>

#include "app/console/print.hpp"
#include "elements/elements.hpp"

namespace crumple::app {

namespace {

constexpr int lines_per_run = 20;
constexpr double seconds_between_lines = 10;
constexpr double seconds_between_bars = 0.2;
constexpr double seconds_between_words = 0.2;
constexpr double noted_fall = 0.01;

}  // namespace

Monitor::Monitor(const timeloop::Simulation& simulation, const Console& console, bool quiet,
                 double earlier_seconds)
    : simulation_(simulation), console_(console), quiet_(quiet), earlier_seconds_(earlier_seconds) {}

Progress Monitor::progress() const {
  Progress progress;
  progress.end_time = simulation_.model().control.end_time;
  progress.next_step = simulation_.next_step();
  const model::Control& control = simulation_.model().control;
  progress.seconds_to_go = speed_.seconds_to(control.end_time, control.end_cycle);
  progress.seconds = seconds();
  progress.controlling = elements::controlling_element(simulation_.model(), simulation_.domain());
  return progress;
}

void Monitor::clear_bar() {
  if (bar_shown_) print(console_.out, "\r\x1b[K");
  bar_shown_ = false;
}

void Monitor::print_line() {
  clear_bar();
  if (!header_shown_) print(console_.out, "\n{}\n", status_header());
  header_shown_ = true;
  line_cycle_ = simulation_.domain().clock.cycle;
  print(console_.out, "{}\n", status_line(simulation_.domain(), progress()));
  console_.out.flush();
}

void Monitor::print_last_line() {
  if (line_cycle_ != simulation_.domain().clock.cycle) print_line();
}

void Monitor::observe() {
  if (quiet_ && !listener_) return;
  const double now = since_start_.seconds();
  const domain::Clock& clock = simulation_.domain().clock;
  speed_.observe(now, clock.time, clock.cycle);
  if (!quiet_) print_due(now);
  if (!quiet_) print_fall_of_step();
  if (listener_ && now >= next_word_seconds_) {
    listener_(progress());
    next_word_seconds_ = now + seconds_between_words;
  }
}

void Monitor::print_due(double now) {
  const double time = simulation_.domain().clock.time;
  if (time >= next_line_time_ || now >= next_line_seconds_) {
    print_line();
    const double interval = simulation_.model().control.end_time / lines_per_run;
    // Counted and not stepped: a run may be taken up long after the end time that it has now.
    if (interval > 0 && next_line_time_ <= time)
      next_line_time_ = (std::floor(time / interval) + 1) * interval;
    next_line_seconds_ = now + seconds_between_lines;
  }
  if (console_.terminal && now >= next_bar_seconds_) {
    print(console_.out, "\r{}\x1b[K", progress_bar(simulation_.domain(), progress()));
    console_.out.flush();
    bar_shown_ = true;
    next_bar_seconds_ = now + seconds_between_bars;
  }
}

void Monitor::print_fall_of_step() {
  const double limit = simulation_.domain().clock.element_limit;
  if (first_limit_ == 0) noted_limit_ = first_limit_ = limit;
  if (limit >= noted_fall * noted_limit_) return;
  noted_limit_ = limit;
  clear_bar();
  const domain::ControllingElement controlling = progress().controlling;
  print(
      console_.out,
      "note: the stable step has fallen from {:.3e} to {:.3e}, at time {:.4g} by {} {} of part {}; DTMIN of "
      "*CONTROL_TERMINATION would end the run\n",
      first_limit_, limit, simulation_.domain().clock.time, controlling.kind, controlling.element,
      controlling.part);
}

}  // namespace crumple::app
