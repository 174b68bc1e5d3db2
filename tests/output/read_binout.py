#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads binout0000 of a folder of results as programs of the field do, from one symbol table to the next, and
compares it with the tables there, number by number. Standard library only.

    read_binout.py FOLDER
"""
import csv
import pathlib
import struct
import sys

CD, VARIABLE, BEGIN, END, FIRST = 2, 4, 5, 6, 7
TYPES = {1: "s", 3: "i", 4: "q", 10: "d"}

# By branch of binout: columns of our table and what LS-DYNA calls them.
COLUMNS = {
    "glstat": {"dt": "time_step", "kinetic": "kinetic_energy", "hourglass": "hourglass_energy",
               "total": "total_energy", "ratio": "energy_ratio", "added_mass": "added_mass"},
    "matsum": {"internal": "internal_energy", "kinetic": "kinetic_energy", "vz": "z_rbvelocity"},
    "rwforc": {"normal": "normal_force", "fx": "x_force", "fy": "y_force", "fz": "z_force"},
    "nodout": {"uz": "z_displacement", "vz": "z_velocity", "az": "z_acceleration", "z": "z_coordinate"},
}


class Binout:
    """A tree of folders (dict) and arrays (type, place, length)."""

    def __init__(self, path):
        self.bytes = path.read_bytes()
        assert self.bytes[:8] == bytes([8, 8, 8, 1, 1, 1, 0, 0]), "another header"
        assert self.head(8) == (17, FIRST), "no first table"
        self.root = {}
        link = 17
        while self.number(link):
            link = self.read_table(self.number(link))

    def number(self, place):
        return struct.unpack_from("<q", self.bytes, place)[0]

    def head(self, place):
        return struct.unpack_from("<qb", self.bytes, place)

    def read_table(self, place):
        """Adds what a table names; returns the place of the link to the next one."""
        assert self.head(place)[1] == BEGIN, "no table where a link points to"
        place += 9
        folder = self.root
        while True:
            length, command = self.head(place)
            body = self.bytes[place + 9:place + length]
            if command == END:
                return place + 9
            if command == CD:
                folder = self.folder(body.decode())
            else:
                assert command == VARIABLE, f"command {command} in a table"
                kind, record, count = struct.unpack("<bqq", body[-17:])
                folder[body[:-17].decode()] = (kind, record + 11 + len(body) - 17, count)
            place += length

    def folder(self, path):
        folder = self.root
        for part in path.strip("/").split("/"):
            folder = folder.setdefault(part, {})
        return folder

    def values(self, array):
        kind, place, count = array
        if kind == 1:
            return self.bytes[place:place + count].decode()
        return struct.unpack_from(f"<{count}{TYPES[kind]}", self.bytes, place)

    def history(self, branch, name):
        states = sorted(key for key in branch if key != "metadata")
        return [value for state in states for value in self.values(branch[state][name])]


def main():
    folder = pathlib.Path(sys.argv[1])
    binout = Binout(folder / "binout0000")
    compared = 0
    for name, columns in COLUMNS.items():
        if name not in binout.root:
            continue
        branch = binout.root[name]["forces"] if name == "rwforc" else binout.root[name]
        with (folder / f"{name}.csv").open() as stream:
            rows = list(csv.DictReader(stream))
        for ours, theirs in columns.items():
            assert binout.history(branch, theirs) == [float(row[ours]) for row in rows], f"{name}: {theirs}"
            compared += len(rows)
        times = binout.history(branch, "time")
        assert times == sorted(set(float(row["time"]) for row in rows)), f"{name}: time"
        assert len(binout.values(branch["metadata"]["title"])) == 80, f"{name}: title"
    print(f"{compared} numbers in {' '.join(binout.root)}")


if __name__ == "__main__":
    main()
