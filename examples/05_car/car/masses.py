# SPDX-License-Identifier: BSD-3-Clause
"""Mass, centre of gravity and moments of inertia: of what is meshed, and the trim that is added to reach the real car's.

What a car has besides its body (trim, wiring, glass frames, fluids, drive) is spread over parts by *ELEMENT_MASS_PART. How
much each gets is the smallest change of a guess that meets mass, centre and the three moments of inertia."""

from . import dimensions as d
from .materials import DENSITY, DIAMETERS
from .mesh import cross, dot, minus

# NCAC (2011): see README.md. The measured car.
TARGET = {"mass": 1078.0, "x": d.FRONT_AXLE + 1004.0, "y": -4.4, "z": 569.0, "roll": 395.0e6, "pitch": 1566.0e6, "yaw": 1739.0e6}
# Part: guess of what is added [kg].
TRIM = {
    "engine": 118.0, "gearbox": 48.0, "radiator": 12.0, "front fascia": 5.0, "bumper beam": 2.0, "bonnet inner": 2.0,
    "dash": 22.0, "cowl": 8.0, "instrument panel": 22.0, "floor": 40.0, "roof": 12.0, "knuckle right": 16.0,
    "knuckle left": 16.0, "subframe": 14.0, "front door right inner": 12.0, "front door left inner": 12.0,
    "rear door right inner": 9.0, "rear door left inner": 9.0, "rear floor": 40.0, "fuel tank": 34.0, "shelf": 5.0,
    "rear seat back": 14.0, "boot lid": 5.0, "rear panel": 8.0, "rear fascia": 6.0, "quarter right": 6.0, "quarter left": 6.0,
    "twist beam": 10.0, "seat right frame": 10.0, "seat left frame": 10.0, "sill right": 3.0, "sill left": 3.0,
    "roof frame right": 4.0, "roof frame left": 4.0, "trailing arm right": 6.0, "trailing arm left": 6.0,
    "wheel front right rim": 4.0, "wheel front left rim": 4.0, "wheel rear right rim": 4.0, "wheel rear left rim": 4.0,
    "windscreen": 4.0, "rear window": 2.0,
}


def shell_area(points):
    return 0.5 * dot(*[cross(minus(points[2], points[0]), minus(points[3], points[1]))] * 2) ** 0.5


def solid_volume(p):
    """Of a hexahedron of nearly plane faces: six tetrahedra about its diagonal."""
    volume = 0.0
    for a, b in ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1)):
        volume += dot(minus(p[a], p[0]), cross(minus(p[b], p[0]), minus(p[6], p[0]))) / 6
    return abs(volume)


class Moments:
    """Sums of m, m x, m y, m z, m x^2, m y^2, m z^2 of lumped masses."""

    def __init__(self):
        self.sums = [0.0] * 7

    def add(self, mass, point):
        values = (1.0, *point, *(c * c for c in point))
        self.sums = [s + mass * v for s, v in zip(self.sums, values)]

    def added(self, other, factor=1.0):
        self.sums = [s + factor * o for s, o in zip(self.sums, other.sums)]

    def about_centre(self):
        """mass, x, y, z of the centre, roll, pitch and yaw inertia about it."""
        m, mx, my, mz, xx, yy, zz = self.sums
        x, y, z = mx / m, my / m, mz / m
        xx, yy, zz = xx - m * x * x, yy - m * y * y, zz - m * z * z
        return {"mass": m, "x": x, "y": y, "z": z, "roll": yy + zz, "pitch": xx + zz, "yaw": xx + yy}


def part_moments(mesh, parts, place):
    """Moments of each part, masses lumped at the nodes as the program does."""
    found = {part.number: Moments() for part in parts}
    table = {part.number: part for part in parts}
    for kind, corners in ((mesh.shells, 4), (mesh.solids, 8)):
        for element in kind:
            part = table[element[0]]
            points = [place(mesh.point(n)) for n in element[1:]]
            size = shell_area(points) * part.thickness if corners == 4 else solid_volume(points)
            share = size * DENSITY[part.material] / corners
            for point in points:
                found[part.number].add(share, point)
    return found


def beam_moments(car):
    total = Moments()
    for part, a, b in car.welds:
        diameter = DIAMETERS[car.parts.of(part).material]
        points = car.mesh.point(a), car.mesh.point(b)
        length = sum((p - q) ** 2 for p, q in zip(*points)) ** 0.5
        for point in points:
            total.add(0.785398 * diameter ** 2 * length * DENSITY["weld spot"] / 2, point)
    return total


def equations(moments):
    """The seven rows that are linear in masses: mass, first moments, sums of second moments, about the aim's centre."""
    m, mx, my, mz, xx, yy, zz = moments.sums
    x, z = TARGET["x"], TARGET["z"]
    xx, zz = xx - 2 * x * mx + m * x * x, zz - 2 * z * mz + m * z * z
    return [m, mx - m * x, my - m * TARGET["y"], mz - m * z, yy + zz, xx + zz, xx + yy]


def solve_linear(matrix, right):
    """Gauss with pivoting, in place."""
    size = len(right)
    rows = [list(line) + [r] for line, r in zip(matrix, right)]
    for i in range(size):
        pivot = max(range(i, size), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(size):
            if k != i:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    return [rows[i][size] / rows[i][i] for i in range(size)]


def solve_trim(fixed, movable):
    """Added masses by name, left and right alike: the least sum of (mass - guess)^2 / guess that meets the aim exactly, none
    below a fifth of its guess. `movable`: name -> Moments of the part; what is added lies as the part's own mass does."""
    goal = Moments()
    mass, x, y, z = (TARGET[name] for name in ("mass", "x", "y", "z"))
    goal.sums = [mass, mass * x, mass * y, mass * z, 0.0, 0.0, 0.0]
    aim = equations(goal)[:4] + [TARGET["roll"], TARGET["pitch"], TARGET["yaw"]]
    columns, guesses = {}, {}
    for name, moments in movable.items():
        key = name.replace("left", "*").replace("right", "*")
        column = [v / moments.sums[0] * TRIM[name] for v in equations(moments)]
        columns[key] = [a + b for a, b in zip(columns.get(key, [0.0] * 7), column)]
        guesses[key] = guesses.get(key, 0.0) + TRIM[name]
    rest = [a - f for a, f in zip(aim, equations(fixed))]
    scale = [max(abs(c[i]) for c in columns.values()) for i in range(7)]
    factors = {key: 1.0 for key in columns}
    held = set()
    while True:  # factors on the guesses: 1 + column . multipliers, those at their bound held there
        free = [key for key in columns if key not in held]
        right = [(rest[i] - sum(columns[k][i] * (0.2 if k in held else 1.0) for k in columns)) / scale[i] for i in range(7)]
        matrix = [[sum(guesses[k] * columns[k][i] * columns[k][j] / (scale[i] * scale[j] * guesses[k] ** 2) for k in free)
                   for j in range(7)] for i in range(7)]
        multipliers = solve_linear(matrix, right)
        for key in free:
            factors[key] = 1.0 + sum(m * columns[key][i] / scale[i] for i, m in enumerate(multipliers)) / guesses[key]
        low = {key for key in free if factors[key] < 0.2}
        if not low:
            break
        held |= low
        factors.update(dict.fromkeys(low, 0.2))
    return {name: TRIM[name] * factors[name.replace("left", "*").replace("right", "*")] for name in movable}
