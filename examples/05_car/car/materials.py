# SPDX-License-Identifier: BSD-3-Clause
"""Materials. Units: kg, mm, ms, GPa.

Yield stresses over plastic strain are typical of the grades named (cold rolled mild steel, HSLA 340, dual phase 590,
press hardened 1500); Cowper-Symonds constants of mild steel are those of W. Abramowicz & N. Jones, Int. J. Impact Engng 2
(1984) 263-281 (6844 1/s, 3.91), those of the others are chosen so that the increase at 100 1/s is 10 to 15 percent."""

STEEL = 7.85e-6, 210.0, 0.3
ALUMINIUM = 2.7e-6, 70.0, 0.33
# Title: keyword, density, E, nu, yield stresses over plastic strains, C [1/ms], P, failure strain, thinning at failure
STRAINS = (0.0, 0.02, 0.05, 0.10, 0.20, 0.40, 1.0)
SHEETS = {
    "mild": ("024", *STEEL, (0.180, 0.225, 0.265, 0.310, 0.360, 0.400, 0.430), 6.844, 3.91, 0.0, 0.0),
    "high strength": ("024", *STEEL, (0.360, 0.405, 0.440, 0.480, 0.520, 0.550, 0.580), 3000.0, 5.0, 0.0, 0.0),
    "rail": ("123", *STEEL, (0.360, 0.405, 0.440, 0.480, 0.520, 0.550, 0.580), 3000.0, 5.0, 0.0, 0.65),
    "ultra high strength": ("024", *STEEL, (1.000, 1.120, 1.190, 1.240, 1.280, 1.300, 1.320), 0.0, 0.0, 0.0, 0.0),
    "aluminium": ("024", *ALUMINIUM, (0.080, 0.110, 0.130, 0.150, 0.165, 0.175, 0.180), 0.0, 0.0, 0.0, 0.0),
    "plastic": ("024", 1.0e-6, 1.5, 0.4, (0.020, 0.024, 0.027, 0.030, 0.033, 0.036, 0.040), 0.0, 0.0, 0.0, 0.0),
    "glass": ("123", 2.5e-6, 70.0, 0.22, (0.060, 0.062, 0.064, 0.066, 0.068, 0.070, 0.072), 0.0, 0.0, 0.03, 0.0),
}
RIGID = {"engine": (1.2e-6, 70.0), "steel rigid": (7.85e-6, 210.0), "rim": (2.7e-6, 70.0)}
SPOT_STRENGTH = 6.0, 10.0  # tension and shear of a weld at failure [kN] for a pitch of 45 mm
WELD_STEEL = 0.6  # yield stress
SPRINGS = {"front spring": ("MAT_SPRING_ELASTIC", 0.024), "front damper": ("MAT_DAMPER_VISCOUS", 1.4),
           "rear spring": ("MAT_SPRING_ELASTIC", 0.026), "rear damper": ("MAT_DAMPER_VISCOUS", 1.2)}
DIAMETERS = {"weld spot": 6.0, "weld seam": 8.0, "weld bolt": 10.0}
# Seat foam of 50 kg/m3: nominal stress over compression [GPa].
SEAT_FOAM = [(0.0, 0.0), (0.05, 4.0e-6), (0.40, 7.0e-6), (0.60, 1.2e-5), (0.75, 3.0e-5), (0.85, 9.0e-5), (0.92, 4.0e-4)]
NAMES = [*SHEETS, *RIGID, "tyre", "rod", "seat foam", *SPRINGS, *DIAMETERS, "barrier core", "barrier bumper"]
DENSITY = {name: row[1] for name, row in SHEETS.items()} | {name: row[0] for name, row in RIGID.items()} | {
    "tyre": 1.1e-6, "rod": 7.85e-6, "seat foam": 5.0e-8, "barrier core": 8.3e-8, "barrier bumper": 1.6e-7,
    **{name: 7.85e-6 for name in DIAMETERS}, **{name: 0.0 for name in SPRINGS}}
# Crush strengths of the offset deformable barrier (96/79/EC): core 0.342 MPa, bumper 1.711 MPa.
BARRIER = {"barrier core": 3.42e-4, "barrier bumper": 1.711e-3}


def number(name):
    return NAMES.index(name) + 1


def row(*values):
    return "".join(f"{value:>10}" if isinstance(value, (int, str)) else f"{value:10.4g}" for value in values)


def curve(lcid, points):
    return ["*DEFINE_CURVE", row(lcid)] + [f"{x:20.8g}{y:20.8g}" for x, y in points]


def sheet_cards(name):
    keyword, density, modulus, poisson, stresses, c, p, fail, thinning = SHEETS[name]
    mid = number(name)
    title = {"024": "*MAT_PIECEWISE_LINEAR_PLASTICITY_TITLE", "123": "*MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY_TITLE"}
    second = row(c, p, mid, 0, 0 if c == 0 else 1, *((thinning, 0, 0) if keyword == "123" else ()))
    return [title[keyword], name, row(mid, density, modulus, poisson, stresses[0], 0, fail or 0.0), second,
            *curve(mid, zip(STRAINS, stresses))]


def other_cards(pitch):
    scale = pitch / 45.0
    lines = []
    for name, (density, modulus) in RIGID.items():
        lines += ["*MAT_RIGID_TITLE", name, row(number(name), density, modulus, 0.3), row(0.0, 0, 0)]
    lines += ["*MAT_ELASTIC_TITLE", "tyre", row(number("tyre"), DENSITY["tyre"], 0.45, 0.40)]
    lines += ["*MAT_PLASTIC_KINEMATIC_TITLE", "rod", row(number("rod"), DENSITY["rod"], 210.0, 0.3, 0.5, 1.0, 1.0), row(0, 0, 0)]
    mid = number("seat foam")
    lines += ["*MAT_LOW_DENSITY_FOAM_TITLE", "seat foam", row(mid, DENSITY["seat foam"], 1.0e-4, mid, 1.0e-5, 0.3, 0.0, 0.1),
              row(5.0, 0.0), *curve(mid, SEAT_FOAM)]
    for name, (keyword, value) in SPRINGS.items():
        lines += [f"*{keyword}_TITLE", name, row(number(name), value)]
    for name in DIAMETERS:
        strength = [s * scale for s in SPOT_STRENGTH]
        failure = row(0.0, strength[0], strength[1], strength[1]) if name == "weld spot" else row(0.0)
        lines += ["*MAT_SPOTWELD_TITLE", name, row(number(name), DENSITY[name], 210.0, 0.3, WELD_STEEL, 1.0, 0.0), failure]
    return lines


def cards(pitch):
    """All materials of the car and their curves."""
    return [line for name in SHEETS for line in sheet_cards(name)] + other_cards(pitch)


def barrier_cards():
    lines = []
    for name, stress in BARRIER.items():
        mid = number(name)
        points = [(0.0, stress), (0.60, 1.02 * stress), (0.75, 1.6 * stress), (0.85, 6.0 * stress), (0.95, 60.0 * stress)]
        lines += ["*MAT_CRUSHABLE_FOAM_TITLE", name,
                  row(mid, DENSITY[name], 0.1 if "core" in name else 0.3, 0.0, mid, 0.5 * stress, 0.1), *curve(mid, points)]
    return lines
