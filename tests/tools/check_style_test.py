# SPDX-License-Identifier: BSD-3-Clause
"""tools/check_style on small trees: every rule fails where it is broken."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LICENCE = "// SPDX-License-Identifier: BSD-3-Clause\n"


class CheckStyle(unittest.TestCase):
    def run_on(self, text, name="crumple/base/thing.cpp"):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
        result = subprocess.run([sys.executable, str(ROOT / "tools" / "check_style"), "--root", str(folder)],
                                capture_output=True, text=True)
        return result.returncode, result.stdout + result.stderr

    def assert_fails(self, text, words, name="crumple/base/thing.cpp"):
        status, output = self.run_on(text, name)
        self.assertEqual(status, 1, output)
        self.assertIn(words, output)

    def test_good_files(self):
        for name, text in (("a.cpp", LICENCE + "int x;\n"), ("b.md", "no licence needed\n"),
                           ("tool", "#!/usr/bin/env bash\n#" + LICENCE[2:] + "true\n")):
            status, output = self.run_on(text, name)
            self.assertEqual(status, 0, output)

    def test_licence(self):
        self.assert_fails("int x;\n", "thing.cpp:1: the first line must be")

    def test_length(self):
        self.assertEqual(self.run_on(LICENCE + "int x;\n" * 499)[0], 0)
        self.assert_fails(LICENCE + "int x;\n" * 500, "501 lines")

    def test_tab_and_spaces(self):
        self.assert_fails(LICENCE + "\tint x;\n", "thing.cpp:2: a tab")
        self.assert_fails(LICENCE + "int x; \n", "thing.cpp:2: spaces at the end")

    def test_path_of_a_machine(self):
        path = "/" + "home/someone/crumple"
        self.assert_fails(LICENCE + f"// {path}\n", "thing.cpp:2: an absolute path")
        self.assert_fails(f"see {path}\n", "page.md:1: an absolute path", "page.md")

    def test_merge_conflict(self):
        for mark in ("<" * 7 + " HEAD", "|" * 7 + " 1a2b3c", ">" * 7 + " branch", ">" * 7):
            for name in ("page.md", "fields.txt", "record.json"):
                self.assert_fails(f"ours\n{mark}\n", f"{name}:2: the mark of a merge conflict", name)
            self.assert_fails(LICENCE + f"{mark}\n", "thing.cpp:2: the mark of a merge conflict")
        self.assertEqual(self.run_on("Heading\n=======\n\n| " + ">" * 7 + " quoted |\n", "page.md")[0], 0)

    def test_open_end(self):
        word = "TO" + "DO"
        self.assert_fails(LICENCE + f"// {word}: more\n", "thing.cpp:2: an open end")
        self.assertEqual(self.run_on(LICENCE + f"// {word} (#12): more\n")[0], 0)

    def test_scripts_parse(self):
        self.assert_fails("#" + LICENCE[2:] + "def f(:\n", "Python cannot parse", "tool.py")
        self.assert_fails("#!/bin/bash\n#" + LICENCE[2:] + "if true; then\n", "bash cannot parse", "tool")


if __name__ == "__main__":
    unittest.main()
