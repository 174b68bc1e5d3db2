# SPDX-License-Identifier: BSD-3-Clause
# The extension module: python/binding/crumple_module.cpp. What it has is for the package alone.
from typing import Any, Optional, Sequence

import numpy

version: str

class Error(RuntimeError): ...
class NumericalError(Error): ...
class OutputError(Error): ...
class DeckError(Error): ...

class DeckReading:
    can_be_built: bool
    console: str
    faults: list[str]
    diagnostics: list[dict[str, Any]]
    parameters: dict[str, tuple[str, str]]
    files: list[str]
    hash: str
    units: str
    title: bytes
    end_time: float
    node_ids: numpy.ndarray
    positions: numpy.ndarray
    parts: list[dict[str, Any]]
    def elements(self, kind: str) -> dict[str, numpy.ndarray]: ...
    def fault_at_start(self) -> str: ...

def read_deck(path: str, options: dict[str, Any]) -> DeckReading: ...

class Run:
    ending: Optional[tuple[str, str, int]]
    closed: bool
    warnings: list[str]
    time: float
    cycle: int
    next_step: float
    energies: numpy.ndarray
    energy_history: numpy.ndarray
    state_hash: str
    node_ids: numpy.ndarray
    deck_order: numpy.ndarray
    positions: numpy.ndarray
    reference: numpy.ndarray
    velocities: numpy.ndarray
    angular_velocities: numpy.ndarray
    accelerations: numpy.ndarray
    contact_forces: numpy.ndarray
    masses: numpy.ndarray
    def __init__(self, deck: DeckReading, options: dict[str, Any]) -> None: ...
    def advance(self, until: float, steps: int) -> int: ...
    def interrupt(self, reason: str) -> None: ...
    def close(self) -> None: ...

def run_program(arguments: Sequence[str]) -> tuple[int, bytes, bytes]: ...
def channel_filter(values: numpy.ndarray, cfc: int, interval: float) -> numpy.ndarray: ...
