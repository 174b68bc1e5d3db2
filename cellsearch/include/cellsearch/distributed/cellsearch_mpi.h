// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cellsearch/cellsearch.h"

/* The search over ranks (cellsearch/distributed/distributed.hpp) for C and Fortran, over MPI: target cellsearch::mpi.
   Settings and the scene of each rank are set in a handle as for a search of one rank; every rank holds its own nodes and
   segments. Status codes are those of cellsearch_status; code, sentence and index stay with that handle. Where the
   input of one rank is wrong all ranks return its code, and may go on. CELLSEARCH_TRANSPORT_FAULT: another rank cannot go
   on; leave. Every rank calls the collective functions in the same order: create, destroy, find and update. */

#ifdef __cplusplus
extern "C" {
#endif

/** The ranks of a communicator, and what they know of each other. Opaque. */
typedef struct cellsearch_ranks cellsearch_ranks;

/** `communicator`: its Fortran handle, in C MPI_Comm_c2f(communicator); it is duplicated. Null if memory ran out or MPI
    is not initialised. The caller ends it with cellsearch_ranks_destroy(), before MPI_Finalize(). */
cellsearch_ranks* cellsearch_ranks_create(int32_t communicator);

/** Ends it and all that it lent out. Null is allowed. */
void cellsearch_ranks_destroy(cellsearch_ranks* ranks);

/** The global numbers of all nodes and segments of a handle's scene, >= 0, counted as the caller likes. Viewed until they
    are set again; null where there are none. Not collective. CELLSEARCH_BAD_ARGUMENT. */
int32_t cellsearch_ranks_set_ids(cellsearch_ranks* ranks, cellsearch_handle* handle, const int64_t* node_id,
                                 const int64_t* segment_id);

/** The candidate segments of each node that takes part on this rank, of all ranks, as one search of the whole model would
    find them. With `base` the index base of the handle, row p = base, base + 1 ... in the order of the nodes that take
    part is (*segment)[(*first)[p - base] - base] to (*segment)[(*first)[p - base + 1] - base - 1]: held segments from the
    base on, ascending by global number. Each of the last three may be null. They belong to `ranks` and hold until its
    next search. Beside the codes of a build: CELLSEARCH_BAD_NODE_ID, CELLSEARCH_BAD_SEGMENT_ID,
    CELLSEARCH_BAD_ARGUMENT, CELLSEARCH_TRANSPORT_FAULT. */
int32_t cellsearch_ranks_find(cellsearch_ranks* ranks, cellsearch_handle* handle, const int64_t** first,
                              const int32_t** segment, int64_t* pairs);

/** What a rank holds after a search: own and ghost segments, own nodes and then ghost nodes. */
typedef struct cellsearch_held_parts {
  int64_t segments;             /**< number of held segments */
  int64_t own_nodes;            /**< number of nodes of this rank */
  int64_t ghost_nodes;          /**< number of nodes of other ranks */
  const int64_t* segment_id;    /**< global number of each held segment, ascending */
  const int32_t* owner;         /**< rank of each, from 0 as MPI counts */
  const int32_t* corner;        /**< 4 held nodes of each, from the index base: own ones first, then ghosts */
  const int64_t* ghost_node_id; /**< global number of each ghost node, ascending */
  const double* xyz;            /**< x, y, z of each held node [length] */
} cellsearch_held_parts;

/** Fills `held`; its arrays belong to `ranks` and hold until the next search; `xyz` follows the updates. Not
    collective. CELLSEARCH_NOT_BUILT. */
int32_t cellsearch_ranks_held(cellsearch_ranks* ranks, cellsearch_handle* handle, cellsearch_held_parts* held);

/** Takes the positions of own nodes again from the array set in the handle, and those of ghosts from their owners. Only
    coordinates travel; the candidates stay. CELLSEARCH_NOT_BUILT, CELLSEARCH_BAD_LAYOUT,
    CELLSEARCH_TRANSPORT_FAULT. */
int32_t cellsearch_ranks_update(cellsearch_ranks* ranks, cellsearch_handle* handle);

#ifdef __cplusplus
}
#endif
