// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "cellsearch/distributed/transport.hpp"

namespace cellsearch::transport_checks {

/// What any transport must do, as programs of one rank; each throws std::runtime_error where it does not. Run
/// in threads by transport_test.cpp and in processes by mpi_test.cpp.

/// Messages of known and unknown length to all ranks, itself included, over several rounds of two exchanges
/// that overlap.
void check_exchange(Transport& transport);

/// Minimum, maximum and sum, with signed zeros and NaN, the same bits on all ranks.
void check_reductions(Transport& transport);

/// Gathers to all and to one, with empty parts, and barriers.
void check_gathers(Transport& transport);

/// Nothing is lost where ranks are several rounds apart: a chain in which rank 0 only sends.
void check_ahead(Transport& transport);

/// All of the above.
void check_all(Transport& transport);

}  // namespace cellsearch::transport_checks
