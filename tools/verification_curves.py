# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the verification manual: the curves that tests note with test::drawn (tests/support/drawn.hpp), as SVG."""

import math
import re
from html import escape

WIDTH, HEIGHT = 560, 320
LEFT, RIGHT, TOP, BOTTOM = 76, 18, 44, 52
MOST_DOTS = 40  # longer curves are drawn as lines


def curves_of(results):
    """Every picture noted in a result: {file, title, across, up, lines}, lines being (kind, name, points)."""
    for suite in results["testsuites"]:
        for test in suite["testsuite"]:
            for name, value in test.items():
                if not re.fullmatch(r"curves_\d+", name):
                    continue
                title, across, up, *lines = (part.strip() for part in value.split(" | "))
                yield {"file": re.sub(r".*?(tests/)", r"\1", test["file"]), "title": title, "across": across,
                       "up": up, "lines": [line_of(line) for line in lines]}


def line_of(text):
    kind, name, numbers = (part.strip() for part in text.split(" :"))
    values = [float(number) for number in numbers.split()]
    return kind, name, list(zip(values[0::2], values[1::2]))


def file_name(curve):
    """verified_bar_onto_a_wall_the_front_half_way.svg"""
    return "verified_" + re.sub(r"[^a-z0-9]+", "_", curve["title"].lower()).strip("_") + ".svg"


def ticks(low, high):
    """Four to eight round numbers from low to high."""
    step = 10 ** math.floor(math.log10((high - low) / 4))
    for factor in (1, 2, 5, 10):
        if (high - low) / (step * factor) <= 8:
            step *= factor
            break
    return [step * i for i in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


def bounds(values):
    low, high = min(values), max(values)
    low, high = min(low, 0.0) if low < 0.3 * high else low, max(high, 0.0) if high < 0.3 * low else high
    return (low, high) if high > low else (low - 1, high + 1)


class Frame:
    """Places of numbers in the picture."""

    def __init__(self, curve):
        points = [point for _, _, line in curve["lines"] for point in line]
        self.x = bounds([x for x, _ in points])
        self.y = bounds([y for _, y in points])

    def across(self, x):
        return LEFT + (WIDTH - LEFT - RIGHT) * (x - self.x[0]) / (self.x[1] - self.x[0])

    def up(self, y):
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * (y - self.y[0]) / (self.y[1] - self.y[0])


def axes(curve, frame):
    for x in ticks(*frame.x):
        at = frame.across(x)
        yield f'<path class="g" d="M{at:.1f} {TOP}V{HEIGHT - BOTTOM}"/>'
        yield f'<text x="{at:.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{x:.6g}</text>'
    for y in ticks(*frame.y):
        at = frame.up(y)
        yield f'<path class="g" d="M{LEFT} {at:.1f}H{WIDTH - RIGHT}"/>'
        yield f'<text x="{LEFT - 6}" y="{at + 4:.1f}" text-anchor="end">{y:.6g}</text>'
    yield f'<text x="{(LEFT + WIDTH - RIGHT) / 2:.0f}" y="{HEIGHT - 14}" text-anchor="middle">{escape(curve["across"])}</text>'
    middle = (TOP + HEIGHT - BOTTOM) / 2
    yield (f'<text transform="translate(16 {middle:.0f}) rotate(-90)" text-anchor="middle">{escape(curve["up"])}</text>')


def drawing(curve, frame):
    legend = LEFT
    for kind, name, line in curve["lines"]:
        places = [(frame.across(x), frame.up(y)) for x, y in line]
        if kind == "found" and len(places) <= MOST_DOTS:
            yield from (f'<circle class="d" cx="{x:.1f}" cy="{y:.1f}" r="3"/>' for x, y in places)
        else:
            yield f'<polyline class="{kind[0]}" points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in places) + '"/>'
        if not name:
            continue
        yield f'<path class="{kind[0]}" d="M{legend} {TOP - 14}h22"/><text x="{legend + 28}" y="{TOP - 10}">{escape(name)}</text>'
        legend += 50 + 7 * len(name)


def picture(curve):
    """The SVG text of one picture."""
    frame = Frame(curve)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" role="img">',
           "<!-- SPDX-License-Identifier: BSD-3-Clause -->", f"<title>{escape(curve['title'])}</title>",
           "<style>text{font:12px sans-serif;fill:#1c2024}.g{stroke:#e3e7ec}.a{fill:none;stroke:#9aa3ad;stroke-width:4}"
           ".f{fill:none;stroke:#1f4e79;stroke-width:1.5}.d{fill:#1f4e79}.t{font-weight:bold}</style>",
           f'<rect width="{WIDTH}" height="{HEIGHT}" rx="8" fill="#ffffff"/>',
           f'<text class="t" x="{LEFT}" y="16">{escape(curve["title"])}</text>']
    out += [*axes(curve, frame), *drawing(curve, frame), "</svg>"]
    return "\n".join(out) + "\n"
