// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

namespace crumple::app {

/// How fast a run comes on, for the time that it still takes: wall time by simulated time, so that the steps
/// as they were and all that they cost are in it, contact and output too. It is averaged over the last
/// quarter of the run so far, and at least the last two seconds: shorter would follow single frames and
/// searches, longer would lag behind steps that shrink and contacts that grow. The first cycles touch memory
/// for the first time and set up the contacts: they count only as long as there are no others.
class RunSpeed {
 public:
  /// Where the run is after so much wall time [s]; times and cycles never fall.
  void observe(double seconds, double time, long cycle);

  /// Wall time until an end time and, unless that is 0, an end by cycles, whichever comes first [s]; negative
  /// if nothing is known yet.
  double seconds_to(double end_time, long end_cycle) const;

 private:
  struct Sample {
    double seconds = 0;
    double time = 0;
    long cycle = 0;
  };

  std::deque<Sample> samples_;  ///< the last one is where the run is
  Sample first_;                ///< of all
  bool is_started_ = false;
};

}  // namespace crumple::app
