// SPDX-License-Identifier: BSD-3-Clause
// Elements of one kind that have the same nodes under two ids.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// Ascending, each node once, then zeros: however the element begins, and whichever it repeats.
template <std::size_t N>
std::array<UserId, N> as_set(std::array<UserId, N> node) {
  std::sort(node.begin(), node.end());
  std::fill(std::unique(node.begin(), node.end()), node.end(), 0);
  return node;
}

std::array<UserId, 4> nodes_of(const RawShell& raw) {
  return as_set(raw.node);
}
std::array<UserId, 2> nodes_of(const RawBeam& raw) {
  return as_set(raw.node);
}
std::array<UserId, 14> nodes_of(const RawSolid& raw) {
  std::array<UserId, 14> node{};
  const auto end = std::copy(raw.node.begin(), raw.node.end(), node.begin());
  std::copy(raw.middle.begin(), raw.middle.end(), end);
  return as_set(node);
}

template <std::size_t N>
std::uint64_t hash_of(const std::array<UserId, N>& node) {
  constexpr std::uint64_t offset = 0xcbf29ce484222325U;  // FNV-1a, word by word
  constexpr std::uint64_t prime = 0x100000001b3U;
  std::uint64_t hash = offset;
  for (const UserId id : node) {
    hash = (hash ^ static_cast<std::uint64_t>(id)) * prime;
    hash ^= hash >> 32U;
  }
  return hash;
}

/// Springs between two nodes are put side by side on purpose, one for each direction.
bool is_spring(const Build& build, UserId part) {
  const Index index = build.find_quietly(Item::Part, part);
  if (index == no_index) return false;
  const Index section = build.model.parts[static_cast<std::size_t>(index)].beam_section;
  return section != no_index && build.model.beam_sections[static_cast<std::size_t>(section)].formulation ==
                                    model::BeamFormulation::Discrete;
}

template <class Raw>
void warn_of_pair(const Raw& first, const Raw& second, std::string_view name, Build& build) {
  const bool same_part = first.part == second.part;
  if (!same_part && is_spring(build, first.part) && is_spring(build, second.part)) return;
  build.report.warning(
      second.where, same_part ? "same nodes" : "same nodes in two parts",
      fmt::format(
          "{0} {1} of part {2} has the nodes of {0} {3}{4} at {5}: mass and stiffness of both count{6}", name,
          second.id, second.part, first.id,
          same_part ? std::string() : fmt::format(" of part {}", first.part), build.report.place(first.where),
          same_part ? "; remove one of them" : ", as of two layers; remove one if that is not meant"));
}

/// Elements with the same hash lie beside each other when sorted, those of the deck's beginning first.
template <class Raw>
void check(const std::vector<Raw>& elements, std::string_view name, Build& build) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  order.reserve(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (!build.is_dropped(elements[i].part)) order.emplace_back(hash_of(nodes_of(elements[i])), i);
  std::sort(order.begin(), order.end());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // the second, the first
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i].first != order[i - 1].first) continue;
    const Raw& one = elements[order[i - 1].second];
    const Raw& other = elements[order[i].second];
    // Ids that are there twice are an error already.
    if (one.id != other.id && nodes_of(one) == nodes_of(other))
      pairs.emplace_back(order[i].second, order[i - 1].second);
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [second, first] : pairs) warn_of_pair(elements[first], elements[second], name, build);
}

}  // namespace

void check_coincident_elements(Build& build) {
  check(build.deck.shells, "shell", build);
  check(build.deck.solids, "solid", build);
  check(build.deck.beams, "beam", build);
}

}  // namespace crumple::deck
