# SPDX-License-Identifier: BSD-3-Clause
"""Studies: samples, tables, and taking up after any end."""
import csv
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

import numpy

import crumple
from small_deck import write_plate
from support import FolderTest

RESPONSES = {"force": crumple.peak("rwforc", "normal", wall=1), "energy": crumple.absorbed()}


class SampleTest(unittest.TestCase):
    def test_factorial(self):
        rows = crumple.factorial({"a": [1, 2], "b": [3.0, 4.0, 5.0]})
        self.assertEqual(len(rows), 6)
        self.assertEqual(rows[1], {"a": 1, "b": 4.0})

    def test_latin_hypercube_has_one_sample_per_share(self):
        rows = crumple.latin_hypercube({"a": (0.0, 1.0), "b": (-20.0, -10.0)}, 50, seed=3)
        a = numpy.array([row["a"] for row in rows])
        b = numpy.array([row["b"] for row in rows])
        numpy.testing.assert_array_equal(numpy.sort(numpy.floor(50 * a)), numpy.arange(50))
        numpy.testing.assert_array_equal(numpy.sort(numpy.floor(5 * (b + 20))), numpy.arange(50))
        self.assertEqual(rows, crumple.latin_hypercube({"a": (0.0, 1.0), "b": (-20.0, -10.0)}, 50, seed=3))
        self.assertNotEqual(rows, crumple.latin_hypercube({"a": (0.0, 1.0), "b": (-20.0, -10.0)}, 50, seed=4))
        self.assertLess(abs(numpy.corrcoef(a, b)[0, 1]), 0.5)


class SweepTest(FolderTest):
    def sweep(self, deck, samples, responses=None, **options):
        self.ran = []
        return crumple.sweep(deck, samples, responses or RESPONSES, folder=self.folder / "study",
                             on_case=lambda done, total, outcome: self.ran.append(outcome["key"]), **options)

    def test_rows_are_those_of_single_runs(self):
        deck = write_plate(self.folder)
        samples = crumple.factorial({"thick": [1.0, 1.5], "speed": [-10.0, -12.0]})
        table = self.sweep(deck, samples, jobs=2)
        self.assertTrue(table.ok.all())
        self.assertEqual((table.parameters, table.responses), (["thick", "speed"], ["force", "energy"]))
        self.assertEqual(table.inputs().shape, (4, 2))
        for k, sample in enumerate(samples):
            with crumple.Simulation(crumple.Deck(deck, sample), output=self.folder / "single") as single:
                single.run()
            self.assertEqual(table["state_hash"][k], single.state_hash)
            self.assertEqual(table["force"][k], RESPONSES["force"](single.result))
        with open(self.folder / "study/table.csv", newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual([float(row["force"]) for row in rows], table["force"].tolist())
        self.assertEqual([float(row["thick"]) for row in rows], [1.0, 1.0, 1.5, 1.5])

    def test_nothing_runs_twice(self):
        deck = write_plate(self.folder)
        first = self.sweep(deck, {"thick": [1.0, 1.2, 1.0]})
        self.assertEqual(len(self.ran), 2)
        self.assertEqual(first["force"][0], first["force"][2])
        again = self.sweep(deck, {"thick": [1.2, 1.4]}, {"peak": RESPONSES["force"]})
        self.assertEqual(len(self.ran), 1)
        self.assertEqual(again["peak"][0], first["force"][1])
        # Another text of the deck is another study.
        write_plate(self.folder, **{"       0.3      0.25": "       0.3      0.35"})
        self.sweep(deck, {"thick": [1.2]})
        self.assertEqual(len(self.ran), 1)
        self.sweep(deck, {"thick": [1.2]}, options=("--end", "0.04"))
        self.assertEqual(len(self.ran), 1)

    def test_failed_runs_are_rows_without_numbers(self):
        deck = write_plate(self.folder)
        table = self.sweep(deck, {"thick": [1.0, -1.0]})
        self.assertEqual(table["termination"].tolist(), ["normal", "refused"])
        self.assertTrue(numpy.isnan(table["force"][1]))
        self.assertEqual(table.ok.tolist(), [True, False])
        self.sweep(deck, {"thick": [1.0, -1.0]})
        self.assertEqual(len(self.ran), 0)
        self.sweep(deck, {"thick": [1.0, -1.0]}, retry_failed=True)
        self.assertEqual(len(self.ran), 1)

    def test_unknown_parameters_fail_with_the_words_of_the_console(self):
        table = self.sweep(write_plate(self.folder), {"thik": [1.0]})
        self.assertFalse(table.ok[0])
        outcome = (self.folder / "study/cases" / table["case"][0] / "case.json").read_text()
        self.assertIn("did you mean THICK?", outcome)

    def test_faulty_responses_name_the_run(self):
        deck = write_plate(self.folder)
        with self.assertRaisesRegex(crumple.Error, "response 'wrong'.*cases.*rbdout"):
            self.sweep(deck, {"thick": [1.0]}, {"wrong": crumple.peak("rbdout", "x")})
        self.sweep(deck, {"thick": [1.0]})
        self.assertEqual(len(self.ran), 0)

    def test_wrong_samples(self):
        with self.assertRaises(ValueError):
            self.sweep(write_plate(self.folder), {"thick": [1.0], "speed": [1.0, 2.0]})
        with self.assertRaises(ValueError):
            self.sweep(write_plate(self.folder), [{"thick": 1.0}, {"speed": -1.0}])
        with self.assertRaises(ValueError):
            self.sweep(write_plate(self.folder), {"thick": [1.0]}, jobs=0)


class KilledSweepTest(FolderTest):
    COUNT = 8
    SCRIPT = """
import crumple, sys
crumple.sweep(sys.argv[1], {{"thick": [1.0 + 0.1 * k for k in range({count})]}},
              {{"force": crumple.peak("rwforc", "normal", wall=1)}}, jobs=2, folder=sys.argv[2])
"""

    def start(self, deck):
        return subprocess.Popen([sys.executable, "-c", self.SCRIPT.format(count=self.COUNT), str(deck),
                                 str(self.folder / "study")], stderr=subprocess.PIPE)

    def done(self):
        return {path: path.stat().st_mtime_ns for path in (self.folder / "study").glob("cases/*/case.json")}

    def running(self):
        """Processes that work in the folder of this test."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    words = (entry / "cmdline").read_bytes().split(b"\0")
                except OSError:
                    continue
                if b"run" in words and any(word.startswith(os.fsencode(self.folder)) for word in words):
                    found.append(int(entry.name))
        return found

    def wait_for(self, condition):
        limit = time.monotonic() + 120
        while not condition():
            self.assertLess(time.monotonic(), limit)
            time.sleep(0.005)

    def kill_and_take_up(self, kind):
        deck = write_plate(self.folder, cells=12, **{"      0.05\n*": "       0.3\n*"})
        process = self.start(deck)
        self.wait_for(lambda: len(self.done()) >= 2)
        process.send_signal(kind)
        process.wait()
        process.stderr.close()
        before = self.done()
        self.assertLess(len(before), self.COUNT)
        self.wait_for(lambda: not self.running())
        process = self.start(deck)
        _, errors = process.communicate()
        self.assertEqual(process.returncode, 0, errors.decode())
        after = self.done()
        self.assertEqual(len(after), self.COUNT)
        for path, written in before.items():
            self.assertEqual(after[path], written)
        with open(self.folder / "study/table.csv", newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual({row["termination"] for row in rows}, {"normal"})
        single = crumple.Simulation(crumple.Deck(deck, {"thick": 1.0 + 0.1 * (self.COUNT - 1)})).run()
        self.assertEqual(rows[-1]["state_hash"], single.state_hash)

    def test_killed(self):
        self.kill_and_take_up(signal.SIGKILL)

    def test_ended_by_ctrl_c(self):
        self.kill_and_take_up(signal.SIGINT)

    def test_runs_end_with_a_killed_study(self):
        # Hours of computing, were they left alone.
        deck = write_plate(self.folder, cells=12, **{"      0.05\n*": "     1.0e6\n*"})
        process = self.start(deck)
        self.wait_for(lambda: len(self.running()) == 2)
        process.kill()
        process.wait()
        process.stderr.close()
        self.wait_for(lambda: not self.running())
        self.assertEqual(self.done(), {})

    def test_two_studies_in_a_folder(self):
        deck = write_plate(self.folder, cells=12, **{"      0.05\n*": "       0.3\n*"})
        process = self.start(deck)
        self.wait_for(self.done)
        with self.assertRaisesRegex(crumple.Error, "Another process"):
            crumple.sweep(deck, {"thick": [1.0]}, RESPONSES, folder=self.folder / "study")
        process.kill()
        process.wait()
        process.stderr.close()


if __name__ == "__main__":
    unittest.main()
