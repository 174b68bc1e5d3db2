# SPDX-License-Identifier: BSD-3-Clause
"""What tools/count_instructions does without running anything: reads callgrind's profile, keeps the figures in a
table, compares them with the stored ones."""

import csv

ROOM = 0.03  # more than this above the stored figure is a failure
LEAST_SHARE = 0.05  # stages that are a smaller part of their case are too small to be judged alone

COLUMNS = ("case", "stage", "compiler", "instructions")


def read_calls(profile):
    """{function: (calls, instructions with all that it calls)} of the functions called, from the text of a profile
    that was written with --compress-strings=no. Functions that call themselves are counted more than once."""
    calls = {}
    callee, count, cost_follows = None, 0, False
    for line in profile.splitlines():
        if cost_follows:
            before = calls.get(callee, (0, 0))
            calls[callee] = (before[0] + count, before[1] + int(line.split()[-1]))
            cost_follows = False
        elif line.startswith("cfn="):
            callee = line[len("cfn="):]
        elif line.startswith("calls="):
            count, cost_follows = int(line[len("calls="):].split()[0]), True
    return calls


def find(calls, beginning):
    """(calls, instructions) of the one function whose name begins so; (0, 0) if it was not called."""
    found = [value for name, value in calls.items() if name.startswith(beginning)]
    if len(found) > 1:
        raise ValueError(f"{len(found)} functions begin with {beginning}; one was expected")
    return found[0] if found else (0, 0)


def read_figures(path):
    """{(case, stage): (compiler, instructions)} of a table; empty if there is none."""
    if not path.exists():
        return {}
    with path.open(newline="") as stream:
        return {(row["case"], row["stage"]): (row["compiler"], float(row["instructions"]))
                for row in csv.DictReader(stream)}


def write_figures(path, figures):
    with path.open("w", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(COLUMNS)
        for (case, stage), (compiler, instructions) in figures.items():
            writer.writerow((case, stage, compiler, f"{instructions:.2f}"))


def judged(stages, whole):
    """The stages, whole included, that are large enough to be stored and compared."""
    return {name: value for name, value in stages.items() if value >= LEAST_SHARE * stages[whole]}


def compare(stored, counted):
    """(failures, notes): sentences about figures of {(case, stage): instructions} that left the room."""
    failures, notes = [], []
    for (case, stage), now in counted.items():
        if (case, stage) not in stored:
            failures.append(f"{case}, {stage}: no figure is stored")
            continue
        before = stored[case, stage][1]
        change = now / before - 1
        sentence = f"{case}, {stage}: {now:.1f} instructions instead of {before:.1f}, {100 * change:+.1f} %"
        if change > ROOM:
            failures.append(sentence)
        elif change < -ROOM:
            notes.append(sentence)
    return failures, notes
