# SPDX-License-Identifier: BSD-3-Clause
"""Parts of the car: what each is made of, in which files they stand, and what of them touches."""

from dataclasses import dataclass


@dataclass
class Part:
    number: int
    name: str
    material: str
    thickness: float  # of shells [mm]; zero is solids
    touches: bool = True  # takes part in the contact of the car with itself
    contact_thickness: float = 0.0  # *PART_CONTACT, zero is none


class Parts:
    def __init__(self):
        self.by_name = {}

    def sheet(self, name, material, thickness, **more):
        """The number of a part of shells; a part that exists stays as it is."""
        if name not in self.by_name:
            self.by_name[name] = Part(len(self.by_name) + 1, name, material, thickness, **more)
        return self.by_name[name].number

    def solid(self, name, material, **more):
        return self.sheet(name, material, 0.0, **more)

    def number(self, name):
        return self.by_name[name].number

    def named(self, start):
        """Numbers of the parts whose name begins so."""
        return [part.number for name, part in self.by_name.items() if name.startswith(start)]

    def of(self, number):
        return next(part for part in self.by_name.values() if part.number == number)

    def __iter__(self):
        return iter(self.by_name.values())
