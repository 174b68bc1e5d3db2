# SPDX-License-Identifier: BSD-3-Clause
"""The search of cellsearch over arrays of NumPy."""
from __future__ import annotations

import dataclasses
from typing import Optional, Tuple

import numpy

from ._cellsearch import SearchOfArrays


@dataclasses.dataclass(frozen=True)
class Candidates:
    """Pairs of segments and nodes as compressed rows: those of segment s are node[first[s]:first[s + 1]], ascending."""

    first: numpy.ndarray  #: int64, shape (segments + 1,)
    node: numpy.ndarray  #: int32, shape (pairs,)

    def of(self, segment: int) -> numpy.ndarray:
        """The nodes near a segment."""
        if not 0 <= segment < len(self.first) - 1:
            raise IndexError(f"There is no segment {segment}: there are {len(self.first) - 1}.")
        return self.node[self.first[segment]:self.first[segment + 1]]

    def pairs(self) -> Tuple[numpy.ndarray, numpy.ndarray]:
        """Segment and node of each pair, shape (pairs,) both."""
        return numpy.repeat(numpy.arange(len(self.first) - 1), numpy.diff(self.first)), self.node

    def __len__(self) -> int:
        return len(self.node)


class Search:
    """Finds the nodes near the segments of a mesh. Keep it over many queries: it uses its memory again.

    `x`: positions [length], shape (nodes, 3), float64; `segments`: places of their nodes from 0, shape (segments, 4), or
    (segments, 3) for triangles; among quadrilaterals a triangle repeats its last node. Arrays of the right type in C
    order are used without a copy: if they change, the next query() sees it. Others are copied; see update().

    `segment_expansion`: further expansion of each segment, `node_radius`: of each node [length]; `nodes`: the only ones
    that can be candidates, ascending; `active`: False for segments that are switched off; `exclude_neighbours`: leaves
    out nodes that share a segment with one of the segment's. `method`: one of methods(), all with the same results.

    query() raises cellsearch.Error, a ValueError, that names the node or segment at fault.
    """

    def __init__(
        self,
        x: numpy.ndarray,
        segments: numpy.ndarray,
        *,
        segment_expansion: Optional[numpy.ndarray] = None,
        node_radius: Optional[numpy.ndarray] = None,
        nodes: Optional[numpy.ndarray] = None,
        active: Optional[numpy.ndarray] = None,
        exclude_neighbours: bool = False,
        method: str = "production",
        threads: int = 1,
    ) -> None:
        if threads < 1:
            raise ValueError(f"threads is at least 1, not {threads}.")
        self._search = SearchOfArrays(method, threads)
        self._segments = _connectivity(segments)
        self.update(x)
        if segment_expansion is not None:
            self._search.set_segment_expansion(numpy.asarray(segment_expansion, float))
        if node_radius is not None:
            self._search.set_node_radius(numpy.asarray(node_radius, float))
        if nodes is not None:
            self._search.set_nodes(_whole(nodes, "nodes"))
        if active is not None:
            self._search.set_active(numpy.asarray(active, bool).astype(numpy.uint8))
        self._search.set_exclude_neighbours(exclude_neighbours)

    def update(self, x: numpy.ndarray) -> None:
        """New positions of the nodes [length], shape (nodes, 3)."""
        positions = numpy.ascontiguousarray(x, dtype=float)
        if positions.ndim != 2 or positions.shape[1] != 3:
            raise ValueError(f"x has the shape (nodes, 3), not {positions.shape}.")
        self._search.set_mesh(positions, self._segments)

    def query(self, expansion: float = 0.0) -> Candidates:
        """The nodes in the bounding box of each segment, expanded on all sides by `expansion` [length], without its own
        nodes. The arrays are the caller's to keep."""
        first, node = self._search.query(float(expansion))
        return Candidates(first, node)

    @property
    def statistics(self) -> dict:
        """What the last query did: cells, bytes, visits, candidates."""
        return self._search.statistics


def _whole(values: numpy.ndarray, name: str) -> numpy.ndarray:
    """As the library has them: 32 bits; nothing is cut off."""
    array = numpy.asarray(values)
    if array.size and array.dtype.kind not in "iu":
        raise ValueError(f"{name} are whole numbers, not {array.dtype}.")
    limits = numpy.iinfo(numpy.int32)
    if array.size and (array.max() > limits.max or array.min() < limits.min):
        raise ValueError(f"{name} has numbers beyond 32 bits.")
    return numpy.ascontiguousarray(array, dtype=numpy.int32)


def _connectivity(segments: numpy.ndarray) -> numpy.ndarray:
    array = _whole(segments, "segments")
    if array.ndim != 2 or array.shape[1] not in (3, 4):
        raise ValueError(f"segments has the shape (segments, 4) or (segments, 3), not {array.shape}.")
    return array if array.shape[1] == 4 else numpy.ascontiguousarray(array[:, [0, 1, 2, 2]])
