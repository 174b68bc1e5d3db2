# SPDX-License-Identifier: BSD-3-Clause
"""The generator of the small car: masses, connections, meshes that do not cut each other."""
import math
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "examples" / "05_car"))
from car import masses  # noqa: E402
from car.assembly import Assembly  # noqa: E402
from car.welds import nearest_in_triangle  # noqa: E402


class Helpers(unittest.TestCase):
    def test_nearest_point_of_a_triangle_is_the_best_of_many(self):
        triangle = (0.0, 0.0, 0.0), (3.0, 0.0, 0.5), (1.0, 2.0, -0.5)
        for point in ((1.0, 0.5, 2.0), (-1.0, -1.0, 0.3), (5.0, 0.0, 0.0), (1.5, 3.0, 1.0), (2.5, 1.5, -1.0), (-1.0, 1.0, 0.0)):
            best = math.inf
            for i in range(101):
                for j in range(101 - i):
                    a, b = i / 100, j / 100
                    place = [p + a * (q - p) + b * (r - p) for p, q, r in zip(*triangle)]
                    best = min(best, math.dist(place, point))
            found = math.dist(nearest_in_triangle(point, *triangle), point)
            self.assertLessEqual(found, best + 1e-12)
            self.assertGreater(found, best - 0.03)

    def test_volume_and_area(self):
        corners = [(0, 0, 0), (2, 0, 0), (2, 3, 0), (0, 3, 0), (0, 0, 4), (2, 0, 4), (2, 3, 4), (0, 3, 4)]
        self.assertAlmostEqual(masses.solid_volume(corners), 24.0)
        self.assertAlmostEqual(masses.shell_area(corners[:4]), 6.0)

    def test_linear_equations(self):
        matrix = [[0.0, 2.0, 1.0], [1.0, 1.0, 0.0], [3.0, 0.0, -1.0]]
        x = [1.0, -2.0, 0.5]
        right = [sum(a * b for a, b in zip(row, x)) for row in matrix]
        for a, b in zip(masses.solve_linear(matrix, right), x):
            self.assertAlmostEqual(a, b)


class SmallestCar(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.assembly = Assembly("20k")

    def test_mass_centre_and_inertia_are_those_of_the_measured_car(self):
        # D. Marzougui et al., NCAC 2011-T-001: the measured car.
        measured = {"mass": 1078.0, "roll": 395.0e6, "pitch": 1566.0e6, "yaw": 1739.0e6}
        found = self.assembly.properties
        for name, value in measured.items():
            self.assertLess(abs(found[name] / value - 1), 0.02, name)
        self.assertLess(abs(found["x"] - 830.0 - 1004.0), 0.02 * 1004.0)
        self.assertLess(abs(found["y"]), 10.0)
        self.assertLess(abs(found["z"] - 569.0), 0.02 * 569.0)

    def test_masses_agree_with_a_sum_over_the_elements_of_the_deck(self):
        """Mass of the sheet by the formula of the area from the lengths of the diagonals, not that of the generator."""
        mesh, parts = self.assembly.car.mesh, self.assembly.car.parts
        part = parts.by_name["floor"]
        total = 0.0
        for shell in mesh.shells:
            if shell[0] == part.number:
                a, b, c, d = (mesh.point(n) for n in shell[1:])
                for p, q, r in ((a, b, c), (a, c, d)):  # Heron
                    x, y, z = math.dist(p, q), math.dist(q, r), math.dist(r, p)
                    s = (x + y + z) / 2
                    total += math.sqrt(max(0.0, s * (s - x) * (s - y) * (s - z)))
        self.assertAlmostEqual(total * part.thickness * 7.85e-6, self.assembly.part_masses["floor"], places=6)

    def test_trim_is_shared_alike_by_both_sides_and_nowhere_negative(self):
        trim = self.assembly.trim_by_name
        for name, mass in trim.items():
            self.assertGreater(mass, 0.0, name)
            self.assertAlmostEqual(mass, trim[name.replace("left", "*").replace("right", "left").replace("*", "right")])

    def test_sizes(self):
        shells, solids, beams = self.assembly.elements()
        self.assertTrue(18000 < shells + solids + beams < 30000)

    def test_every_connection_has_welds_and_none_is_loose(self):
        self.assertEqual(self.assembly.welder.unused, [])

    def test_every_part_of_sheet_hangs_on_the_others(self):
        """Parts are connected by welds, shared nodes and rigid bodies: one piece."""
        car = self.assembly.car
        part_of = {}
        for shell in car.mesh.shells:
            for node in shell[1:]:
                part_of.setdefault(car.mesh.point(node), set()).add(shell[0])
        joined = {part.number: part.number for part in car.parts if part.touches and part.thickness}

        def root(number):
            while joined[number] != number:
                number = joined[number]
            return number

        def join(numbers):
            numbers = [n for n in numbers if n in joined]
            for number in numbers[1:]:
                joined[root(number)] = root(numbers[0])

        for numbers in part_of.values():
            join(sorted(numbers))
        for one, other in self.connected():
            join([one, other])
        body = root(car.parts.number("floor"))
        loose = {car.parts.of(n).name for n in joined if root(n) != body}
        # The axle hangs on its arms by joints.
        self.assertEqual(loose, {"twist beam"})

    def connected(self):
        from car.connections import BODY, CHASSIS, HANGING, expanded

        numbers = {part.name: part.number for part in self.assembly.car.parts}
        for name, number in numbers.items():
            if f"{name} plate" in numbers:
                yield number, numbers[f"{name} plate"]
        for one, other, *_ in expanded(BODY + HANGING + CHASSIS):
            if one in numbers and other in numbers:
                yield numbers[one], numbers[other]


if __name__ == "__main__":
    unittest.main()
