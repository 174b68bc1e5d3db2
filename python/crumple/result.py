# SPDX-License-Identifier: BSD-3-Clause
"""Results: what a run has left in its folder."""
from __future__ import annotations

import csv
import json
import os
import pathlib
import tempfile
import xml.etree.ElementTree as xml
from typing import Any, Iterator, Mapping, Optional, Sequence, Union

import numpy

from . import _crumple
from ._crumple import Error
from .units import Units, kind_of_column
from .vtu import VtuFile


class History(Mapping):
    """A table over time: column name -> array of shape (rows,). `units[column]` is its unit, "" for none."""

    def __init__(self, name: str, columns: Mapping[str, numpy.ndarray], units: Units) -> None:
        self.name = name
        self._columns = dict(columns)
        self.units = {column: units.unit(kind_of_column(name, column)) for column in self._columns}
        self._system = units

    def __getitem__(self, column: str) -> numpy.ndarray:
        if column not in self._columns:
            raise KeyError(f"{self.name}.csv has no column {column!r}; it has {', '.join(self._columns)}.")
        return self._columns[column]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        return len(next(iter(self._columns.values()))) if self._columns else 0

    def select(self, **values: Any) -> "History":
        """The rows in which columns have these values: `history.select(wall=1)`."""
        chosen = numpy.ones(self.rows, bool)
        for column, value in values.items():
            chosen &= self[column] == value
        return History(self.name, {name: array[chosen] for name, array in self._columns.items()}, self._system)

    def to_structured(self) -> numpy.ndarray:
        """A structured array with a field per column; the units are in the metadata of its dtype."""
        dtype = numpy.dtype([(name, array.dtype) for name, array in self._columns.items()],
                            metadata={"units": self.units})
        table = numpy.empty(self.rows, dtype)
        for name, array in self._columns.items():
            table[name] = array
        return table

    def to_pandas(self) -> Any:
        """A DataFrame; the units are in its `attrs["units"]`. Needs pandas."""
        import pandas

        frame = pandas.DataFrame(self._columns)
        frame.attrs["units"] = dict(self.units)
        return frame

    def __repr__(self) -> str:
        columns = ", ".join(f"{name} [{unit}]" if unit else name for name, unit in self.units.items())
        return f"History({self.name}: {self.rows} rows; {columns})"


class Frame:
    """The model at one time, read from its file at the first use. Nodes in the order of the file."""

    def __init__(self, path: pathlib.Path, time: float) -> None:
        self.path = path
        self.time = time  #: [time]
        self._opened: Optional[VtuFile] = None

    @property
    def _file(self) -> VtuFile:
        if self._opened is None:
            self._opened = VtuFile(self.path)
        return self._opened

    @property
    def points(self) -> numpy.ndarray:
        """Positions at this time [length], shape (nodes, 3): Float32, as the file has them."""
        return self._file.array("Points", self._file.names("Points")[0])

    @property
    def node_ids(self) -> numpy.ndarray:
        return self._file.array("PointData", "node_id")

    @property
    def displacements(self) -> numpy.ndarray:
        """From time zero [length], shape (nodes, 3)."""
        return self._file.array("PointData", "displacement")

    @property
    def cells(self) -> list[numpy.ndarray]:
        """For each element the places of its nodes in `points`, from 0."""
        ends = self._file.array("Cells", "offsets")
        return numpy.split(self._file.array("Cells", "connectivity"), ends[:-1]) if len(ends) else []

    @property
    def point_names(self) -> list[str]:
        return self._file.names("PointData")

    @property
    def cell_names(self) -> list[str]:
        return self._file.names("CellData")

    def point_data(self, name: str) -> numpy.ndarray:
        """A field of the nodes, shape (nodes,) or (nodes, components). KeyError if there is none of that name."""
        return self._file.array("PointData", name)

    def cell_data(self, name: str) -> numpy.ndarray:
        """A field of the elements, shape (elements,) or (elements, components)."""
        return self._file.array("CellData", name)

    def __repr__(self) -> str:
        return f"Frame(time {self.time:g}: {self.path.name})"


class Result:
    """A folder of results. Reads what is asked for, when it is asked for; a run may still be writing it.

    `units`: as "kg, mm, ms", where the guess of run.json is absent or wrong. Raises Error if the folder is none.
    """

    def __init__(self, folder: Union[str, os.PathLike], units: Optional[str] = None) -> None:
        self.folder = pathlib.Path(folder)
        if not self.folder.is_dir():
            raise Error(f"{self.folder} is no folder of results: it does not exist or is a file.")
        self._units = units
        self._record: Optional[dict] = None

    @property
    def record(self) -> dict:
        """run.json. Raises Error while the run has not ended, as it is written last."""
        if self._record is None:
            path = self.folder / "run.json"
            try:
                self._record = json.loads(path.read_text(encoding="utf-8", errors="replace"))
            except FileNotFoundError:
                raise Error(f"{path} does not exist: the run has not ended, or this is no folder of results.") from None
            except ValueError as fault:
                raise Error(f"{path} is damaged: {fault}.") from None
        return self._record

    @property
    def has_ended(self) -> bool:
        return (self.folder / "run.json").exists()

    @property
    def termination(self) -> str:
        """"normal", "error" or "interrupted"."""
        return self.record["termination"]

    @property
    def units(self) -> Units:
        if self._units is not None:
            return Units(self._units)
        return Units(self.record.get("units", "") if self.has_ended else "")

    @property
    def history_names(self) -> list[str]:
        """Of the CSV files that are there."""
        return sorted(path.stem for path in self.folder.glob("*.csv"))

    def history(self, name: str) -> History:
        """A history by its file's name: "glstat", "rwforc" ... Raises Error if it is not there."""
        path = self.folder / f"{name.removesuffix('.csv')}.csv"
        if not path.exists():
            raise Error(f"{path} does not exist; {self.folder} has {', '.join(self.history_names) or 'no histories'}.")
        with open(path, newline="", encoding="utf-8") as stream:
            lines = list(csv.reader(stream))
        header, rows = lines[0], lines[1:]
        # A run that still writes may have written half of the last row.
        if rows and len(rows[-1]) < len(header):
            rows.pop()
        columns = {column: _array_of([row[k] for row in rows]) for k, column in enumerate(header)}
        return History(path.stem, columns, self.units)

    def table(self, name: str) -> Any:
        """history(name) as a DataFrame where pandas is installed, else as a structured array; both carry units."""
        history = self.history(name)
        try:
            return history.to_pandas()
        except ImportError:
            return history.to_structured()

    @property
    def frames(self) -> list[Frame]:
        """All frames by time; their files are read when they are asked for something."""
        collections = sorted(self.folder.glob("*.pvd"))
        if not collections:
            raise Error(f"{self.folder} has no .pvd file: no frames.")
        found = []
        for item in xml.parse(collections[0]).getroot().iter("DataSet"):
            if item.get("part", "0") == "0":  # the second part are rigid walls
                found.append(Frame(self.folder / item.get("file", ""), float(item.get("timestep", "nan"))))
        return found

    def frame_at(self, time: float) -> Frame:
        """The frame nearest to a time [time]."""
        return min(self.frames, key=lambda frame: abs(frame.time - time))

    def compare(self, other: Union["Result", str, os.PathLike], *, cfc: int = 0, quantities: Sequence[str] = ()) -> dict:
        """Rates the histories of `other` against these, as `crumple compare --json` (docs/compare.md): "curves" has one
        entry per curve. `cfc`: channel frequency class [Hz], 0 filters nothing. Raises Error with the console's text."""
        second = other.folder if isinstance(other, Result) else pathlib.Path(other)
        with tempfile.TemporaryDirectory(prefix="crumple_compare_") as folder:
            target = os.path.join(folder, "comparison.json")
            arguments = ["compare", str(self.folder), str(second), "--json", target, "--quiet"]
            arguments += ["--cfc", str(cfc)] if cfc else []
            for quantity in quantities:
                arguments += ["--quantity", quantity]
            code, out, error = _crumple.run_program(arguments)
            if code != 0 or not os.path.exists(target):
                raise Error((error or out).decode(errors="replace").strip())
            with open(target, encoding="utf-8") as stream:
                return json.load(stream)

    def __repr__(self) -> str:
        return f"Result({str(self.folder)!r})"


def _array_of(texts: list[str]) -> numpy.ndarray:
    """Whole numbers, else numbers, else text."""
    for kind in (numpy.int64, numpy.float64):
        try:
            return numpy.array(texts, dtype="U").astype(kind) if texts else numpy.empty(0)
        except (ValueError, OverflowError):
            continue
    return numpy.array(texts)
