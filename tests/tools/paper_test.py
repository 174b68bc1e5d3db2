# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the parts of bench/paper that compute."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "bench" / "paper"))
import page  # noqa: E402
from plan import all_jobs, with_settings  # noqa: E402
from results import Result, Results, median_of  # noqa: E402

DECK = """*KEYWORD
$crumple method=linked-cell
$crumple cells=60,8,8
$crumple domain=0,0.30,0,0.04,-0.02,0.02
$crumple expansion=0.003
*END
"""

VALUES = {
    "shells": 500, "nodes": 600, "cycles": 2000, "loop": 0.3, "find": 0.002, "searches": 20, "candidates": 4000,
    "timings": {"contact_search": 0.01, "contact_local": 0.03, "contact_forces": 0.01, "output": 0.1},
    "search": {"bytes": 4}, "seconds": 0.4, "cpu_seconds": 0.2,
}


class SettingsTest(unittest.TestCase):
    def test_zero_leaves_the_deck_as_it_is(self):
        self.assertEqual(with_settings(DECK, 0, 0), DECK)

    def test_cells_fill_the_domain_and_the_expansion_is_set(self):
        deck = with_settings(DECK, 0.01, 0.004)
        self.assertIn("$crumple cells=30,4,4\n", deck)
        self.assertIn("$crumple expansion=0.004\n", deck)
        self.assertIn("$crumple domain=0,0.30,0,0.04,-0.02,0.02\n", deck)

    def test_the_program_may_choose_both(self):
        deck = with_settings(DECK, 0, 0, automatic=True)
        for key in ("cells", "domain", "expansion"):
            self.assertNotIn(f"$crumple {key}=", deck)
        kept = [line for line in DECK.splitlines() if not line.startswith(("$crumple cells", "$crumple domain", "$crumple expansion"))]
        self.assertEqual(deck.splitlines(), kept)

    def test_there_is_at_least_one_cell(self):
        self.assertIn("$crumple cells=1,1,1\n", with_settings(DECK, 5, 0))


class PlanTest(unittest.TestCase):
    def test_every_job_has_a_key_of_its_own(self):
        keys = [job.key for job in all_jobs()]
        self.assertEqual(len(keys), len(set(keys)))

    def test_medians_are_of_odd_numbers_of_runs(self):
        self.assertTrue(all(job.repeats % 2 == 1 for job in all_jobs()))


class ResultTest(unittest.TestCase):
    def test_costs_and_shares(self):
        result = Result(VALUES)
        self.assertAlmostEqual(result.global_cost, 10)  # 0.01 s over a million element-cycles
        self.assertAlmostEqual(result.both_cost, 40)
        self.assertAlmostEqual(result.per_segment(result.values["find"]), 200)  # 0.002 s over 500 x 20
        self.assertAlmostEqual(result.share(result.global_seconds), 5)  # of 0.2 s without output
        self.assertAlmostEqual(result.share(result.contact_seconds), 25)

    def test_medians_are_taken_of_each_time(self):
        others = [dict(VALUES, loop=0.2, find=0.009), dict(VALUES, loop=0.9, find=0.001)]
        merged = median_of([VALUES, *others])
        self.assertEqual(merged["loop"], 0.3)
        self.assertEqual(merged["find"], 0.002)
        self.assertEqual(merged["shells"], 500)

    def test_results_are_found_by_the_start_of_their_key(self):
        results = Results({("mesh", "frame", 2.0): VALUES, ("mesh", "frame", 1.0): VALUES, ("cell", "frame"): VALUES})
        self.assertEqual([key for key, _ in results.of("mesh", "frame")], [(1.0,), (2.0,)])
        self.assertAlmostEqual(results.busy(), 2)

    def test_a_table_has_its_columns(self):
        self.assertEqual(page.table(["a", "b"], [["1", "2"]]), "| a | b |\n|---|---|\n| 1 | 2 |")


if __name__ == "__main__":
    unittest.main()
