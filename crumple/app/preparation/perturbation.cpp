// SPDX-License-Identifier: BSD-3-Clause
#include "app/preparation/perturbation.hpp"

#include <array>
#include <bit>

#include "app/preparation/bounding_box.hpp"

namespace crumple::app {

namespace {

/// The finaliser of the splitmix64 generator (Steele, Lea & Flood, OOPSLA 2014, fig. 16).
std::uint64_t scrambled(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// The same for all nodes at one place; adding zero makes one zero of both.
std::uint64_t hash_of_place(const std::array<double, 3>& position, std::uint64_t seed) {
  std::uint64_t hash = scrambled(seed);
  for (std::size_t axis = 0; axis < 3; ++axis)
    hash = scrambled(hash ^ std::bit_cast<std::uint64_t>(position[axis] + 0.0));
  return hash;
}

/// Uniform in [-1, 1).
double random_number(std::uint64_t place, std::uint64_t axis) {
  const std::uint64_t bits = scrambled(place ^ axis);
  return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

}  // namespace

void perturb_coordinates(model::Model& model, double fraction, std::uint64_t seed) {
  const double amplitude = fraction * bounding_box(model).diagonal();
  for (auto& position : model.nodes.position) {
    const std::uint64_t place = hash_of_place(position, seed);
    for (std::size_t axis = 0; axis < 3; ++axis) position[axis] += amplitude * random_number(place, axis);
  }
}

}  // namespace crumple::app
