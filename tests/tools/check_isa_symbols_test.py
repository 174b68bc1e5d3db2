# SPDX-License-Identifier: BSD-3-Clause
"""tools/check_isa_symbols on object files compiled here: a function shared between instruction sets must be found."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SHARED = """namespace crumple {
[[gnu::noinline]] inline double twice(double x) { return x + x; }
double USER(double x) { return twice(x); }
}
"""
APART = """namespace crumple {
template <int Width> [[gnu::noinline]] double twice(double x) { return x + x; }
double USER(double x) { return twice<WIDTH>(x); }
}
"""


class CheckIsaSymbols(unittest.TestCase):
    def run_on(self, sources, build_type="Release"):
        build = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, build)
        (build / "CMakeCache.txt").write_text(f"CMAKE_BUILD_TYPE:STRING={build_type}\n")
        for number, (target, text) in enumerate(sources.items(), 1):
            target, _, name = target.partition("/")
            file = build / "CMakeFiles" / f"{target}.dir" / (name or "text.cpp")
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
            subprocess.run(["g++", "-O3", "-c", f"-DUSER=user_{number}", f"-DWIDTH={number}", file.name,
                            "-o", f"{file.name}.o"], cwd=file.parent, check=True)
        result = subprocess.run([sys.executable, str(ROOT / "tools" / "check_isa_symbols"), str(build)],
                                capture_output=True, text=True)
        return result.returncode, result.stdout + result.stderr

    def test_shared_with_the_common_code(self):
        status, output = self.run_on({"crumple_elements_avx2": SHARED, "crumple_domain": SHARED})
        self.assertEqual(status, 1, output)
        self.assertIn("crumple::twice(double)", output)
        self.assertIn("avx2, common", output)

    def test_shared_between_two_variants(self):
        status, output = self.run_on({"crumple_elements_avx2": SHARED, "crumple_elements_avx512": SHARED})
        self.assertEqual(status, 1, output)

    def test_scalar_and_baseline_share_no_function_of_ours(self):
        status, output = self.run_on({"crumple_elements_scalar": SHARED, "crumple_elements_baseline": SHARED})
        self.assertEqual(status, 1, output)

    def test_common_code_may_share(self):
        status, output = self.run_on({"crumple_model": SHARED, "crumple_domain": SHARED})
        self.assertEqual(status, 0, output)

    def test_names_that_differ(self):
        status, output = self.run_on({"crumple_elements_avx2": APART, "crumple_domain": APART})
        self.assertEqual(status, 0, output)

    def test_search_kernels_against_each_other(self):
        status, output = self.run_on({"cellsearch/src/production/x86/avx2.cpp": SHARED,
                                      "cellsearch/src/production/x86/avx512.cpp": SHARED})
        self.assertEqual(status, 1, output)
        self.assertIn("avx2, avx512", output)
        self.assertIn("2 kernel objects of 2, 1 shared functions", output)

    def test_search_kernels_against_the_rest_of_the_library(self):
        for kernel in ("x86/avx2.cpp", "kernel_avx512.cpp"):
            status, output = self.run_on({f"cellsearch/src/production/{kernel}": SHARED,
                                          "cellsearch/src/search.cpp": SHARED})
            self.assertEqual(status, 1, output)
            self.assertIn("crumple::twice(double)", output)

    def test_search_kernels_with_names_that_differ(self):
        status, output = self.run_on({"cellsearch/src/production/x86/avx2.cpp": APART,
                                      "cellsearch/src/production/x86/avx512.cpp": APART,
                                      "cellsearch/src/production/kernel_portable.cpp": APART})
        self.assertEqual(status, 0, output)

    def test_only_release_builds_say_something(self):
        status, output = self.run_on({"crumple_domain": SHARED}, "Debug")
        self.assertEqual(status, 1, output)
        self.assertIn("not a Release build", output)


if __name__ == "__main__":
    unittest.main()
