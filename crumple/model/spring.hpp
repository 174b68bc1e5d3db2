// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>

#include "base/index.hpp"

namespace crumple::model {

// Laws of springs and dampers: a force over a deformation, positive where the ends move apart. For torsional
// elements read moment for force and angle for deformation.

/// Force = stiffness x deformation (*MAT_SPRING_ELASTIC).
struct LinearSpring {
  double stiffness = 0;  ///< K [force/length]
};

/// Force = constant x rate (*MAT_DAMPER_VISCOUS).
struct LinearDamper {
  double damping = 0;  ///< DC [force time/length]
};

/// Elastic, then linear isotropic hardening (*MAT_SPRING_ELASTOPLASTIC).
struct ElastoplasticSpring {
  double stiffness = 0;          ///< K [force/length]
  double tangent_stiffness = 0;  ///< KT, force over total deformation behind yield [force/length]
  double yield_force = 0;        ///< FY [force]
};

/// Force by a curve over the deformation, times a curve over the rate (*MAT_SPRING_NONLINEAR_ELASTIC).
struct NonlinearSpring {
  Index curve = no_index;       ///< in Model::curves
  Index rate_curve = no_index;  ///< in Model::curves; ordinate a factor; no_index: no effect of the rate
};

/// Force by a curve over the rate (*MAT_DAMPER_NONLINEAR_VISCOUS).
struct NonlinearDamper {
  Index curve = no_index;  ///< in Model::curves
};

/// A spring beside a spring in series with a damper: the stiffness falls from the first value to the last
/// (*MAT_SPRING_MAXWELL).
struct MaxwellSpring {
  double stiffness = 0;        ///< K0, at once [force/length]
  double final_stiffness = 0;  ///< KI, after all time [force/length]
  double decay = 0;            ///< BETA [1/time]
  double cut_off = 1e20;       ///< TC: from this time on the force is constant [time]
  double cut_off_force = 0;    ///< FC [force]
};

/// Force by a curve in one direction alone, which unloads with a stiffness of its own, for good
/// (*MAT_SPRING_INELASTIC).
struct InelasticSpring {
  Index curve = no_index;          ///< in Model::curves: amounts of force over amounts of deformation
  double unloading_stiffness = 0;  ///< KU; the steepest slope of the curve if that is larger
  bool tension = false;            ///< CTF: bears tension alone, else compression alone
};

/// A new law is one more alternative here.
using SpringLaw = std::variant<LinearSpring, LinearDamper, ElastoplasticSpring, NonlinearSpring,
                               NonlinearDamper, MaxwellSpring, InelasticSpring>;

/// The material of a part of springs or dampers; it has no density.
struct SpringMaterial {
  UserId id = 0;
  std::string title;
  SpringLaw law;
};

/// What a law is called.
const char* name_of(const SpringLaw& law);

}  // namespace crumple::model
