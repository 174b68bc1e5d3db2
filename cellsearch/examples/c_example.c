// SPDX-License-Identifier: BSD-3-Clause
// Two parallel plates of one segment each, 0.1 apart: which nodes are near which segment?
#include <cellsearch/cellsearch.h>
#include <inttypes.h>
#include <stdio.h>

int main(void) {
  const double xyz[] = {0, 0, 0.0, 1, 0, 0.0, 1, 1, 0.0, 0, 1, 0.0,   // lower plate
                        0, 0, 0.1, 1, 0, 0.1, 1, 1, 0.1, 0, 1, 0.1};  // upper plate
  const int32_t segments[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const int64_t* first;
  const int32_t* node;

  cellsearch_handle* search = cellsearch_create();  // keep it: it re-uses its memory from search to search
  cellsearch_set_positions(search, 8, xyz, 3);      // views: nothing is copied
  cellsearch_set_segments(search, 2, segments);
  cellsearch_set_expansion(search, 0.2);  // c: how far a node may be from the bounding box of a segment
  if (cellsearch_find(search, &first, &node, NULL) != CELLSEARCH_OK) {
    fprintf(stderr, "%s\n", cellsearch_error_message(search));
    return 1;
  }
  for (int32_t segment = 0; segment < 2; ++segment) {
    printf("segment %" PRId32 ":", segment);
    for (int64_t place = first[segment]; place < first[segment + 1]; ++place) printf(" %" PRId32, node[place]);
    printf("\n");
  }
  cellsearch_destroy(search);
  return 0;
}
