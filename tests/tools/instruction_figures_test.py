# SPDX-License-Identifier: BSD-3-Clause
"""tools/instruction_figures.py: what is read of a profile, and that a figure above the room fails."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import instruction_figures as figures  # noqa: E402
from built_by import compiler_in  # noqa: E402

PROFILE = """# callgrind format
events: Ir
fn=main
cfn=step(int)
calls=3 0
0 900
0 7

fn=step(int)
0 100
cfn=forces(double)
calls=2 0
12 500
cfn=forces(double)
calls=1 0
12 250
"""


class Reading(unittest.TestCase):
    def test_calls_and_inclusive_costs_add_up(self):
        calls = figures.read_calls(PROFILE)
        self.assertEqual(calls, {"step(int)": (3, 900), "forces(double)": (3, 750)})
        self.assertEqual(figures.find(calls, "forces("), (3, 750))
        self.assertEqual(figures.find(calls, "contact("), (0, 0))

    def test_a_beginning_of_two_functions_is_refused(self):
        with self.assertRaises(ValueError):
            figures.find({"step(int)": (1, 1), "step(double)": (1, 1)}, "step(")

    def test_compiler(self):
        gcc = "String dump of section '.comment':\n  [     0]  GCC: (Debian 12.2.0-14+deb12u1) 12.2.0\n"
        self.assertEqual(compiler_in(gcc), "g++ 12.2.0")
        self.assertEqual(compiler_in(gcc + "  [    27]  Debian clang version 14.0.6\n"), "clang++ 14.0.6")
        self.assertEqual(compiler_in(""), "an unknown compiler")

    def test_table_is_read_as_written(self):
        table = {("tube, mixed", "step"): ("g++ 12.2.0", 804.95), ("tube, mixed", "nodes"): ("g++ 12.2.0", 99.25)}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "figures.csv"
            self.assertEqual(figures.read_figures(path), {})
            figures.write_figures(path, table)
            self.assertEqual(figures.read_figures(path), table)

    def test_small_stages_are_not_judged(self):
        self.assertEqual(figures.judged({"step": 100, "elements": 80, "nodes": 5, "contact": 4.9}, "step"),
                         {"step": 100, "elements": 80, "nodes": 5})


class Comparing(unittest.TestCase):
    stored = {("tube", "step"): ("g++ 12.2.0", 1000.0), ("tube", "contact"): ("g++ 12.2.0", 100.0)}

    def test_within_the_room(self):
        self.assertEqual(figures.compare(self.stored, {("tube", "step"): 1029.0, ("tube", "contact"): 97.1}), ([], []))

    def test_more_fails_and_names_the_stage(self):
        failures, notes = figures.compare(self.stored, {("tube", "step"): 1004.0, ("tube", "contact"): 104.0})
        self.assertEqual(failures, ["tube, contact: 104.0 instructions instead of 100.0, +4.0 %"])
        self.assertEqual(notes, [])

    def test_fewer_is_a_note(self):
        failures, notes = figures.compare(self.stored, {("tube", "step"): 960.0})
        self.assertEqual(failures, [])
        self.assertEqual(notes, ["tube, step: 960.0 instructions instead of 1000.0, -4.0 %"])

    def test_what_is_not_stored_fails(self):
        failures, _ = figures.compare(self.stored, {("tube", "nodes"): 1.0})
        self.assertEqual(failures, ["tube, nodes: no figure is stored"])


if __name__ == "__main__":
    unittest.main()
