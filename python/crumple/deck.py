# SPDX-License-Identifier: BSD-3-Clause
"""Decks: reading, what is wrong with them, and the model that they describe."""
from __future__ import annotations

import dataclasses
import numbers
import os
from typing import Mapping, Optional, Union

import numpy

from . import _crumple
from ._crumple import DeckError

ParameterValue = Union[float, int, str]


@dataclasses.dataclass(frozen=True)
class Diagnostic:
    """Something to say about a place in a deck; str() is the line of the console."""

    severity: str  #: "error" (the deck cannot be run), "warning" or "note"
    file: str
    line: int  #: counted from 1; 0 is the file as a whole
    keyword: str  #: with its asterisk; empty if it is about none
    card: int  #: data card of the keyword, counted from 1; 0 is the keyword as a whole
    field: str  #: empty if it is about none
    message: str
    count: int  #: for how many of one kind it stands
    text: str = dataclasses.field(repr=False)

    def __str__(self) -> str:
        return self.text


def parameter_text(value: ParameterValue) -> str:
    """A value as the command line has it (-P NAME=VALUE): numbers with all their digits."""
    if isinstance(value, bool):
        raise TypeError("A parameter is a number, and True and False are none.")
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    return str(value)


class Deck:
    """An LS-DYNA keyword deck as crumple reads it. It never changes; any number of runs may share it.

    `parameters` are values for the &NAMEs of the deck, before those of *PARAMETER, as `-P` gives them. One that the
    deck does not have or does not use raises DeckError with the text of the console. Any other fault is left to
    check(): reading a faulty deck raises nothing, running it does.

    The other arguments are options of `crumple run`: `end_time` [time], `contact="auto"`, `ls_dyna_defaults`,
    `allow_unsupported`, `search`, `local_search`, `perturb` [-] with `seed`.
    """

    def __init__(
        self,
        path: Union[str, os.PathLike],
        parameters: Optional[Mapping[str, ParameterValue]] = None,
        *,
        end_time: Optional[float] = None,
        contact: Optional[str] = None,
        ls_dyna_defaults: bool = False,
        allow_unsupported: bool = False,
        search: Optional[str] = None,
        local_search: Optional[str] = None,
        perturb: float = 0.0,
        seed: int = 1,
    ) -> None:
        if contact not in (None, "auto"):
            raise ValueError(f"contact is None or 'auto', not {contact!r}.")
        self.path = os.fspath(path)
        texts = [(name, parameter_text(value)) for name, value in (parameters or {}).items()]
        self._reading = _crumple.read_deck(self.path, {
            "parameters": texts,
            "end_time": end_time,
            "search": search,
            "local_search": local_search,
            "automatic_contact": contact == "auto",
            "ls_dyna_defaults": ls_dyna_defaults,
            "allow_unsupported": allow_unsupported,
            "perturbation": perturb,
            "seed": seed,
        })
        self._check: Optional[list[Diagnostic]] = None
        wrong = [str(item) for item in self.diagnostics if _is_about_a_given_parameter(item)]
        if wrong:
            raise DeckError("\n".join(wrong))

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """What the reader says, by file and line."""
        return [Diagnostic(**item) for item in self._reading.diagnostics]

    def check(self) -> list[Diagnostic]:
        """What the reader says, and what a start of the run says beyond that, as `crumple check`. Takes as long as a
        start of the run, the first time."""
        if self._check is None:
            found = self.diagnostics
            texts = list(self._reading.faults)
            if self._reading.can_be_built:
                fault = self._reading.fault_at_start()
                texts += [fault] if fault else []
            for text in texts:
                message = text.split(": error: ", 1)[-1]
                found.append(Diagnostic("error", self.path, 0, "", 0, "", message, 1, text))
            self._check = found
        return list(self._check)

    @property
    def ok(self) -> bool:
        """Whether it can be run: reads without errors, and starts."""
        return self._reading.can_be_built and not any(item.severity == "error" for item in self.check())

    @property
    def console(self) -> str:
        """What `crumple run` prints about it on standard error, in lines."""
        return self._reading.console

    @property
    def files(self) -> list[str]:
        """All files read, the deck itself first."""
        return self._reading.files

    @property
    def parameters(self) -> dict[str, tuple[str, str]]:
        """Of the whole deck: name -> (value as text, "deck" or "command line"). Those given to Deck() are the latter."""
        return self._reading.parameters

    @property
    def hash(self) -> str:
        """Of all text and the parameters given; the `deck_hash_with_parameters` of run.json."""
        return self._reading.hash

    @property
    def title(self) -> str:
        return self._reading.title.decode(errors="replace")

    @property
    def units(self) -> str:
        """Guess of the units, such as "kg, mm, ms"; empty if there is none."""
        return self._reading.units

    @property
    def end_time(self) -> float:
        return self._reading.end_time

    @property
    def node_ids(self) -> numpy.ndarray:
        """Ids of the nodes in the order of the deck, shape (nodes,)."""
        return self._reading.node_ids

    @property
    def positions(self) -> numpy.ndarray:
        """Positions of the nodes [length], shape (nodes, 3); read-only, nothing is copied."""
        return self._reading.positions

    def elements(self, kind: str = "shell") -> dict[str, numpy.ndarray]:
        """Elements of a kind ("shell", "solid", "beam", "discrete") in the order of the deck: `id` and `part` (ids),
        shape (elements,); `nodes`, shape (elements, 4, 8 or 2): places in node_ids and positions, from 0. A triangle
        repeats its third node. Raises DeckError if the deck is faulty, ValueError for other kinds."""
        return self._reading.elements(kind)

    @property
    def parts(self) -> list[dict]:
        """For each part: id, title, kind of its elements, rigid, elements (how many)."""
        return self._reading.parts

    def __repr__(self) -> str:
        if not self._reading.can_be_built:
            return f"Deck({self.path!r}: cannot be run)"
        return f"Deck({self.path!r}: {len(self.node_ids)} nodes, {len(self.parts)} parts)"


def _is_about_a_given_parameter(item: Diagnostic) -> bool:
    return (item.severity == "error" and not item.keyword and item.line == 0 and item.message.startswith("parameter ")
            and " of the command line " in item.message)
