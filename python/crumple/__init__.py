# SPDX-License-Identifier: BSD-3-Clause
"""crumple for Python: decks, runs, results and studies of many runs. See docs/python.md.

    import crumple
    deck = crumple.Deck("tube.k", {"thick": 1.4})
    with crumple.Simulation(deck, output="out") as simulation:
        simulation.run()
    print(crumple.Result("out").history("rwforc"))
"""
from ._crumple import DeckError, Error, NumericalError, OutputError
from ._crumple import version as _version
from .deck import Deck, Diagnostic
from .injury import hic, hic_of_result
from .responses import absorbed, intrusion, mean, peak
from .result import Frame, History, Result
from .samples import factorial, latin_hypercube
from .signals import cfc_filter
from .simulation import Simulation
from .sweep import SweepTable, sweep

for _error in (Error, DeckError, NumericalError, OutputError):
    _error.__module__ = "crumple"

__version__ = _version.split()[-1]
__all__ = [
    "Deck", "DeckError", "Diagnostic", "Error", "Frame", "History", "NumericalError", "OutputError", "Result",
    "Simulation", "SweepTable", "absorbed", "cfc_filter", "factorial", "hic", "hic_of_result", "intrusion",
    "latin_hypercube", "mean", "peak", "sweep",
]
