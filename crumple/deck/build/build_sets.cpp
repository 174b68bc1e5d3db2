// SPDX-License-Identifier: BSD-3-Clause
// Boxes, and sets of nodes, parts, elements and segments.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "deck/build/build.hpp"
#include "model/solid_faces.hpp"

namespace crumple::deck {

namespace {

using What = RawMember::What;
using Segment = std::array<Index, 4>;
/// Nothing where there was a fault, which has been reported.
using Found = std::optional<std::vector<Index>>;

/// What a line of a set names, other than sets of the same kind.
using Select = std::function<Found(const RawMember&)>;

/// Follows the lines of the sets of one kind in their order, each member once; sets may refer to each other.
class SetTable {
 public:
  SetTable(Build& build, Item item, const std::vector<RawSet>& raws, Select select)
      : build_(build),
        item_(item),
        raws_(raws),
        select_(std::move(select)),
        members_(raws.size()),
        states_(raws.size(), State::Open) {
    for (std::size_t i = 0; i < raws.size(); ++i) build.enter(item, {raws[i].id, "SID", raws[i].where}, i);
  }

  const std::vector<Index>& members(std::size_t set) {
    if (states_[set] == State::Open) follow(set);
    return members_[set];
  }

 private:
  enum class State { Open, Running, Done };

  void follow(std::size_t set) {
    states_[set] = State::Running;
    std::vector<Index> order;
    std::vector<char> taken;
    bool missing = false;
    for (const RawMember& member : raws_[set].members) {
      const Found found = member.what == What::OwnSet ? of_sets(member) : select_(member);
      missing = missing || !found;
      if (!found) continue;
      for (const Index index : *found) {
        const auto place = static_cast<std::size_t>(index);
        if (place >= taken.size()) taken.resize(place + 1, 0);
        if (!member.removes && !taken[place]) order.push_back(index);
        taken[place] = member.removes ? 0 : 1;
      }
    }
    // What was taken out and put in again stands twice in the order.
    for (const Index index : order) {
      char& is_taken = taken[static_cast<std::size_t>(index)];
      if (is_taken) members_[set].push_back(index);
      is_taken = 0;
    }
    if (members_[set].empty() && !missing)
      build_.report.warning(raws_[set].where, "empty", fmt::format("set {} has no members", raws_[set].id));
    states_[set] = State::Done;
  }

  Found of_sets(const RawMember& member) {
    if (member.first == member.last) {
      const Index set = build_.find(item_, {member.first, member.field, member.where});
      if (set == no_index) return std::nullopt;
      return of_set(static_cast<std::size_t>(set), member);
    }
    std::vector<Index> all;
    for (std::size_t i = 0; i < raws_.size(); ++i) {
      if (raws_[i].id < member.first || raws_[i].id > member.last) continue;
      Found found = of_set(i, member);
      if (!found) return found;
      all.insert(all.end(), found->begin(), found->end());
    }
    return all;
  }

  Found of_set(std::size_t set, const RawMember& member) {
    if (states_[set] != State::Running) return members(set);
    build_.report.field_error(member.where, {member.field, std::to_string(raws_[set].id), "another set",
                                             "the set would contain itself", "loop"});
    return std::nullopt;
  }

  Build& build_;
  Item item_;
  const std::vector<RawSet>& raws_;
  Select select_;
  std::vector<std::vector<Index>> members_;
  std::vector<State> states_;
};

std::vector<Index> up_to(std::size_t count) {
  std::vector<Index> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<Index>(i);
  return all;
}

/// A single member, which must exist, or those of a range that do.
Found own_members(const RawMember& member, Item item, const std::vector<UserId>& ids, Build& build) {
  if (member.first == member.last) {
    const Index index = build.find(item, {member.first, member.field, member.where});
    if (index == no_index) return std::nullopt;
    return std::vector<Index>{index};
  }
  std::vector<Index> found;
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (ids[i] >= member.first && ids[i] <= member.last && (ids[i] - member.first) % member.increment == 0)
      found.push_back(static_cast<Index>(i));
  return found;
}

/// Item that a line names, or no_index with a message.
Index named(const RawMember& member, Item item, Build& build) {
  return build.find(item, {member.first, member.field, member.where});
}

template <class Members>
bool all_inside(const RawBox& box, const Members& node, const model::Nodes& nodes) {
  return std::all_of(node.begin(), node.end(), [&](Index n) {
    return n != no_index && is_inside(box, nodes.position[static_cast<std::size_t>(n)]);
  });
}

template <class Elements>
std::vector<UserId> ids_of(const Elements& elements) {
  std::vector<UserId> ids;
  ids.reserve(elements.size());
  for (const auto& element : elements) ids.push_back(element.id);
  return ids;
}

/// Elements for which a condition holds.
template <class Elements, class Condition>
std::vector<Index> elements_where(const Elements& elements, const Condition& holds) {
  std::vector<Index> found;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (holds(elements[i])) found.push_back(static_cast<Index>(i));
  return found;
}

template <class Elements>
Found select_elements(const RawMember& member, Item item, const Elements& elements,
                      const std::vector<UserId>& ids, Build& build) {
  switch (member.what) {
    case What::All:
      return up_to(elements.size());
    case What::Part: {
      const Index part = named(member, Item::Part, build);
      if (part == no_index) return std::nullopt;
      return elements_where(elements, [&](const auto& element) { return element.part == part; });
    }
    case What::Box: {
      const Index index = named(member, Item::Box, build);
      if (index == no_index) return std::nullopt;
      const RawBox& box = build.deck.boxes[static_cast<std::size_t>(index)];
      return elements_where(
          elements, [&](const auto& element) { return all_inside(box, element.node, build.model.nodes); });
    }
    default:
      return own_members(member, item, ids, build);
  }
}

/// Nodes of elements that the model has, each as often as it comes.
template <class Elements>
std::vector<Index> nodes_of(const Elements& elements, const std::vector<Index>& which) {
  std::vector<Index> found;
  for (const Index element : which)
    for (const Index node : elements[static_cast<std::size_t>(element)].node)
      if (node != no_index) found.push_back(node);
  return found;
}

/// Nodes of one element of a kind.
template <class Elements>
Found nodes_of_element(const RawMember& member, Item item, const Elements& elements, Build& build) {
  const Index element = named(member, item, build);
  if (element == no_index) return std::nullopt;
  return nodes_of(elements, {element});
}

/// Nodes of a set of elements, whose members stand in `sets`.
template <class Elements>
Found nodes_of_set(const RawMember& member, Item item, const Elements& elements,
                   const std::vector<std::vector<Index>>& sets, Build& build) {
  const Index set = named(member, item, build);
  if (set == no_index) return std::nullopt;
  return nodes_of(elements, sets[static_cast<std::size_t>(set)]);
}

Found select_nodes(const RawMember& member, Build& build) {
  const model::Nodes& nodes = build.model.nodes;
  switch (member.what) {
    case What::All:
      return up_to(nodes.id.size());
    case What::Part: {
      const Index part = named(member, Item::Part, build);
      if (part == no_index) return std::nullopt;
      return nodes_of_parts(build, {part});
    }
    case What::Box: {
      const Index index = named(member, Item::Box, build);
      if (index == no_index) return std::nullopt;
      const RawBox& box = build.deck.boxes[static_cast<std::size_t>(index)];
      return elements_where(nodes.position, [&](const auto& x) { return is_inside(box, x); });
    }
    case What::ShellSet: {
      const Index set = named(member, Item::ShellSet, build);
      if (set == no_index) return std::nullopt;
      return nodes_of(build.model.shells, build.model.shell_sets[static_cast<std::size_t>(set)].shells);
    }
    case What::SolidSet:
      return nodes_of_set(member, Item::SolidSet, build.model.solids, build.solid_sets, build);
    case What::BeamSet:
      return nodes_of_set(member, Item::BeamSet, build.model.beams, build.beam_sets, build);
    case What::DiscreteSet:
      return nodes_of_set(member, Item::DiscreteSet, build.model.discretes, build.discrete_sets, build);
    case What::Shell:
      return nodes_of_element(member, Item::Shell, build.model.shells, build);
    case What::Solid:
      return nodes_of_element(member, Item::Solid, build.model.solids, build);
    case What::Beam:
      return nodes_of_element(member, Item::Beam, build.model.beams, build);
    case What::Discrete:
      return nodes_of_element(member, Item::Discrete, build.model.discretes, build);
    default:
      return own_members(member, Item::Node, nodes.id, build);
  }
}

/// Pieces of surface by number; two with the same nodes have the same one.
class Segments {
 public:
  Segments(Build& build, SetTable& solid_sets) : build_(build), solid_sets_(solid_sets) {}

  const Segment& operator[](Index index) const { return segments_[static_cast<std::size_t>(index)]; }

  Found select(const RawMember& member) {
    switch (member.what) {
      case What::All:
        return both(of_shells(up_to(build_.model.shells.size())),
                    of_solids(up_to(build_.model.solids.size())));
      case What::Part: {
        const Index part = named(member, Item::Part, build_);
        if (part == no_index) return std::nullopt;
        return both(of_shells(elements_of(build_.model.shells, part)),
                    of_solids(elements_of(build_.model.solids, part)));
      }
      case What::Shell: {
        const Index shell = named(member, Item::Shell, build_);
        if (shell == no_index) return std::nullopt;
        return of_shells({shell});
      }
      case What::ShellSet: {
        const Index set = named(member, Item::ShellSet, build_);
        if (set == no_index) return std::nullopt;
        return of_shells(build_.model.shell_sets[static_cast<std::size_t>(set)].shells);
      }
      case What::SolidSet: {
        const Index set = named(member, Item::SolidSet, build_);
        if (set == no_index) return std::nullopt;
        return of_solids(solid_sets_.members(static_cast<std::size_t>(set)));
      }
      case What::PartWithInside: {
        const Index part = named(member, Item::Part, build_);
        if (part == no_index) return std::nullopt;
        return both(of_shells(elements_of(build_.model.shells, part)),
                    all_of_solids(elements_of(build_.model.solids, part)));
      }
      case What::SolidSetWithInside: {
        const Index set = named(member, Item::SolidSet, build_);
        if (set == no_index) return std::nullopt;
        return all_of_solids(solid_sets_.members(static_cast<std::size_t>(set)));
      }
      case What::Segment:
        return of_nodes(member);
      default:
        return in_box(member);
    }
  }

 private:
  template <class Elements>
  static std::vector<Index> elements_of(const Elements& elements, Index part) {
    return elements_where(elements, [&](const auto& element) { return element.part == part; });
  }

  static std::vector<Index> both(std::vector<Index> first, const std::vector<Index>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  static bool is_whole(const auto& element) {
    return std::find(element.node.begin(), element.node.end(), no_index) == element.node.end();
  }

  Index number(const Segment& segment) {
    Segment key = segment;
    std::sort(key.begin(), key.end());
    std::fill(std::unique(key.begin(), key.end()), key.end(),
              *std::max_element(segment.begin(), segment.end()));
    const auto [entry, is_new] = numbers_.try_emplace(key, static_cast<Index>(segments_.size()));
    if (is_new) segments_.push_back(segment);
    return entry->second;
  }

  std::vector<Index> of_shells(const std::vector<Index>& shells) {
    std::vector<Index> found;
    for (const Index index : shells) {
      const model::ShellElement& shell = build_.model.shells[static_cast<std::size_t>(index)];
      if (is_whole(shell)) found.push_back(number(shell.node));
    }
    return found;
  }

  std::vector<Index> of_solids(std::vector<Index> solids) {
    std::erase_if(solids,
                  [&](Index i) { return !is_whole(build_.model.solids[static_cast<std::size_t>(i)]); });
    std::vector<Index> found;
    for (const model::SolidFace& face : model::outer_faces(build_.model.solids, solids))
      found.push_back(number(face.node));
    return found;
  }

  /// The faces between two of them as well.
  std::vector<Index> all_of_solids(std::vector<Index> solids) {
    std::vector<Index> found = of_solids(solids);
    std::erase_if(solids,
                  [&](Index i) { return !is_whole(build_.model.solids[static_cast<std::size_t>(i)]); });
    for (const model::SolidFace& face : model::all_faces(build_.model.solids, solids))
      found.push_back(number(face.node));
    return found;
  }

  Found of_nodes(const RawMember& member) {
    static constexpr std::array<std::string_view, 4> listed = {"N1", "N2", "N3", "N4"};
    static constexpr std::array<std::string_view, 4> general = {"E1", "E2", "E3", "E4"};
    const auto& fields = member.field == "OPTION" ? general : listed;
    Segment segment{};
    bool good = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool again = i == 3 && member.node[3] == member.node[2];
      segment[i] = again ? segment[2] : build_.find(Item::Node, {member.node[i], fields[i], member.where});
      good = good && segment[i] != no_index;
    }
    if (!good) return std::nullopt;
    return std::vector<Index>{number(segment)};
  }

  /// One segment of every shell, and of every part the faces of solids that are outside.
  Found in_box(const RawMember& member) {
    const Index index = named(member, Item::Box, build_);
    if (index == no_index) return std::nullopt;
    std::vector<Index> found;
    const bool inside_too = member.what == What::BoxOfAllFaces;
    if (inside_too) found = all_of_solids(up_to(build_.model.solids.size()));
    if (member.what == What::Box || member.what == What::BoxOfShells)
      found = of_shells(up_to(build_.model.shells.size()));
    if (member.what != What::BoxOfShells && !inside_too)
      for (std::size_t part = 0; part < build_.model.parts.size(); ++part)
        found = both(std::move(found), of_solids(elements_of(build_.model.solids, static_cast<Index>(part))));
    const RawBox& box = build_.deck.boxes[static_cast<std::size_t>(index)];
    std::erase_if(found, [&](Index i) { return !all_inside(box, (*this)[i], build_.model.nodes); });
    return found;
  }

  Build& build_;
  SetTable& solid_sets_;
  std::vector<Segment> segments_;
  std::map<Segment, Index> numbers_;
};

void build_segment_sets(Build& build, SetTable& solid_sets) {
  Segments segments(build, solid_sets);
  SetTable table(build, Item::SegmentSet, build.deck.segment_sets,
                 [&](const RawMember& member) { return segments.select(member); });
  for (std::size_t i = 0; i < build.deck.segment_sets.size(); ++i) {
    const RawSet& raw = build.deck.segment_sets[i];
    model::SegmentSet set{raw.id, raw.title, {}};
    for (const Index segment : table.members(i)) set.segments.push_back(segments[segment]);
    build.model.segment_sets.push_back(std::move(set));
  }
}

/// Members of the sets of beams or of discrete elements.
template <class Elements>
std::vector<std::vector<Index>> line_sets(Build& build, Item set, Item element,
                                          const std::vector<RawSet>& raws, const Elements& elements) {
  const std::vector<UserId> ids = ids_of(elements);
  SetTable table(build, set, raws, [&](const RawMember& member) {
    return select_elements(member, element, elements, ids, build);
  });
  std::vector<std::vector<Index>> members;
  for (std::size_t i = 0; i < raws.size(); ++i) members.push_back(table.members(i));
  return members;
}

}  // namespace

bool is_inside(const RawBox& box, const std::array<double, 3>& point) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(point[i] >= box.lowest[i] && point[i] <= box.highest[i])) return false;
  return true;
}

void build_sets(Build& build) {
  const RawDeck& deck = build.deck;
  model::Model& model = build.model;
  for (std::size_t i = 0; i < deck.boxes.size(); ++i)
    build.enter(Item::Box, {deck.boxes[i].id, "BOXID", deck.boxes[i].where}, i);

  const std::vector<UserId> part_ids = ids_of(model.parts);
  SetTable parts(build, Item::PartSet, deck.part_sets, [&](const RawMember& member) -> Found {
    if (member.what == What::All) return up_to(part_ids.size());
    return own_members(member, Item::Part, part_ids, build);
  });
  for (std::size_t i = 0; i < deck.part_sets.size(); ++i)
    model.part_sets.push_back({deck.part_sets[i].id, deck.part_sets[i].title, parts.members(i)});

  const std::vector<UserId> shell_ids = ids_of(model.shells);
  SetTable shells(build, Item::ShellSet, deck.shell_sets, [&](const RawMember& member) {
    return select_elements(member, Item::Shell, model.shells, shell_ids, build);
  });
  for (std::size_t i = 0; i < deck.shell_sets.size(); ++i)
    model.shell_sets.push_back({deck.shell_sets[i].id, deck.shell_sets[i].title, shells.members(i)});

  const std::vector<UserId> solid_ids = ids_of(model.solids);
  SetTable solids(build, Item::SolidSet, deck.solid_sets, [&](const RawMember& member) {
    return select_elements(member, Item::Solid, model.solids, solid_ids, build);
  });
  for (std::size_t i = 0; i < deck.solid_sets.size(); ++i) build.solid_sets.push_back(solids.members(i));
  build.beam_sets = line_sets(build, Item::BeamSet, Item::Beam, deck.beam_sets, model.beams);
  build.discrete_sets =
      line_sets(build, Item::DiscreteSet, Item::Discrete, deck.discrete_sets, model.discretes);

  SetTable nodes(build, Item::NodeSet, deck.node_sets,
                 [&](const RawMember& member) { return select_nodes(member, build); });
  for (std::size_t i = 0; i < deck.node_sets.size(); ++i)
    model.node_sets.push_back({deck.node_sets[i].id, deck.node_sets[i].title, nodes.members(i)});

  build_segment_sets(build, solids);
}

}  // namespace crumple::deck
