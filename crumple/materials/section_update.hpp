// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/common/history_view.hpp"
#include "materials/common/section_material.hpp"
#include "materials/plasticity/fibre_plasticity.hpp"

namespace crumple::materials {

/// Increments of the strains of a cross section, or its resultants.
template <class Pack>
struct SectionNumbers {
  Pack of[section_row::count];
};

/// The strain of a point (s, t): the cross section stays plane, the twist shears across the way to the point.
template <class Pack>
CRUMPLE_INLINE FibreStrain<Pack> strain_at(const SectionNumbers<Pack>& e, const Pack& s, const Pack& t) {
  using namespace section_row;
  return {multiply_add(t, e.of[curvature_s], multiply_add(Pack(-s), e.of[curvature_t], e.of[stretch])),
          multiply_add(Pack(-t), e.of[twist], e.of[shear_s]), multiply_add(s, e.of[twist], e.of[shear_t])};
}

/// Adds the share of a point to the resultants: the transpose of strain_at().
template <class Pack>
CRUMPLE_INLINE void add_resultants(const FibreStress<Pack>& stress, const Pack& s, const Pack& t,
                                   const Pack& area, SectionNumbers<Pack>& q) {
  using namespace section_row;
  const Pack normal = area * stress.rr;
  const Pack along_s = area * stress.rs;
  const Pack along_t = area * stress.rt;
  q.of[stretch] = q.of[stretch] + normal;
  q.of[curvature_s] = multiply_add(t, normal, q.of[curvature_s]);
  q.of[curvature_t] = multiply_add(Pack(-s), normal, q.of[curvature_t]);
  q.of[twist] = multiply_add(s, along_t, multiply_add(Pack(-t), along_s, q.of[twist]));
  q.of[shear_s] = q.of[shear_s] + along_s;
  q.of[shear_t] = q.of[shear_t] + along_t;
}

/// The stress of one point at the end of the step.
template <class Law, class Pack>
CRUMPLE_INLINE FibreStress<Pack> updated_stress(const Law& law, const FibreStress<Pack>& old,
                                                const FibreStrain<Pack>& strain,
                                                const HistoryView<double>& history, Pack& intact) {
  const Pack zero(0.0);
  FibreStress<Pack> now = law.elasticity.stress(own_stress(law, old, history), strain);
  if constexpr (Law::can_yield) {
    now = law.returned(now, strain, history);
    if constexpr (requires { law.left(history); }) now = scaled(now, law.left(history));
    if (!law.fails()) return now;
    const auto holds = law.intact(history);
    intact = select<Pack>(holds, Pack(1.0), intact);
    now = {select<Pack>(holds, now.rr, zero), select<Pack>(holds, now.rs, zero),
           select<Pack>(holds, now.rt, zero)};
  }
  return now;
}

/// Brings all points of the cross sections of a pack of beams up to date.
template <class Law, class Pack>
void update_sections(const SectionTask& task) {
  constexpr int width = width_of<Pack>;
  const Law law(task);
  SectionNumbers<Pack> strain;
  SectionNumbers<Pack> sum;
  for (int row = 0; row < section_row::count; ++row) {
    strain.of[row] = load<Pack>(task.strain + row * width);
    sum.of[row] = Pack(0.0);
  }
  Pack intact(1.0);
  if constexpr (Law::has_stress) {
    if constexpr (Law::can_yield)
      if (law.fails()) intact = Pack(0.0);
    for (int p = 0; p < task.points; ++p) {
      const double* const place = task.place + p * section_place::count;
      const Pack s(place[section_place::s]);
      const Pack t(place[section_place::t]);
      double* const stress = task.state + (task.stress + section_components * p) * lanes;
      const HistoryView<double> history{task.state + task.history * lanes, task.points, p};
      const FibreStress<Pack> old{load<Pack>(stress), load<Pack>(stress + lanes),
                                  load<Pack>(stress + 2 * lanes)};
      const FibreStress<Pack> now = updated_stress(law, old, strain_at(strain, s, t), history, intact);
      store(stress, now.rr);
      store(stress + lanes, now.rs);
      store(stress + 2 * lanes, now.rt);
      add_resultants(now, s, t, Pack(place[section_place::area]), sum);
    }
  }
  for (int row = 0; row < section_row::count; ++row) store(task.resultant + row * width, sum.of[row]);
  store(task.intact, intact);
}

}  // namespace crumple::materials
