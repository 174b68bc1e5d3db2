// SPDX-License-Identifier: BSD-3-Clause
#include "app/perturbation.hpp"

#include "app/bounding_box.hpp"

namespace crumple::app {

namespace {

/// The finaliser of the splitmix64 generator (Steele, Lea & Flood, OOPSLA 2014, fig. 16).
std::uint64_t scrambled(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// Uniform in [-1, 1).
double random_number(UserId node, std::uint64_t axis, std::uint64_t seed) {
  const std::uint64_t bits = scrambled(scrambled(scrambled(seed) ^ static_cast<std::uint64_t>(node)) ^ axis);
  return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

}  // namespace

void perturb_coordinates(model::Model& model, double fraction, std::uint64_t seed) {
  const double amplitude = fraction * bounding_box(model).diagonal();
  for (Index node = 0; node < model.nodes.count(); ++node)
    for (std::size_t axis = 0; axis < 3; ++axis)
      model.nodes.position[node][axis] += amplitude * random_number(model.nodes.id[node], axis, seed);
}

}  // namespace crumple::app
