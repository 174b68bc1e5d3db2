# SPDX-License-Identifier: BSD-3-Clause
"""The theory manual has a page for everything that is registered, and each page tells its limits."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
THEORY = ROOT / "docs" / "theory"
CONTENTS = (THEORY / "README.md").read_text()
LISTS = ("materials/list.hpp", "elements/shell/list.hpp", "elements/solid/solid_list.hpp")
# Pages that have their limits in the text, or describe what has none.
WITHOUT_LIMITS = {"README.md", "energy.md", "hourglass.md", "thickness_integration.md", "time_integration.md"}


def registered():
    """Names in the lists of laws, equations of state and formulations, and the beams' kernels."""
    for name in LISTS:
        text = (ROOT / "crumple" / name).read_text()
        for body in re.findall(r"List<((?:\s*//.*|[^<>])*?)>;", text):
            yield from re.findall(r"^\s*([A-Z]\w+)", body, re.M)
    beams = (ROOT / "crumple" / "elements" / "kernels" / "beams.cpp").read_text()
    yield from re.findall(r"beam_chunk<(\w+)", beams)


class DocumentationTest(unittest.TestCase):
    def test_everything_registered_has_a_row(self):
        names = list(registered())
        self.assertGreater(len(names), 25)
        for name in names:
            self.assertIn(f"`{name}`", CONTENTS)

    def test_every_page_is_in_the_contents(self):
        for page in THEORY.glob("*.md"):
            if page.name != "README.md":
                self.assertIn(f"]({page.name}", CONTENTS)

    def test_every_page_tells_its_limits(self):
        for page in THEORY.glob("*.md"):
            if page.name not in WITHOUT_LIMITS:
                self.assertIn("\n## Limits\n", page.read_text(), page.name)


if __name__ == "__main__":
    unittest.main()
