// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/** C interface of cellsearch, C99, also for Fortran by iso_c_binding (cellsearch.f90).

    Contact search: for every segment of a mesh, the nodes inside its bounding box expanded by c. Create a
    handle, tell it where the arrays are, search, read the rows, move, search again; destroy it at the end.

    - Units are the caller's, as long as they are consistent: [length], [time].
    - Arrays are viewed, not copied. They stay the caller's and must be alive and unchanged from a build to
      the last query after it; then they may be changed in place, and the next build sees it. Only where the
      index base is 1, node numbers are copied at each build.
    - Every function that returns int32_t `status` returns CELLSEARCH_OK or one of the codes below; the handle
      then holds code, message and index of what was wrong, until its next call. Nothing is thrown, nothing
      aborts, and the handle stays usable. Search and query cost O(N) time, everything else O(1) if not said
      otherwise.
    - A handle may be used by one thread at a time; different handles are independent. There is no global
      state. A null handle gives CELLSEARCH_BAD_ARGUMENT. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A search with its settings, views and results. */
typedef struct cellsearch_handle cellsearch_handle;

/** Status codes. The number is fixed for ever; in brackets what cellsearch_error_index() names, in the
    index base of the handle where it is a node, segment, group or place, and -1 where nothing is said. */
enum cellsearch_status {
  CELLSEARCH_OK = 0,
  CELLSEARCH_BAD_LAYOUT = 1,            /**< lengths or stride do not fit together */
  CELLSEARCH_EMPTY_INPUT = 2,           /**< there is not a single node */
  CELLSEARCH_NON_FINITE_COORDINATE = 3, /**< NaN or infinite [node] */
  CELLSEARCH_BAD_CONNECTIVITY = 4,      /**< a segment names a node that does not exist [segment] */
  CELLSEARCH_BAD_EXPANSION = 5,         /**< negative or not finite [segment; -1: the common one] */
  CELLSEARCH_BAD_NODE_LIST = 6,         /**< out of range or not strictly ascending [place in the list] */
  CELLSEARCH_BAD_DOMAIN = 7,         /**< inverted, flat, not finite, too many cells [axis from 0, or -1] */
  CELLSEARCH_BAD_SETTING = 8,        /**< a setting is outside its range */
  CELLSEARCH_BAD_RADIUS = 9,         /**< negative or not finite [node] */
  CELLSEARCH_BAD_NODE_GROUP = 10,    /**< out of range [node] */
  CELLSEARCH_BAD_SEGMENT_GROUP = 11, /**< out of range [segment] */
  CELLSEARCH_UNSUITED_METHOD = 12,   /**< the method is not made for this scene [segment] */
  CELLSEARCH_BAD_NODE_ID = 13,       /**< global number negative, twice, or coordinates differ by rank [node] */
  CELLSEARCH_BAD_SEGMENT_ID = 14,    /**< global number negative or twice [segment] */
  CELLSEARCH_BAD_ARGUMENT = 20,      /**< a null pointer or a negative number where none may be */
  CELLSEARCH_NOT_BUILT = 21,         /**< no successful build since the last change of settings or views */
  CELLSEARCH_OUT_OF_MEMORY = 22,     /**< memory ran out */
  CELLSEARCH_INTERNAL_ERROR = 23,    /**< a fault of the library; please report it */
  CELLSEARCH_TRANSPORT_FAULT = 24    /**< another rank cannot go on, or cannot be reached */
};

/* ---- handle and errors ---- */

/** A new handle: index base 0, one thread, default method, no arrays. Null if memory ran out. The caller
    gives it back with cellsearch_destroy(). */
cellsearch_handle* cellsearch_create(void);

/** Ends a handle and all results that it lent out. Null is allowed. */
void cellsearch_destroy(cellsearch_handle* handle);

/** The version of the library, as "0.1.0"; never ends. */
const char* cellsearch_version(void);

/** The status of the last call with this handle. */
int32_t cellsearch_error_code(const cellsearch_handle* handle);

/** One sentence about it, at most 511 characters and a null; empty after success. Belongs to the handle,
   holds until its next call. */
const char* cellsearch_error_message(const cellsearch_handle* handle);

/** The node, segment, place or axis concerned, see cellsearch_status; -1 if none, also after success. */
int64_t cellsearch_error_index(const cellsearch_handle* handle);

/* ---- settings; each ends the validity of the last build; after an error the old value stays ---- */

/** Number of the first node, segment and group in all arrays given and returned: 0 (as created; C) or 1
    (Fortran). Else CELLSEARCH_BAD_SETTING. */
int32_t cellsearch_set_index_base(cellsearch_handle* handle, int32_t base);

/** The method by its name, a null-terminated string. CELLSEARCH_BAD_SETTING names those that exist. */
int32_t cellsearch_set_method(cellsearch_handle* handle, const char* name);

/** Number of the methods, and the name of each, 0 <= number < count; null else. */
int32_t cellsearch_method_count(void);
const char* cellsearch_method_name(int32_t number);

/** Number of threads, >= 1, else CELLSEARCH_BAD_SETTING. Results do not depend on it in any bit. */
int32_t cellsearch_set_threads(cellsearch_handle* handle, int32_t threads);

/** Edge of the cells [length], > 0, finite, else CELLSEARCH_BAD_SETTING; 0: chosen by the method again. Larger ones
    are taken where these would be too many. */
int32_t cellsearch_set_cell_edge(cellsearch_handle* handle, double edge);

/** Instruction set of the production method by its name: "portable", "avx2", "avx512"; empty: the best that this
    processor has. CELLSEARCH_BAD_SETTING if there is none of that name or the processor lacks it. */
int32_t cellsearch_set_instruction_set(cellsearch_handle* handle, const char* name);

/** Automatic cells: cell edge over mean segment edge, > 0, finite, else CELLSEARCH_BAD_SETTING. */
int32_t cellsearch_set_cell_factor(cellsearch_handle* handle, double factor);

/** Automatic cells: at most this many per node, > 0, finite, else CELLSEARCH_BAD_SETTING. */
int32_t cellsearch_set_cells_per_node(cellsearch_handle* handle, double cells);

/** Cells over part of space only: nodes outside the closed box are never candidates. `minimum`, `maximum`:
    corners, x, y, z [length]; `cells`: Nx, Ny, Nz, >= 1. All three null: automatic again. The numbers are
    copied. CELLSEARCH_BAD_DOMAIN, CELLSEARCH_BAD_ARGUMENT. */
int32_t cellsearch_set_domain(cellsearch_handle* handle, const double* minimum, const double* maximum,
                              const int32_t* cells);

/* ---- the scene; each ends the validity of the last build; errors show at the build if not said here.
   Set positions and segments first: arrays by node or by segment have as many entries as there are nodes or
   segments then. If these numbers change, set the arrays anew, or the build gives CELLSEARCH_BAD_LAYOUT. ----
 */

/** Positions: node number i (from 0) has x, y, z at xyz[i * stride + 0, 1, 2] [length]. `nodes`: how many,
    `stride`: doubles from one node to the next, >= 3. Viewed. CELLSEARCH_BAD_ARGUMENT, CELLSEARCH_BAD_LAYOUT.
 */
int32_t cellsearch_set_positions(cellsearch_handle* handle, int64_t nodes, const double* xyz, int64_t stride);

/** Segments: 4 node numbers each, in order around it, one segment after another; a triangle repeats its last
    node. Viewed. May be none. CELLSEARCH_BAD_ARGUMENT, CELLSEARCH_BAD_LAYOUT. */
int32_t cellsearch_set_segments(cellsearch_handle* handle, int64_t segments, const int32_t* nodes);

/** c, by which the box of every segment is expanded on all sides [length], >= 0, finite; 0 as created. */
int32_t cellsearch_set_expansion(cellsearch_handle* handle, double expansion);

/** One further expansion per segment [length], >= 0, finite, added to c. Viewed. Null: none. */
int32_t cellsearch_set_segment_expansion(cellsearch_handle* handle, const double* expansion);

/** The nodes that may be candidates: `count` numbers, strictly ascending. Viewed. Null: all nodes. A count of
    0 with a pointer that is not null: none. CELLSEARCH_BAD_ARGUMENT. */
int32_t cellsearch_set_nodes(cellsearch_handle* handle, int64_t count, const int32_t* nodes);

/** A radius per node [length], >= 0, finite, added to the expansion in tests of this node. Viewed. Null:
    none. */
int32_t cellsearch_set_node_radius(cellsearch_handle* handle, const double* radius);

/** A flag per segment: 0 switches it off (eroded), so that it has no candidates. Viewed. Null: all on. */
int32_t cellsearch_set_active(cellsearch_handle* handle, const uint8_t* active);

/** Whether nodes that share an active segment with a node of the segment are excluded as well: 0 no (as
    created), else yes. */
int32_t cellsearch_set_exclude_neighbours(cellsearch_handle* handle, int32_t exclude);

/** Who may touch whom: `node_group` per node and `segment_group` per segment, numbered from the index base;
    a node of group b is a candidate of a segment of group a only if allow[a * groups + b] is not 0 with a and
    b counted from 0 (in Fortran: allow(b, a)). Viewed. groups = 0: everyone may. CELLSEARCH_BAD_ARGUMENT. */
int32_t cellsearch_set_groups(cellsearch_handle* handle, int32_t groups, const int32_t* node_group,
                              const int32_t* segment_group, const uint8_t* allow);

/* ---- search ---- */

/** Checks the scene and sorts its nodes. Ends the validity of earlier results. Any status from
    CELLSEARCH_BAD_LAYOUT to CELLSEARCH_UNSUITED_METHOD. */
int32_t cellsearch_build(cellsearch_handle* handle);

/** The candidates of the last build. With `base` the index base, row s = base .. base + segments - 1 is
    (*node)[(*first)[s - base] - base] to (*node)[(*first)[s - base + 1] - base - 1]; in Fortran
   node(first(s)) to node(first(s + 1) - 1). In each row nodes ascend, none twice. `first`: segments + 1
   numbers; `node`: `pairs` numbers; each of the three may be null if it is not wanted. They belong to the
   handle and hold until its next query, build or end. CELLSEARCH_NOT_BUILT. */
int32_t cellsearch_query(cellsearch_handle* handle, const int64_t** first, const int32_t** node,
                         int64_t* pairs);

/** cellsearch_build() and cellsearch_query() at once. */
int32_t cellsearch_find(cellsearch_handle* handle, const int64_t** first, const int32_t** node,
                        int64_t* pairs);

/** Called for a pair; `data` is what the caller of cellsearch_visit() gave. Returns 0 to go on. It must not
    use the handle, throw or jump out. */
typedef int32_t cellsearch_visitor(int32_t segment, int32_t node, void* data);

/** Calls `visitor` for the pairs of the last build, in the order of cellsearch_query(), on the calling
   thread, and stores nothing. Stops without error when it returns something else than 0.
   CELLSEARCH_NOT_BUILT. */
int32_t cellsearch_visit(cellsearch_handle* handle, cellsearch_visitor* visitor, void* data);

/** What the last build and the queries since did; does not depend on the number of threads. */
typedef struct cellsearch_counts {
  int64_t segments;        /**< rows of the result */
  int64_t participants;    /**< nodes that took part */
  int64_t nodes_in_domain; /**< of these, inside the given domain */
  int64_t cells;           /**< number of cells; 0 for methods without */
  int64_t bytes;           /**< working memory [bytes] */
  int64_t cell_visits;     /**< cells looked into */
  int64_t raw_visits;      /**< nodes looked at */
  int64_t candidates;      /**< pairs reported */
} cellsearch_counts;

/** Fills `counts`. CELLSEARCH_NOT_BUILT. */
int32_t cellsearch_statistics(cellsearch_handle* handle, cellsearch_counts* counts);

/** Compares the candidates of the last build with brute force, O(N^2) time. `segment`, `node`: the first pair
    that one of the two lacks, or base - 1 if they are equal. CELLSEARCH_NOT_BUILT. */
int32_t cellsearch_verify(cellsearch_handle* handle, int64_t* segment, int64_t* node);

/* ---- further queries; they need no build, look at the scene during the call only, and cost O(N + results)
   time. Each result belongs to the handle and holds until the next call of the same function, or the handle's
   end. Status codes are those of a build. ---- */

/** Which segments are near which: all pairs i < j whose boxes, each expanded by its own expansion, have a
   point in common (for all segments within d of each other set the expansion d / 2). `exclude_shared_nodes`:
   not 0 leaves out pairs with a node in common. Flags of activity and groups count (either of the two
   directions is enough), what concerns nodes does not. Rows as in cellsearch_query(): row i holds its j > i,
   ascending; `first`: segments + 1 numbers, `second`: `pairs` numbers; each may be null. */
int32_t cellsearch_segment_pairs(cellsearch_handle* handle, int32_t exclude_shared_nodes,
                                 const int64_t** first, const int32_t** second, int64_t* pairs);

/** The different edges of the active segments: two node numbers each, the smaller first, ascending. `nodes`:
   2 * `edges` numbers. Each may be null. */
int32_t cellsearch_edges(cellsearch_handle* handle, const int32_t** nodes, int64_t* edges);

/** Which edges are near which: all pairs i < j of the edges of cellsearch_edges(), numbered in its order from
   the index base, whose boxes, each expanded by `expansion` [length], have a point in common.
   `exclude_shared_nodes` and the rows as above. CELLSEARCH_BAD_EXPANSION. The edges of cellsearch_edges() are
   found anew. */
int32_t cellsearch_edge_pairs(cellsearch_handle* handle, double expansion, int32_t exclude_shared_nodes,
                              const int64_t** first, const int32_t** second, int64_t* pairs);

/** Nearest nodes, one row per node whether it takes part or not, each by ascending distance, then number.
   With `base` the index base, row p is node[first[p - base] - base] to node[first[p - base + 1] - base - 1].
 */
typedef struct cellsearch_neighbours {
  const int64_t* first;   /**< nodes + 1 numbers */
  const int32_t* node;    /**< `count` numbers */
  const double* distance; /**< `count` distances [length], in the same places */
  int64_t count;          /**< of all rows together */
} cellsearch_neighbours;

/** For each node that takes part the nearest `neighbours` others that take part, >= 1, but none farther away
   than `largest_distance` [length], >= 0, may be infinite. `exclude_connected`: not 0 leaves out nodes that
   share an active segment with it. After an error `found` holds null pointers. CELLSEARCH_BAD_SETTING. */
int32_t cellsearch_nearest(cellsearch_handle* handle, int32_t neighbours, double largest_distance,
                           int32_t exclude_connected, cellsearch_neighbours* found);

/* ---- how long the candidates stay complete ---- */

/** Starts to watch the motion, from the positions of the last build, which must not have changed since. Every
    pair within `contact_distance` h [length] of a segment's box stays among its candidates until a node has
    moved relative to a segment by more than expansion - contact_distance along an axis. `expansion`: c
   [length]; if it differs by segment, give the pair with the smallest difference. Copies positions: 24 bytes
   per node, O(N) time. CELLSEARCH_NOT_BUILT, CELLSEARCH_BAD_SETTING (negative or not finite). */
int32_t cellsearch_motion_start(cellsearch_handle* handle, double expansion, double contact_distance);

/** Compares the present positions with those at the start, O(N) time. `used`: largest relative displacement
    along an axis [length]; `left`: what remains of c - h [length]; `due`: 1 if a new search is needed now,
   before candidates are used again, else 0. Each may be null. Before a start, and after an error, a search is
   due and used is infinite. CELLSEARCH_NON_FINITE_COORDINATE [node], CELLSEARCH_BAD_LAYOUT. */
int32_t cellsearch_motion_update(cellsearch_handle* handle, double* used, double* left, int32_t* due);

/** For how many further steps of at most `largest_step` [time] the candidates stay complete if velocities
    remain, eq. (10) with the largest relative velocity: at least 1, at most `cap`. `velocities`: x, y, z of
   each node [length/time], laid out like positions with a stride of their own, >= 3. O(N) time.
   CELLSEARCH_BAD_ARGUMENT, CELLSEARCH_BAD_LAYOUT. */
int32_t cellsearch_motion_steps(cellsearch_handle* handle, const double* velocities, int64_t stride,
                                double largest_step, int32_t cap, int32_t* steps);

/** Eq. (10) of the paper alone: (expansion - contact_distance) / (largest_speed * largest_step), rounded
   down, at least 1 and at most `cap`; 1 where a number is NaN or negative. [length], [length], [length/time],
   [time] */
int32_t cellsearch_interval(double expansion, double contact_distance, double largest_speed,
                            double largest_step, int32_t cap);

#ifdef __cplusplus
}
#endif
