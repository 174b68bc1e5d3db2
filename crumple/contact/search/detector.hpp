// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "contact/enforcement/touch.hpp"
#include "contact/enforcement/touch_notes.hpp"
#include "contact/surface/kinematics.hpp"
#include "contact/surface/statistics.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

/// A way to find what touches: nodes on segments, edges on edges, pinballs. An interface has a list of
/// detectors and asks each the same, in the order of the list:
///
///     update()    follow erosion, search candidates again where needed     every step, or find_nothing()
///     find()      the contacts at this time, count() of them
///     fill()      the contacts as touches, for which forces are computed
///     remember()  what the next step needs of touches and forces
///
/// Calls are virtual once for all contacts of a step, never for each.
class Detector {
 public:
  Detector() = default;
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;
  virtual ~Detector() = default;

  /// Of the global search, for reports.
  virtual std::string method() const = 0;

  /// Follows erosion if the surface has changed, and searches again if the candidates may no longer be
  /// complete. `start` is true once, before the first step. Returns what the penalties of contacts held whose
  /// nodes, segments or edges have eroded [energy]. Throws NumericalError if a coordinate is not finite.
  virtual double update(const domain::Domain& domain, const Kinematics& motion, bool surface_changed,
                        bool start) = 0;

  /// Finds the contacts where `motion` has the nodes; the same for any number of threads. At the `start` each
  /// is allowed the penetration that it has. Adds what it has lost to the report, and returns what the
  /// penalties of contacts held that ended at an eroded rim [energy].
  virtual double find(const domain::Domain& domain, const Kinematics& motion, bool start,
                      domain::ContactReport& report) = 0;
  /// There are no contacts at this time.
  virtual void find_nothing() = 0;

  /// Contacts that were found, until the next find().
  virtual Index count() const = 0;
  /// Writes them as touches, in order; `touches` has the length count().
  virtual void fill(const Kinematics& motion, std::span<Touch> touches) const = 0;
  /// Takes over what multipliers have left of the penetrations, and where the contacts came to lie.
  virtual void correct(const Kinematics& /*motion*/, std::span<const Touch> /*touches*/) {}
  /// Keeps what the next step needs. `touches` are those of fill(), with their forces.
  virtual void remember(const Kinematics& motion, std::span<const Touch> touches, TouchNotes& notes) = 0;

  /// Appends the contacts found at the start that overlap.
  virtual void append_initial_overlaps(std::vector<domain::InitialOverlap>& overlaps) const = 0;
  /// Compares the candidates with all pairs, O(N^2): throws Error naming the first that was missed.
  virtual void verify(const Kinematics& motion) = 0;
  /// Adds searches, candidates and contacts on the far side to what is counted of the whole contact.
  virtual void report(domain::ContactReport& report, ContactStatistics& statistics) const = 0;
  /// Adds what a check of the whole model finds, beside cuts of segments.
  virtual void inspect(const domain::Domain& /*domain*/, domain::ContactInspection& /*seen*/) const {}

  /// Declares the positions at the last search.
  virtual void declare_search(domain::StateList& list) = 0;
  /// Declares what is remembered from step to step.
  virtual void declare_pairs(domain::StateList& list) = 0;
  /// To be called once after a restart has filled what was declared, when the surface has followed erosion.
  virtual void resume(const domain::Domain& domain, const Kinematics& motion) = 0;
};

}  // namespace crumple::contact
