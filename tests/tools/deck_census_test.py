# SPDX-License-Identifier: BSD-3-Clause
"""tools/deck_census: which decks are main decks, and how what is missing is ranked."""

import csv
import importlib.machinery
import importlib.util
import json
import stat
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOL = Path(__file__).resolve().parents[2] / "tools" / "deck_census"


def load():
    loader = importlib.machinery.SourceFileLoader("deck_census", str(TOOL))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("deck_census", loader))
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


census = load()


def answer(missing, can_run=False, harmless=0):
    return {"can_run": can_run, "errors": len(missing),
            "missing": [{"name": name, "count": count} for name, count in missing.items()],
            "without_effect": [{"name": "*DATABASE_ABSTAT", "count": harmless}] if harmless else []}


class Finding(unittest.TestCase):
    def test_names_of_included_files(self):
        text = "*KEYWORD\n*INCLUDE\n$ a remark\nmesh.k\nparts/a_very_long_ +\nname.k\n*NODE\n1\n*include_transform\nbody.k\n1,2\n"
        self.assertEqual(census.included_names(text), ["mesh.k", "parts/a_very_long_name.k", "body.k"])
        self.assertEqual(census.included_names("*INCLUDE_PATH\nfolder\n"), [])

    def test_main_decks_are_those_that_no_other_includes(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            (root / "one" / "sub").mkdir(parents=True)
            (root / "one" / "main.k").write_text("*KEYWORD\n*INCLUDE\nsub\\mesh.k\n*INCLUDE\nelsewhere/body.key\n")
            (root / "one" / "sub" / "mesh.k").write_text("*NODE\n")
            (root / "body.key").write_text("*NODE\n")
            (root / "other.DYN").write_text("$ a remark\n*KEYWORD\n")
            (root / "picture.k").write_text("no keyword\n")
            (root / "notes.txt").write_text("*KEYWORD\n")
            decks = census.main_decks(census.keyword_files([root]))
            self.assertEqual(decks, [root / "one" / "main.k", root / "other.DYN"])

    def test_a_deck_that_includes_itself_is_one(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder).resolve() / "main.k"
            path.write_text("*INCLUDE\nmain.k\n")
            self.assertEqual(census.main_decks(census.keyword_files([path])), [path])


class Ranking(unittest.TestCase):
    def test_what_most_decks_lack_comes_first(self):
        count = census.Census()
        count.add(answer({"*A": 1, "*B": 7}))
        count.add(answer({"*A": 2}))
        count.add(answer({}, can_run=True, harmless=3))
        count.add(answer({}))
        count.add("took longer than 1 s")
        self.assertEqual(count.ranking(), [("*A", 2, 1, 3), ("*B", 1, 0, 7)])
        self.assertEqual(count.summary(), "5 main decks: 1 can be run, 2 need what is missing, 1 have errors of their own, "
                                          "1 gave no answer; 3 cards without effect were accepted")

    def test_table_and_file_name_no_deck(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "secret.k").write_text("*KEYWORD\n")
            (root / "answer.json").write_text(json.dumps(answer({"*MAT_SPOTWELD": 2})))
            program = root / "program"
            program.write_text(f"#!/bin/sh\ncat '{root / 'answer.json'}'\nexit 2\n")
            program.chmod(program.stat().st_mode | stat.S_IXUSR)
            result = subprocess.run([sys.executable, str(TOOL), str(root), "--crumple", str(program), "--csv",
                                     str(root / "missing.csv")], capture_output=True, text=True, check=True)
            self.assertIn("*MAT_SPOTWELD", result.stdout)
            self.assertNotIn("secret", result.stdout)
            with open(root / "missing.csv", newline="", encoding="utf-8") as file:
                self.assertEqual(list(csv.reader(file)),
                                 [["missing", "decks", "alone", "times"], ["*MAT_SPOTWELD", "1", "1", "2"]])

    def test_help_has_examples(self):
        result = subprocess.run([sys.executable, str(TOOL), "--help"], capture_output=True, text=True, check=True)
        self.assertIn("examples:", result.stdout)

    def test_a_folder_that_is_missing_is_said(self):
        result = subprocess.run([sys.executable, str(TOOL), "no_such_folder"], capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 2)
        self.assertIn("there is no such folder", result.stderr)


if __name__ == "__main__":
    unittest.main()
