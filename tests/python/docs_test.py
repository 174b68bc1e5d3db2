# SPDX-License-Identifier: BSD-3-Clause
"""The examples of docs/python.md, run as they stand, and the example study."""
import contextlib
import io
import os
import re
import shutil
import subprocess
import sys
import unittest

import numpy

from support import ROOT, FolderTest


class DocsTest(FolderTest):
    def test_examples_of_the_page(self):
        for name in ("tube.k", "mesh.k"):
            shutil.copy(ROOT / "examples/00_first_deck" / name, self.folder)
        blocks = re.findall(r"^```python\n(.*?)^```", (ROOT / "docs/python.md").read_text(), re.S | re.M)
        self.assertGreaterEqual(len(blocks), 6)
        place = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, place)
        printed = io.StringIO()
        names = {}
        with contextlib.redirect_stdout(printed):
            for number, block in enumerate(blocks):
                exec(compile(block, f"docs/python.md, example {number + 1}", "exec"), names)
        self.assertIn("kg, mm, ms ('1.4', 'command line')", printed.getvalue())
        self.assertIn(" kN\n", printed.getvalue())
        self.assertEqual(names["simulation"].termination, "normal")
        self.assertEqual(len(names["speeds"]), 6)
        self.assertTrue(names["table"].ok.all())

    def test_the_names_of_the_page_exist(self):
        import crumple

        text = (ROOT / "docs/python.md").read_text()
        for name in re.findall(r"crumple\.([A-Za-z_]+)", text):
            if name not in ("sh",):
                self.assertTrue(hasattr(crumple, name), name)
        for name in re.findall(r"^\| `([^|]*?)` \|", text, re.M):
            for word in re.findall(r"[A-Za-z_]+", name.split("(")[0]):
                self.assertTrue(hasattr(crumple, word) or hasattr(crumple.Simulation, word), word)

    def test_the_study(self):
        script = ROOT / "examples/python/sweep_square_tube.py"
        command = [sys.executable, str(script), str(self.folder / "study"), "--runs", "14"]
        first = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(first.returncode, 0, first.stderr)
        lines = first.stdout.splitlines()
        self.assertEqual(lines[0], "14 of 14 runs ended normally")
        self.assertEqual([line[:12].strip() for line in lines[2:]], ["peak force", "mean force", "crushed"])
        again = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(again.stdout, first.stdout)

    def test_sobol_indices_of_the_study_against_closed_forms(self):
        # The function of T. Ishigami, T. Homma (1990) with a = 7, b = 0.1: variance and parts in closed form.
        sys.path.insert(0, str(ROOT / "examples/python"))
        self.addCleanup(sys.path.remove, str(ROOT / "examples/python"))
        import sweep_square_tube as study

        def ishigami(points):
            x = numpy.pi * points
            return numpy.sin(x[:, 0]) + 7 * numpy.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * numpy.sin(x[:, 0])

        first, total = study.sobol(ishigami, 3, n=200000)
        pi4 = numpy.pi**4
        v1 = 0.5 * (1 + 0.1 * pi4 / 5) ** 2
        v2 = 49 / 8
        v13 = 0.01 * pi4**2 * (1 / 18 - 1 / 50)
        variance = v1 + v2 + v13
        numpy.testing.assert_allclose(first, numpy.array([v1, v2, 0]) / variance, atol=0.01)
        numpy.testing.assert_allclose(total, numpy.array([v1 + v13, v2, v13]) / variance, atol=0.01)

    def test_surrogate_of_the_study_fits_a_quadratic_exactly(self):
        sys.path.insert(0, str(ROOT / "examples/python"))
        self.addCleanup(sys.path.remove, str(ROOT / "examples/python"))
        import sweep_square_tube as study

        x = numpy.random.default_rng(1).uniform(-1, 1, (30, 3))
        y = 1 + 2 * x[:, 0] - x[:, 1] * x[:, 2] + 3 * x[:, 2] ** 2
        coefficients, quality = study.fit(x, y)
        self.assertAlmostEqual(quality, 1.0, 9)
        numpy.testing.assert_allclose(study.polynomial(x) @ coefficients, y)
        noise = numpy.random.default_rng(2).normal(size=30)
        self.assertLess(study.fit(x, noise)[1], 0.3)


if __name__ == "__main__":
    unittest.main()
