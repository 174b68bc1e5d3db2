# SPDX-License-Identifier: BSD-3-Clause
"""Runs that Python drives: the same steps, bit by bit, as `crumple run`."""
from __future__ import annotations

import math
import os
import sys
from typing import Callable, Optional, Union

import numpy

from . import _crumple
from ._crumple import Error, NumericalError, OutputError
from .deck import Deck
from .result import Result

_NUMERICAL, _OUTPUT = 3, 4  # exit codes of the program
_UNBOUNDED = 2**62


class Simulation:
    """A model in motion. Made, it stands at time zero, with forces and the first time step known.

    `threads`: results are bitwise the same for any number. `precision`: "double" or "mixed"; None is what the deck
    asks for, else double. `output`: folder of the results, in which it writes all that `crumple run -o` writes; None
    writes nothing. `history_every`: between rows of energy_history [time]; a thousandth of the end time if None.
    `isa`, `d3plot`, `allow_negative_contact_energy`: as the options of `crumple run`.

    Raises DeckError if the deck cannot be run, OutputError if the folder cannot be written or another run has it.
    One thread at a time may use it; other threads of Python go on while it computes. Ctrl-C raises KeyboardInterrupt
    between two steps, and the simulation may go on afterwards. close(), or the end of a `with` block, ends a run with
    `output` before its end time as an interrupted one.
    """

    def __init__(
        self,
        deck: Union[Deck, str, os.PathLike],
        threads: int = 1,
        precision: Optional[str] = None,
        output: Union[str, os.PathLike, None] = None,
        *,
        isa: Optional[str] = None,
        d3plot: bool = False,
        allow_negative_contact_energy: bool = False,
        history_every: Optional[float] = None,
    ) -> None:
        if threads < 1:
            raise ValueError(f"threads is at least 1, not {threads}.")
        if history_every is not None and not history_every > 0:
            raise ValueError(f"history_every is a positive time, not {history_every}.")
        self.deck = deck if isinstance(deck, Deck) else Deck(deck)
        self.output = None if output is None else os.fspath(output)
        reading = self.deck._reading
        if history_every is None:
            history_every = reading.end_time / 1000 if reading.can_be_built else 1.0
        self._run = _crumple.Run(reading, {
            "threads": threads,
            "precision": precision,
            "isa": isa,
            "output": self.output,
            "d3plot": d3plot,
            "allow_negative_contact_energy": allow_negative_contact_energy,
            "history_every": history_every if history_every > 0 else math.inf,
            "command": [str(argument) for argument in sys.argv],
        })

    # The loop

    def run(
        self,
        until: Optional[float] = None,
        on_frame: Optional[Callable[["Simulation"], object]] = None,
        every: Optional[float] = None,
    ) -> "Simulation":
        """Steps to the first time at or behind `until` [time], or to the end of the run. Returns itself.

        `on_frame(simulation)` is called now, at the first step at or behind each multiple of `every` [time; a hundredth
        of the end time if None], and at the end; it ends the run early by returning False. Raises NumericalError or
        OutputError with the text of the console if the run fails; all results up to there are kept.
        """
        target = math.inf if until is None else float(until)
        if on_frame is None:
            self._advance(target, _UNBOUNDED)
            return self
        interval = self.deck.end_time / 100 if every is None else float(every)
        if not interval > 0:
            raise ValueError(f"every is a positive time, not {interval}.")
        goes_on = on_frame(self) is not False
        while goes_on and not self.finished and self.time < target:
            following = interval * (math.floor(self.time / interval * (1 + 1e-12)) + 1)
            self._advance(min(following, target), _UNBOUNDED)
            goes_on = on_frame(self) is not False
        if not goes_on:
            self._stop("on_frame returned False.")
        return self

    def step(self, n: int = 1) -> int:
        """Takes up to n steps; returns how many, which is fewer only at the end of the run. Raises as run()."""
        if n < 0:
            raise ValueError(f"n is not negative, but {n} is.")
        return self._advance(math.inf, n)

    def _advance(self, until: float, steps: int) -> int:
        done = 0
        if self._run.ending is None:
            done = self._run.advance(until, steps)
        self._settle()
        return done

    def _settle(self) -> None:
        """Closes a run that has ended; raises if it has failed."""
        if self._run.ending is None:
            return
        self._run.close()
        _, reason, code = self._run.ending
        if code == _NUMERICAL:
            raise NumericalError(f"crumple: error: {reason}")
        if code == _OUTPUT:
            raise OutputError(f"crumple: error: {reason}")

    def _stop(self, reason: str) -> None:
        if self._run.ending is None:
            self._run.interrupt(reason)
            self._run.close()

    def close(self) -> None:
        """Ends the run here. With `output` it writes the last state and run.json ("interrupted")."""
        self._stop("Closed by Python.")

    def __enter__(self) -> "Simulation":
        return self

    def __exit__(self, kind: object, error: object, trace: object) -> None:
        self.close()

    # How far it is

    @property
    def time(self) -> float:
        """Time n, to which positions, forces and energies belong [time]."""
        return self._run.time

    @property
    def cycle(self) -> int:
        """Steps done."""
        return self._run.cycle

    @property
    def next_step(self) -> float:
        """The step from here to time n + 1 [time]."""
        return self._run.next_step

    @property
    def finished(self) -> bool:
        """True at the end of the run, however it has come."""
        return self._run.ending is not None

    @property
    def termination(self) -> Optional[str]:
        """"normal", "error" or "interrupted", as run.json has it; None before the end."""
        return self._run.ending[0] if self._run.ending else None

    @property
    def reason(self) -> Optional[str]:
        """Why it ended, in a sentence; None before the end."""
        return self._run.ending[1] if self._run.ending else None

    @property
    def warnings(self) -> list[str]:
        """About the results, at the end of a run with `output`: those of run.json."""
        return self._run.warnings

    @property
    def state_hash(self) -> str:
        """Fingerprint of all that changes; equal to that of run.json of `crumple run` at the same cycle."""
        return self._run.state_hash

    # State. Views are read-only, show the present state and keep it alive; copy() them to keep a moment. Their order
    # is the solver's own.

    @property
    def node_ids(self) -> numpy.ndarray:
        """Ids of the nodes in the order of all arrays below, shape (nodes,)."""
        return self._run.node_ids

    @property
    def deck_order(self) -> numpy.ndarray:
        """Places in the arrays below of the nodes of the deck: `simulation.positions[simulation.deck_order]` goes with
        `deck.node_ids`. Shape (nodes,)."""
        return self._run.deck_order

    @property
    def positions(self) -> numpy.ndarray:
        """x at time n [length], shape (nodes, 3); a view."""
        return self._run.positions

    @property
    def reference(self) -> numpy.ndarray:
        """x at time zero [length], shape (nodes, 3); a view."""
        return self._run.reference

    @property
    def displacements(self) -> numpy.ndarray:
        """positions - reference [length], shape (nodes, 3); a copy."""
        return self._run.positions - self._run.reference

    @property
    def velocities(self) -> numpy.ndarray:
        """v at time n + 1/2, half a step ahead [length/time], shape (nodes, 3); a view."""
        return self._run.velocities

    @property
    def angular_velocities(self) -> numpy.ndarray:
        """omega at time n + 1/2, global axes [1/time], shape (nodes, 3); a view."""
        return self._run.angular_velocities

    @property
    def accelerations(self) -> numpy.ndarray:
        """a at time n [length/time^2], shape (nodes, 3); a view. Zero in directions in which a support holds the node."""
        return self._run.accelerations

    @property
    def forces(self) -> numpy.ndarray:
        """Sum of the forces that move each node at time n [force], shape (nodes, 3); a copy: mass times acceleration, as
        the step clears the forces themselves when it has used them."""
        return self._run.masses[:, None] * self._run.accelerations

    @property
    def contact_forces(self) -> numpy.ndarray:
        """Of all contacts on each node at time n [force], shape (nodes, 3); a view. Shape (0, 3) without contacts."""
        return self._run.contact_forces

    @property
    def masses(self) -> numpy.ndarray:
        """Of the nodes [mass], shape (nodes,); a view."""
        return self._run.masses

    @property
    def energies(self) -> dict[str, float]:
        """Of the model at time n [energy]: kinetic, internal, hourglass, contact, friction, rigidwall, damping,
        external_work, eroded, total."""
        row = self._run.energies[0]
        return {name: float(row[name]) for name in row.dtype.names if name != "time"}

    @property
    def energy_history(self) -> numpy.ndarray:
        """The energies so far: a structured array with `time` and the names of energies; a copy."""
        return self._run.energy_history

    @property
    def result(self) -> Result:
        """What lies in the folder `output`. Raises Error without one."""
        if self.output is None:
            raise Error("This simulation writes nothing: give Simulation() an output folder.")
        return Result(self.output)

    def __repr__(self) -> str:
        state = f"ended: {self.termination}" if self.finished else "running"
        return f"Simulation({self.deck.path!r}: cycle {self.cycle}, time {self.time:g}, {state})"
