// SPDX-License-Identifier: BSD-3-Clause
#include "app/preparation/model_summary.hpp"

#include <algorithm>
#include <ostream>

#include "app/console/print.hpp"
#include "app/preparation/bounding_box.hpp"
#include "app/preparation/left_out.hpp"
#include "app/preparation/part_tables.hpp"
#include "base/counted.hpp"
#include "contact/tied/node_rotation.hpp"

namespace crumple::app {

namespace {

std::string describe(const model::ContactSide& side) {
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + counted(count, what);
  };
  add(side.parts.size(), "part");
  add(side.shells.size(), "shell");
  add(side.segments.size(), "segment");
  add(side.nodes.size(), "node");
  return text;
}

std::string describe(const model::Contact& contact) {
  if (contact.kind == model::ContactKind::SingleSurface)
    return "single surface, " + describe(contact.side[0]);
  const bool nodes = contact.kind == model::ContactKind::NodesToSurface;
  return fmt::format("{}{}, {} to {}", nodes ? "nodes to surface" : "surface to surface",
                     contact.oriented ? " with an outside" : "", describe(contact.side[0]),
                     describe(contact.side[1]));
}

double lumped_mass(const model::Model& model) {
  double sum = 0;
  for (const model::LumpedMass& mass : model.lumped_masses) sum += mass.mass;
  return sum;
}

const char* name_of(model::WallShape shape) {
  switch (shape) {
    case model::WallShape::Flat:
      return "rectangle";
    case model::WallShape::Prism:
      return "prism";
    case model::WallShape::Cylinder:
      return "cylinder";
    case model::WallShape::Sphere:
      return "sphere";
    default:
      return "plane";
  }
}

std::string describe_motion(const model::RigidWall& wall) {
  if (wall.mass > 0) return fmt::format(", mass {:g}, velocity {:g}", wall.mass, wall.initial_velocity);
  return wall.motion.curve == no_index ? "" : ", moves";
}

/// Directions that are held, as "xyz/yz": along the axes and about them.
std::string held_words(const domain::RigidBody& body) {
  const auto axes = [](const std::array<bool, 3>& held) {
    std::string words;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (held[axis]) words += "xyz"[axis];
    return words.empty() ? "-" : words;
  };
  return axes(body.fixed_translation) + "/" + axes(body.fixed_rotation);
}

/// The bodies of the model, which stand before those of welds.
void print_rigid_bodies(std::ostream& out, const model::Model& model, const domain::Domain& domain) {
  constexpr std::size_t rows = 20;
  const auto& bodies = domain.rigid_bodies;
  const std::size_t count = model.rigid_bodies.size();
  if (count == 0) return;
  print(out, "  {:>10} {:>8} {:>11}  {:<35} {:<35} held\n", "rigid body", "nodes", "mass", "centre of mass",
        "principal moments of inertia");
  const auto three = [](const math::Vec3& v) { return fmt::format("{:.4g} {:.4g} {:.4g}", v.x, v.y, v.z); };
  for (std::size_t b = 0; b < std::min(rows, count); ++b)
    print(out, "  {:>10} {:>8} {:>11.4g}  {:<35} {:<35} {}\n", bodies[b].id, bodies[b].nodes.size(),
          bodies[b].mass, three(bodies[b].centre), three(bodies[b].principal_inertia), held_words(bodies[b]));
  if (count > rows) print(out, "  ... and {} more\n", count - rows);
}

/// "1 node is", "3 nodes are".
std::string nodes_are(Index count) {
  return count == 1 ? "1 node is" : fmt::format("{} nodes are", count);
}

/// Nodes that were meant to be tied and are too far away, furthest first.
void warn_of_untied(std::ostream& err, const domain::Tie& tie) {
  constexpr std::size_t shown = 5;
  if (tie.tied_elsewhere > 0)
    print(err, "warning: {}: {} tied by an earlier contact already, left out here\n", tie.name(),
          nodes_are(tie.tied_elsewhere));
  if (tie.untied.empty()) return;
  print(err, "warning: {}: {} not tied, too far away:", tie.name(),
        nodes_are(static_cast<Index>(tie.untied.size())));
  for (std::size_t i = 0; i < std::min(shown, tie.untied.size()); ++i)
    print(err, "{} {} by {:.4g}", i == 0 ? "" : ",", tie.untied[i].node, tie.untied[i].distance);
  print(err, "{}\n", tie.untied.size() > shown ? ", ..." : "");
}

/// Nodes that the contact would turn with segments that do not turn.
void warn_of_hinges(std::ostream& err, const model::TiedContact& given, const domain::Domain& domain,
                    const domain::Tie& tie) {
  const auto hinged = [&](const domain::TiedNode& tied) {
    for (std::size_t k = 0; k < 4; ++k)
      if (!tied.turns && tied.weight[k] != 0 && !contact::has_rotation(domain, tied.corner[k]))
        return domain.nodes.inertia[tied.node] > 0;
    return false;
  };
  const auto count = static_cast<Index>(std::count_if(tie.nodes.begin(), tie.nodes.end(), hinged));
  if (count > 0)
    print(
        err, "warning: {}: {} free to turn, as on a hinge: {}\n", tie.name(), nodes_are(count),
        given.turns_on_faces
            ? "too heavy against their segments, or held by springs"
            : "the segments, of solids, have no rotations; *CONTACT_TIED_SHELL_EDGE_TO_SOLID passes moments "
              "on to their nodes");
}

/// "4, 5, 6, ..."
std::string first_of(const std::vector<UserId>& ids) {
  constexpr std::size_t shown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, ids.size()); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", ids[i]);
  return text + (ids.size() > shown ? ", ..." : "");
}

/// Nodes of beams that were meant to move with solids, and do not.
void warn_of_embedding(std::ostream& err, const domain::Embedding& embedding) {
  if (embedding.elsewhere > 0)
    print(err, "warning: {}: {} coupled by an earlier one already, left out here\n", embedding.name(),
          nodes_are(embedding.elsewhere));
  if (!embedding.outside.empty())
    print(err, "warning: {}: {} in no solid, and not coupled: {}\n", embedding.name(),
          nodes_are(static_cast<Index>(embedding.outside.size())), first_of(embedding.outside));
  if (!embedding.long_beams.empty())
    print(err,
          "warning: {}: {} on through solids between {} nodes, where nothing is coupled: NCOUP and XINT have "
          "no effect, take shorter beams: {}\n",
          embedding.name(),
          embedding.long_beams.size() == 1 ? "1 beam goes"
                                           : fmt::format("{} beams go", embedding.long_beams.size()),
          embedding.long_beams.size() == 1 ? "its" : "their", first_of(embedding.long_beams));
}

/// Whether some of the elements are of parts of a contact.
template <class Element>
bool has_any(const model::Contact& contact, const std::vector<Element>& elements,
             const std::vector<Index>& wanted) {
  return std::ranges::any_of(contact.side, [&](const model::ContactSide& side) {
    return std::ranges::any_of(wanted, [&](Index element) {
      return std::ranges::binary_search(side.parts, elements[element].part);
    });
  });
}

/// Contact does not know which beams are in solids, so that these would press on the surface from inside.
void warn_of_inner_contact(std::ostream& err, const model::Model& model,
                           const model::EmbeddedBeams& embedded) {
  for (const model::Contact& contact : model.contacts)
    if (has_any(contact, model.beams, embedded.beams) && has_any(contact, model.solids, embedded.solids))
      print(
          err,
          "warning: Coupling of beams {}: contact {} has its beams and its solids, whose surface these beams "
          "may touch from inside: take them out of the contact\n",
          embedded.id, contact.id);
}

std::string describe(const domain::Tie& tie) {
  const Index springs = tie.springs();
  if (springs == 0) return "by constraint";
  if (tie.method != model::TieMethod::Offset || springs == static_cast<Index>(tie.nodes.size()))
    return "by penalty";
  return fmt::format("by constraint, {} by penalty", counted(springs, "node"));
}

void print_ties(std::ostream& out, const domain::Domain& domain) {
  for (const domain::Tie& tie : domain.ties) {
    print(out, "  tied contact {:<8} {}, {} to {}", tie.id, describe(tie), counted(tie.nodes.size(), "node"),
          counted(tie.segments, "segment"));
    if (tie.largest_move > 0)
      print(out, ", moved by up to {:.4g} (node {})", tie.largest_move, tie.moved_node);
    print(out, "\n");
  }
  for (const domain::Embedding& embedding : domain.embeddings)
    print(out, "  beams in solids {:<5} {} in solids, {} shared with them, {} in none\n", embedding.id,
          counted(embedding.nodes.size(), "node"), embedding.shared, embedding.outside.size());
}

void print_conditions(std::ostream& out, const model::Model& model) {
  print(out, "  nodes held            {}\n", model.fixed_nodes.size());
  print(out, "  initial velocities    {}\n", model.initial_velocities.size());
  if (!model.nodal_loads.empty()) print(out, "  nodal loads           {}\n", model.nodal_loads.size());
  if (!model.pressure_loads.empty()) print(out, "  pressure loads        {}\n", model.pressure_loads.size());
  if (!model.blast_segments.empty())
    print(out, "  segments under blast  {}, of {}\n", model.blast_segments.size(),
          counted(model.air_blasts.size(), "charge"));
  if (!model.viscous_segments.empty())
    print(out, "  non-reflecting faces  {}\n", model.viscous_segments.size());
  if (!model.control_volumes.empty())
    print(out, "  airbags               {}\n", model.control_volumes.size());
  if (!model.body_loads.empty()) print(out, "  body loads            {}\n", model.body_loads.size());
  if (!model.rigid_body_loads.empty())
    print(out, "  loads on rigid bodies {}\n", model.rigid_body_loads.size());
  if (!model.prescribed_motions.empty())
    print(out, "  prescribed motions    {}\n", model.prescribed_motions.size());
  if (model.relaxation) print(out, "  dynamic relaxation    before the run\n");
  if (!model.spot_welds.empty()) print(out, "  spot welds            {}\n", model.spot_welds.size());
  if (!model.rivets.empty()) print(out, "  rivets                {}\n", model.rivets.size());
  if (!model.constrained_node_sets.empty())
    print(out, "  constrained sets      {}\n", model.constrained_node_sets.size());
  if (!model.joints.empty()) print(out, "  joints                {}\n", model.joints.size());
  if (!model.joint_stiffnesses.empty())
    print(out, "  joint stiffnesses     {}\n", model.joint_stiffnesses.size());
  if (!model.linear_equations.empty())
    print(out, "  linear equations      {}\n", model.linear_equations.size());
  if (!model.interpolations.empty()) print(out, "  interpolated nodes    {}\n", model.interpolations.size());
  for (const model::RigidWall& wall : model.rigid_walls)
    print(out, "  rigid wall {:<10} {}{}, stops {}, friction {:g}\n", wall.id, name_of(wall.shape),
          describe_motion(wall), counted(wall.nodes.size(), "node"), wall.friction);
  for (const model::Contact& contact : model.contacts)
    print(out, "  contact {:<13} {}, friction {}\n", contact.id, describe(contact),
          contact.part_friction.empty()
              ? fmt::format("{:g}/{:g}", contact.static_friction, contact.dynamic_friction)
              : "by parts");
  for (const model::ForceTransducer& transducer : model.force_transducers)
    print(out, "  transducer {:<10} {}{}\n", transducer.id, describe(transducer.side[0]),
          transducer.side[1].empty() ? "" : ", from " + describe(transducer.side[1]));
  if (model.contacts.empty()) print(out, "  contact               none\n");
}

}  // namespace

void print_reading(std::ostream& out, const deck::ReadResult& deck) {
  for (const auto& file : deck.files) print(out, "Read {}\n", file.string());
  if (!deck.unit_system.empty()) print(out, "Units seem to be {}\n", deck.unit_system);
  print_left_out(out, left_out_of(deck));
}

void print_model(std::ostream& out, const model::Model& model, const domain::Domain& domain) {
  const auto triangles =
      std::count_if(model.shells.begin(), model.shells.end(),
                    [](const model::ShellElement& shell) { return shell.node[2] == shell.node[3]; });
  double mass = 0;
  for (const double nodal : domain.nodes.mass) mass += nodal;
  const BoundingBox box = bounding_box(model);
  if (!model.title.empty()) print(out, "\n{}\n", model.title);
  print(out, "\nModel\n");
  print(out, "  nodes                 {}\n", model.nodes.count());
  print(out, "  shells                {} ({} of them {})\n", model.shells.size(), triangles,
        triangles == 1 ? "a triangle" : "triangles");
  if (!model.solids.empty()) print(out, "  solids                {}\n", model.solids.size());
  if (!model.beams.empty()) print(out, "  beams                 {}\n", model.beams.size());
  if (!model.discretes.empty()) print(out, "  discrete elements     {}\n", model.discretes.size());
  print(out, "  mass                  {:.6g}, of it lumped {:.6g} at {}, added {:.4g}\n", mass,
        lumped_mass(model), counted(model.lumped_masses.size(), "node"), domain.added_mass);
  print(out, "  box                   x {:.6g} to {:.6g}, y {:.6g} to {:.6g}, z {:.6g} to {:.6g}\n",
        box.lowest[0], box.highest[0], box.lowest[1], box.highest[1], box.lowest[2], box.highest[2]);
  print_conditions(out, model);
  print_ties(out, domain);
  print_parts(out, model, domain);
  print_rigid_bodies(out, model, domain);
}

void warn_of_ties(std::ostream& err, const model::Model& model, const domain::Domain& domain) {
  for (std::size_t i = 0; i < domain.ties.size(); ++i) {
    warn_of_untied(err, domain.ties[i]);
    if (model.tied_contacts[i].ties_rotations)
      warn_of_hinges(err, model.tied_contacts[i], domain, domain.ties[i]);
  }
  for (const domain::Embedding& embedding : domain.embeddings) warn_of_embedding(err, embedding);
  for (const model::EmbeddedBeams& embedded : model.embedded_beams)
    warn_of_inner_contact(err, model, embedded);
}

}  // namespace crumple::app
