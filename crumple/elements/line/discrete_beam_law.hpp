// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "elements/line/discrete_law.hpp"
#include "model/model.hpp"

namespace crumple::elements {

/// Directions of a discrete beam: along r, s, t and about them.
inline constexpr int discrete_directions = 6;

/// Numbers that a direction remembers where it unloads on a path of its own.
inline constexpr int discrete_history = 2;

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
  double* history = nullptr;             ///< rows of direction and number; only where the law has any
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
  bool has_history() const { return unloading_ != Unloading::None; }
  /// Largest stiffness there can be in a direction, of a cable of this length without force.
  double stiffness(int direction, double free_length) const;
  double damping(int direction) const {
    return directions_[static_cast<std::size_t>(direction)].most_damping;
  }

 private:
  using Unloading = model::DiscreteBeamLaw::Unloading;

  struct Direction {
    double stiffness = 0;
    double damping = 0;
    double preload = 0;
    double tensile_limit = 0;
    double compressive_limit = 0;
    double most_stiffness = 0;
    double most_damping = 0;
    double unloading_stiffness = 0;
    Unloading unloading = Unloading::None;
    SlopedCurve curve, damping_curve, damping_factor, unloading_curve;

    double force(double displacement, double rate, double preload_share, double by_curve) const;
    /// Parts of the criteria of tension and compression; the beam fails at a sum of one.
    double tension(double displacement) const;
    double compression(double displacement) const;
  };
  /// The force of the curve, between displacements before and now.
  double curve_force(const Direction& one, double before, double now, double* history, int stride) const;
  double shifted_force(const Direction& one, double displacement, double* history, int stride) const;
  double quadratic_force(const Direction& one, double displacement, double* history, int stride) const;
  double preload_share(double time) const;

  model::DiscreteBeamLaw::Kind kind_ = model::DiscreteBeamLaw::Kind::Axes;
  double axial_stiffness_ = 0;  ///< E A of a cable [force]
  double area_ = 0;             ///< of a cable with a curve of stresses
  double ramp_time_ = 0;
  Unloading unloading_ = Unloading::None;
  double permanent_share_ = 0;
  bool joint_failure_ = false;
  double steepest_stress_ = 0;
  SlopedCurve stress_;
  std::array<Direction, discrete_directions> directions_;
};

}  // namespace crumple::elements
