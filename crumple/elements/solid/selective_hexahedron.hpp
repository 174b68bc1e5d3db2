// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements/solid/assumed_bending.hpp"
#include "elements/solid/hexahedron_gather.hpp"
#include "elements/solid/solid_geometry.hpp"
#include "elements/solid/solid_resistance.hpp"
#include "elements/solid/tangents.hpp"

namespace crumple::elements {

/// Vector areas across the tangents of the trilinear map at one of the eight points, an eighth of them, as
/// fields are given by sums over the nodes.
template <class Pack>
struct PointGeometry {
  ThreeVectors<Pack> area;
  Pack jacobian;
};

/// Derivatives of a field along xi, eta and zeta at a point, eight times.
template <class Pack>
CRUMPLE_INLINE ThreeVectors<Pack> tangents_at(const SolidPatterns<Pack>& f, Pack xi, Pack eta, Pack zeta) {
  using math::multiply_add;
  using namespace pattern;
  return {{multiply_add(eta, multiply_add(zeta, f.of[xi_eta_zeta], f.of[xi_eta]),
                        multiply_add(zeta, f.of[xi_zeta], f.of[pattern::xi])),
           multiply_add(xi, multiply_add(zeta, f.of[xi_eta_zeta], f.of[xi_eta]),
                        multiply_add(zeta, f.of[eta_zeta], f.of[pattern::eta])),
           multiply_add(xi, multiply_add(eta, f.of[xi_eta_zeta], f.of[xi_zeta]),
                        multiply_add(eta, f.of[eta_zeta], f.of[pattern::zeta]))}};
}
template <class Pack>
CRUMPLE_INLINE PointGeometry<Pack> geometry_at(const ThreeVectors<Pack>& t) {
  ThreeVectors<Pack> area = areas_across(t);
  for (math::PackVec3<Pack>& a : area.of) a = Pack(RealOf<Pack>(1.0 / 512)) * a;
  return {area, math::dot(t.of[0], area.of[0])};
}

/// Visits the eight points with their places as packs.
template <class Pack, class Visit>
CRUMPLE_INLINE void for_each_point(const Visit& visit) {
  using Real = RealOf<Pack>;
  for (int point = 0; point < 8; ++point) {
    constexpr double place = 0.57735026918962576;  // 1 / sqrt(3)
    const auto side = [&](int bit) { return Pack(static_cast<Real>((point & bit) != 0 ? place : -place)); };
    visit(point, side(1), side(2), side(4));
  }
}

/// The eight-node hexahedron with 2 x 2 x 2 points, whose dilatation is everywhere the mean over the element
/// (selectively reduced integration as mean dilatation: Nagtegaal, Parks & Rice, CMAME 4 (1974) 153-177;
/// Hughes, IJNME 15 (1980) 1413-1418): docs/theory/selectively_reduced_hexahedron.md. With `AssumesStrains`
/// less the strains that bending must not have (assumed_bending.hpp).
template <bool AssumesStrains>
struct AnySelectiveHexahedron {
  static constexpr int points = 8;
  static constexpr int corners = 8;
  static constexpr KeptItem kept{};
  static constexpr bool averages = false;

  static constexpr int row_volume = solid_scratch::own;
  static constexpr int row_dilatation = row_volume + 1;    ///< rate
  static constexpr int row_jacobian = row_dilatation + 1;  ///< of the points
  static constexpr int rows = row_jacobian + points;

  template <class Pack>
  static void strains(const SolidPlace<RealOf<Pack>>& place);
  template <class Pack>
  static SolidForces<Pack> forces(const SolidPlace<RealOf<Pack>>& place);
};

struct SelectiveHexahedron : AnySelectiveHexahedron<false> {
  static constexpr model::SolidFormulation formulation = model::SolidFormulation::SelectiveHexahedron;
  static constexpr const char* name = "selectively reduced hexahedron";
};

/// For elements that are much longer than thick: docs/theory/assumed_strain_hexahedron.md.
struct AssumedStrainHexahedron : AnySelectiveHexahedron<true> {
  static constexpr model::SolidFormulation formulation = model::SolidFormulation::AssumedStrainHexahedron;
  static constexpr const char* name = "assumed strain hexahedron";
};

template <bool AssumesStrains>
template <class Pack>
CRUMPLE_INLINE void AnySelectiveHexahedron<AssumesStrains>::strains(const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  const SolidMotion<Pack> motion = gathered_motion<Pack>(place, kept.count);
  const SolidPatterns<Pack>& x = motion.x;
  const SolidPatterns<Pack>& v = motion.v;
  const SolidGeometry<Pack> whole = solid_geometry(x, true);
  const PackMatrix<Pack> mean = velocity_gradient(whole, v, true);
  const Pack dilatation = trace(mean);
  keep_row(place, row_volume, whole.volume);
  keep_row(place, row_dilatation, dilatation);
  resist_early(place, whole.volume, dilatation);
  [[maybe_unused]] BendingFrame<Pack> frame;
  [[maybe_unused]] BendingModes<Pack> modes;
  if constexpr (AssumesStrains) {
    frame = bending_frame(x);
    modes = bending_modes(frame, x, v, mean);
  }
  for_each_point<Pack>([&](int point, const Pack& xi, const Pack& eta, const Pack& zeta) {
    const PointGeometry<Pack> g = geometry_at(tangents_at(x, xi, eta, zeta));
    PackMatrix<Pack> l = gradient_of(tangents_at(v, xi, eta, zeta), g.area, Pack(Pack(Real(1)) / g.jacobian));
    if constexpr (AssumesStrains) correct_bending(frame, modes, g.jacobian, {xi, eta, zeta}, l);
    lessen_diagonal(l, Pack(Pack(Real(1.0 / 3.0)) * (trace(l) - dilatation)));
    leave_strains(place, point, l);
    keep_row(place, row_jacobian + point, g.jacobian);
  });
}

template <bool AssumesStrains>
template <class Pack>
CRUMPLE_INLINE SolidForces<Pack> AnySelectiveHexahedron<AssumesStrains>::forces(
    const SolidPlace<RealOf<Pack>>& place) {
  using Real = RealOf<Pack>;
  using Vec = math::PackVec3<Pack>;
  using math::multiply_add;
  const SolidPatterns<Pack> x = left_positions<Pack>(place);
  const SolidGeometry<Pack> whole = solid_geometry(x, true);
  const Pack zero(Real(0));
  const Pack active = own_item<Pack>(place, solid_state::active);
  const Pack dilatation = kept_row<Pack>(place, row_dilatation);
  const Resistance<Pack> resistance = resist(place, active, whole.volume, dilatation);
  Pack work = -resistance.mean * (Pack(place.task.step) * dilatation) * kept_row<Pack>(place, row_volume);
  Pack spherical = zero;       // mean stress over the volume
  Pack narrowest(Real(1e30));  // square, with the sign of the Jacobian
  SolidPatterns<Pack> conjugate;
  for (Vec& f : conjugate.of) f = {zero, zero, zero};
  [[maybe_unused]] BendingFrame<Pack> frame;
  [[maybe_unused]] BendingModes<Pack> on_modes;
  if constexpr (AssumesStrains) {
    frame = bending_frame(x);
    on_modes = no_bending<Pack>();
  }
  for_each_point<Pack>([&](int point, const Pack& xi, const Pack& eta, const Pack& zeta) {
    using namespace pattern;
    const PointGeometry<Pack> g = geometry_at(tangents_at(x, xi, eta, zeta));
    PackMatrix<Pack> stress = stress_of<Pack>(place, point, active);
    const Pack mean = Pack(Real(1.0 / 3.0)) * trace(stress);
    lessen_diagonal(stress, mean);
    if constexpr (AssumesStrains) add_bending(frame, stress, {xi, eta, zeta}, on_modes);
    spherical = multiply_add(g.jacobian, mean, spherical);
    work = multiply_add(Pack(active * kept_row<Pack>(place, solid_scratch::material_energy + point)),
                        kept_row<Pack>(place, row_jacobian + point), work);
    const Vec f[3] = {stress * g.area.of[0], stress * g.area.of[1], stress * g.area.of[2]};
    const auto add = [&](int p, const Vec& more) { conjugate.of[p] = conjugate.of[p] + more; };
    add(pattern::xi, f[0]);
    add(pattern::eta, f[1]);
    add(pattern::zeta, f[2]);
    add(eta_zeta, multiply_add(zeta, f[1], eta * f[2]));
    add(xi_zeta, multiply_add(zeta, f[0], xi * f[2]));
    add(xi_eta, multiply_add(eta, f[0], xi * f[1]));
    add(xi_eta_zeta,
        multiply_add(Pack(eta * zeta), f[0], multiply_add(Pack(xi * zeta), f[1], Pack(xi * eta) * f[2])));
    const Pack largest =
        larger(math::dot(g.area.of[0], g.area.of[0]),
               larger(math::dot(g.area.of[1], g.area.of[1]), math::dot(g.area.of[2], g.area.of[2])));
    narrowest = smaller(narrowest, Pack(g.jacobian * absolute(g.jacobian) / largest));
  });
  keep_row(place, solid_scratch::internal_energy, work);
  leave_damping_energy(place, active, row_jacobian);
  keep_row(place, solid_scratch::hourglass_energy, zero);
  if constexpr (AssumesStrains) take_bending_forces(frame, on_modes, x, whole, conjugate);
  const Pack pressure = multiply_add(spherical, resistance.per_volume, Pack(-resistance.pressure));
  for (int p = 0; p < 6; ++p) conjugate.of[p] = multiply_add(pressure, whole.gradient[p], conjugate.of[p]);
  // One that is inside out at a point ends the run.
  Pack length = smaller(Pack(whole.volume / square_root(largest_face_squared(x))),
                        free_length(whole, 6, shear_share_of<Pack>(place)));
  if constexpr (AssumesStrains) length = skew_factor(frame.tangent) * length;
  leave_limit(place, active, select<Pack>(narrowest > zero, length, narrowest), resistance);
  return nodal_forces(conjugate);
}

}  // namespace crumple::elements
