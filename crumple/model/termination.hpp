// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/index.hpp"

namespace crumple::model {

/// A reason to end the run before its end time (*TERMINATION).
struct Termination {
  enum class Kind {
    Place,         ///< of a node along an axis, out of bounds
    Touch,         ///< a contact acts on a node
    Displacement,  ///< of the centre of a rigid body along an axis, out of bounds
    Distance,      ///< the same, its size
    NoContact,     ///< the force of a contact is no more than a threshold, for some time
    Deleted,       ///< elements of some parts have eroded
  };
  Kind kind = Kind::Place;
  UserId id = 0;          ///< of the node, body, contact, or of part or set, for the message
  Index item = no_index;  ///< node, rigid body or contact of the model
  int axis = 0;           ///< global; of a contact's force -1 is its size
  double most = 1e21;     ///< bounds [length]
  double least = -1e21;
  double threshold = 0;        ///< [force]
  double activation = 0;       ///< nothing counts before [time]
  double duration = 0;         ///< for this long [time]
  long count = 1;              ///< of elements
  std::vector<Index> parts{};  ///< of the elements
};

}  // namespace crumple::model
