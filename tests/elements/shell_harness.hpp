// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "domain/build.hpp"
#include "elements/elements.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"

namespace crumple::elements::testing {

using math::Vec3;

inline constexpr double youngs_modulus = 210000;
inline constexpr double poissons_ratio = 0.3;
inline constexpr double density = 7.85e-9;
inline constexpr double thickness = 1.5;

inline model::Material elastic() {
  return {
      .id = 1, .title = "elastic", .density = density, .law = model::Elastic{youngs_modulus, poissons_ratio}};
}
inline model::Material plastic(double beta = 0.4, double tangent = 2100) {
  return {.id = 1,
          .title = "plastic",
          .density = density,
          .law = model::PlasticKinematic{youngs_modulus, poissons_ratio, 250, tangent, beta, 0, 0, 0}};
}
inline model::HourglassControl no_hourglass_control() {
  return {model::HourglassForm::Viscous, 0, 0, 0};
}

/// A plane grid of n x n elements of about `size`, each inner and outer node moved by up to `distortion` of
/// it.
inline void add_distorted_grid(model::Model& model, Index n, double size, double distortion, int seed = 1) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  test::add_grid(model, 0, n, n, [&](double u, double v) {
    const double dx = distortion * size * uniform(generator);
    const double dy = distortion * size * uniform(generator);
    return test::Point{u * n * size + dx, v * n * size + dy, 0};
  });
}

/// Makes two triangles of each quadrilateral; both have their first side along that of nodes 1 and 2.
inline void split_into_triangles(model::Model& model) {
  const std::vector<model::ShellElement> quads = std::move(model.shells);
  model.shells.clear();
  for (const model::ShellElement& quad : quads)
    for (const std::size_t first : {0U, 2U}) {
      const Index third = quad.node[(first + 2) % 4];
      model.shells.push_back({.id = static_cast<UserId>(model.shells.size()) + 1,
                              .part = quad.part,
                              .node = {quad.node[first], quad.node[first + 1], third, third}});
    }
}

inline model::Model plate(model::ShellFormulation formulation, Index n, double distortion, int points = 3,
                          const model::Material& material = elastic()) {
  model::Model model = test::one_part(material, test::shell_section(thickness, points, formulation));
  add_distorted_grid(model, n, 5, distortion);
  if (model::is_triangular(formulation)) split_into_triangles(model);
  return model;
}

/// Rotation by an angle about a unit axis (Rodrigues).
inline Vec3 rotated(const Vec3& x, const Vec3& axis, double angle) {
  return std::cos(angle) * x + std::sin(angle) * cross(axis, x) + (1 - std::cos(angle)) * dot(axis, x) * axis;
}

/// Moves every position of a model.
inline void place(model::Model& model, const std::function<Vec3(const Vec3&)>& map) {
  for (auto& p : model.nodes.position) {
    const Vec3 x = map({p[0], p[1], p[2]});
    p = {x.x, x.y, x.z};
  }
}

/// A domain driven by prescribed motion.
class Driven {
 public:
  Driven(const model::Model& model, const domain::Execution& execution)
      : domain(domain::build(model, execution)) {
    prepare_elements(model, domain);
  }

  /// One step: every node goes to target(x) and turns by turn(x) (a rotation vector in the sense of Hughes
  /// and Winget); then the forces of the new time.
  template <class Target, class Turn>
  void step(double dt, const Target& target, const Turn& turn) {
    domain::NodeFields& nodes = domain.nodes;
    for (Index i = 0; i < nodes.count(); ++i) {
      const Vec3 x = nodes.position[i];
      nodes.velocity[i] = (1 / dt) * (target(x) - x);
      nodes.angular_velocity[i] = (1 / dt) * turn(x);
      nodes.position[i] = target(x);
    }
    update(dt);
  }
  /// The same with one displacement and rotation per node.
  void step(double dt, const std::vector<Vec3>& displacement, const std::vector<Vec3>& rotation) {
    domain::NodeFields& nodes = domain.nodes;
    for (Index i = 0; i < nodes.count(); ++i) {
      nodes.velocity[i] = (1 / dt) * displacement[i];
      nodes.angular_velocity[i] = (1 / dt) * rotation[i];
      nodes.position[i] += displacement[i];
    }
    update(dt);
  }
  void update(double dt) {
    domain.nodes.publish_all();
    for (domain::NodeForce& f : domain.nodes.force) f = {};
    domain.clock.step = dt;
    add_element_forces(domain);
  }

  Vec3 force(Index node) const {
    const auto& f = domain.nodes.force[node].force;
    return {f[0], f[1], f[2]};
  }
  Vec3 moment(Index node) const {
    const auto& m = domain.nodes.force[node].moment;
    return {m[0], m[1], m[2]};
  }
  const domain::ShellBlock& block() const { return domain.shells[0]; }
  double stress(Index element, Index point, Index component) const {
    return block().state(element, point * 5 + component);
  }
  double largest_stress() const {
    double largest = 0;
    for (const domain::ShellBlock& b : domain.shells)
      for (Index e = 0; e < b.elements; ++e)
        for (Index c = 0; c < 5 * b.points; ++c) largest = test::larger_of(largest, std::fabs(b.state(e, c)));
    return largest;
  }
  double item(const std::string& name, Index element, Index at = 0) const {
    return block().state(element, block().find(name)->first + at);
  }

  domain::Domain domain;
};

struct Kind {
  model::ShellFormulation formulation;
  const char* name;
};
inline constexpr Kind belytschko_tsay{model::ShellFormulation::BelytschkoTsay, "BelytschkoTsay"};
inline constexpr Kind belytschko_wong_chiang{model::ShellFormulation::BelytschkoWongChiang,
                                             "BelytschkoWongChiang"};
inline constexpr Kind hughes_liu{model::ShellFormulation::HughesLiu, "HughesLiu"};
inline constexpr Kind hughes_liu_selective{model::ShellFormulation::HughesLiuSelectiveReduced,
                                           "HughesLiuSelective"};
inline constexpr Kind fully_integrated{model::ShellFormulation::FullyIntegrated, "FullyIntegrated"};
inline constexpr Kind triangle{model::ShellFormulation::Triangle, "Triangle"};
inline constexpr Kind membrane{model::ShellFormulation::Membrane, "Membrane"};
inline constexpr Kind full_membrane{model::ShellFormulation::FullyIntegratedMembrane,
                                    "FullyIntegratedMembrane"};
inline constexpr Kind membrane_triangle{model::ShellFormulation::MembraneTriangle, "MembraneTriangle"};
/// Every formulation of quadrilaterals that bend.
inline constexpr std::array kinds{belytschko_tsay, belytschko_wong_chiang, hughes_liu, hughes_liu_selective,
                                  fully_integrated};
/// With forces in the plane alone.
inline constexpr std::array membrane_kinds{membrane, full_membrane, membrane_triangle};
/// Every formulation; of triangles plate() makes two for each quadrilateral.
inline constexpr std::array all_kinds{belytschko_tsay,  belytschko_wong_chiang,
                                      hughes_liu,       hughes_liu_selective,
                                      fully_integrated, triangle,
                                      membrane,         full_membrane,
                                      membrane_triangle};
/// Every formulation of quadrilaterals.
inline constexpr std::array quadrilaterals{belytschko_tsay,      belytschko_wong_chiang, hughes_liu,
                                           hughes_liu_selective, fully_integrated,       membrane,
                                           full_membrane};
/// Those with one point in plane and hourglass control.
inline constexpr std::array one_point_kinds{belytschko_tsay, belytschko_wong_chiang, hughes_liu};

inline std::vector<domain::Execution> all_executions() {
  std::vector<domain::Execution> all;
  for (const Precision precision : {Precision::Double, Precision::Mixed})
    for (const Isa isa : available_isas()) all.push_back({precision, isa, 1});
  return all;
}
inline std::string name_of(const domain::Execution& execution) {
  return std::string(isa_name(execution.isa)) +
         (execution.precision == Precision::Mixed ? " mixed" : " double");
}
/// Round-off of the kernels' arithmetic.
inline double round_off(const domain::Execution& execution) {
  return execution.precision == Precision::Mixed ? 1.2e-7 : 2.2e-16;
}

/// Energy of one rectangular element whose nodes move as in a beam that is bent in the element's plane, over
/// the energy of the beam. `aspect` is length over height.
inline double in_plane_bending_energy(model::ShellFormulation formulation, double aspect) {
  model::Model model = plate(formulation, 1, 0);
  place(model, [&](const Vec3& x) { return Vec3{aspect * (x.x - 2.5), x.y - 2.5, 0}; });
  Driven beam(model, {Precision::Double, available_isas().back(), 1});
  const double curvature = 1e-9;
  std::vector<Vec3> u;
  for (const Vec3& x : beam.domain.nodes.position)
    u.push_back({curvature * x.x * x.y, -0.5 * curvature * (x.x * x.x + poissons_ratio * x.y * x.y), 0});
  beam.step(1e-7, u, std::vector<Vec3>(u.size()));
  const double exact = 0.5 * youngs_modulus * thickness * 125.0 / 12 * curvature * curvature * 5 * aspect;
  return beam.block().internal_energy / exact;
}

}  // namespace crumple::elements::testing
