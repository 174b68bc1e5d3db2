# SPDX-License-Identifier: BSD-3-Clause
"""bench/record.py: names of files, rows of a program's table, rows appended under one header."""

import csv
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))
import record  # noqa: E402

TABLE = """ns per element-cycle                                               wall      cpu elements    nodes
belytschko-tsay plastic-kinematic mixed avx512 1k 2t              20.00    39.50    26.25     5.60
hughes-liu elastic double avx2 10k 1t                          not in this build
"""


class Record(unittest.TestCase):
    def test_file_name(self):
        self.assertEqual(record.file_name({"processor": "AMD EPYC 9B14", "processors": 2}), "amd_epyc_9b14_2")
        self.assertEqual(record.file_name({"processor": "Intel(R) Xeon(R) CPU E5-2690 @ 2.90GHz", "processors": 16}),
                         "intel_xeon_e5_2690_16")

    def test_rows_of_a_table(self):
        self.assertEqual(list(record.of_table(TABLE)), [
            {"case": "belytschko-tsay plastic-kinematic mixed avx512 1k 2t", "precision": "mixed", "isa": "avx512",
             "threads": "2", "wall": "20.00", "cpu": "39.50", "elements": "26.25", "integrate": "5.60"}])

    def test_rows_are_appended_under_one_header(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "results" / "machine.csv"
            self.assertEqual(record.append(path, [{"case": "a", "wall": "1.0"}]), 1)
            self.assertEqual(record.append(path, [{"case": "b"}, {"case": "c"}]), 2)
            with path.open() as stream:
                rows = list(csv.DictReader(stream))
        self.assertEqual([row["case"] for row in rows], ["a", "b", "c"])
        self.assertEqual(rows[0]["wall"], "1.0")

    def test_a_column_that_the_table_has_not_is_refused(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(ValueError):
            record.append(Path(folder) / "machine.csv", [{"colour": "red"}])


if __name__ == "__main__":
    unittest.main()
