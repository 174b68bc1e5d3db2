// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/fitting_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace crumple::timeloop {

namespace {

using Saved = domain::StateSnapshot::Array;

[[noreturn]] void refuse(const Saved& array, const std::string& what) {
  throw Error("The state is damaged: " + array.name + " " + what + ".");
}

template <class Number, class Fits>
void require_each(const Saved& array, const Fits& fits, const std::string& what) {
  for (std::size_t at = 0; at + sizeof(Number) <= array.bytes.size(); at += sizeof(Number)) {
    Number value{};
    std::memcpy(&value, array.bytes.data() + at, sizeof(Number));
    if (!fits(value)) refuse(array, what);
  }
}

std::size_t bytes_per_number(std::string_view name) {
  if (name == "fixed") return sizeof(std::uint8_t);
  return name == "body_of_node" ? sizeof(Index) : sizeof(double);
}

void require_length(const Saved& array, const domain::StateArray& to, std::size_t nodes) {
  const std::size_t bytes = array.bytes.size();
  if (!to.resize || bytes == to.bytes.size()) return;
  // Only what contacts remember grows from nothing; their owners look at it. That of nodes comes with the
  // first step or the first body.
  const bool grows = to.entity == domain::Entity::Contact && array.name.starts_with("contact_");
  if (!to.bytes.empty() || (!grows && to.entity != domain::Entity::Node))
    refuse(array, "has another length than the model gives it");
  const std::size_t all_nodes =
      nodes * static_cast<std::size_t>(to.components) * bytes_per_number(array.name);
  if (to.entity == domain::Entity::Node && bytes != 0 && bytes != all_nodes)
    refuse(array, "is neither empty nor of all nodes");
}

void require_numbers(const Saved& array) {
  constexpr std::array<std::string_view, 3> positive{"mass", "next_step", "largest_step"};
  constexpr std::array<std::string_view, 5> finite{"position", "velocity", "angular_velocity", "time",
                                                   "step"};
  const auto is_one_of = [&](const auto& names) {
    return std::ranges::find(names, array.name) != names.end();
  };
  if (is_one_of(finite))
    require_each<double>(
        array, [](double value) { return std::isfinite(value); }, "is not finite");
  if (is_one_of(positive))
    require_each<double>(
        array, [](double value) { return value >= 0; }, "is negative or not a number");
  if (array.name == "time")
    require_each<double>(
        array, [](double value) { return value >= 0; }, "is negative");
  constexpr std::array<std::string_view, 3> flags{"body_active", "contact_edges_ready",
                                                  "pressure_load_ended"};
  if (is_one_of(flags))
    require_each<std::uint8_t>(
        array, [](std::uint8_t value) { return value <= 1; }, "is neither true nor false");
  if (array.name == "cycle")
    require_each<std::int64_t>(
        array, [](std::int64_t value) { return value >= 0; }, "is negative");
}

void require_indices(const Saved& array, std::size_t bodies, std::size_t links) {
  const auto one_of = [](std::size_t items) {
    return [items](Index index) {
      return index == no_index || (index >= 0 && static_cast<std::size_t>(index) < items);
    };
  };
  if (array.name == "body_of_node")
    require_each<Index>(array, one_of(bodies), "names a body that does not exist");
  if (array.name == "tied_by") require_each<Index>(array, one_of(links), "names a tie that does not exist");
}

}  // namespace

void require_fitting_state(const domain::StateSnapshot& state, const domain::StateList& list,
                           const domain::Domain& domain) {
  const auto& saved = state.arrays();
  const auto& arrays = list.arrays();
  // Another count or other names are refused, with a reason, when the state is put back.
  if (saved.size() != arrays.size()) return;
  const auto nodes = static_cast<std::size_t>(domain.nodes.count());
  std::size_t links = 0;
  for (std::size_t i = 0; i < saved.size(); ++i) {
    if (saved[i].name != arrays[i].name) return;
    require_length(saved[i], arrays[i], nodes);
    require_numbers(saved[i]);
    // A flag for each tie comes before the list that refers to them.
    if (saved[i].name == "tied_nodes") links = arrays[i].bytes.size() / sizeof(std::int32_t);
    require_indices(saved[i], domain.rigid_bodies.size(), links);
  }
}

}  // namespace crumple::timeloop
