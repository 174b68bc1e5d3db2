// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "loads/segment_pressure.hpp"
#include "math/rotation.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// Resistance of a solid's boundary per area to motion along and across its normal [mass/(area * time)].
struct Impedance {
  double normal = 0;      ///< rho c_d
  double tangential = 0;  ///< rho c_s
};

/// Dashpots on faces of solids that take waves of normal incidence without reflection
/// (*BOUNDARY_NON_REFLECTING): tractions -rho c_d v_n and -rho c_s v_t, rho, c_d and c_s being the density
/// and the speeds of dilatational and shear waves of the solid at time zero. Each corner of a segment has an
/// equal share of its present area. The velocity is the mean of those of n-1/2 and n+1/2, found with all
/// other forces at hand, so that the dashpots take energy in every step, however stiff, and leave the stable
/// step as it is. Nodes that a rigid body moves have none. Source: J. Lysmer, R.L. Kuhlemeyer, J. Eng. Mech.
/// Div. ASCE 95 (1969) 859-877; the time integration is our own derivation (docs/theory/viscous_boundary.md).
class ViscousBoundary {
 public:
  /// `impedances`: by part of the model, where it has viscous segments. The model must outlive the boundary.
  /// Throws Error if a node is tied to a segment.
  ViscousBoundary(const model::Model& model, const domain::Domain& domain,
                  const std::vector<Impedance>& impedances);

  /// Adds the forces at time n and, by the trapezoidal rule, what they took since time n-1 to the ledger's
  /// damping energy. On entry nodes.force has all forces but those of multipliers, nodes.velocity is
  /// v(n-1/2), clock.step the step before; `interval` is the time from there to n+1/2.
  void add_forces(domain::Domain& domain, double interval);

  /// What the forces at time zero take in the first half step beyond what the first step books: see
  /// timeloop/start_loss.hpp [energy].
  double start_loss() const { return start_loss_; }

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  struct Segment {
    SegmentNodes node{};
    double normal = 0;      ///< rho c_d / k of k corners, or 0 [mass/(area * time)]
    double tangential = 0;  ///< rho c_s / k, or 0 [mass/(area * time)]
    Index solid = no_index;
  };
  /// What a node gets in a step.
  struct Push {
    math::Vec3 force;
    math::Vec3 velocity;  ///< mean of v(n-1/2) and the v(n+1/2) that is expected
  };
  static Segment segment_of(const domain::Domain& domain, const model::ViscousSegment& given,
                            const Impedance& impedance);
  void list_corners();
  void find_eroded(const domain::Domain& domain);
  math::Matrix3 resistance(const domain::Domain& domain, std::size_t place) const;
  static Push push_on(const domain::NodeFields& nodes, Index node, const math::Matrix3& resistance,
                      double interval);

  const model::Model* model_;
  std::vector<Segment> segments_;
  std::vector<Index> nodes_;           ///< of the domain, ascending
  std::vector<Index> first_corner_;    ///< of each node, in corners_; one more than nodes
  std::vector<Index> corners_;         ///< segments
  std::vector<char> gone_;             ///< by solid of the model, as of `eroded_`
  Index eroded_ = no_index;            ///< solids that had eroded when `gone_` was found
  std::vector<math::Vec3> previous_;   ///< force on each node at time n-1
  std::vector<double> taken_;          ///< by the pieces of nodes; kept for its room alone
  std::vector<double> lost_at_start_;  ///< the same
  double start_loss_ = 0;
};

}  // namespace crumple::loads
