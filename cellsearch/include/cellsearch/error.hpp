// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "cellsearch/types.hpp"

namespace cellsearch {

/// What is wrong with the input. `Error::index()` says where.
enum class ErrorKind {
  BadLayout,            ///< span lengths or stride do not fit together; index -1
  EmptyInput,           ///< there is not a single node; index -1
  NonFiniteCoordinate,  ///< index: the node
  BadConnectivity,      ///< a segment names a node that does not exist; index: the segment
  BadExpansion,         ///< negative or not finite; index: the segment, -1 for the common expansion
  BadRadius,            ///< negative or not finite; index: the node
  BadNodeGroup,         ///< out of range; index: the node
  BadSegmentGroup,      ///< out of range; index: the segment
  BadNodeList,          ///< the list of nodes is out of range or not strictly ascending; index: place in list
  BadDomain,            ///< inverted, flat, non-finite or too many cells; index: the axis (0, 1, 2) or -1
  BadSetting,           ///< a setting is outside its range; index -1
  UnsuitedMethod,       ///< the method is not made for this scene (see Method); index: the segment
  BadNodeId,     ///< global number negative or given twice, or coordinates differ by rank; index: the node
  BadSegmentId,  ///< global number negative or given twice; index: the segment
};

/// The only exception of this library, apart from std::bad_alloc. It is thrown before the loops over segments
/// start, never inside, and the `Search` object stays usable afterwards. Where several inputs are wrong, the
/// smallest index is named, whatever the number of threads.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, Index index, const std::string& message)
      : std::runtime_error(message), kind_(kind), index_(index) {}

  /// The class of the error, for programs.
  ErrorKind kind() const noexcept { return kind_; }

  /// The node, segment, list place or axis concerned (see ErrorKind), or -1.
  Index index() const noexcept { return index_; }

 private:
  ErrorKind kind_;
  Index index_;
};

}  // namespace cellsearch
