#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the car and prints the figures of README.md as a Markdown table: pulse, crush, wall force, energies, checks, cost.

    ./measure.py ../../build/release/crumple                      20 000 elements onto the wall
    ./measure.py ../../build/release/crumple --size 100k -t 2 --keep out_100k
    ./measure.py --result out_100k                                of a run that is there

With --keep the folder keeps the decks and the result, and pulse.csv: deceleration, velocity and displacement of the feet of
both B pillars and the force on the wall, deceleration and force filtered by CFC 60 (SAE J211).
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
from runs import rows_of, run  # noqa: E402

GRAVITY = 9.80665e-3  # [mm/ms2]
STEP = 0.05  # of even curves [ms]


def filtered(values, step, frequency_class=60.0):
    """SAE J211-1, appendix C: Butterworth of second order, forwards and backwards. `step` [ms]."""
    w = math.tan(2 * math.pi * frequency_class * 2.0775 * step * 1e-3 / 2)
    divisor = 1 + math.sqrt(2) * w + w * w
    a0, b1, b2 = w * w / divisor, -2 * (w * w - 1) / divisor, (-1 + math.sqrt(2) * w - w * w) / divisor
    for _ in range(2):
        out = [values[0], values[0]]
        for i in range(2, len(values)):
            out.append(a0 * (values[i] + 2 * values[i - 1] + values[i - 2]) + b1 * out[i - 1] + b2 * out[i - 2])
        values = out[::-1]
    return values


def evenly(times, values, step):
    """Linear interpolation at multiples of the step."""
    result, i = [], 0
    for k in range(int(times[-1] / step) + 1):
        t = k * step
        while i < len(times) - 2 and times[i + 1] < t:
            i += 1
        share = (t - times[i]) / (times[i + 1] - times[i])
        result.append(values[i] + share * (values[i + 1] - values[i]))
    return result


def pulse(folder):
    """Times, deceleration [g], velocity and displacement [mm/ms, mm], means of the feet of both B pillars."""
    by_node = {}
    for row in rows_of(folder / "nodout.csv"):
        by_node.setdefault(row["node"], []).append(row)
    pillars = sorted((rows for rows in by_node.values() if abs(rows[0]["x"] - 2225) < 40 and abs(rows[0]["y"]) > 600),
                     key=lambda rows: rows[0]["y"])
    curves = []
    for rows in pillars:
        times = [row["time"] for row in rows]
        velocity = evenly(times, [row["vx"] for row in rows], STEP)
        way = evenly(times, [row["ux"] for row in rows], STEP)
        acceleration = [(b - a) / STEP / GRAVITY for a, b in zip(velocity, velocity[1:])]
        curves.append((filtered(acceleration + acceleration[-1:], STEP), velocity, way))
    mean = [[sum(values) / len(curves) for values in zip(*(curve[k] for curve in curves))] for k in range(3)]
    return [k * STEP for k in range(len(mean[0]))], *mean


def wall_force(folder, count):
    """Filtered force on the rigid wall at the times of pulse(); zero where there is none."""
    file = folder / "rwforc.csv"
    rows = rows_of(file) if file.exists() else []
    if len(rows) < 3:
        return [0.0] * count
    values = filtered(evenly([row["time"] for row in rows], [row["normal"] for row in rows], STEP), STEP)
    return (values + values[-1:] * count)[:count]


def figures(folder):
    record = json.loads((folder / "run.json").read_text())
    times, acceleration, velocity, way = pulse(folder)
    stop = next((i for i, v in enumerate(velocity) if v >= 0), len(velocity) - 1)
    energy = record["energy"]
    force = wall_force(folder, len(times))
    with open(folder / "pulse.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time", "deceleration [g]", "velocity [m/s]", "displacement [mm]", "wall force [kN]"])
        writer.writerows([f"{t:.2f}", f"{a:.4f}", f"{-v:.4f}", f"{-u:.3f}", f"{f:.3f}"] for t, a, v, u, f in
                         zip(times, acceleration, velocity, way, force))
    absorbed = energy["internal"] + energy["hourglass"] + energy["friction"] + energy["eroded"]
    failed = [check["name"] for check in record["checks"] if not check["pass"]]
    return [("elements (shells / solids / beams)", " / ".join(str(record["elements"].get(k, 0)) for k in ("shells", "solids", "beams"))),
            ("cycles", record["cycles"]),
            ("B pillars stop after [ms]", f"{times[stop]:.1f}" if velocity[stop] >= 0 else f"later than {times[stop]:.1f}"),
            ("dynamic crush: their largest displacement [mm]", f"{-min(way):.0f}"),
            ("their mean deceleration until then [g]", f"{(velocity[stop] - velocity[0]) / times[stop] / GRAVITY:.1f}"),
            ("their largest deceleration, CFC 60 [g]", f"{max(acceleration):.1f} at {times[acceleration.index(max(acceleration))]:.1f} ms"),
            ("their velocity at the end, rebound is positive [m/s]", f"{velocity[-1]:.2f}"),
            ("largest force on the wall, CFC 60 [kN]", f"{max(force):.0f} at {times[force.index(max(force))]:.1f} ms"),
            ("absorbed [kJ]", f"{absorbed / 1000:.1f}"),
            ("hourglass / internal [%]", f"{100 * energy['hourglass'] / energy['internal']:.1f}"),
            ("energy error [%]", f"{100 * energy['error']:.2g}"),
            ("checks that fail", ", ".join(failed) or "none"),
            ("ns per element and cycle, whole loop", f"{record['ns_per_element_cycle']:.0f}"),
            ("loop [s]", f"{record['loop_seconds']:.0f}")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?", help="the crumple program")
    parser.add_argument("--result", type=pathlib.Path, help="a result that is there")
    parser.add_argument("--size", default="20k")
    parser.add_argument("--case", default="wall")
    parser.add_argument("--end", default="100")
    parser.add_argument("-t", "--threads", default="1")
    parser.add_argument("--keep", type=pathlib.Path, help="folder that keeps decks and result")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.result
        if folder is None:
            base = options.keep or pathlib.Path(temporary)
            subprocess.run([sys.executable, HERE / "make_car.py", "--size", options.size, "--case", options.case, "--end",
                            options.end, "-o", base], check=True)
            folder = base / "out"
            run(options.program, base / "car.k", folder, ["--precision", "mixed", "-t", options.threads])
        print("| | |\n|---|---|")
        for name, value in figures(folder):
            print(f"| {name} | {value} |")


if __name__ == "__main__":
    main()
