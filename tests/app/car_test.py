#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The smallest of the generated cars (examples/05_car): the program reads it, finds its masses, and runs its first steps.

    car_test.py PROGRAM [unittest options]
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
EXAMPLE = pathlib.Path("examples/05_car").resolve()
CYCLES = 300


class Car(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def written(self, case):
        folder = self.folder / case
        subprocess.run([sys.executable, EXAMPLE / "make_car.py", "-o", folder, "--case", case, "--cycles", str(CYCLES)],
                       check=True, stdout=subprocess.DEVNULL)
        return folder / "car.k"

    def checked(self, deck):
        done = subprocess.run([PROGRAM, "check", deck, "--json"], capture_output=True, text=True, check=False)
        answer = json.loads(done.stdout)
        self.assertEqual(done.returncode, 0, answer["messages"])
        self.assertTrue(answer["can_run"])
        self.assertEqual(answer["counts"]["missing"], 0)
        self.assertEqual(answer["counts"]["left_out"], 0)
        return answer

    def run_of(self, deck):
        out = deck.parent / "out"
        done = subprocess.run([PROGRAM, "run", deck, "-o", out, "-q", "--precision", "mixed"], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((out / "run.json").read_text())

    def test_wall(self):
        deck = self.written("wall")
        self.checked(deck)
        record = self.run_of(deck)
        self.assertEqual(record["cycles"], CYCLES)
        # The kinetic energy at the start is that of the mass that the generator weighs, within what the step adds.
        mass = 2 * record["energy"]["initial_total"] / (56 / 3.6) ** 2
        self.assertLess(abs(mass / 1078 - 1), 0.02)
        for check in record["checks"]:
            self.assertTrue(check["pass"], check)

    def test_other_cases_are_read(self):
        for case in ("offset", "pole"):
            self.checked(self.written(case))


if __name__ == "__main__":
    unittest.main()
