// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "contact/interface.hpp"
#include "domain/build.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"
#include "support/larger.hpp"

namespace crumple::test {

using math::Vec3;

/// Builds models of shells for contact tests: one part, elastic, with masses set by hand.
class Bodies {
 public:
  explicit Bodies(double thickness = 0.1) {
    model.shell_sections.resize(1);
    model.shell_sections[0].thickness = {thickness, thickness, thickness, thickness};
    model.materials.resize(1);
    model.materials[0].density = 1;
    model.materials[0].law = model::Elastic{1000.0, 0.25};
    model.parts.resize(1);
    model.parts[0].id = 1;
    model.parts[0].section = 0;
    model.parts[0].material = 0;
    contact.id = 7;
    contact.side[0].parts = {0};
  }

  /// Another part of the same shells, to which the next ones belong.
  Index part() {
    current_part = static_cast<Index>(model.parts.size());
    model.parts.push_back(model.parts[0]);
    model.parts.back().id = current_part + 1;
    return current_part;
  }

  /// Turns the model into two parts of solids of the one material, both of them in the contact.
  void take_two_parts_of_solids() {
    model.solid_sections.resize(1);
    model.parts.push_back({.id = 2, .title = "second"});
    for (model::Part& one : model.parts) {
      one.section = no_index;
      one.solid_section = 0;
      one.material = 0;
    }
    contact.side[0].parts = {0, 1};
  }

  Index node(const Vec3& x) {
    model.nodes.id.push_back(1000 + model.nodes.count());
    model.nodes.position.push_back({x.x, x.y, x.z});
    return model.nodes.count() - 1;
  }

  Index shell(Index a, Index b, Index c, Index d) {
    const auto place = static_cast<Index>(model.shells.size());
    model.shells.push_back({5000 + place, current_part, {a, b, c, d}, {}});
    return place;
  }

  /// Adds a part of round beams to the contact, and lets edges take part.
  void add_wires(double radius) {
    constexpr double pi = 3.14159265358979323846;
    model.beam_sections.resize(1);
    model.beam_sections[0].area = pi * radius * radius;
    model.parts.resize(2);
    model.parts[1].id = 2;
    model.parts[1].beam_section = 0;
    model.parts[1].material = 0;
    contact.side[0].parts = {0, 1};
    contact.edges = model::ContactEdges::Free;
  }

  Index beam(Index a, Index b) {
    const auto place = static_cast<Index>(model.beams.size());
    model::BeamElement element;
    element.id = 8000 + place;
    element.part = 1;
    element.node = {a, b};
    model.beams.push_back(element);
    return place;
  }

  /// A wire of n beams with node i at `at(i / n)`. Returns its first node; node i is first + i.
  template <class At>
  Index wire(int n, const At& at) {
    const Index first = model.nodes.count();
    for (int i = 0; i <= n; ++i) node(at(static_cast<double>(i) / n));
    for (int i = 0; i < n; ++i) beam(first + i, first + i + 1);
    return first;
  }

  /// A strip of nx by ny quadrilaterals: node (i, j) at `at(i / nx, j / ny)`. Returns its first node; node
  /// (i, j) is first + i (ny + 1) + j.
  template <class At>
  Index sheet(int nx, int ny, const At& at) {
    const Index first = model.nodes.count();
    for (int i = 0; i <= nx; ++i)
      for (int j = 0; j <= ny; ++j) node(at(static_cast<double>(i) / nx, static_cast<double>(j) / ny));
    for (int i = 0; i < nx; ++i)
      for (int j = 0; j < ny; ++j) {
        const Index corner = first + i * (ny + 1) + j;
        shell(corner, corner + ny + 1, corner + ny + 2, corner + 1);
      }
    return first;
  }

  /// The domain, with the same mass at every node.
  domain::Domain build(double mass = 1.0, int threads = 1) const {
    domain::Execution execution;
    execution.threads = threads;
    domain::Domain made = domain::build(model, execution);
    made.nodes.mass.assign(made.nodes.mass.size(), mass);
    made.contacts.resize(1);
    return made;
  }

  contact::Interface attach(const domain::Domain& made) const {
    return contact::Interface(model, made, contact, 0);
  }

  model::Model model;
  model::Contact contact;
  Index current_part = 0;
};

/// Index in the domain of a node of the model.
inline Index at(const domain::Domain& made, Index model_node) {
  return made.nodes.domain_node[model_node];
}

inline void clear_forces(domain::Domain& made) {
  for (domain::NodeForce& force : made.nodes.force) force = domain::NodeForce{};
  for (Vec3& force : made.contact_force) force = Vec3{};
}

/// Forces at the present positions.
inline void add_forces(contact::Interface& touching, domain::Domain& made) {
  clear_forces(made);
  touching.find_touches(made);
  touching.evaluate_forces(made);
  touching.add_forces(made);
}

/// Moves all nodes to new positions in one step, with the velocities that this takes, and adds the forces.
inline void move_to(contact::Interface& touching, domain::Domain& made, const std::vector<Vec3>& x,
                    double step) {
  for (Index i = 0; i < made.nodes.count(); ++i) {
    made.nodes.velocity[i] = (1.0 / step) * (x[i] - made.nodes.position[i]);
    made.nodes.position[i] = x[i];
  }
  made.clock.step = step;
  made.clock.time += step;
  ++made.clock.cycle;
  add_forces(touching, made);
}

/// Holds everything where it is for a step, after which contacts have the force of their depth: a landing
/// step has less.
inline void settle(contact::Interface& touching, domain::Domain& made) {
  const std::vector<Vec3> here(made.nodes.position.begin(), made.nodes.position.end());
  move_to(touching, made, here, made.clock.step);
}

/// One step of central differences under contact forces alone: velocities from the forces at time n, then
/// positions and forces at n+1. Nodes in `held` keep their velocity.
inline void integrate(contact::Interface& touching, domain::Domain& made, double step,
                      const std::vector<Index>& held = {}) {
  std::vector<char> fixed(made.nodes.count(), 0);
  for (const Index node : held) fixed[node] = 1;
  for (Index i = 0; i < made.nodes.count(); ++i) {
    const double* force = made.nodes.force[i].force;
    // The first kick is half a step, so that x(0) and v(-1/2) start from the same time.
    const double kick = made.clock.cycle == 0 ? 0.5 * step : step;
    if (fixed[i] == 0)
      made.nodes.velocity[i] += (kick / made.nodes.mass[i]) * Vec3{force[0], force[1], force[2]};
    made.nodes.position[i] += step * made.nodes.velocity[i];
  }
  made.clock.step = step;
  made.clock.time += step;
  ++made.clock.cycle;
  add_forces(touching, made);
}

struct Balance {
  double kinetic = 0;  ///< at time n, from the velocities before and after the kick [energy]
  Vec3 momentum;       ///< before the kick [mass * length/time]
  Vec3 spin;           ///< moment of momentum about the origin [mass * length^2/time]
};

inline Balance balance(const domain::Domain& made, double step) {
  Balance sum;
  for (Index i = 0; i < made.nodes.count(); ++i) {
    const double mass = made.nodes.mass[i];
    const double* force = made.nodes.force[i].force;
    const Vec3 kick = (step / mass) * Vec3{force[0], force[1], force[2]};
    const Vec3 before = made.nodes.velocity[i];
    sum.kinetic += 0.5 * mass * dot(before, before + kick);
    sum.momentum += mass * before;
    sum.spin += cross(made.nodes.position[i], mass * before);
  }
  return sum;
}

/// Throws everything that lies above z = `height` with this velocity, and what lies below against it.
inline void throw_together(domain::Domain& made, double height, const Vec3& velocity) {
  for (Index i = 0; i < made.nodes.count(); ++i)
    made.nodes.velocity[i] = (made.nodes.reference[i].z > height ? 1.0 : -1.0) * velocity;
}

/// What an impact under contact forces alone does to the sums.
struct Impact {
  Balance start;
  double stored = 0;  ///< largest energy in the contact [energy]
  double imbalance =
      0;  ///< largest difference of the kinetic and the stored energy from that at first [energy]
  double momentum = 0;  ///< largest change [mass * length/time]
  double spin = 0;      ///< largest change of the moment of momentum [mass * length^2/time]
};

/// Runs `steps` steps.
inline Impact impact(contact::Interface& touching, domain::Domain& made, double step, int steps) {
  Impact found;
  found.start = balance(made, step);
  for (int i = 0; i < steps; ++i) {
    integrate(touching, made, step);
    const Balance now = balance(made, step);
    const double stored = made.contacts[0].energy;
    found.stored = larger_of(found.stored, stored);
    found.imbalance = larger_of(found.imbalance, std::fabs(now.kinetic + stored - found.start.kinetic));
    found.momentum = larger_of(found.momentum, norm(now.momentum - found.start.momentum));
    found.spin = larger_of(found.spin, norm(now.spin - found.start.spin));
  }
  return found;
}

/// Turns everything as one body about an axis through the origin by an angle [rad], in many steps.
inline void turn(contact::Interface& touching, domain::Domain& made, const Vec3& axis, double angle,
                 int steps) {
  const Vec3 e = normalised(axis);
  const std::vector<Vec3> start(made.nodes.position.begin(), made.nodes.position.end());
  std::vector<Vec3> x(start.size());
  for (int i = 1; i <= steps; ++i) {
    const double a = angle * i / steps;
    for (std::size_t n = 0; n < x.size(); ++n)
      x[n] = std::cos(a) * start[n] + std::sin(a) * cross(e, start[n]) +
             (1 - std::cos(a)) * dot(e, start[n]) * e;
    move_to(touching, made, x, 1e-3);
  }
}

inline Vec3 total_force(const domain::Domain& made) {
  Vec3 sum;
  for (const Vec3& force : made.contact_force) sum += force;
  return sum;
}

inline Vec3 total_moment(const domain::Domain& made) {
  Vec3 sum;
  for (Index i = 0; i < made.nodes.count(); ++i) sum += cross(made.nodes.position[i], made.contact_force[i]);
  return sum;
}

/// Gives all shells the item that says whether they are active, as if their material could fail.
inline void make_erodible(domain::Domain& made) {
  for (domain::ShellBlock& block : made.shells) {
    const Index active = domain::add_item(block, "active", "-", 1);
    block.double_state.assign(static_cast<std::size_t>(block.groups()) * block.components * lanes, 0.0);
    for (Index place = 0; place < block.elements; ++place) block.set_state(place, active, 1);
  }
}

/// Lets these shells of the model fail.
inline void erode(domain::Domain& made, const std::vector<Index>& shells) {
  for (domain::ShellBlock& block : made.shells)
    for (Index place = 0; place < block.elements; ++place) {
      if (std::find(shells.begin(), shells.end(), block.element[place]) == shells.end()) continue;
      block.set_state(place, block.find("active")->first, 0);
      ++block.eroded;
    }
}

}  // namespace crumple::test
