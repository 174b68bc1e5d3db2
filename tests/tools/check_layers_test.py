# SPDX-License-Identifier: BSD-3-Clause
"""tools/check_layers on small trees: a good one passes, and each kind of offence fails at its file and line."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LAYERS = """set(CRUMPLE_LAYERS
  "base:"
  "model: base"
  "contact: model base cellsearch"
  "deck: model base")
set(CRUMPLE_NON_CORE deck)
"""
GOOD = {
    "cmake/layers.cmake": LAYERS,
    "cellsearch/include/cellsearch/search.hpp": "#include <vector>\n",
    "cellsearch/src/search.cpp": '#include "cellsearch/search.hpp"\n',
    "crumple/base/index.hpp": "#include <cstdint>\n#include <experimental/simd>\n",
    "crumple/model/model.hpp": '// #include "deck/reader.hpp"\n#include "base/index.hpp"\n',
    "crumple/deck/reader.hpp": '#include <fmt/format.h>\n#include "model/model.hpp"\n',
    "crumple/contact/surface/surface.cpp": '#include <cellsearch/search.hpp>\n',
    "crumple/app/main.cpp": '#include <CLI/CLI.hpp>\n#include "deck/reader.hpp"\n',
}


class CheckLayers(unittest.TestCase):
    def run_on(self, changes):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        for name, text in {**GOOD, **changes}.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)
        result = subprocess.run([sys.executable, str(ROOT / "tools" / "check_layers"), "--root", str(folder)],
                                capture_output=True, text=True)
        return result.returncode, result.stdout + result.stderr

    def assert_fails(self, changes, place, words):
        status, output = self.run_on(changes)
        self.assertEqual(status, 1, output)
        lines = [line for line in output.splitlines() if line.startswith(place + ":")]
        self.assertTrue(any(words in line for line in lines), f"no '{place}: ... {words}' in:\n{output}")

    def test_good_tree_passes(self):
        status, output = self.run_on({})
        self.assertEqual(status, 0, output)

    def test_upward_include(self):
        self.assert_fails({"crumple/base/index.hpp": '#include <cstdint>\n\n#  include "model/model.hpp"\n'},
                          "crumple/base/index.hpp:3", "base may not include model")

    def test_upward_include_as_system_header(self):
        self.assert_fails({"crumple/base/index.hpp": "#include <model/model.hpp>\n"},
                          "crumple/base/index.hpp:1", "base may not include model")

    def test_nobody_includes_the_program(self):
        self.assert_fails({"crumple/app/app.hpp": "", "crumple/deck/reader.hpp": '#include "app/app.hpp"\n'},
                          "crumple/deck/reader.hpp:1", "deck may not include app")

    def test_cycle_of_folders(self):
        self.assert_fails({"crumple/base/index.hpp": '#include "model/model.hpp"\n'},
                          "crumple/model/model.hpp:2", "in a cycle of folders")

    def test_cycle_in_the_allow_list(self):
        self.assert_fails({"cmake/layers.cmake": LAYERS.replace('"base:"', '"base: deck"')},
                          "cmake/layers.cmake:1", "the allow-list has a cycle")

    def test_search_library_by_others_than_contact(self):
        self.assert_fails({"crumple/model/model.hpp": "#include <cellsearch/search.hpp>\n"},
                          "crumple/model/model.hpp:1", "model may not include cellsearch")

    def test_cellsearch_includes_crumple(self):
        self.assert_fails({"cellsearch/src/search.cpp": '\n#include "base/index.hpp"\n'},
                          "cellsearch/src/search.cpp:2", "stands alone")

    def test_cellsearch_reaches_crumple_by_a_path(self):
        self.assert_fails({"cellsearch/src/search.cpp": '#include "../../crumple/base/index.hpp"\n'},
                          "cellsearch/src/search.cpp:1", "stands alone")

    def test_cellsearch_with_a_dependency(self):
        self.assert_fails({"cellsearch/src/search.cpp": "#include <fmt/format.h>\n"},
                          "cellsearch/src/search.cpp:1", "standard library")

    def test_mpi_outside_its_transport(self):
        self.assert_fails({"cellsearch/src/search.cpp": "#include <mpi.h>\n"},
                          "cellsearch/src/search.cpp:1", "standard library")
        status, output = self.run_on({"cellsearch/include/cellsearch/distributed/mpi_transport.hpp": "#include <mpi.h>\n"})
        self.assertEqual(status, 0, output)

    def test_core_with_a_dependency(self):
        self.assert_fails({"crumple/model/model.hpp": "#include <zlib.h>\n"},
                          "crumple/model/model.hpp:1", "standard library")

    def test_path_around_the_rule(self):
        self.assert_fails({"crumple/base/index.hpp": '#include "../model/model.hpp"\n'},
                          "crumple/base/index.hpp:1", "from the root of crumple")

    def test_computed_include(self):
        self.assert_fails({"crumple/base/index.hpp": "#include HEADER\n"},
                          "crumple/base/index.hpp:1", "cannot be checked")

    def test_folder_without_a_rule(self):
        self.assert_fails({"crumple/extra/thing.hpp": "\n"}, "crumple/extra/thing.hpp:1", "not in cmake/layers.cmake")

    def in_rooms(self, header):
        rooms = LAYERS + '\nset(CRUMPLE_ROOMS\n  "model/parts:"\n  "model/whole: model/parts")\n'
        return {"cmake/layers.cmake": rooms, "crumple/model/parts/part.hpp": "", "crumple/model/whole/all.hpp": "",
                "crumple/model/top.hpp": '#include "model/whole/all.hpp"\n', **header}

    def test_rooms_of_a_folder(self):
        status, output = self.run_on(self.in_rooms(
            {"crumple/model/whole/all.hpp": '#include "model/parts/part.hpp"\n'}))
        self.assertEqual(status, 0, output)

    def test_upward_include_between_rooms(self):
        self.assert_fails(self.in_rooms({"crumple/model/parts/part.hpp": '#include "model/whole/all.hpp"\n'}),
                          "crumple/model/parts/part.hpp:1", "model/parts may not include model/whole")

    def test_no_room_includes_what_stands_above_it(self):
        self.assert_fails(self.in_rooms({"crumple/model/parts/part.hpp": '#include "model/top.hpp"\n'}),
                          "crumple/model/parts/part.hpp:1", "model/parts may not include model")

    def with_shared_header(self, text):
        tree = self.in_rooms({"crumple/model/limits.hpp": text,
                              "crumple/model/parts/part.hpp": '#include "model/limits.hpp"\n'})
        tree["cmake/layers.cmake"] += "set(CRUMPLE_SHARED_HEADERS model/limits.hpp)\n"
        return tree

    def test_shared_header_of_a_folder(self):
        status, output = self.run_on(self.with_shared_header('#include "base/index.hpp"\n'))
        self.assertEqual(status, 0, output)

    def test_shared_header_with_an_include_of_its_folder(self):
        self.assert_fails(self.with_shared_header('#include "model/whole/all.hpp"\n'),
                          "crumple/model/limits.hpp:1", "must not include anything of its folder")

    def test_shared_header_that_does_not_exist(self):
        self.assert_fails({"cmake/layers.cmake": LAYERS + "set(CRUMPLE_SHARED_HEADERS model/gone.hpp)\n"},
                          "cmake/layers.cmake:1", "model/gone.hpp does not exist")

    def test_room_without_a_rule(self):
        self.assert_fails(self.in_rooms({"crumple/model/cellar/box.hpp": '#include "model/parts/part.hpp"\n'}),
                          "crumple/model/cellar/box.hpp:1", "not in cmake/layers.cmake")


if __name__ == "__main__":
    unittest.main()
