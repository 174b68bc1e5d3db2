// SPDX-License-Identifier: BSD-3-Clause
#include "model/air_blast.hpp"

#include <cmath>

namespace crumple::model {

ScaledRange scaled_range(AirBlast::Burst burst) {
  return burst == AirBlast::Burst::Surface ? ScaledRange{0.45, 100} : ScaledRange{0.37, 100};
}

double scaled_distance(const AirBlast& blast, double distance) {
  return distance * blast.units.feet / std::cbrt(blast.mass * blast.units.pounds);
}

}  // namespace crumple::model
