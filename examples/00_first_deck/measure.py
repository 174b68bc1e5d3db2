#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Peak force, shortening and mean force of a result of tube.k: measure.py DIR"""

import csv
import sys

walls = list(csv.DictReader(open(sys.argv[1] + "/rwforc.csv")))
motion = list(csv.DictReader(open(sys.argv[1] + "/rwmotion.csv")))
peak = max(walls, key=lambda row: float(row["normal"]))
stroke = max(-float(row["uz"]) for row in motion) - 1.0  # the wall starts 1 mm above the tube
lost = float(motion[0]["kinetic"]) - float(motion[-1]["kinetic"])
print(f"peak force {float(peak['normal']):.1f} kN at {float(peak['time']):.2f} ms, "
      f"shortening {stroke:.1f} mm, mean force {lost / stroke:.1f} kN")
