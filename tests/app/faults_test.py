#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a run leaves behind when something goes wrong around it.

    faults_test.py PROGRAM [unittest options]

A kill at any moment, a full disk, a limit on the size of files, a folder that vanishes: earlier files stay
readable, the message names the file, and the run can be taken up again to the same end, bit by bit.
"""
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as xml

PROGRAM = os.path.abspath(sys.argv.pop(1))
DECK = os.path.abspath("examples/04_square_tube/square_tube.k")
END = "3"
KILLS = 50


def command(*arguments):
    return [PROGRAM, "run", "-q", *map(str, arguments)]


def begin(folder, *more):
    return command(DECK, "-o", folder, "--end", END, "--precision", "mixed", "--restart-every", 60, *more)


def take_up(folder, *more):
    return command("--restart", folder, "--restart-every", 60, *more)


def run(arguments, **options):
    return subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False, **options)


def tables(folder):
    return {file.name: file.read_bytes() for file in sorted(folder.glob("*.csv"))}


def state_hash(folder):
    return json.loads((folder / "run.json").read_text())["state_hash"]


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp(prefix="crumple_faults_"))
        cls.whole = cls.root / "whole"
        result = run(begin(cls.whole))
        assert result.returncode == 0, result.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root, ignore_errors=True)

    def setUp(self):
        self.folder = self.root / self.id().rsplit(".", maxsplit=1)[-1]

    def check_readable(self, folder, killed=False):
        """Frames that the collection names are whole, and tables consist of whole rows. Where a process was killed a
        table may end within a row: the system gives up a write between two pages of a file."""
        collections = list(folder.glob("*.pvd"))
        for collection in collections:
            for entry in xml.parse(collection).getroot().iter("DataSet"):
                head = (folder / entry.get("file")).read_bytes()
                self.assertTrue(head.rstrip().endswith(b"</VTKFile>"), entry.get("file"))
        for name, content in tables(folder).items():
            if killed:
                self.assertTrue(content.endswith(b"\n") or len(content) % resource.getpagesize() == 0,
                                f"{name}: {len(content)} bytes")
                content = content[:content.rfind(b"\n") + 1]
            if not content:
                continue
            self.assertTrue(content.endswith(b"\n"), name)
            self.assertEqual(len({line.count(b",") for line in content.splitlines()}), 1, name)
        return bool(collections)

    def check_same_end(self, folder):
        self.assertEqual(state_hash(folder), state_hash(self.whole))
        self.assertEqual(tables(folder), tables(self.whole))

    def start_and_wait_for(self, path, arguments):
        process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while process.poll() is None and not path.exists():
            time.sleep(0.002)
        return process

    def test_kills(self):
        dice = random.Random(20261122)
        kills = 0
        while kills < KILLS:
            has_file = any((self.folder / "restart").glob("*.restart"))
            arguments = take_up(self.folder, "-t", dice.choice([1, 2])) if has_file else begin(self.folder)
            # Once the end comes in sight, begin anew.
            process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            try:
                _, told = process.communicate(timeout=dice.uniform(0.02, 0.25))
                self.assertEqual(process.returncode, 0, told)
                self.check_same_end(self.folder)
                shutil.rmtree(self.folder)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                process.communicate()
                kills += 1
                if self.folder.exists():
                    self.check_readable(self.folder, killed=True)
        result = run(take_up(self.folder) if any((self.folder / "restart").glob("*.restart")) else begin(self.folder))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.check_same_end(self.folder)

    def check_ends_and_goes_on(self, result, elsewhere):
        """The run ended for lack of room; with more room it comes to its end."""
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("Cannot write", result.stderr)
        self.assertIn(str(self.folder), result.stderr)
        self.check_readable(self.folder)
        shutil.copytree(self.folder, elsewhere)
        again = run(take_up(elsewhere))
        self.assertEqual(again.returncode, 0, again.stderr)
        self.check_same_end(elsewhere)

    def test_full_disk(self):
        self.folder.mkdir()
        mount = ["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", str(self.folder)]
        if os.geteuid() != 0 or subprocess.run(mount, capture_output=True, check=False).returncode != 0:
            self.skipTest("a small file system cannot be mounted here")
        try:
            self.check_ends_and_goes_on(run(begin(self.folder)), self.root / "with_room")
        finally:
            subprocess.run(["umount", str(self.folder)], check=True)

    def test_limit_on_the_size_of_files(self):
        size = max(file.stat().st_size for file in (self.whole / "restart").iterdir())
        csv = (self.whole / "matsum.csv").stat().st_size
        self.assertGreater(csv, 10000)

        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (csv // 2, resource.RLIM_INFINITY))

        # Nothing as large as a restart file can be written.
        result = run(begin(self.folder), preexec_fn=limit)
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("latest.restart", result.stderr)
        self.check_readable(self.folder)
        self.assertGreater(size, csv // 2)
        # A table stops growing in the middle of the run.
        shutil.rmtree(self.folder)
        self.check_readable_after_limit(2 * size)

    def check_readable_after_limit(self, size):
        result = run(begin(self.folder, "--d3plot"), preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY)))
        self.check_ends_and_goes_on(result, self.root / "without_limit")

    def test_vanished_folder(self):
        process = self.start_and_wait_for(self.folder / "restart" / "latest.restart", begin(self.folder))
        saved = self.root / "saved"
        shutil.move(self.folder, saved)
        _, told = process.communicate(timeout=100)
        self.assertEqual(process.returncode, 4, told)
        self.assertIn("Cannot write", told)
        again = run(take_up(saved))
        self.assertEqual(again.returncode, 0, again.stderr)
        self.check_same_end(saved)

    def test_forbidden_folder(self):
        if os.geteuid() == 0:
            self.skipTest("root may write anywhere")
        process = self.start_and_wait_for(self.folder / "restart" / "latest.restart", begin(self.folder))
        for place in ("vtu", "restart"):
            (self.folder / place).chmod(0o500)
        _, told = process.communicate(timeout=100)
        for place in ("vtu", "restart"):
            (self.folder / place).chmod(0o700)
        self.assertEqual(process.returncode, 4, told)
        self.assertIn("Permission denied", told)
        self.check_readable(self.folder)
        again = run(take_up(self.folder))
        self.assertEqual(again.returncode, 0, again.stderr)
        self.check_same_end(self.folder)

    def test_a_scatter_whose_terminal_is_closed_ends_its_runs(self):
        """The runs are in process groups of their own and do not get the signal of the terminal."""
        scatter = subprocess.Popen([PROGRAM, "scatter", DECK, "-q", "-o", self.folder, "--runs", "2", "-t", "2"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 30
        while len(list(self.folder.glob("run_*/glstat.csv"))) < 2 and time.monotonic() < deadline:
            time.sleep(0.01)
        scatter.send_signal(signal.SIGHUP)
        _, said = scatter.communicate(timeout=30)
        self.assertEqual(scatter.returncode, 129, said)
        for number in range(2):
            record = json.loads((self.folder / f"run_{number:03d}" / "run.json").read_text())
            self.assertIn("SIGHUP", record["reason"])

    def test_threads_wait_briefly_unless_the_user_chooses(self):
        def spins(**chosen):
            surroundings = {name: value for name, value in os.environ.items()
                            if name not in ("OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "OMP_NUM_THREADS")}
            surroundings |= {"OMP_DISPLAY_ENV": "verbose", **chosen}
            shown = run([PROGRAM, "--version"], env=surroundings)
            self.assertEqual(shown.returncode, 0)
            return shown.stderr.count("GOMP_SPINCOUNT = '1000'")

        self.assertEqual(spins(), 1)
        self.assertEqual(spins(GOMP_SPINCOUNT="70"), 0)
        self.assertEqual(spins(OMP_WAIT_POLICY="passive"), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
