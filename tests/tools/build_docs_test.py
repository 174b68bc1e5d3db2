# SPDX-License-Identifier: BSD-3-Clause
"""tools/build_docs finds what is wrong with pages and with a site."""

import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[2] / "tools"
sys.path.insert(0, str(TOOLS))
sys.dont_write_bytecode = True
LOADER = SourceFileLoader("build_docs", str(TOOLS / "build_docs"))
build_docs = module_from_spec(spec_from_loader("build_docs", LOADER))
LOADER.exec_module(build_docs)

NAVIGATION = "nav:\n  - Home: README.md\n"


class BuildDocsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve() / "project"

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def gather(self, readme, navigation=NAVIGATION):
        self.write("README.md", readme)
        self.write("mkdocs.yml", navigation)
        self.pages = self.root.parent / "pages"
        return build_docs.gather_pages(self.root, self.pages)

    def check(self, page, **others):
        self.write("index.html", page)
        for name, text in others.items():
            self.write(f"{name}.html", text)
        return build_docs.check_site(self.root)[0]

    def test_linked_files_come_along(self):
        self.write("pictures/a.svg", "<svg/>")
        self.assertEqual(self.gather("![a](pictures/a.svg) and `[no](link)`\n"), [])
        self.assertTrue((self.pages / "pictures" / "a.svg").is_file())

    def test_bars_in_code_lose_their_backslash(self):
        self.gather("| `a\\|b` | \\| |\n")
        self.assertEqual((self.pages / "README.md").read_text(), "| `a|b` | \\| |\n")

    def test_dead_links_and_folders_are_told(self):
        (self.root / "docs").mkdir(parents=True)
        problems = self.gather("[a](gone.md), [b](docs)\n")
        self.assertEqual(len(problems), 2)

    def test_pages_without_a_place_in_the_navigation_are_told(self):
        self.write("docs/lost.md", "# Lost\n")
        self.assertEqual(self.gather("text\n"), ["docs/lost.md: is not in the navigation of mkdocs.yml"])

    def test_good_site(self):
        page = '<a href="b.html#x">b</a><a href="https://example.org">e</a>'
        self.assertEqual(self.check(page, b='<p id="x">'), [])

    def test_dead_anchors_are_told(self):
        self.assertEqual(len(self.check('<a href="b.html#y">b</a><a href="c.html">c</a>', b='<p id="x">')), 2)

    def test_what_comes_from_elsewhere_is_told(self):
        self.write("site.css", "@import 'https://example.org/a.css'; a { background: url(//example.org/b.png) }")
        problems = self.check('<script src="https://example.org/a.js"></script><img src="//example.org/b.png">')
        self.assertEqual(len(problems), 4)


if __name__ == "__main__":
    unittest.main()
