#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Folders and decks that somebody else has made, and machines that are short of something.

    strangers_test.py PROGRAM [unittest options]

Nothing outside of a folder of results is written to, nothing waits for ever, time is linear in the length of a
deck, and each refusal says why.
"""
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
DECK = os.path.abspath("examples/04_square_tube/square_tube.k")
PRECIOUS = "precious"


def run(*arguments, timeout=60, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False, timeout=timeout, **options)


def begin(folder, *more):
    return ["run", DECK, "-q", "-o", folder, "--end", "0.2", "--precision", "mixed", *more]


class Case(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="crumple_strangers_"))
        self.addCleanup(shutil.rmtree, self.root, True)
        self.folder = self.root / "out"


class Folders(Case):
    """Every file of a results folder is replaced by a link, a hard link, a pipe or a device."""

    def setUp(self):
        super().setUp()
        self.victim = self.root / "victim"

    def names(self):
        """Files that a run with everything writes, relative to its folder."""
        result = run(*begin(self.root / "whole", "--d3plot", "--restart-every", 20))
        self.assertEqual(result.returncode, 0, result.stderr)
        whole = self.root / "whole"
        names = [str(file.relative_to(whole)) for file in sorted(whole.rglob("*")) if file.is_file()]
        self.assertIn("run.json", names)
        self.assertIn("restart/latest.restart", names)
        self.assertGreater(len(names), 10)
        return names

    def prepare(self, names, place):
        shutil.rmtree(self.folder, ignore_errors=True)
        for name in names:
            for ending in ("", ".tmp", ".new"):
                path = self.folder / (name + ending)
                path.parent.mkdir(parents=True, exist_ok=True)
                place(path)
        self.victim.write_text(PRECIOUS)

    def check_untouched(self):
        self.assertEqual(self.victim.read_text(), PRECIOUS)
        self.assertEqual(sorted(path.name for path in self.root.iterdir()), ["out", "victim", "whole"])

    def test_links_are_not_written_through(self):
        names = self.names()
        self.victim.write_text(PRECIOUS)
        for place in (lambda path: path.symlink_to(self.victim), lambda path: path.symlink_to(self.root / "absent"),
                      lambda path: path.hardlink_to(self.victim)):
            self.prepare(names, place)
            result = run(*begin(self.folder, "--d3plot", "--restart-every", 20))
            self.assertEqual(result.returncode, 0, result.stderr)
            self.check_untouched()
            for name in names:
                self.assertFalse((self.folder / name).is_symlink(), name)
            # Taken up, with links put in place of what is there.
            for name in names:
                if not name.startswith("restart"):
                    (self.folder / name).unlink(missing_ok=True)
                    place(self.folder / name)
            result = run("run", "-q", "--restart", self.folder, "--end", "0.25")
            self.check_untouched()
            self.assertIn(result.returncode, (0, 4), result.stderr)

    def test_pipes_and_devices_are_refused_at_once(self):
        names = self.names()
        for place in (os.mkfifo, lambda path: path.symlink_to("/dev/full"), lambda path: path.symlink_to("/dev/zero")):
            self.prepare(names, place)
            result = run(*begin(self.folder, "--d3plot", "--restart-every", 20))
            self.assertIn(result.returncode, (0, 4), result.stderr)
            self.check_untouched()
            for verb in (["report", self.folder], ["compare", self.folder, self.folder],
                         ["run", "-q", "--restart", self.folder]):
                result = run(*verb)
                self.assertGreater(result.returncode, 0)
                self.assertNotIn("internal error", result.stderr)

    def test_subfolders_are_no_links(self):
        elsewhere = self.root / "elsewhere"
        for name in ("vtu", "restart"):
            shutil.rmtree(self.folder, ignore_errors=True)
            shutil.rmtree(elsewhere, ignore_errors=True)
            self.folder.mkdir()
            elsewhere.mkdir()
            (elsewhere / "square_tube_000000.vtu").write_text(PRECIOUS)
            (elsewhere / "latest.restart").write_text(PRECIOUS)
            (self.folder / name).symlink_to(elsewhere)
            result = run(*begin(self.folder, "--restart-every", 20))
            self.assertEqual(result.returncode, 4, result.stderr)
            self.assertIn("it is a link", result.stderr)
            for file in elsewhere.iterdir():
                self.assertEqual(file.read_text(), PRECIOUS)

    def test_reports_do_not_follow_links(self):
        self.assertEqual(run(*begin(self.folder)).returncode, 0)
        self.victim.write_text(PRECIOUS)
        template = self.root / "page.html"
        template.write_text("<body><!-- crumple-data --></body>")
        for ending in ("", ".tmp"):
            (self.folder / ("report.html" + ending)).symlink_to(self.victim)
        result = run("report", self.folder, env={**os.environ, "CRUMPLE_REPORT_TEMPLATE": str(template)})
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.victim.read_text(), PRECIOUS)
        self.assertGreater((self.folder / "report.html").stat().st_size, 1000)

    def test_a_device_is_no_report(self):
        self.assertEqual(run(*begin(self.folder)).returncode, 0)
        pipe = self.root / "pipe"
        os.mkfifo(pipe)
        template = self.root / "page.html"
        template.write_text("<body><!-- crumple-data --></body>")
        result = run("report", self.folder, "-o", pipe, env={**os.environ, "CRUMPLE_REPORT_TEMPLATE": str(template)})
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertTrue(pipe.is_fifo())


class TwoRuns(Case):
    def start(self):
        process = subprocess.Popen([PROGRAM, "run", DECK, "-q", "-o", str(self.folder), "--restart-every", "50"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + 30
        while not (self.folder / "restart" / "latest.restart").exists() and time.monotonic() < deadline:
            time.sleep(0.01)
        return process

    def test_a_folder_has_one_run(self):
        first = self.start()
        for arguments in (begin(self.folder), ["run", "-q", "--restart", self.folder]):
            second = run(*arguments)
            self.assertEqual(second.returncode, 4, second.stderr)
            self.assertIn(f"in use by another run (process {first.pid} on ", second.stderr)
        self.assertIsNone(first.poll())
        first.send_signal(signal.SIGINT)
        self.assertEqual(first.wait(timeout=30), 130)
        self.assertFalse((self.folder / ".crumple.lock").exists())

    def test_the_lock_of_a_killed_run_does_not_block(self):
        first = self.start()
        first.kill()
        first.wait()
        self.assertTrue((self.folder / ".crumple.lock").exists())
        result = run("run", "-q", "--restart", self.folder, "--end", "1")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_a_lock_that_is_none_is_not_written_to(self):
        self.folder.mkdir()
        victim = self.root / "victim"
        victim.write_text(PRECIOUS)
        for place in (lambda path: path.symlink_to(victim), lambda path: path.hardlink_to(victim), os.mkfifo, os.mkdir):
            place(self.folder / ".crumple.lock")
            result = run(*begin(self.folder))
            self.assertEqual(result.returncode, 4, result.stderr)
            self.assertEqual(victim.read_text(), PRECIOUS)
            lock = self.folder / ".crumple.lock"
            lock.rmdir() if lock.is_dir() and not lock.is_symlink() else lock.unlink()

    def test_tables_that_are_removed_are_noticed(self):
        process = self.start()
        (self.folder / "glstat.csv").unlink()
        _, output = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 4, output)
        self.assertIn("glstat.csv", output)
        self.assertIn("removed or replaced", output)


class Decks(Case):
    HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n"

    def check(self, text, seconds=10):
        deck = self.root / "deck.k"
        deck.write_text(text)
        started = time.monotonic()
        result = run("check", deck, timeout=10 * seconds)
        self.assertEqual(result.returncode, 1, result.stderr[:1000])
        self.assertLess(time.monotonic() - started, seconds)
        self.assertLess(len(result.stderr), 3_000_000)
        return result.stderr

    def test_includes_are_regular_files(self):
        os.mkfifo(self.root / "pipe")
        for name, reason in (("/dev/zero", "a device"), ("/dev/stdin", ""), ("pipe", "a pipe"), (".", "a folder"),
                             ("/proc/self/maps", "the kernel makes this file up"), ("/proc/kmsg", ""), ("/proc/kcore", "")):
            output = self.check(self.HEAD + f"*INCLUDE\n{name}\n*END\n")
            self.assertIn("cannot read", output, name)
            self.assertIn(reason, output, name)

    def test_a_file_beyond_memory_is_refused_with_its_size(self):
        with open(self.root / "large.k", "wb") as file:
            file.truncate(1 << 43)
        self.assertIn("8.8 TB", self.check(self.HEAD + "*INCLUDE\nlarge.k\n*END\n"))

    def test_unknown_keywords_take_linear_time(self):
        output = self.check(self.HEAD + "".join(f"*UNKNOWN_{i}\n1\n" for i in range(100_000)), 20)
        self.assertIn("more of other kinds", output)

    def test_unsupported_materials_of_many_parts_take_linear_time(self):
        text = "".join(f"*MAT_UNKNOWN\n{i},1.0\n*PART\nx\n{i},1,{i}\n" for i in range(1, 30_001))
        self.check(self.HEAD + text, 20)

    def test_errors_without_number_are_counted(self):
        output = self.check(self.HEAD + "*NODE\n" + "x,y,z\n" * 100_000, 20)
        self.assertIn("more of this kind", output)

    def test_a_keyword_of_100_mb_is_not_echoed(self):
        output = self.check(self.HEAD + "*" + "X" * 100_000_000 + "\n", 20)
        self.assertLess(len(output), 10_000)

    def test_a_line_of_100_mb_is_not_echoed(self):
        output = self.check(self.HEAD + "*NODE\n" + "X" * 100_000_000 + ",1,2,3\n", 20)
        self.assertLess(len(output), 10_000)

    def test_restart_files_without_number_take_no_time(self):
        text = pathlib.Path(DECK).read_text().replace("*END", "*DATABASE_BINARY_RUNRSF\n50,2000000000\n*END")
        deck = self.root / "many.k"
        deck.write_text(text)
        result = run("run", deck, "-q", "-o", self.folder, "--end", "0.2", "--precision", "mixed")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater(len(list((self.folder / "restart").glob("previous*.restart"))), 2)


class Shortage(Case):
    def limited(self, *limits):
        def limit():
            for kind, value in limits:
                resource.setrlimit(kind, (value, value))
        return limit

    def check_clear(self, result):
        """Ended well, or with a sentence."""
        self.assertGreaterEqual(result.returncode, 0, f"signal: {result.stderr}")
        if result.returncode != 0:
            self.assertNotIn("internal error", result.stderr)
            self.assertNotEqual(result.stderr.strip(), "")

    def test_small_stack(self):
        for kilobytes in (64, 128, 256, 512, 1024, 2048):
            for threads in (1, 2):
                result = run(*begin(self.folder, "-t", threads),
                             preexec_fn=self.limited((resource.RLIMIT_STACK, kilobytes * 1024)))
                self.check_clear(result)
                if kilobytes >= 1024:
                    self.assertEqual(result.returncode, 0, result.stderr)

    def test_few_descriptors(self):
        for count in (3, 4, 6, 10, 20):
            self.check_clear(run(*begin(self.folder), preexec_fn=self.limited((resource.RLIMIT_NOFILE, count))))

    def test_little_memory(self):
        for megabytes in (60, 100, 150, 200):
            self.check_clear(run(*begin(self.folder), preexec_fn=self.limited((resource.RLIMIT_AS, megabytes << 20))))


class Parameters(Case):
    def test_run_json_says_what_was_run(self):
        deck = self.root / "tube.k"
        deck.write_text(pathlib.Path(DECK).read_text().replace("*KEYWORD", "*KEYWORD\n*PARAMETER\nR ending,0.05\n", 1)
                        .replace("*END", "*CONTROL_TERMINATION\n&ending\n*END"))
        command = ["run", deck, "-q", "-o", self.folder, "-P", "ending=0.1", "--precision", "mixed"]
        result = run(*command)
        self.assertEqual(result.returncode, 0, result.stderr)
        record = json.loads((self.folder / "run.json").read_text())
        self.assertEqual(record["parameters"]["ENDING"], {"value": 0.1, "source": "command line"})
        self.assertEqual(record["command"], [str(word) for word in command])
        self.assertEqual(record["options"]["precision"], "mixed")
        self.assertNotEqual(record["deck_hash"], record["deck_hash_with_parameters"])
        self.assertIn("compiler", record["versions"])
        answer = json.loads(run("check", deck, "--json", "-P", "ending=0.1").stdout)
        self.assertEqual(answer["deck_hash_with_parameters"], record["deck_hash_with_parameters"])
        self.assertEqual(answer["parameters"]["ENDING"]["source"], "command line")
        for verb in (["run", deck, "-q", "-o", self.root / "none"], ["check", deck]):
            result = run(*verb, "-P", "endign=0.1")
            self.assertEqual(result.returncode, 1)
            self.assertIn("did you mean ENDING?", result.stderr)
        self.assertFalse((self.root / "none").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
