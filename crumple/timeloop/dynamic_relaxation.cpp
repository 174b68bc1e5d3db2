// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/dynamic_relaxation.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::timeloop {

namespace {

/// A factor nearer to 1 would leave bodies without supports to fly on.
constexpr double largest_factor = 0.9999;
/// A smaller one is of modes that the step barely follows.
constexpr double smallest_factor = 0.5;

}  // namespace

DynamicRelaxation::DynamicRelaxation(const model::Model& model, const domain::Execution& execution)
    : settings_(model.relaxation->settings),
      model_(model::relaxation_model(model)),
      simulation_(model_, execution),
      slowest_(settings_.automatic_tolerance),
      factor_(settings_.factor) {}

void DynamicRelaxation::start() {
  simulation_.relax(1 - factor_);
  simulation_.start();
}

bool DynamicRelaxation::step() {
  simulation_.step();
  const double energy = distortional_energy();
  largest_ = std::max(largest_, energy);
  largest_since_check_ = std::max(largest_since_check_, energy);
  if (settings_.automatic) adapt();
  if (simulation_.domain().clock.cycle % settings_.check_cycles != 0) return false;
  ratio_ = largest_ > 0 ? largest_since_check_ / largest_ : 0;
  largest_since_check_ = 0;
  converged_ = ratio_ < settings_.tolerance;
  return true;
}

/// The factor that damps the slowest motion critically: there both roots of c^2 - (1 + k - (w step)^2) c + k
/// are one, with k = (1 - w step)^2.
void DynamicRelaxation::adapt() {
  const auto rate = slowest_.observe(simulation_.domain().nodes, factor_);
  if (!rate) return;
  const double root = 1 - std::sqrt(std::min(*rate, 1.0));
  factor_ = std::clamp(root * root, smallest_factor, largest_factor);
  simulation_.relax(1 - factor_);
}

double DynamicRelaxation::distortional_energy() const {
  const domain::Domain& domain = simulation_.domain();
  return domain.energy.kinetic - constraints::RigidBodies::kinetic_energy(domain) -
         constraints::RigidWall::kinetic_energy(domain);
}

bool DynamicRelaxation::out_of_time() const {
  return settings_.end_time > 0 && simulation_.domain().clock.time >= settings_.end_time;
}

void begin_relaxed(Simulation& run) {
  if (!run.model().relaxation) return;
  DynamicRelaxation relaxation(run.model(), run.domain().execution);
  relaxation.start();
  while (!relaxation.finished()) relaxation.step();
  run.begin_with(relaxation.simulation());
}

}  // namespace crumple::timeloop
