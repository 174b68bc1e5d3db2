# SPDX-License-Identifier: BSD-3-Clause
"""tools/check_headers on small trees: a header that needs another one is found unless a file that is built begins with
it, whose own compilation would fail."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NEEDY = "#pragma once\ninline Index next(Index i) { return i + 1; }\n"


class CheckHeaders(unittest.TestCase):
    def run_on(self, files, *options):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        return self.check(folder, {"crumple/base/index.hpp": "#pragma once\nusing Index = int;\n", **files}, *options)

    def check(self, folder, files, *options):
        for name, text in files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
        result = subprocess.run([sys.executable, str(ROOT / "tools" / "check_headers"), "--root", str(folder), *options],
                                capture_output=True, text=True)
        return result.returncode, result.stdout

    def test_of_a_commit_on_only_what_differs_is_compiled(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        self.check(folder, {"crumple/base/old.hpp": NEEDY})
        for words in (["init", "-q"], ["add", "."], ["-c", "user.name=n", "-c", "user.email=n@n", "commit", "-qm", "first"]):
            subprocess.run(["git", *words], cwd=folder, check=True)
        self.assertEqual(self.check(folder, {}, "--since", "HEAD")[0], 0)
        self.assertEqual(self.check(folder, {"crumple/base/old.hpp": NEEDY + "\n"}, "--since", "HEAD")[0], 1)

    def test_of_an_unknown_commit_all_is_compiled(self):
        self.assertEqual(self.run_on({"crumple/base/next.hpp": NEEDY}, "--since", "0" * 40)[0], 1)

    def test_a_header_that_needs_another_is_named(self):
        status, said = self.run_on({"crumple/base/next.hpp": NEEDY})
        self.assertEqual(status, 1)
        self.assertIn("crumple/base/next.hpp: does not compile alone", said)

    def test_included_second_it_is_compiled_all_the_same(self):
        source = '#include "base/index.hpp"\n#include "base/next.hpp"\n'
        self.assertEqual(self.run_on({"crumple/base/next.hpp": NEEDY, "crumple/base/next.cpp": source})[0], 1)

    def test_what_a_source_begins_with_is_left_to_the_build(self):
        status, said = self.run_on({"crumple/base/next.hpp": NEEDY, "crumple/base/next.cpp": '#include "base/next.hpp"\n'})
        self.assertEqual(status, 0)
        self.assertIn("2 headers, 1 of them compiled alone", said)

    def test_a_source_that_is_not_built_proves_nothing(self):
        self.assertEqual(self.run_on({"crumple/base/next.hpp": NEEDY, "bench/next.cpp": '#include "base/next.hpp"\n'})[0], 1)

    def test_a_whole_header_passes(self):
        whole = '#pragma once\n#include "base/index.hpp"\n' + NEEDY.split("\n", 1)[1]
        self.assertEqual(self.run_on({"crumple/base/next.hpp": whole})[0], 0)


if __name__ == "__main__":
    unittest.main()
