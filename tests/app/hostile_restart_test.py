#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Restart files with a right checksum and wrong content.

    hostile_restart_test.py PROGRAM [unittest options]

Whatever stands in an array, the program says what is wrong, or goes on and ends as runs end; no signal ends it.
"""
import json
import os
import pathlib
import random
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
DECKS = ("tests/app/attacks/block_onto_plate.k", "tests/app/attacks/struck_block.k")
VARIANTS = 100
MASK = (1 << 64) - 1
INDICES = (-1, -2, 1 << 20, (1 << 31) - 1, -(1 << 31))
NUMBERS = (float("nan"), float("inf"), -1e300, 1e300, 0.0, -1.0, 1e9)


class StateHash:
    """crumple/base/state_hash.hpp."""

    def __init__(self):
        self.value = 0

    def mix(self, word):
        z = ((self.value ^ word) + 0x9e3779b97f4a7c15) & MASK
        z = ((z ^ (z >> 30)) * 0xbf58476d1ce4e5b9) & MASK
        z = ((z ^ (z >> 27)) * 0x94d049bb133111eb) & MASK
        self.value = z ^ (z >> 31)

    def add(self, data):
        whole = len(data) // 8 * 8
        for (word,) in struct.iter_unpack("<Q", data[:whole]):
            self.mix(word)
        self.mix(int.from_bytes(data[whole:], "little") ^ (len(data) << 8 & MASK))


class RestartFile:
    """crumple/output/files/restart_file.cpp."""

    def __init__(self, data):
        length = struct.unpack_from("<Q", data, 16)[0]
        self.preamble = data[:16]
        self.header = json.loads(data[24:24 + length])
        at = 24 + length
        self.texts = []
        for bytes_of in self.header["texts"]:
            self.texts.append(data[at:at + bytes_of])
            at += bytes_of
        self.arrays = []
        for kind in ("simulation", "files"):
            for name, bytes_of in self.header[kind]:
                self.arrays.append([kind, name, data[at:at + bytes_of]])
                at += bytes_of
        assert at + 8 == len(data)

    def bytes(self):
        for kind in ("simulation", "files"):
            self.header[kind] = [[name, len(data)] for of, name, data in self.arrays if of == kind]
        header = json.dumps(self.header).encode()
        pieces = [self.preamble + struct.pack("<Q", len(header)), header, *self.texts, *(array[2] for array in self.arrays)]
        checksum = StateHash()
        for piece in pieces:
            checksum.add(piece)
        return b"".join(pieces) + struct.pack("<Q", checksum.value)


def change(data, dice):
    kind = dice.randrange(6)
    if kind == 0:
        return data[:dice.randrange(len(data) + 1)]
    if kind == 1:
        return data + bytes(dice.randrange(1, 400))
    if not data:
        return struct.pack("<ii", dice.choice(INDICES), dice.choice(INDICES)) * dice.randrange(1, 30)
    if kind == 2:
        at = dice.randrange(len(data))
        return data[:at] + bytes([dice.randrange(256)]) + data[at + 1:]
    put = struct.pack("<i", dice.choice(INDICES)) if kind < 5 else struct.pack("<d", dice.choice(NUMBERS))
    # An index stands anywhere in an item, or everywhere.
    if dice.randrange(4) == 0:
        return (put * (len(data) // len(put) + 1))[:len(data)]
    at = dice.randrange(max(1, len(data) // len(put))) * len(put)
    return (data[:at] + put + data[at + len(put):])[:len(data)]


class HostileRestart(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="crumple_hostile_"))
        self.addCleanup(shutil.rmtree, self.root, True)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, "run", "-q", *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, check=False, timeout=120)

    def begin(self, deck):
        folder = self.root / pathlib.Path(deck).stem
        result = self.run_program(deck, "-o", folder, "--restart-every", 200)
        self.assertEqual(result.returncode, 0, result.stderr)
        return (folder / "restart" / "previous.restart").read_bytes()

    def take_up(self, data):
        file = self.root / "changed.restart"
        file.write_bytes(data)
        shutil.rmtree(self.root / "out", ignore_errors=True)
        return self.run_program("--restart", file, "-o", self.root / "out")

    def test_what_is_not_changed_is_taken_up(self):
        data = self.begin(DECKS[0])
        result = self.take_up(RestartFile(data).bytes())
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_changed_arrays_crash_nothing(self):
        dice = random.Random(20261126)
        seen = {}
        for deck in DECKS:
            data = self.begin(deck)
            for variant in range(VARIANTS // len(DECKS)):
                file = RestartFile(data)
                changed = [dice.randrange(len(file.arrays)) for _ in range(dice.choice((1, 1, 2, 5)))]
                for number in changed:
                    file.arrays[number][2] = change(file.arrays[number][2], dice)
                result = self.take_up(file.bytes())
                names = [file.arrays[number][1] for number in changed]
                self.assertIn(result.returncode, (0, 1, 3, 4), f"{deck} {variant} {names}: {result.stderr[-500:]}")
                self.assertNotIn("internal error", result.stderr, names)
                seen[result.returncode] = seen.get(result.returncode, 0) + 1
        # The files get beyond the checksum, and not all of them are good.
        self.assertGreater(seen.get(1, 0), VARIANTS // 10)


if __name__ == "__main__":
    unittest.main(verbosity=2)
