// SPDX-License-Identifier: BSD-3-Clause
#include "rank_summary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <string>

#include "cellsearch/territory.hpp"
#include "checks.hpp"
#include "footprint.hpp"

namespace cellsearch {

namespace {

constexpr std::int32_t no_error = -1;

/// Throws if a number is negative or given twice. Ascending ones need no memory.
void check_ids(std::span<const GlobalId> ids, ErrorKind kind, const char* what) {
  const auto fail = [&](std::size_t place, const char* why) {
    throw Error(kind, static_cast<Index>(place),
                std::string(what) + " " + std::to_string(place) + " has the global number " +
                    std::to_string(ids[place]) + ", which is " + why + ".");
  };
  const auto negative = std::find_if(ids.begin(), ids.end(), [](GlobalId id) { return id < 0; });
  if (negative != ids.end()) fail(static_cast<std::size_t>(negative - ids.begin()), "negative");
  if (std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end()) return;
  std::vector<std::size_t> order(ids.size());
  for (std::size_t place = 0; place < order.size(); ++place) order[place] = place;
  std::sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    return ids[one] != ids[other] ? ids[one] < ids[other] : one < other;
  });
  std::size_t first = ids.size();
  for (std::size_t place = 1; place < order.size(); ++place) {
    if (ids[order[place]] == ids[order[place - 1]]) first = std::min(first, order[place]);
  }
  if (first < ids.size()) fail(first, "given twice");
}

/// FNV-1a (Fowler, Noll, Vo).
std::uint64_t hashed(std::uint64_t hash, std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3U;
  return hash;
}

std::uint64_t hash_of_common(const Scene& scene, const Settings& settings) {
  const std::array<std::int64_t, 3> flags{scene.exclude_neighbours ? 1 : 0, scene.groups.count,
                                          settings.domain ? 1 : 0};
  std::uint64_t hash = hashed(0xcbf29ce484222325U, std::as_bytes(std::span(flags)));
  hash = hashed(hash, std::as_bytes(scene.groups.allow));
  if (settings.domain) {
    hash = hashed(hash, std::as_bytes(std::span(settings.domain->box.lo)));
    hash = hashed(hash, std::as_bytes(std::span(settings.domain->box.hi)));
  }
  return hash;
}

/// All ranks learn of the errors, and throw.
[[noreturn]] void throw_on_all(Transport& transport, const std::optional<Error>& failure) {
  std::vector<std::byte> own(sizeof(std::int32_t));
  const std::int32_t kind = failure ? static_cast<std::int32_t>(failure->kind()) : no_error;
  std::memcpy(own.data(), &kind, sizeof kind);
  if (failure) {
    const char* text = failure->what();
    const auto* bytes = reinterpret_cast<const std::byte*>(text);
    own.insert(own.end(), bytes, bytes + std::strlen(text));
  }
  Gathered all;
  transport.allgather(own, all);
  if (failure) throw Error(*failure);
  for (int rank = 0; rank < transport.size(); ++rank) {
    const std::span<const std::byte> given = all.of(rank);
    std::int32_t its = no_error;
    std::memcpy(&its, given.data(), sizeof its);
    if (its == no_error) continue;
    const std::string text(reinterpret_cast<const char*>(given.data()) + sizeof its,
                           given.size() - sizeof its);
    throw Error(static_cast<ErrorKind>(its), -1, "Rank " + std::to_string(rank) + ": " + text);
  }
  throw TransportFault(-1, "A rank reported an error that it does not have.");
}

void check_agreement(const std::vector<RankSummary>& all) {
  std::int64_t nodes = 0;
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    nodes += all[rank].node_count;
    if (all[rank].common == all[0].common &&
        std::bit_cast<std::uint64_t>(all[rank].expansion) == std::bit_cast<std::uint64_t>(all[0].expansion)) {
      continue;
    }
    throw Error(
        ErrorKind::BadSetting, -1,
        "Rank " + std::to_string(rank) +
            " has another expansion, exclusion of neighbours, matrix of groups or domain than rank 0.");
  }
  if (nodes == 0) throw Error(ErrorKind::EmptyInput, -1, "There is not a single node on any rank.");
}

}  // namespace

void check_rank(const RankScene& own, int threads) {
  const Scene& scene = own.scene;
  if (own.node_id.size() != scene.positions.count() || own.segment_id.size() != scene.segments.count()) {
    throw Error(ErrorKind::BadLayout, -1, "The global numbers are not as many as the nodes or segments.");
  }
  // A rank may be empty, which a scene may not.
  if (scene.positions.count() == 0 && scene.segments.nodes().empty() && scene.participants() == 0) {
    check_positions(scene.positions);
    return;
  }
  check_scene(scene, threads);
  check_ids(own.node_id, ErrorKind::BadNodeId, "Node");
  check_ids(own.segment_id, ErrorKind::BadSegmentId, "Segment");
}

RankSummary summarise(const RankScene& own, const Settings& settings) {
  const Scene& scene = own.scene;
  RankSummary summary;
  summary.node_count = static_cast<std::int64_t>(scene.positions.count());
  summary.expansion = scene.expansion;
  summary.expansion_differs = scene.segment_expansion.empty() ? 0 : 1;
  summary.common = hash_of_common(scene, settings);
  for (Index place = 0; place < static_cast<Index>(scene.participants()); ++place) {
    summary.nodes.include(reach_of(scene, scene.participant(place)));
  }
  for (Index segment = 0; segment < static_cast<Index>(scene.segments.count()); ++segment) {
    if (scene.active(segment)) summary.territories.include(territory(scene, segment));
  }
  return summary;
}

void exchange_summaries(Transport& transport, const RankSummary& own, const std::optional<Error>& failure,
                        Gathered& memory, std::vector<RankSummary>& all) {
  RankSummary given = own;
  given.bad = failure ? 1 : 0;
  transport.allgather(std::as_bytes(std::span(&given, 1)), memory);
  all.resize(static_cast<std::size_t>(transport.size()));
  std::memcpy(all.data(), memory.bytes.data(), all.size() * sizeof(RankSummary));
  if (std::any_of(all.begin(), all.end(), [](const RankSummary& rank) { return rank.bad != 0; })) {
    throw_on_all(transport, failure);
  }
  check_agreement(all);
}

void agree(Transport& transport, const std::optional<Error>& failure) {
  std::array<std::int64_t, 1> bad{failure ? 1 : 0};
  transport.allreduce(Reduction::Max, bad);
  if (bad[0] != 0) throw_on_all(transport, failure);
}

}  // namespace cellsearch
