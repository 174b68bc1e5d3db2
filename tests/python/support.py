# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python packages share: a folder for each test, and the program."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["CRUMPLE_PROGRAM"]
ROOT = pathlib.Path(__file__).resolve().parents[2]


class FolderTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="crumple_python_"))
        self.addCleanup(shutil.rmtree, self.folder, True)

    def program(self, *arguments):
        """Runs the program; returns code, output, errors."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr
