# SPDX-License-Identifier: BSD-3-Clause
"""What bench/validation.py makes of the histories of a run."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))
import validation  # noqa: E402


def run(work):
    energies = [{"time": 0.5 * i, "internal": 10.0 * i, "hourglass": 1.0 * i, "contact": -0.1 * i, "friction": work * i,
                 "rigidwall": 0.0} for i in range(3)]
    walls = [{"time": 0.0, "normal": 0.0}, {"time": 0.5, "normal": 8.0}, {"time": 1.0, "normal": -2.0}]
    return validation.Run(energies, walls, [{"dt": 2.0}, {"dt": 0.5}, {"dt": 1.0}], 3)


class Validation(unittest.TestCase):
    def test_quantities_of_a_run(self):
        found = run(2.0)
        self.assertAlmostEqual(found.absorbed(0.9), 2 * (10 + 1 - 0.1 + 2))
        self.assertEqual(found.peak(), 8)
        self.assertAlmostEqual(found.mean_force(), 0.5 * (4 + 3))
        self.assertAlmostEqual(found.lowest_contact(), -0.01)
        self.assertAlmostEqual(found.smallest_step(), 0.25)

    def test_end_of_the_profile_has_moved_so_far_at_its_time(self):
        self.assertAlmostEqual(1500 * (validation.crush_time(71.25) - 0.0025), 71.25)
        self.assertAlmostEqual(validation.crush_time(71.25), 0.05)

    def test_table_tells_deviations_and_the_range_of_perturbed_runs(self):
        quantity = validation.Quantity("peak, kN", 10, "7", lambda of: of.peak(), 1)
        model = validation.Model("model", "deck.k", "", "text", ["as it is"], [quantity])
        rows = validation.table(model, {"as it is": run(1)}, [run(1), run(2)]).splitlines()
        self.assertEqual(rows[2], "| peak, kN | 10 | 7 | 8.0 (-20 %) | 8.0 to 8.0 |")
        self.assertEqual(rows[3], "| lowest contact / largest internal energy |  |  | -1.0e-02 |  |")
        self.assertEqual(rows[4], "| hourglass / internal energy |  |  | 10.0 % |  |")
        self.assertEqual(rows[5], "| smallest step / first |  |  | 0.25 |  |")
        self.assertEqual(rows[6], "| mid-surface cuts at the end |  |  | 3 |  |")


if __name__ == "__main__":
    unittest.main()
