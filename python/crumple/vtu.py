# SPDX-License-Identifier: BSD-3-Clause
"""Reads the .vtu files that crumple writes: appended raw data, zlib, 64-bit headers (VTK File Formats, "XML File
Formats"). Arrays are unpacked when they are asked for."""
from __future__ import annotations

import os
import xml.etree.ElementTree as xml
import zlib
from typing import Union

import numpy

from ._crumple import Error

_TYPES = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8", "UInt8": "u1"}
_MARK = b'<AppendedData encoding="raw">\n_'


class VtuFile:
    """The arrays of one file by section ("PointData", "CellData", "Points", "Cells"). Raises Error for a file that is
    damaged or of another form."""

    def __init__(self, path: Union[str, os.PathLike]) -> None:
        self.path = os.fspath(path)
        with open(self.path, "rb") as stream:
            data = stream.read()
        mark = data.find(_MARK)
        if mark < 0:
            raise self._error("it has no appended raw data")
        try:
            root = xml.fromstring(data[:mark] + b"</VTKFile>")
        except xml.ParseError as fault:
            raise self._error(f"its head is no XML ({fault})") from None
        if root.get("compressor") != "vtkZLibDataCompressor" or root.get("header_type") != "UInt64":
            raise self._error("it is not packed by zlib with 64-bit headers")
        self._order = "<" if root.get("byte_order") == "LittleEndian" else ">"
        self._data = data
        self._begin = mark + len(_MARK)
        self.time = float(root.findtext(".//FieldData/DataArray") or "nan")
        piece = root.find(".//Piece")
        if piece is None:
            raise self._error("it has no piece")
        self.points = int(piece.get("NumberOfPoints", "0"))
        self.cells = int(piece.get("NumberOfCells", "0"))
        self._heads = {section.tag: {head.get("Name", ""): head for head in section} for section in piece}

    def _error(self, reason: str) -> Error:
        return Error(f"{self.path} is not a frame of crumple: {reason}.")

    def names(self, section: str) -> list[str]:
        return list(self._heads.get(section, {}))

    def array(self, section: str, name: str) -> numpy.ndarray:
        """Shape (tuples,) or (tuples, components). Raises KeyError if there is no such array."""
        head = self._heads.get(section, {}).get(name)
        if head is None:
            raise KeyError(f"{self.path} has no {name!r} in {section}; it has {', '.join(self.names(section)) or 'nothing'}.")
        components = int(head.get("NumberOfComponents", "1"))
        values = numpy.frombuffer(self._unpack(int(head.get("offset", "0"))), self._order + _TYPES[head.get("type", "")])
        return values.reshape(-1, components) if components > 1 else values

    def _unpack(self, offset: int) -> bytes:
        at = self._begin + offset
        try:
            blocks, _, _ = numpy.frombuffer(self._data, self._order + "u8", 3, at)
            sizes = numpy.frombuffer(self._data, self._order + "u8", int(blocks), at + 24)
            at += 24 + 8 * int(blocks)
            pieces = []
            for size in sizes:
                pieces.append(zlib.decompress(self._data[at:at + int(size)]))
                at += int(size)
        except (ValueError, zlib.error) as fault:
            raise self._error(f"its data are damaged ({fault})") from None
        return b"".join(pieces)
