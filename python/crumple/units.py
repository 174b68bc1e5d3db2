# SPDX-License-Identifier: BSD-3-Clause
"""Units of results. A deck has none; crumple guesses them from densities and moduli ("kg, mm, ms"), and so may users say
them. What the guess does not tell is given in symbols, as "M L/T^2"."""
from __future__ import annotations

from typing import Optional

#: In SI: mass [kg], length [m] and time [s] of the names that the guess uses (crumple/deck/build/units.cpp).
_MASS = {"t": 1000.0, "kg": 1.0, "g": 1e-3, "lbf s^2/in": 175.126835, "slug": 14.593903, "kgf s^2/mm": 9806.65}
_LENGTH = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254, "ft": 0.3048}
_TIME = {"s": 1.0, "ms": 1e-3, "us": 1e-6}

#: Exponents of mass, length and time by kind of quantity.
_DIMENSIONS = {
    "time": (0, 0, 1), "length": (0, 1, 0), "mass": (1, 0, 0), "velocity": (0, 1, -1), "acceleration": (0, 1, -2),
    "force": (1, 1, -2), "moment": (1, 2, -2), "energy": (1, 2, -2), "stress": (1, -1, -2), "volume": (0, 3, 0),
    "area": (0, 2, 0), "mass flow": (1, 0, -1), "rotation rate": (0, 0, -1), "number": (0, 0, 0), "id": (0, 0, 0),
}
#: Names for sizes in SI.
_NAMES = {
    "force": {1.0: "N", 1e3: "kN", 1e6: "MN", 1e-3: "mN"},
    "moment": {1.0: "N m", 1e3: "kN m", 1e-3: "N mm"},
    "energy": {1.0: "J", 1e3: "kJ", 1e-3: "mJ", 1e-6: "uJ", 1e6: "MJ"},
    "stress": {1.0: "Pa", 1e3: "kPa", 1e6: "MPa", 1e9: "GPa", 1e11: "Mbar"},
}

#: What the columns of the histories are, by file; "*" holds for all of them.
_COLUMNS = {
    "*": {
        "time": "time", "dt": "time", "kinetic": "energy", "internal": "energy", "hourglass": "energy",
        "contact": "energy", "friction": "energy", "rigidwall": "energy", "damping": "energy",
        "external_work": "energy", "eroded": "energy", "total": "energy", "energy": "energy", "residual": "energy",
        "ratio": "number", "added_mass": "mass", "mass": "mass", "normal": "force", "fx": "force", "fy": "force",
        "fz": "force", "resultant": "force", "force": "force", "axial": "force", "shear": "force", "shear_s": "force",
        "shear_t": "force", "mx": "moment", "my": "moment", "mz": "moment", "moment": "moment", "moment_s": "moment",
        "moment_t": "moment", "torsion": "moment", "ux": "length", "uy": "length", "uz": "length", "x": "length",
        "y": "length", "z": "length", "vx": "velocity", "vy": "velocity", "vz": "velocity", "ax": "acceleration",
        "ay": "acceleration", "az": "acceleration", "wx": "rotation rate", "wy": "rotation rate",
        "wz": "rotation rate", "xx": "stress", "yy": "stress", "zz": "stress", "xy": "stress", "yz": "stress",
        "zx": "stress", "rr": "stress", "rs": "stress", "rt": "stress", "plastic_strain": "number", "s": "length",
        "t": "length", "opening": "length", "broken": "number", "tied": "number", "element": "id", "node": "id",
        "part": "id", "wall": "id", "interface": "id", "body": "id", "weld": "id", "joint": "id", "section": "id",
        "airbag": "id", "point": "id", "plane": "id",
    },
    "abstat": {"volume": "volume", "pressure": "stress", "inflow": "mass flow", "outflow": "mass flow", "area": "area"},
    "deforc": {"displacement": "length"},
    "jntforc": {"damping": "energy"},
}


class Units:
    """A system of units: mass, length, time. `name` as run.json has it; empty if it is not known."""

    def __init__(self, name: str = "") -> None:
        self.name = name
        self.parts = tuple(part.strip() for part in name.split(",")) if name else ()
        if self.parts and not (len(self.parts) == 3 and self.parts[0] in _MASS and self.parts[1] in _LENGTH
                               and self.parts[2] in _TIME):
            raise ValueError(f"{name!r} is no system of units: write it as 'kg, mm, ms' (mass, length, time).")

    @property
    def known(self) -> bool:
        return bool(self.parts)

    def si(self, kind: str) -> float:
        """One unit of a kind of quantity ("force", "acceleration" ...) in SI. Raises ValueError if units are unknown."""
        if not self.known:
            raise ValueError("The units of the result are not known: give units, as 'kg, mm, ms'.")
        sizes = (_MASS[self.parts[0]], _LENGTH[self.parts[1]], _TIME[self.parts[2]])
        value = 1.0
        for size, exponent in zip(sizes, _DIMENSIONS[kind]):
            value *= size**exponent
        return value

    def unit(self, kind: Optional[str]) -> str:
        """The unit of a kind of quantity; "" for ids and numbers without one, "?" for what is not known."""
        if kind is None:
            return "?"
        exponents = _DIMENSIONS[kind]
        if not any(exponents):
            return ""
        if self.known and kind in _NAMES:
            size = self.si(kind)
            for named, name in _NAMES[kind].items():
                if abs(size / named - 1) < 1e-9:
                    return name
        return _product(self.parts if self.known else ("M", "L", "T"), exponents)


def _product(symbols: tuple, exponents: tuple) -> str:
    def power(symbol: str, exponent: int) -> str:
        return symbol if exponent == 1 else f"{symbol}^{exponent}"

    above = [power(s, e) for s, e in zip(symbols, exponents) if e > 0]
    below = [power(s, -e) for s, e in zip(symbols, exponents) if e < 0]
    text = " ".join(above) or "1"
    return text + ("/" + "/".join(below) if below else "")


def kind_of_column(history: str, column: str) -> Optional[str]:
    """What a column of a history is ("force", "id" ...); None if that is not known."""
    return _COLUMNS.get(history, {}).get(column, _COLUMNS["*"].get(column))
