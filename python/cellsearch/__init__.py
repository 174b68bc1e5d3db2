# SPDX-License-Identifier: BSD-3-Clause
"""cellsearch for Python: which nodes are near which segments of a mesh? See docs/python.md and cellsearch/README.md.

    import cellsearch
    found = cellsearch.Search(x, segments).query(expansion=0.2)
    for segment in range(len(segments)):
        found.of(segment)
"""
from ._cellsearch import Error, methods
from .search import Candidates, Search

Error.__module__ = "cellsearch"

__all__ = ["Candidates", "Error", "Search", "methods"]
