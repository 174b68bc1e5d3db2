# SPDX-License-Identifier: BSD-3-Clause
"""tools/count_places: the places to add to are there, and one that is gone is reported. It compiles the dummies in
tools/nightly only, as that takes a minute."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def count(root):
    result = subprocess.run([sys.executable, str(ROOT / "tools" / "count_places"), "--root", str(root), "--no-compile"],
                            capture_output=True, text=True)
    return result.returncode, result.stdout + result.stderr


class CountPlaces(unittest.TestCase):
    def test_all_places_are_there(self):
        status, output = count(ROOT)
        self.assertEqual(status, 0, output)
        for kind in ("material", "shell formulation", "history", "keyword"):
            self.assertIn(kind, output)

    def test_a_place_that_is_gone(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        shutil.copytree(ROOT / "crumple", folder / "crumple")
        laws = folder / "crumple" / "materials" / "list.hpp"
        laws.write_text(laws.read_text().replace("SolidLaws", "LawsOfSolids"))
        status, output = count(folder)
        self.assertEqual(status, 1, output)
        self.assertIn("crumple/materials/list.hpp: the place to add to is not there", output)

    def test_a_place_that_is_new(self):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        shutil.copytree(ROOT / "crumple", folder / "crumple")
        (folder / "crumple" / "app" / "new_place.cpp").write_text("// if this is a CrushableFoam\n")
        status, output = count(folder)
        self.assertEqual(status, 1, output)
        self.assertIn("crumple/app/new_place.cpp: names a sibling", output)


if __name__ == "__main__":
    unittest.main()
