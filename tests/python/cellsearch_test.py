# SPDX-License-Identifier: BSD-3-Clause
"""cellsearch from Python, compared with brute force by NumPy."""
import unittest

import numpy

import cellsearch


def brute_force(x, segments, expansion, radius=None):
    """Rows of nodes in the closed box of each segment, expanded, without its own."""
    rows = []
    for own in segments:
        low, high = x[own].min(axis=0) - expansion, x[own].max(axis=0) + expansion
        r = numpy.zeros(len(x)) if radius is None else radius
        inside = numpy.all((x + r[:, None] >= low) & (x - r[:, None] <= high), axis=1)
        inside[own] = False
        rows.append(numpy.flatnonzero(inside))
    return rows


def scene(nodes=400, segments=150, seed=1):
    random = numpy.random.default_rng(seed)
    x = random.random((nodes, 3))
    corners = numpy.array([random.choice(nodes, 4, replace=False) for _ in range(segments)])
    # Small segments: the three others near the first.
    for row in corners:
        row[1:] = numpy.argsort(numpy.linalg.norm(x - x[row[0]], axis=1))[1:4]
    return x, corners


class SearchTest(unittest.TestCase):
    def assert_rows(self, found, rows):
        self.assertEqual(found.first.dtype, numpy.int64)
        self.assertEqual(found.node.dtype, numpy.int32)
        numpy.testing.assert_array_equal(numpy.diff(found.first), [len(row) for row in rows])
        numpy.testing.assert_array_equal(found.node, numpy.concatenate(rows))

    def test_candidates_are_those_of_brute_force(self):
        x, segments = scene()
        for expansion in (0.02, 0.05, 0.3):
            for threads in (1, 2):
                with self.subTest(expansion=expansion, threads=threads):
                    rows = brute_force(x, segments, expansion)
                    self.assertGreater(sum(map(len, rows)), 20)
                    self.assert_rows(cellsearch.Search(x, segments, threads=threads).query(expansion), rows)

    def test_all_methods_agree(self):
        x, segments = scene()
        rows = brute_force(x, segments, 0.1)
        for method in cellsearch.methods():
            if method != "nbs":  # for bodies of similar size alone
                with self.subTest(method):
                    self.assert_rows(cellsearch.Search(x, segments, method=method).query(0.1), rows)
        with self.assertRaises(ValueError):
            cellsearch.Search(x, segments, method="guess")

    def test_radii_and_triangles(self):
        x, segments = scene()
        radius = numpy.random.default_rng(2).random(len(x)) * 0.1
        self.assert_rows(cellsearch.Search(x, segments, node_radius=radius).query(0.02),
                         brute_force(x, segments, 0.02, radius))
        self.assert_rows(cellsearch.Search(x, segments[:, :3]).query(0.1), brute_force(x, segments[:, :3], 0.1))

    def test_chosen_nodes_and_switched_off_segments(self):
        x, segments = scene()
        chosen = numpy.arange(0, len(x), 3)
        active = numpy.arange(len(segments)) % 2 == 0
        rows = brute_force(x, segments, 0.1)
        expected = [numpy.intersect1d(row, chosen) if on else row[:0] for row, on in zip(rows, active)]
        self.assert_rows(cellsearch.Search(x, segments, nodes=chosen, active=active).query(0.1), expected)

    def test_motion_is_seen_without_a_copy_and_by_update(self):
        x, segments = scene()
        search = cellsearch.Search(x, segments)
        search.query(0.1)
        x += 0.2 * numpy.random.default_rng(3).random(x.shape)
        self.assert_rows(search.query(0.1), brute_force(x, segments, 0.1))
        other = x.astype(numpy.float32)
        search.update(other)
        self.assert_rows(search.query(0.1), brute_force(other.astype(float), segments, 0.1))

    def test_results_are_kept(self):
        x, segments = scene()
        search = cellsearch.Search(x, segments)
        first = search.query(0.1)
        copy = first.node.copy()
        search.query(0.3)
        numpy.testing.assert_array_equal(first.node, copy)
        segment, node = first.pairs()
        self.assertEqual(len(segment), len(node))
        numpy.testing.assert_array_equal(first.of(5), node[segment == 5])
        with self.assertRaises(IndexError):
            first.of(len(segments))
        self.assertEqual(search.statistics["participants"], len(x))

    def test_wrong_input(self):
        x, segments = scene()
        bad = x.copy()
        bad[17, 1] = numpy.nan
        with self.assertRaisesRegex(cellsearch.Error, "17"):
            cellsearch.Search(bad, segments).query(0.1)
        with self.assertRaises(cellsearch.Error):
            cellsearch.Search(x[:50], segments).query(0.1)
        with self.assertRaises(cellsearch.Error):
            cellsearch.Search(x, segments).query(-1.0)
        with self.assertRaises(cellsearch.Error):
            cellsearch.Search(x, segments, node_radius=[1.0]).query(0.1)
        for positions, corners in ((x[:, :2], segments), (x, segments[:, :2]), (x, segments + 0.5), (x, segments + 2**40)):
            with self.assertRaises(ValueError):
                cellsearch.Search(positions, corners)
        with self.assertRaises(ValueError):
            cellsearch.Search(x, segments, threads=0)


if __name__ == "__main__":
    unittest.main()
