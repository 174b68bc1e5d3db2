# SPDX-License-Identifier: BSD-3-Clause
"""tools/verification_manual reads what tests note, and tells when a page says something else."""

import sys
import unittest
import xml.etree.ElementTree as ElementTree
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
LOADER = SourceFileLoader("verification_manual", str(ROOT / "tools" / "verification_manual"))
manual = module_from_spec(spec_from_loader("verification_manual", LOADER))
LOADER.exec_module(manual)


def results(*notes, name="Moves/Fast"):
    test = {"name": name, "file": "/somewhere/tests/verification/bar_wave_test.cpp"}
    test.update({f"case_{i}": note for i, note in enumerate(notes)})
    return {"testsuites": [{"name": "Both/Bar", "testsuite": [test]}]}


def page(*notes):
    return manual.page_of(list(manual.cases_of(results(*notes))), [], ROOT)


class VerificationManualTest(unittest.TestCase):
    def test_reads_a_note(self):
        case, = manual.cases_of(results("bar: front | exact | near | 1.01 | 1 | 0.02"))
        self.assertEqual(case["file"], "tests/verification/bar_wave_test.cpp")
        self.assertEqual((case["test"], case["variant"]), ("Bar.Moves", "Fast"))
        self.assertAlmostEqual(manual.share_of(case), 0.5)

    def test_shares_of_each_kind(self):
        within, below = manual.cases_of(results("a | b | within | 19 | 20 | 0.1", "a | b | below | 1e-13 | 0 | 1e-12"))
        self.assertAlmostEqual(manual.share_of(within), 0.5)
        self.assertAlmostEqual(manual.share_of(below), 0.1)

    def test_variants_share_a_row(self):
        cases = list(manual.cases_of(results("a | b | near | 1 | 1 | 0.1")))
        cases += list(manual.cases_of(results("a | b | near | 1.05 | 1 | 0.1", name="Moves/VerySlow")))
        self.assertIn("| a | b | 1 | +- 0.1 | Fast 1, Very Slow 1.05 |", manual.page_of(cases, [], ROOT))

    def test_instruction_sets_are_one_figure_the_worst(self):
        cases = list(manual.cases_of(results("a | b | below | 1e-15 | 0 | 1e-12", name="Moves/scalar")))
        cases += manual.cases_of(results("a | b | below | 3e-15 | 0 | 1e-12", "a | b | below | 2e-15 | 0 | 1e-12", name="Moves/avx2"))
        self.assertIn("| a | b | 0 | < 1e-12 | 3e-15 |", manual.page_of(cases, [], ROOT))

    def test_as_many_digits_as_the_limit_resolves(self):
        for note, words in (("near | 1.0000000000123 | 1 | 1e-9", "1 | +- 1e-09 | 1.00000000001"),
                            ("near | 1.0123456 | 1 | 0.1", "1 | +- 0.1 | 1.0123"),
                            ("within | 1999.99876 | 2000.0012 | 1e-6", "2000.0012 | +- 0.0001 % | 1999.99876"),
                            ("near | 0.33333333333333381 | 0.33333333333333331 | 1e-14",
                             "0.333333333333333 | +- 1e-14 | 0.3333333333333338"),
                            ("near | 6.0000000000000009 | 6 | 1e-15", "6 | +- 1e-15 | 6.000000000000001"),
                            ("near | 1.2345e-16 | 0 | 1e-15", "0 | +- 1e-15 | 1.2e-16")):
            noted = list(manual.cases_of(results(f"a | b | {note}", name="Moves")))
            self.assertIn(f"| a | b | {words} |", manual.page_of(noted, [], ROOT))

    def test_a_narrow_limit_has_an_honest_share(self):
        case, = manual.cases_of(results("a | b | near | 1.00000000000025 | 1 | 1e-12"))
        self.assertAlmostEqual(manual.share_of(case), 0.25, places=3)

    def test_accepted_values_that_are_written_alike_are_one(self):
        cases = list(manual.cases_of(results("a | b | near | 0.10000000000000003 | 0.10000000000000001 | 1e-12",
                                             name="Moves/scalar")))
        cases += manual.cases_of(results("a | b | near | 0.10000000000000001 | 0.10000000000000002 | 1e-12", name="Moves/avx2"))
        self.assertEqual(manual.page_of(cases, [], ROOT).count("| a | b | 0.1 | +- 1e-12 |"), 1)

    def test_formulations_of_one_test_share_a_row(self):
        cases = list(manual.cases_of(results("HughesLiu, bent: moment | b | below | 1e-15 | 0 | 1e-12",
                                             "IHQ 5, bent: moment | b | below | 2e-15 | 0 | 1e-12")))
        self.assertIn("| bent: moment | b | 0 | < 1e-12 | Hughes Liu 1e-15, IHQ 5 2e-15 |", manual.page_of(cases, [], ROOT))

    def test_contents_lead_to_every_heading(self):
        cases = []
        for file in ("elements/shell/erosion", "verification/erosion", "materials/solid_paths"):
            noted = results("a | b | near | 1 | 1 | 0.1")
            noted["testsuites"][0]["testsuite"][0]["file"] = f"/somewhere/tests/{file}_test.cpp"
            cases += manual.cases_of(noted)
        page = manual.page_of(cases, [], ROOT)
        self.assertIn("[Erosion (elements)](#erosion-elements)", page)
        self.assertLess(page.index("\n### Erosion (elements)\n"), page.index("\n## Material laws\n\n### Solid paths\n"))
        self.assertLess(page.index("\n### Solid paths\n"), page.index("\n## Whole models\n\n### Erosion (verification)\n"))

    def test_draws_curves(self):
        noted = results("a | b | near | 1 | 1 | 0.1")
        noted["testsuites"][0]["testsuite"][0]["curves_1"] = (
            "Bar, half-way | x [mm] | u [mm] | accepted : exact : 0 0 1 -2 2 -2 | found : 50 elements : 0 0 2 -1.99")
        curve, = manual.curves_of(noted)
        self.assertEqual(curve["lines"][1], ("found", "50 elements", [(0.0, 0.0), (2.0, -1.99)]))
        self.assertEqual(manual.file_name(curve), "verified_bar_half_way.svg")
        drawn = ElementTree.fromstring(manual.picture(curve))
        self.assertEqual(len(drawn.findall("{*}circle")), 2)
        self.assertEqual(len(drawn.findall("{*}polyline")), 1)
        page = manual.page_of(list(manual.cases_of(noted)), [curve], ROOT)
        self.assertIn("![Bar, half-way](pictures/verified_bar_half_way.svg)", page)

    def test_round_off_is_no_difference(self):
        written = page("a | b | near | 1.01 | 1 | 0.02", "c | b | below | 1.0e-14 | 0 | 1e-12")
        now = page("a | b | near | 1.0101 | 1 | 0.02", "c | b | below | 2.0e-14 | 0 | 1e-12")
        self.assertEqual(manual.differences(written, now), [])
        written = page("a | b | near | 6.0000000000000009 | 6 | 1e-15")
        self.assertEqual(manual.differences(written, page("a | b | near | 6 | 6 | 1e-15")), [])

    def test_a_difference_of_narrow_limits_is_told(self):
        written = page("a | b | near | 1 | 1 | 1e-9")
        self.assertEqual(len(manual.differences(written, page("a | b | near | 1.0000000005 | 1 | 1e-9"))), 1)

    def test_other_figures_and_limits_are_told(self):
        written = page("a | b | near | 1.01 | 1 | 0.02")
        self.assertEqual(len(manual.differences(written, page("a | b | near | 1.015 | 1 | 0.02"))), 1)
        self.assertEqual(len(manual.differences(written, page("a | b | near | 1.01 | 1 | 0.03"))), 2)
        self.assertEqual(len(manual.differences(written, page("a | b | within | 1.01 | 1 | 0.02"))), 2)


if __name__ == "__main__":
    unittest.main()
