# SPDX-License-Identifier: BSD-3-Clause
"""The runs of a study, each in a folder and a process of its own. A run counts as done when case.json lies in its folder,
which is written whole, last."""
from __future__ import annotations

import ctypes
import hashlib
import json
import os
import pathlib
import signal
import subprocess
import sys
from typing import Mapping, Optional, Sequence

from . import _crumple
from ._crumple import Error

#: Exit codes that the same run would have again: normal end, a deck that cannot be run, numerical error.
FINAL_CODES = (0, 1, 3)


def write_whole(path: pathlib.Path, text: str) -> None:
    """Replaces a text file as a whole: at any moment, also after a kill or a power cut, it holds the old text or the new one."""
    beside = path.with_name(f".{path.name}.{os.getpid()}.part")
    with open(beside, "w", encoding="utf-8") as stream:
        stream.write(text)
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(beside, path)


class Case:
    """One run: a deck with parameters. Equal ones have the same key, and so the same folder."""

    def __init__(self, folder: pathlib.Path, deck: str, deck_hash: str, parameters: Mapping[str, str],
                 options: Sequence[str]) -> None:
        text = json.dumps([deck_hash, sorted((name.upper(), value) for name, value in parameters.items()), list(options)])
        self.key = hashlib.sha256(text.encode()).hexdigest()[:16]
        self.folder = folder / "cases" / self.key
        self.deck = deck
        self.parameters = dict(parameters)
        self.options = list(options)

    @property
    def results(self) -> pathlib.Path:
        return self.folder / "out"

    def outcome(self) -> Optional[dict]:
        """What case.json says; None if the run has not been done."""
        try:
            return json.loads((self.folder / "case.json").read_text(encoding="utf-8"))
        except FileNotFoundError:
            return None

    def start(self, threads: int) -> subprocess.Popen:
        """Begins the run, which ends with this process, however that ends."""
        self.folder.mkdir(parents=True, exist_ok=True)
        command = [sys.executable, "-m", "crumple", "run", self.deck, "-o", str(self.results), "-t", str(threads), "-q"]
        for name, value in self.parameters.items():
            command += ["-P", f"{name}={value}"]
        command += self.options
        package = os.path.dirname(os.path.dirname(os.path.abspath(_crumple.__file__)))
        environment = dict(os.environ)
        environment["PYTHONPATH"] = os.pathsep.join(filter(None, [package, environment.get("PYTHONPATH")]))
        parent = os.getpid()
        with open(self.folder / "console.txt", "wb") as console:
            return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=console, stderr=subprocess.STDOUT,
                                    env=environment, preexec_fn=lambda: _end_with(parent))

    def finish(self, code: int) -> dict:
        """Notes how the run ended. Raises Error for an end that is no result: killed, disk full."""
        console = (self.folder / "console.txt").read_text(encoding="utf-8", errors="replace")
        if code not in FINAL_CODES:
            raise Error(f"The run in {self.folder} ended with code {code}:\n{console[-2000:]}")
        outcome = {"key": self.key, "deck": self.deck, "parameters": self.parameters, "options": self.options,
                   "exit_code": code, "termination": "refused", "reason": console[-2000:].strip(), "state_hash": ""}
        record = self.results / "run.json"
        if record.exists() and code != 1:
            run = json.loads(record.read_text(encoding="utf-8", errors="replace"))
            outcome.update({name: run[name] for name in ("termination", "reason", "state_hash", "wall_seconds")})
        write_whole(self.folder / "case.json", json.dumps(outcome, indent=1) + "\n")
        return outcome


def _end_with(parent: int) -> None:
    """In the child: has the system kill it when the parent ends (Linux; elsewhere it runs on)."""
    parent_death_signal = 1  # PR_SET_PDEATHSIG of prctl(2)
    try:
        ctypes.CDLL(None).prctl(parent_death_signal, signal.SIGKILL)
    except (AttributeError, OSError):
        return
    if os.getppid() != parent:
        os._exit(1)
