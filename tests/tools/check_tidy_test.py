# SPDX-License-Identifier: BSD-3-Clause
"""tools/check_tidy: files that are read together, and what is found in one of them."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
LOADER = SourceFileLoader("check_tidy", str(ROOT / "tools" / "check_tidy"))
check_tidy = module_from_spec(spec_from_loader("check_tidy", LOADER))
LOADER.exec_module(check_tidy)


class Batches(unittest.TestCase):
    def test_every_file_is_in_one_and_no_kernel_with_others(self):
        files = [str(path) for folder in ("crumple", "tests") for path in sorted((ROOT / folder).rglob("*.cpp"))]
        groups = check_tidy.batches(ROOT, files)
        self.assertEqual(sorted(file for group in groups for file in group), files)
        self.assertLess(len(groups), len(files) / 2)
        for group in groups:
            self.assertEqual(len({Path(file).parent for file in group}), 1)
            if len(group) > 1:
                self.assertNotIn("kernels", Path(group[0]).parts)


class Since(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp()).resolve()
        self.addCleanup(shutil.rmtree, self.root)
        self.write("crumple/deck/a.cpp", '#include "deck/a.hpp"\n')
        self.write("crumple/deck/b.cpp", '#include "deck/a.hpp"\n#include "deck/c.hpp"\n')
        for name in ("a", "c"):
            self.write(f"crumple/deck/{name}.hpp", "#pragma once\n")
        self.write(".clang-tidy", "Checks: '*'\n")
        self.git("init", "-q")
        self.first = self.commit()

    def write(self, name, text):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text)

    def git(self, *words):
        return subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=self.root, check=True,
                              capture_output=True, text=True).stdout.strip()

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-qm", "a")
        return self.git("rev-parse", "HEAD")

    def chosen(self):
        changed = check_tidy.changed_under_the_same_rules(self.root, self.first)
        entries = {str(self.root / "crumple" / "deck" / name): {} for name in ("a.cpp", "b.cpp")}
        return changed and [Path(file).name for file in check_tidy.chosen_since(entries, changed, check_tidy.Sources(self.root))]

    def test_a_source_file_by_itself(self):
        self.write("crumple/deck/b.cpp", '#include "deck/c.hpp"\n')
        self.commit()
        self.assertEqual(self.chosen(), ["b.cpp"])

    def test_a_header_with_the_file_of_its_name_or_another(self):
        self.write("crumple/deck/a.hpp", "#pragma once\n#define A\n")
        self.assertEqual(self.chosen(), ["a.cpp"])
        self.write("crumple/deck/c.hpp", "#pragma once\n#define C\n")
        self.assertEqual(self.chosen(), ["a.cpp", "b.cpp"])

    def test_all_if_the_rules_changed_or_the_commit_is_unknown(self):
        self.assertIsNone(check_tidy.changed_under_the_same_rules(self.root, "0" * 40))
        self.assertIsNone(check_tidy.changed_under_the_same_rules(self.root, ""))
        self.write(".clang-tidy", "Checks: '-*'\n")
        self.assertIsNone(check_tidy.changed_under_the_same_rules(self.root, self.first))


@unittest.skipUnless(shutil.which("clang-tidy-14") or shutil.which("clang-tidy"), "clang-tidy is missing")
class Together(unittest.TestCase):
    def batch_of(self, texts):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        shutil.copy(ROOT / ".clang-tidy", folder)
        entries = {}
        for name, text in texts.items():
            file = folder / "crumple" / "deck" / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
            entries[str(file)] = {"directory": str(folder), "file": str(file),
                                  "arguments": ["clang++", "-std=c++20", "-c", str(file)]}
        program = shutil.which("clang-tidy-14") or shutil.which("clang-tidy")
        found = check_tidy.Tidy(program, folder, folder, entries, False).batch(list(entries))
        return found and {Path(file).name: result.returncode for file, result in found.items()}

    def test_nothing_to_say(self):
        self.assertIsNone(self.batch_of({"a.cpp": "int first() { return 1; }\n", "b.cpp": "int second() { return 2; }\n"}))

    def test_a_fault_of_the_second_is_that_of_the_second(self):
        self.assertEqual(self.batch_of({"a.cpp": "int first() { return 1; }\n", "b.cpp": "int BadName() { return 2; }\n"}),
                         {"a.cpp": 0, "b.cpp": 1})

    def test_files_that_do_not_go_together_are_read_alone(self):
        local = "namespace {\nint local() { return 1; }\n}\nint %s() { return local(); }\n"
        self.assertEqual(self.batch_of({"a.cpp": local % "first", "b.cpp": local % "second"}), {"a.cpp": 0, "b.cpp": 0})


if __name__ == "__main__":
    unittest.main()
