// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "elements/line/discrete_law.hpp"
#include "model/model.hpp"

namespace crumple::elements {

/// Directions of a discrete beam: along r, s, t and about them.
inline constexpr int discrete_directions = 6;

/// The numbers of a law as ElementBlock::material_constants holds them, curves included: those of one
/// quadrant are mirrored.
std::vector<double> discrete_beam_numbers(const model::DiscreteBeamLaw& law, const model::Model& model,
                                          const model::DiscreteBeamData& data);

/// One step of the beams of a pack; rows of `width` numbers, one for each direction.
struct DiscreteBeamStep {
  int width = 0;
  double time = 0;                       ///< at its end [time]
  double step = 0;                       ///< [time]; may be 0
  const double* displacement = nullptr;  ///< at its end; turns behind lengths
  const double* before = nullptr;        ///< at its beginning
  const double* free_length = nullptr;   ///< one row: of lines and cables, without force [length]
  double* force = nullptr;               ///< out
  double* intact = nullptr;              ///< out, one row: 0 where a limit has been passed, else 1
};

/// The law of a block of discrete beams; reads `numbers`, which must outlive it. Plain code, the same for all
/// instruction sets.
class DiscreteBeamResponse {
 public:
  explicit DiscreteBeamResponse(const double* numbers);

  void forces(const DiscreteBeamStep& step) const;

  model::DiscreteBeamLaw::Kind kind() const { return kind_; }
  /// Largest stiffness there can be in a direction, of a cable of this length without force.
  double stiffness(int direction, double free_length) const;
  double damping(int direction) const {
    return directions_[static_cast<std::size_t>(direction)].most_damping;
  }

 private:
  struct Direction {
    double stiffness = 0;
    double damping = 0;
    double preload = 0;
    double tensile_limit = 0;
    double compressive_limit = 0;
    double most_stiffness = 0;
    double most_damping = 0;
    SlopedCurve curve, damping_curve;

    double force(double displacement, double rate, double preload_share) const;
    bool holds(double displacement) const;
  };
  double preload_share(double time) const;

  model::DiscreteBeamLaw::Kind kind_ = model::DiscreteBeamLaw::Kind::Axes;
  double axial_stiffness_ = 0;  ///< E A of a cable [force]
  double area_ = 0;             ///< of a cable with a curve of stresses
  double ramp_time_ = 0;
  double steepest_stress_ = 0;
  SlopedCurve stress_;
  std::array<Direction, discrete_directions> directions_;
};

}  // namespace crumple::elements
