// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple::elements {

/// The formulations of one family of elements; a place in the list names a formulation at run time.
template <class... Formulations>
struct FormulationList {
  static constexpr int count = sizeof...(Formulations);
};

}  // namespace crumple::elements
