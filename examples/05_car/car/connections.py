# SPDX-License-Identifier: BSD-3-Clause
"""Which sheets are joined with which: (one, other, reach [mm], kind, pitch [mm] or None). {s} stands for both sides."""

BODY = [
    ("crash box {s}", "bumper beam", 9, "seam", 30), ("crash box {s}", "rail end plate {s}", 8, "seam", 30),
    ("rail front {s}", "rail end plate {s}", 8, "seam", 30), ("rail front {s} plate", "rail end plate {s}", 8, "seam", 30),
    ("rail {s}", "floor", 23, "spot", 50), ("rail {s} plate", "floor", 9, "spot", None), ("rail {s}", "dash", 20, "spot", None),
    ("apron {s}", "rail front {s} plate", 7, "spot", None), ("apron {s}", "rail {s} plate", 7, "spot", None),
    ("strut tower {s}", "rail {s} plate", 7, "spot", None),
    ("apron {s}", "upper rail {s} plate", 8, "spot", None), ("strut tower {s}", "upper rail {s} plate", 8, "spot", None),
    ("apron {s}", "strut tower {s}", 9, "seam", 45), ("apron {s}", "dash", 15, "seam", 45),
    ("upper rail {s}", "hinge pillar {s}", 27, "seam", 25), ("upper rail {s} plate", "hinge pillar {s}", 27, "seam", 25),
    ("dash", "cowl plate", 9, "spot", None), ("cowl", "hinge pillar {s} plate", 18, "seam", 40),
    ("dash", "hinge pillar {s} plate", 17, "spot", None), ("dash", "floor", 9, "spot", None),
    ("dash", "sill {s} plate", 10, "seam", None), ("floor", "sill {s} plate", 8, "spot", None),
    ("seat cross member {p} {s}", "floor", 6, "spot", None), ("seat cross member {p} {s}", "sill {s} plate", 12, "seam", 40),
    ("torque box {p} {s}", "floor", 6, "spot", None), ("torque box {p} {s}", "sill {s} plate", 10, "seam", 40),
    ("torque box front {s}", "rail {s} plate", 11, "seam", 40), ("torque box rear {s}", "rear rail {s} plate", 11, "seam", 40),
    ("rail {s}", "rear rail {s}", 12, "seam", 25), ("rail {s} plate", "rear rail {s} plate", 12, "seam", 25),
    ("hinge pillar {s}", "sill {s}", 10, "seam", 30), ("hinge pillar {s} plate", "sill {s}", 10, "seam", 30),
    ("B pillar {s}", "sill {s}", 10, "seam", 30), ("B pillar {s} plate", "sill {s}", 10, "seam", 30),
    ("roof frame {s}", "hinge pillar {s}", 40, "seam", 20), ("roof frame {s} plate", "hinge pillar {s} plate", 40, "seam", 20),
    ("B pillar {s}", "roof frame {s}", 14, "seam", 25), ("B pillar {s} plate", "roof frame {s}", 14, "seam", 25),
    ("roof frame {s}", "roof", 16, "spot", None), ("roof front header", "roof", 24, "spot", None),
    ("roof middle bow", "roof", 24, "spot", None), ("roof rear header", "roof", 24, "spot", None),
    ("roof front header", "roof frame {s} plate", 26, "seam", 25), ("roof middle bow", "roof frame {s} plate", 26, "seam", 25),
    ("roof rear header", "roof frame {s} plate", 26, "seam", 25),
    ("roof frame {s}", "shelf", 40, "seam", 25), ("rear floor", "floor", 8, "spot", None),
    ("rear rail {s}", "rear floor", 24, "spot", 50), ("rear rail {s}", "floor", 24, "spot", 50),
    ("inner quarter {s}", "rear floor", 10, "seam", None), ("inner quarter {s}", "shelf", 12, "seam", None),
    ("rear seat back", "rear floor", 9, "seam", None), ("rear seat back", "shelf", 12, "seam", None),
    ("rear seat back", "inner quarter {s}", 10, "seam", None), ("rear cross member {p}", "rear floor", 6, "spot", None),
    ("rear cross member {p}", "rear rail {s}", 8, "seam", 25), ("rear panel", "rear rail {s}", 22, "seam", 30),
    ("rear floor", "rear panel", 13, "seam", None), ("inner quarter {s}", "rear panel", 16, "seam", None),
    ("rear bumper beam", "rear panel", 14, "seam", 100), ("fuel tank", "rear floor", 38, "bolt", 250),
    ("instrument panel beam", "dash", 10, "bolt", 20),
    ("instrument panel", "hinge pillar {s} plate", 45, "bolt", 120), ("instrument panel", "cowl", 48, "bolt", 200),
]
HANGING = [
    ("front fascia", "bumper beam", 85, "bolt", 240), ("front fascia", "fender {s}", 20, "bolt", 90),
    ("radiator", "radiator upper member plate", 16, "bolt", 150), ("radiator", "radiator lower member plate", 18, "bolt", 150),
    ("radiator upper member", "upper rail {s} plate", 18, "seam", 20), ("radiator lower member", "rail front {s}", 10, "seam", 20),
    ("bonnet inner", "bonnet", 3.8, "spot", 75), ("bonnet inner", "radiator upper member", 75, "bolt", 320),
    ("bonnet", "cowl", 85, "bolt", 420), ("fender {s}", "upper rail {s}", 11, "bolt", 120),
    ("fender {s}", "hinge pillar {s}", 125, "bolt", 240),
    ("{p} door {s} inner", "{p} door {s} outer", 3.8, "spot", 75), ("{p} door {s} beam", "{p} door {s} inner", 8, "seam", 120),
    ("front door {s} inner", "hinge pillar {s}", 118, "bolt", 230), ("front door {s} inner", "B pillar {s}", 105, "bolt", 230),
    ("rear door {s} inner", "B pillar {s}", 105, "bolt", 230), ("rear door {s} outer", "quarter {s}", 55, "bolt", 230),
    ("{p} side glass {s}", "{p} door {s} inner", 32, "seam", 60), ("{p} side glass {s}", "roof frame {s}", 46, "seam", 110),
    ("windscreen", "roof frame {s}", 16, "seam", 60), ("windscreen", "roof", 60, "seam", 90),
    ("windscreen", "cowl", 45, "seam", 90), ("rear window", "roof frame {s}", 18, "seam", 60),
    ("rear window", "roof", 60, "seam", 90), ("rear window", "shelf", 36, "seam", 90),
    ("quarter {s}", "shelf", 90, "seam", 140), ("quarter {s}", "roof frame {s}", 60, "seam", 60),
    ("quarter {s}", "rear panel", 105, "bolt", 140), ("quarter {s}", "inner quarter {s}", 300, "bolt", 320),
    ("rear fascia", "rear bumper beam", 90, "bolt", 240), ("rear fascia", "quarter {s}", 75, "bolt", 150),
    ("boot lid", "shelf", 85, "bolt", 320), ("boot lid", "rear panel", 65, "bolt", 320),
]
CHASSIS = [
    ("engine mount {s}", "rail front {s}", 10, "bolt", 25), ("engine mount {s}", "rail {s}", 10, "bolt", 25),
    ("subframe mount {s}", "subframe", 9, "bolt", 25), ("subframe mount {s}", "rail {s}", 24, "bolt", 25),
    ("seat {s} frame", "seat {s} rails", 7, "bolt", 60), ("seat {s} rails", "seat cross member {p} {s}", 8, "bolt", 18),
]


def expanded(rows):
    for one, other, *rest in rows:
        for p in ("front", "rear") if "{p}" in one + other else ("",):
            for s in ("right", "left") if "{s}" in one + other else ("",):
                yield one.format(s=s, p=p), other.format(s=s, p=p), *rest


def weld_all(welder):
    """Every hat with its closing plate, then all of the lists."""
    for name in list(welder.places):
        if f"{name} plate" in welder.places:
            welder.join(name, f"{name} plate", 5.0)
    for row in expanded(BODY + HANGING + CHASSIS):
        welder.join(*row)
