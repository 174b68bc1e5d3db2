# SPDX-License-Identifier: BSD-3-Clause
"""Dimensions of the car [mm]. x points to the rear from the bumper's foremost point, y to the right, z up from the road.

Outer dimensions are those of a four-door saloon of the 1100 kg class (README.md has the sources); what lies within is
ours, laid out as such cars are."""

from dataclasses import dataclass

WHEELBASE = 2550.0
FRONT_AXLE = 830.0
REAR_AXLE = FRONT_AXLE + WHEELBASE
TRACK = 1470.0
TYRE_RADIUS = 297.0  # 185/60 R15
TYRE_WIDTH = 185.0
RIM_RADIUS = 195.0
ARCH_RADIUS = 352.0

# Half width of the outer skin over z, and its share over x.
SIDE = [(150, 740), (210, 775), (330, 822), (600, 845), (930, 818), (1150, 716), (1400, 596)]
PLAN = [(0, 0.80), (395, 0.925), (830, 1.0), (3000, 1.0), (3700, 0.98), (4300, 0.88)]
# Height of the bonnet's edge over x.
BONNET = [(60, 705), (250, 765), (700, 862), (1120, 930)]
BONNET_REAR = 1118.0
BONNET_CROWN = 28.0

# Front rails: plane of the closing plate, and of the hat: centre over x with its width (here the height) and depth.
RAIL_Y = 490.0
RAIL_DEPTH = 58.0
RAIL_FRONT = 287.0
RAIL_END = 2000.0
RAIL = [(RAIL_FRONT, 485, 110), (880, 485, 110), (1110, 352, 112), (1318, 158, 78), (1480, 178, 76), (RAIL_END, 178, 76)]
REAR_RAIL = [(2008, 178, 76), (2600, 168, 76), (2760, 354, 84), (3095, 354, 84), (3150, 341, 84), (4165, 341, 84)]
FLANGE = 15.0

DASH = 1150.0
FLOOR = 235.0
FLOOR_FRONT = 1335.0
FLOOR_REAR = 2560.0
TUNNEL_HEIGHT = 350.0
TUNNEL_WIDTH = 110.0
FLOOR_EDGE = 687.0
SILL_Y = 693.0
SILL_DEPTH = 75.0
SILL_CENTRE = 275.0
SILL_HEIGHT = 110.0
SILL_ENDS = 1200.0, 2960.0
BELT = 935.0
REAR_FLOOR = 415.0
REAR_WIDTH = 545.0

# The path of A pillar, roof rail and C pillar: x, y of the inner plane, z.
ROOF_FRAME = [(1288, 702, 966), (1890, 577, 1352), (2010, 566, 1376), (2500, 561, 1386), (2980, 563, 1376),
              (3110, 572, 1342), (3515, 667, 935)]
B_PILLAR = 2225.0
HINGE_PILLAR = 1265.0

DASH_TOP = 872.0
SHELF = 900.0
REAR_PANEL = 4180.0
WHEELS = {"front right": (FRONT_AXLE, 1), "front left": (FRONT_AXLE, -1), "rear right": (REAR_AXLE, 1),
          "rear left": (REAR_AXLE, -1)}


@dataclass(frozen=True)
class Mesh:
    """Lengths of elements [mm]."""
    front: float  # crash boxes and rails
    engine_bay: float  # other sheet before the dash
    cabin: float  # sheet of the cabin
    rear: float  # sheet behind the rear seat, outer panels
    pitch: float  # distance of spot welds

    def at(self, x):
        """Length of elements of sheet at x."""
        if x < 900:
            return self.engine_bay
        return self.cabin if x < 2600 else self.rear


SIZES = {"20k": Mesh(25.0, 34.0, 48.0, 62.0, 62.0), "100k": Mesh(10.0, 15.0, 19.5, 26.0, 45.0),
         "400k": Mesh(5.5, 7.5, 10.0, 12.5, 40.0)}


def between(table, x, column=1):
    """Linear interpolation in rows of ascending first values."""
    if x <= table[0][0]:
        return table[0][column]
    for a, b in zip(table, table[1:]):
        if x <= b[0]:
            return a[column] + (b[column] - a[column]) * (x - a[0]) / (b[0] - a[0])
    return table[-1][column]


def side(x, z):
    """Half width of the outer skin."""
    return between(SIDE, z) * between(PLAN, x)


def bonnet(x):
    """Height of the bonnet's edge."""
    return between(BONNET, x)
