# SPDX-License-Identifier: BSD-3-Clause
"""Results of the runs for docs/paper.md: what is kept of run.json, and the figures that follow from it."""

import json
import statistics


def kept(record):
    """What the page needs of a run.json."""
    contact = record["contact"][0]
    return {
        "shells": record["elements"]["shells"], "nodes": record["nodes"], "cycles": record["cycles"],
        "loop": record["loop_seconds"], "timings": record["timings"], "find": contact["timings"]["find"],
        "searches": contact["searches"], "candidates": contact["candidates"], "search": contact["search"],
        "isa": record["isa"], "precision": record["precision"], "state_hash": record["state_hash"],
        "energy_error": record["energy"]["error"],
        "failed_checks": [check["name"] for check in record["checks"] if not check["pass"]],
        "seconds": record["seconds"], "cpu_seconds": record["cpu_seconds"],
    }


def median_of(results):
    """One result of several runs: the median of each time, counts of the first."""
    merged = dict(results[0])
    for name in ("loop", "find", "seconds", "cpu_seconds"):
        merged[name] = statistics.median(result[name] for result in results)
    merged["timings"] = {stage: statistics.median(result["timings"][stage] for result in results)
                         for stage in results[0]["timings"]}
    return merged


class Result:
    """The figures of one result. Times of the loop are without output, which these short runs have much of."""

    def __init__(self, values):
        self.values = values
        self.shells = values["shells"]
        self.nodes = values["nodes"]
        self.cycles = values["cycles"]
        self.searches = values["searches"]
        self.search = values["search"]
        times = values["timings"]
        self.computing = values["loop"] - times["output"]
        self.work = self.shells * self.cycles
        self.global_seconds = times["contact_search"]
        self.local_seconds = times["contact_local"]
        self.contact_seconds = self.global_seconds + self.local_seconds + times["contact_forces"]

    def per_element_cycle(self, seconds):
        """[ns]"""
        return 1e9 * seconds / self.work

    def per_segment(self, seconds):
        """By segment and search [ns]. Every shell is a segment."""
        return 1e9 * seconds / (self.shells * self.searches)

    def share(self, seconds):
        """Of the time of the loop without output [%]."""
        return 100 * seconds / self.computing

    @property
    def global_cost(self):
        return self.per_element_cycle(self.global_seconds)

    @property
    def both_cost(self):
        """Global and local search."""
        return self.per_element_cycle(self.global_seconds + self.local_seconds)


class Results:
    """All of them by the key of their job, in a file."""

    def __init__(self, values=None):
        self.values = values or {}

    @staticmethod
    def read(path):
        return Results({tuple(key): value for key, value in json.loads(path.read_text())["runs"]})

    def write(self, path, about):
        path.write_text(json.dumps({"about": about, "runs": list(self.values.items())}, indent=1) + "\n")

    def get(self, *key):
        return Result(self.values[key])

    def of(self, *start):
        """(rest of the key, result) of all jobs whose key begins so, in the order of the rest."""
        found = [(key[len(start):], Result(value)) for key, value in self.values.items() if key[:len(start)] == start]
        return sorted(found, key=lambda entry: entry[0])

    def busy(self):
        """Wall time over processor time of all runs: above 1 others used the machine, too."""
        return (sum(value["seconds"] for value in self.values.values())
                / sum(value["cpu_seconds"] for value in self.values.values()))
