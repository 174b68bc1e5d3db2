// SPDX-License-Identifier: BSD-3-Clause
// Spot welds, rivets, constrained sets of nodes, linear equations and interpolations.
#include <fmt/core.h>

#include <algorithm>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// Who moves each node: a node has room for one constraint.
class Owners {
 public:
  explicit Owners(Build& build) : build_(build), owner_(build.model.nodes.id.size()) {
    for (const model::RigidBody& body : build.model.rigid_bodies)
      for (const Index node : body.nodes)
        owner_[static_cast<std::size_t>(node)] = {fmt::format("rigid body {}", body.id), {}};
  }

  /// Enters a constraint for its nodes; reports a node that has one already.
  void take(const std::vector<Index>& nodes, const std::string& name, const Where& where) {
    for (const Index node : nodes) {
      Owner& owner = owner_[static_cast<std::size_t>(node)];
      if (!owner.name.empty())
        build_.report.error(
            where, "shared",
            fmt::format("node {} belongs to {} and {}{}; a node has room for one constraint, as "
                        "in LS-DYNA",
                        build_.model.nodes.id[static_cast<std::size_t>(node)], owner.name, name,
                        owner.where.line > 0 ? fmt::format(" ({})", build_.report.place(owner.where))
                                             : std::string()));
      owner = {name, where};
    }
  }

 private:
  struct Owner {
    std::string name;
    Where where;
  };
  Build& build_;
  std::vector<Owner> owner_;
};

/// Both nodes, or nothing with a message.
std::vector<Index> find_pair(Build& build, const std::array<UserId, 2>& ids, const Where& where) {
  std::vector<Index> pair = {build.find(Item::Node, {ids[0], "N1", where}),
                             build.find(Item::Node, {ids[1], "N2", where})};
  if (pair[0] == no_index || pair[1] == no_index) return {};
  if (pair[0] == pair[1]) {
    build.report.field_error(where, {"N2", std::to_string(ids[1]), "another node than N1",
                                     "a node cannot be joined to itself", "same"});
    return {};
  }
  return pair;
}

/// Distinct nodes of a set and one more (0 is none), ascending; nothing, with a message, if there are less
/// than two.
std::vector<Index> find_members(Build& build, UserId set, UserId more, const Where& where) {
  const std::vector<Index>* const members = set_nodes(build, {set, "NSID", where});
  const Index added = more != 0 ? build.find(Item::Node, {more, "NID", where}) : no_index;
  if (!members || (more != 0 && added == no_index)) return {};
  std::vector<Index> nodes = *members;
  if (added != no_index) nodes.push_back(added);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.size() >= 2) return nodes;
  build.report.field_error(
      where, {"NSID", std::to_string(set), "a set of at least two nodes", "there is nothing to join", "set"});
  return {};
}

/// Forces are told apart along the line between two nodes.
void check_strength(Build& build, const RawWeld& raw, const model::SpotWeld& weld) {
  if (!(weld.normal_strength > 0) && !(weld.shear_strength > 0)) return;
  const auto& positions = build.model.nodes.position;
  const bool pair = weld.nodes.size() == 2 && positions[static_cast<std::size_t>(weld.nodes[0])] !=
                                                  positions[static_cast<std::size_t>(weld.nodes[1])];
  if (pair) return;
  const Where& where = raw.limits_where.line > 0 ? raw.limits_where : raw.where;
  const bool normal = weld.normal_strength > 0;
  build.report.field_unsupported(
      where,
      {normal ? "SN" : "SS", fmt::format("{}", normal ? weld.normal_strength : weld.shear_strength), "0",
       "failure by forces needs two nodes at different places; take TFAIL or EPSF, or *CONSTRAINED_SPOTWELD",
       "strength"});
}

void build_welds(Build& build, Owners& owners) {
  for (std::size_t i = 0; i < build.deck.welds.size(); ++i) {
    const RawWeld& raw = build.deck.welds[i];
    model::SpotWeld weld = raw.weld;
    if (weld.id == 0) weld.id = static_cast<UserId>(i) + 1;
    weld.nodes = raw.node_set != 0 ? find_members(build, raw.node_set, raw.node[0], raw.where)
                                   : find_pair(build, raw.node, raw.where);
    if (weld.nodes.empty()) continue;
    check_strength(build, raw, weld);
    owners.take(weld.nodes, fmt::format("spot weld {}", weld.id), raw.where);
    build.model.spot_welds.push_back(std::move(weld));
  }
}

void build_rivets(Build& build, Owners& owners) {
  for (std::size_t i = 0; i < build.deck.rivets.size(); ++i) {
    const RawRivet& raw = build.deck.rivets[i];
    const std::vector<Index> pair = find_pair(build, raw.node, raw.where);
    if (pair.empty()) continue;
    const UserId id = raw.id == 0 ? static_cast<UserId>(i) + 1 : raw.id;
    const auto& positions = build.model.nodes.position;
    if (positions[static_cast<std::size_t>(pair[0])] == positions[static_cast<std::size_t>(pair[1])])
      build.report.field_error(raw.where, {"N2", std::to_string(raw.node[1]), "a node apart from N1",
                                           "a rivet keeps the distance of two nodes", "distance"});
    owners.take(pair, fmt::format("rivet {}", id), raw.where);
    build.model.rivets.push_back({id, {pair[0], pair[1]}, raw.failure_time});
  }
}

void build_node_sets(Build& build, Owners& owners) {
  for (const RawConstrainedSet& raw : build.deck.constrained_sets) {
    std::vector<Index> nodes = find_members(build, raw.node_set, 0, raw.where);
    if (nodes.empty()) continue;
    owners.take(nodes, fmt::format("the constrained node set {}", raw.node_set), raw.where);
    build.model.constrained_node_sets.push_back({std::move(nodes), raw.direction, raw.failure_time});
  }
}

/// The equation of a deck, if all is well with it.
void build_equation(Build& build, const RawEquation& raw) {
  model::LinearEquation equation{raw.id, {}};
  for (const RawEquation::Term& term : raw.terms) {
    const Index node = build.find(Item::Node, {term.node, "NID", term.where});
    if (node == no_index) return;
    for (const model::LinearEquation::Term& other : equation.terms)
      if (other.node == node && other.component == term.component) {
        build.report.field_error(term.where, {"NID", std::to_string(term.node), "another node or DOF",
                                              "the equation has this one already", "twice"});
        return;
      }
    if (term.factor == 0) {
      build.report.field_error(
          term.where, {"COEF", "0", "a number other than zero", "a term of zero says nothing", "zero"});
      return;
    }
    equation.terms.push_back({node, term.component, term.factor});
  }
  if (equation.terms.empty())
    build.report.error(raw.where, "terms", "the equation has no terms");
  else
    build.model.linear_equations.push_back(std::move(equation));
}

/// A node in the middle of two others moves and turns by the mean of theirs: twice it less both is zero.
void build_mid_node(Build& build, const RawMidNode& raw) {
  constexpr const char* fields[] = {"DNID", "NID1", "NID2"};
  std::array<Index, 3> node{};
  for (std::size_t i = 0; i < 3; ++i) {
    node[i] = build.find(Item::Node, {raw.node[i], fields[i], raw.where});
    if (node[i] == no_index) return;
  }
  if (node[0] == node[1] || node[0] == node[2] || node[1] == node[2]) {
    build.report.field_error(raw.where, {"DNID", std::to_string(raw.node[0]), "three different nodes",
                                         "a node in the middle of two others", "same"});
    return;
  }
  for (int component = 0; component < 6; ++component)
    build.model.linear_equations.push_back(
        {raw.node[0], {{node[0], component, 1}, {node[1], component, -0.5}, {node[2], component, -0.5}}});
}

/// Nodes of equations belong to no other connection, but to as many equations as there are.
void build_equations(Build& build, Owners& owners) {
  for (const RawEquation& raw : build.deck.equations) build_equation(build, raw);
  for (const RawMidNode& raw : build.deck.mid_nodes) build_mid_node(build, raw);
  std::vector<Index> nodes;
  for (const model::LinearEquation& equation : build.model.linear_equations)
    for (const model::LinearEquation::Term& term : equation.terms) nodes.push_back(term.node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.empty()) return;
  owners.take(
      nodes, "a linear equation",
      build.deck.equations.empty() ? build.deck.mid_nodes.front().where : build.deck.equations.front().where);
}

/// The independent nodes of an interpolation, each once.
std::vector<model::Interpolation::Independent> find_independent(Build& build, const RawInterpolation& raw) {
  std::vector<model::Interpolation::Independent> found;
  for (const RawInterpolation::Independent& each : raw.independent) {
    std::vector<Index> nodes;
    if (!raw.of_sets)
      nodes = {build.find(Item::Node, {each.id, "INID", each.where})};
    else if (const std::vector<Index>* const members = set_nodes(build, {each.id, "INID", each.where}))
      nodes = *members;
    for (const Index node : nodes)
      if (node != no_index) {
        found.push_back(each.weights);
        found.back().node = node;
      }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
  return found;
}

void build_interpolation(Build& build, const RawInterpolation& raw, Owners& owners) {
  model::Interpolation interpolation = raw.interpolation;
  interpolation.dependent = build.find(Item::Node, {raw.dependent, "DNID", raw.where});
  interpolation.independent = find_independent(build, raw);
  if (interpolation.dependent == no_index) return;
  const auto same = [](const auto& a, const auto& b) { return a.node == b.node; };
  const auto& all = interpolation.independent;
  const bool twice = std::adjacent_find(all.begin(), all.end(), same) != all.end();
  const bool own = std::any_of(all.begin(), all.end(),
                               [&](const auto& each) { return each.node == interpolation.dependent; });
  if (twice || own || all.size() < 2) {
    build.report.error(raw.where, "independent nodes",
                       own     ? "the dependent node is one of the independent ones"
                       : twice ? "a node is among the independent ones twice"
                               : "there have to be two independent nodes at least");
    return;
  }
  owners.take({interpolation.dependent}, fmt::format("the interpolation {}", interpolation.id), raw.where);
  build.model.interpolations.push_back(std::move(interpolation));
}

/// Independent nodes may be in several interpolations, but in no other connection.
void build_interpolations(Build& build, Owners& owners) {
  if (build.deck.interpolations.empty()) return;
  for (const RawInterpolation& raw : build.deck.interpolations) build_interpolation(build, raw, owners);
  std::vector<Index> nodes;
  for (const model::Interpolation& interpolation : build.model.interpolations)
    for (const model::Interpolation::Independent& each : interpolation.independent)
      nodes.push_back(each.node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  owners.take(nodes, "the independent nodes of an interpolation", build.deck.interpolations.front().where);
}

}  // namespace

std::map<Index, Connection> connections_of_nodes(const Build& build) {
  std::map<Index, Connection> found;
  const auto take = [&](const auto& nodes, const Connection& connection) {
    for (const Index node : nodes) found[node] = connection;
  };
  constexpr std::array<bool, 3> all{true, true, true};
  for (const model::SpotWeld& weld : build.model.spot_welds)
    take(weld.nodes, {fmt::format("spot weld {}", weld.id), all, true});
  for (const model::Rivet& rivet : build.model.rivets)
    take(rivet.node, {fmt::format("rivet {}", rivet.id), all, false});
  for (const model::ConstrainedNodeSet& set : build.model.constrained_node_sets)
    take(set.nodes, {"a constrained node set", set.direction, false});
  for (const model::LinearEquation& equation : build.model.linear_equations)
    for (const model::LinearEquation::Term& term : equation.terms) {
      Connection& connection = found[term.node];
      connection.name = "a linear equation";
      if (term.component < 3) connection.translation[static_cast<std::size_t>(term.component)] = true;
    }
  for (const model::Interpolation& interpolation : build.model.interpolations) {
    take(std::vector<Index>{interpolation.dependent}, {"an interpolation", all, false});
    for (const model::Interpolation::Independent& each : interpolation.independent)
      take(std::vector<Index>{each.node}, {"an interpolation", all, false});
  }
  return found;
}

void build_connections(Build& build) {
  const RawDeck& deck = build.deck;
  if (deck.welds.empty() && deck.rivets.empty() && deck.constrained_sets.empty() && deck.equations.empty() &&
      deck.mid_nodes.empty() && deck.interpolations.empty())
    return;
  Owners owners(build);
  build_welds(build, owners);
  build_rivets(build, owners);
  build_node_sets(build, owners);
  build_equations(build, owners);
  build_interpolations(build, owners);
}

}  // namespace crumple::deck
