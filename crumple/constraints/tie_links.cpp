// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/tie_links.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "constraints/node_owners.hpp"
#include "constraints/tie_lever.hpp"

namespace crumple::constraints {
namespace {

using domain::Domain;
using domain::NodeFields;

/// By how much a corner that moves along its segment's normal may swing the end of a lever [-]: what nodes
/// weigh at the corners does not count it, and the stable step must not miss it.
constexpr double longest_lever = 0.35;
/// A node this far outside its segment, in weights, still follows it [-]: what it weighs at the opposite
/// corner is below zero.
constexpr double least_weight = -0.1;
/// Rotary inertia of a node that turns with a face over a corner's mass times the area of the face [-].
constexpr double most_turning_share = 0.25;

std::string name_of(const model::Model& model, const NodeFields& nodes, Index node) {
  return "node " + std::to_string(model.nodes.id[nodes.model_node[node]]);
}

/// Finds the links, with domain nodes as their members.
class LinkSearch {
 public:
  LinkSearch(const model::Model& model, Domain& domain)
      : model_(model),
        domain_(domain),
        owners_(owners_of_nodes(model)),
        part_(static_cast<std::size_t>(domain.nodes.count()), Part::None) {
    for (const model::RigidWall& wall : model.rigid_walls) {
      std::vector<char>& stops = stops_.emplace_back(part_.size(), 0);
      for (const Index node : wall.nodes) stops[domain.nodes.domain_node[node]] = 1;
    }
  }

  std::vector<TieLink> find();

 private:
  enum class Part : std::uint8_t { None, Follows, Leads };

  void add_tie(std::size_t t);
  void add_embedding(std::size_t e);
  void take_part(const TieLink& link);
  TieLink link_of(std::size_t t, const domain::TiedNode& tied) const;
  bool turns_on_face(const domain::TiedNode& tied) const;
  std::string fault_of(const domain::TiedNode& tied, bool rotates) const;
  std::string fault_of(const domain::EmbeddedNode& found) const;
  void require(const domain::Tie& tie, const domain::TiedNode& tied, bool rotates) const;
  Index rigid_corner(const domain::TiedNode& tied) const;
  bool may_follow(const domain::TiedNode& tied, bool rotates) const;
  bool passes_walls(const domain::TiedNode& tied) const;

  const model::Model& model_;
  Domain& domain_;
  NodeOwners owners_;
  std::vector<Part> part_;                ///< of domain nodes in the links so far
  std::vector<std::vector<char>> stops_;  ///< of each wall, by domain node
  std::vector<TieLink> links_;
};

/// What is wrong with tying a node, after its name; empty if nothing is. Fixed directions of the node must be
/// fixed at all nodes that it follows, as they are where both lie in a plane of symmetry.
std::string LinkSearch::fault_of(const domain::TiedNode& tied, bool rotates) const {
  const NodeFields& nodes = domain_.nodes;
  const Index at = nodes.model_node[tied.node];
  const std::string& owner = owners_.body[at].empty() ? owners_.joint[at] : owners_.body[at];
  if (!owner.empty()) return " is tied to a segment and belongs to " + owner;
  constexpr unsigned translations = 7;
  constexpr unsigned all = 63;
  const unsigned fixed = nodes.fixed[tied.node] & (rotates ? all : translations);
  for (std::size_t k = 0; k < 4; ++k)
    if (tied.weight[k] != 0 && (fixed & ~static_cast<unsigned>(nodes.fixed[tied.corner[k]])) != 0)
      return " is tied to a segment and held by *BOUNDARY_SPC in a direction in which that is free";
  return "";
}

/// The same of putting a node into a solid.
std::string LinkSearch::fault_of(const domain::EmbeddedNode& found) const {
  const NodeFields& nodes = domain_.nodes;
  const Index at = nodes.model_node[found.node];
  const std::string& owner = owners_.body[at].empty() ? owners_.joint[at] : owners_.body[at];
  if (!owner.empty()) return " lies in a solid and belongs to " + owner;
  if (part_[found.node] == Part::Follows) return " lies in a solid and is tied to a segment";
  constexpr unsigned translations = 7;
  for (Index k = 0; k < found.corners; ++k) {
    const Index corner = found.corner[static_cast<std::size_t>(k)];
    const std::string& body = owners_.body[nodes.model_node[corner]];
    if (!body.empty())
      return " lies in a solid with " + name_of(model_, nodes, corner) + " of " + body +
             ", which it can belong to by *CONSTRAINED_EXTRA_NODES";
    if ((nodes.fixed[found.node] & translations & ~static_cast<unsigned>(nodes.fixed[corner])) != 0)
      return " lies in a solid and is held by *BOUNDARY_SPC in a direction in which " +
             name_of(model_, nodes, corner) + " of that is free";
  }
  return "";
}

/// A corner that belongs to a rigid body, or no_index.
Index LinkSearch::rigid_corner(const domain::TiedNode& tied) const {
  for (std::size_t k = 0; k < 4; ++k)
    if (tied.weight[k] != 0 && !owners_.body[domain_.nodes.model_node[tied.corner[k]]].empty())
      return tied.corner[k];
  return no_index;
}

/// Of a tie by constraint, which has nothing else.
void LinkSearch::require(const domain::Tie& tie, const domain::TiedNode& tied, bool rotates) const {
  const std::string node = tie.name() + ": " + name_of(model_, domain_.nodes, tied.node);
  const std::string fault = fault_of(tied, rotates);
  if (!fault.empty())
    throw Error(node + fault +
                "; a node has room for one constraint, as in LS-DYNA. Take it out of the contact, or tie by "
                "penalty (_OFFSET).");
  const Index corner = rigid_corner(tied);
  if (corner != no_index)
    throw Error(node + " is tied to a segment with " + name_of(model_, domain_.nodes, corner) + " of " +
                owners_.body[domain_.nodes.model_node[corner]] +
                "; rigid bodies cannot take part in a tie by constraint, as in LS-DYNA. Tie by penalty "
                "(_OFFSET), or join the node to the body by *CONSTRAINED_EXTRA_NODES.");
}

/// Walls stop the corners instead of the node: each that stops the node must stop them, too.
bool LinkSearch::passes_walls(const domain::TiedNode& tied) const {
  return std::ranges::all_of(stops_, [&](const std::vector<char>& stops) {
    return stops[tied.node] == 0 ||
           std::ranges::all_of(tied.corner, [&](Index corner) { return stops[corner] != 0; });
  });
}

/// Of a tie with a gap: springs hold what may not follow. Chains are left to springs, so that no circle of
/// nodes comes about that follow each other.
bool LinkSearch::may_follow(const domain::TiedNode& tied, bool rotates) const {
  if (part_[tied.node] != Part::None) return false;
  for (std::size_t k = 0; k < 4; ++k)
    if (part_[tied.corner[k]] == Part::Follows || tied.weight[k] < least_weight) return false;
  std::array<math::Vec3, 4> corner;
  for (std::size_t k = 0; k < 4; ++k) corner[k] = domain_.nodes.position[tied.corner[k]];
  const TieLever lever(corner, tied.height);
  const double longer = std::max(norm(lever.first), norm(lever.second));
  return lever.size > 0 && std::fabs(tied.height) * longer <= longest_lever * lever.size &&
         fault_of(tied, rotates).empty() && rigid_corner(tied) == no_index && passes_walls(tied);
}

TieLink LinkSearch::link_of(std::size_t t, const domain::TiedNode& tied) const {
  TieLink link;
  link.tie = static_cast<Index>(t);
  link.at = static_cast<Index>(&tied - domain_.ties[t].nodes.data());
  link.node = tied.node;
  std::ranges::copy(tied.corner, link.corner.begin());
  std::ranges::copy(tied.weight, link.weight.begin());
  link.height = tied.height;
  link.block = tied.block;
  link.element = tied.element;
  const model::TiedContact& given = model_.tied_contacts[t];
  link.rotates = given.ties_rotations;
  for (std::size_t k = 0; k < 4; ++k)
    if (tied.weight[k] != 0 && !(domain_.nodes.inertia[tied.corner[k]] > 0)) link.rotates = false;
  link.turns_on_face = given.turns_on_faces && !link.rotates && turns_on_face(tied);
  link.rotates = link.rotates || link.turns_on_face;
  return link;
}

/// The corners move in place of the node's rotary inertia: they must outweigh it, as the stable step does not
/// know that it is not there.
bool LinkSearch::turns_on_face(const domain::TiedNode& tied) const {
  const NodeFields& nodes = domain_.nodes;
  if (!(nodes.inertia[tied.node] > 0)) return false;
  double lightest = nodes.mass[tied.corner[0]];
  for (const Index corner : tied.corner) lightest = std::min(lightest, nodes.mass[corner]);
  const auto& x = nodes.position;
  const double size =
      norm(cross(x[tied.corner[2]] - x[tied.corner[0]], x[tied.corner[3]] - x[tied.corner[1]]));
  return nodes.inertia[tied.node] <= most_turning_share * lightest * 0.5 * size;
}

void LinkSearch::add_tie(std::size_t t) {
  domain::Tie& tie = domain_.ties[t];
  links_.reserve(links_.size() + tie.nodes.size());
  for (domain::TiedNode& tied : tie.nodes) {
    const TieLink link = link_of(t, tied);
    if (tie.method == model::TieMethod::Constraint)
      require(tie, tied, link.rotates);
    else if (!may_follow(tied, link.rotates))
      continue;
    tied.follows = true;
    tied.turns = link.rotates;
    take_part(link);
  }
}

void LinkSearch::take_part(const TieLink& link) {
  part_[link.node] = Part::Follows;
  for (std::size_t k = 0; k < link.corners; ++k)
    if (part_[link.corner[k]] == Part::None) part_[link.corner[k]] = Part::Leads;
  links_.push_back(link);
}

void LinkSearch::add_embedding(std::size_t e) {
  const domain::Embedding& embedding = domain_.embeddings[e];
  for (std::size_t i = 0; i < embedding.nodes.size(); ++i) {
    const domain::EmbeddedNode& found = embedding.nodes[i];
    const std::string fault = fault_of(found);
    if (!fault.empty())
      throw Error(embedding.name() + ": " + name_of(model_, domain_.nodes, found.node) + fault +
                  ". A node has room for one constraint: take it out of the one or the other.");
    TieLink link;
    link.embedded = true;
    link.tie = static_cast<Index>(e);
    link.at = static_cast<Index>(i);
    link.node = found.node;
    link.corner = found.corner;
    link.weight = found.weight;
    link.corners = static_cast<std::size_t>(found.corners);
    take_part(link);
  }
}

std::vector<TieLink> LinkSearch::find() {
  for (const model::TieMethod method : {model::TieMethod::Constraint, model::TieMethod::Offset})
    for (std::size_t t = 0; t < domain_.ties.size(); ++t)
      if (domain_.ties[t].method == method) add_tie(t);
  for (std::size_t e = 0; e < domain_.embeddings.size(); ++e) add_embedding(e);
  return std::move(links_);
}

std::string name_of_tie(const Domain& domain, const TieLink& link) {
  return link.embedded ? domain.embeddings[link.tie].name() : domain.ties[link.tie].name();
}

/// Levels, and the order by them: what a node carries must be known before it is passed on.
void order_links(const model::Model& model, const Domain& domain, TieLinks& found) {
  std::vector<TieLink>& links = found.links;
  std::vector<Index> tied_by(found.members.size(), no_index);
  for (std::size_t i = 0; i < links.size(); ++i) tied_by[links[i].node] = static_cast<Index>(i);
  constexpr Index most = 100;  // more can only be a circle
  for (bool changed = true; changed;) {
    changed = false;
    for (TieLink& link : links)
      for (std::size_t k = 0; k < link.corners; ++k) {
        const Index under = tied_by[link.corner[k]];
        if (link.weight[k] == 0 || under == no_index || link.level > links[under].level) continue;
        link.level = links[under].level + 1;
        changed = true;
        if (link.level > most)
          throw Error(name_of_tie(domain, link) + ": " +
                      name_of(model, domain.nodes, found.members[link.node]) +
                      " is tied to a segment whose nodes are, by way of others, tied to it in turn. Take one "
                      "of these contacts out.");
      }
  }
  std::ranges::stable_sort(links, [](const TieLink& a, const TieLink& b) { return a.level > b.level; });
}

}  // namespace

TieLinks find_tie_links(const model::Model& model, Domain& domain) {
  TieLinks found;
  if (domain.ties.empty() && domain.embeddings.empty()) return found;
  found.links = LinkSearch(model, domain).find();
  std::vector<Index>& members = found.members;
  for (const TieLink& link : found.links) {
    members.push_back(link.node);
    members.insert(members.end(), link.corner.begin(), link.corner.begin() + link.corners);
  }
  std::ranges::sort(members);
  members.erase(std::unique(members.begin(), members.end()), members.end());
  const auto place_of = [&](Index node) {
    return static_cast<Index>(std::ranges::lower_bound(members, node) - members.begin());
  };
  for (TieLink& link : found.links) {
    link.node = place_of(link.node);
    for (std::size_t k = 0; k < link.corners; ++k) link.corner[k] = place_of(link.corner[k]);
  }
  order_links(model, domain, found);
  return found;
}

}  // namespace crumple::constraints
