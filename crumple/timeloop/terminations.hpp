// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::timeloop {

/// What ends a run before its end time (*TERMINATION): asked after each step.
class Terminations {
 public:
  /// The model must outlive this; the domain is that of time zero.
  Terminations(const model::Model& model, const domain::Domain& domain);

  /// To be called after each step, and at time zero.
  void observe(const domain::Domain& domain);

  /// Whether one was met at the last observation.
  bool met() const { return met_ != no_index; }

  /// The first one that was met, in a sentence.
  std::optional<std::string> reason() const;

  /// Declares what is remembered.
  void declare(domain::StateList& list);

 private:
  bool holds(std::size_t which, const domain::Domain& domain);

  const model::Model* model_;
  std::vector<math::Vec3> start_;  ///< centre of the body at time zero [length]
  std::vector<double>
      without_since_;  ///< when the force of the contact ended; below zero while it acts [time]
  Index met_ = no_index;
};

}  // namespace crumple::timeloop
