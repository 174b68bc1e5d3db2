# SPDX-License-Identifier: BSD-3-Clause
"""Studies: a deck with many sets of parameters, and a table of what came of it."""
from __future__ import annotations

import csv
import fcntl
import io
import math
import os
import pathlib
import time
from typing import Any, Callable, Iterator, Mapping, Optional, Union

import numpy

from . import _crumple
from ._crumple import Error
from .cases import Case, write_whole
from .deck import parameter_text
from .result import Result
from .samples import rows_of

_POLL_SECONDS = 0.02


class SweepTable(Mapping):
    """One row per sample: name -> array of shape (samples,). The columns are the parameters, the responses (NaN where a
    run failed), `termination`, `state_hash` and `case`, the name of the folder below cases/."""

    def __init__(self, columns: dict[str, numpy.ndarray], parameters: list[str], responses: list[str]) -> None:
        self._columns = columns
        self.parameters = parameters
        self.responses = responses

    def __getitem__(self, name: str) -> numpy.ndarray:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def ok(self) -> numpy.ndarray:
        """Which runs ended normally, shape (samples,)."""
        return self["termination"] == "normal"

    def inputs(self) -> numpy.ndarray:
        """The parameters, shape (samples, parameters)."""
        return numpy.column_stack([self[name].astype(float) for name in self.parameters])

    def to_pandas(self) -> Any:
        import pandas

        return pandas.DataFrame(self._columns)

    def csv_text(self) -> str:
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(self._columns)
        for row in zip(*self._columns.values()):
            writer.writerow([value.item() if isinstance(value, numpy.generic) else value for value in row])
        return text.getvalue()

    def __repr__(self) -> str:
        return f"SweepTable({len(self['case'])} samples; {', '.join(self._columns)})"


def sweep(
    deck: Union[str, os.PathLike],
    samples: object,
    responses: Mapping[str, Callable[[Result], float]],
    *,
    jobs: int = 1,
    folder: Union[str, os.PathLike] = "sweep",
    threads: int = 1,
    options: tuple = (),
    retry_failed: bool = False,
    on_case: Optional[Callable[[int, int, dict], object]] = None,
) -> SweepTable:
    """Runs a deck with each sample of its parameters, `jobs` at a time, and returns a table of the responses, which also
    lies in the folder as table.csv (and table.parquet where pyarrow is installed).

    `samples`: a list of dictionaries (factorial(), latin_hypercube()), a dictionary of columns, or a structured array.
    `responses`: name -> function of a Result; computed from the results each time, so that others may be asked for
    later without a run. `options`: further ones of `crumple run`, as ("--end", "0.01"). `on_case(done, samples,
    outcome)` hears of each run.

    It takes up where it was: a run that is done, by the text of the deck, parameters and options, is never done again,
    in whatever way the study was ended, kill -9 among them; equal samples are one run. A run that failed (numerically,
    or its deck is refused) gives NaN and is done, too, unless `retry_failed`. Raises Error if another process works in
    the folder, if a run was killed or could not write, or if a response fails for a run that ended normally.
    """
    if jobs < 1:
        raise ValueError(f"jobs is at least 1, not {jobs}.")
    rows = rows_of(samples)
    place = pathlib.Path(folder)
    place.mkdir(parents=True, exist_ok=True)
    with _OnlyProcess(place):
        deck_hash = _crumple.read_deck(os.fspath(deck), {"parameters": []}).hash
        cases = [Case(place, os.path.abspath(deck), deck_hash,
                      {name: parameter_text(value) for name, value in row.items()}, options) for row in rows]
        _run_missing(cases, jobs, threads, retry_failed, on_case)
        table = _table_of(cases, rows, responses)
        write_whole(place / "table.csv", table.csv_text())
        _write_parquet(place / "table.parquet", table)
    return table


class _OnlyProcess:
    """Holds a folder for this process; the system lets go of it when the process ends."""

    def __init__(self, folder: pathlib.Path) -> None:
        self._path = folder / ".sweep.lock"

    def __enter__(self) -> None:
        self._file = open(self._path, "w")
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            self._file.close()
            raise Error(f"Another process works in {self._path.parent}.") from None

    def __exit__(self, kind: object, error: object, trace: object) -> None:
        self._file.close()


def _run_missing(cases: list[Case], jobs: int, threads: int, retry_failed: bool,
                 on_case: Optional[Callable[[int, int, dict], object]]) -> None:
    missing: dict[str, Case] = {}
    for case in cases:
        outcome = case.outcome()
        if outcome is None or (retry_failed and outcome["exit_code"] != 0):
            missing.setdefault(case.key, case)
    waiting = list(missing.values())
    done = len({case.key for case in cases}) - len(waiting)
    total = done + len(waiting)
    running: list = []
    faults: list[Error] = []
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                case = waiting.pop(0)
                running.append((case, case.start(threads)))
            for entry in list(running):
                case, process = entry
                code = process.poll()
                if code is None:
                    continue
                running.remove(entry)
                try:
                    outcome = case.finish(code)
                except Error as fault:  # the others go on
                    faults.append(fault)
                    continue
                done += 1
                if on_case is not None:
                    on_case(done, total, outcome)
            if running:
                time.sleep(_POLL_SECONDS)
    finally:
        for _, process in running:
            process.kill()
            process.wait()
    if faults:
        raise faults[0]


def _table_of(cases: list[Case], rows: list[dict], responses: Mapping[str, Callable[[Result], float]]) -> SweepTable:
    known: dict[str, dict[str, float]] = {}
    outcomes = {}
    for case in cases:
        if case.key in known:
            continue
        outcome = case.outcome()
        assert outcome is not None
        outcomes[case.key] = outcome
        known[case.key] = _responses_of(case, outcome, responses)
    parameters = list(rows[0]) if rows else []
    columns = {name: numpy.array([row[name] for row in rows]) for name in parameters}
    for name in responses:
        if name in columns:
            raise ValueError(f"{name!r} is a parameter and a response: give the response another name.")
        columns[name] = numpy.array([known[case.key][name] for case in cases], float)
    for name in ("termination", "state_hash"):
        columns[name] = numpy.array([outcomes[case.key][name] for case in cases])
    columns["case"] = numpy.array([case.key for case in cases])
    return SweepTable(columns, parameters, list(responses))


def _responses_of(case: Case, outcome: dict, responses: Mapping[str, Callable[[Result], float]]) -> dict[str, float]:
    if outcome["termination"] != "normal":
        return {name: math.nan for name in responses}
    result = Result(case.results)
    values = {}
    for name, response in responses.items():
        try:
            values[name] = float(response(result))
        except Exception as fault:
            raise Error(f"The response {name!r} of the run in {case.results} failed: {fault}") from fault
    return values


def _write_parquet(path: pathlib.Path, table: SweepTable) -> None:
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        return
    beside = path.with_name(f".{path.name}.{os.getpid()}.part")
    pyarrow.parquet.write_table(pyarrow.table({name: table[name] for name in table}), beside)
    os.replace(beside, path)
