#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of ../contact.md (SVG, standard library only). Run in this folder."""
import math
from pathlib import Path

STYLE = """<style>
text{font:13px sans-serif;fill:#222} .title{font-weight:bold} .small{font-size:11px;fill:#555}
.shell{stroke:#1f4e79;stroke-width:4;fill:none;stroke-linecap:round}
.normal{stroke:#c0392b;stroke-width:1.6;fill:none} .plane{stroke:#7a7a7a;stroke-dasharray:5 4;fill:none}
.reach{stroke:#2e8b57;stroke-width:1.3;fill:none} .own{fill:#1f4e79;fill-opacity:.10}
.other{fill:#e08e0b;fill-opacity:.14} .node{fill:#222} .force{stroke:#222;stroke-width:2;fill:none}
</style>
<defs><marker id="r" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">
<path d="M0 0L8 4L0 8z" fill="#c0392b"/></marker>
<marker id="k" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="6" markerHeight="6" orient="auto">
<path d="M0 0L8 4L0 8z" fill="#222"/></marker></defs>
"""


class Picture:
    def __init__(self, width, height):
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
                      f'width="{width}" height="{height}">', STYLE,
                      f'<rect width="{width}" height="{height}" fill="white"/>']

    def line(self, points, kind, marker=""):
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        end = f' marker-end="url(#{marker})"' if marker else ""
        self.parts.append(f'<path class="{kind}" d="{path}"{end}/>')

    def area(self, points, kind):
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points) + "Z"
        self.parts.append(f'<path class="{kind}" d="{path}"/>')

    def arc(self, centre, radius, start, end, kind):
        steps = 24
        self.line([(centre[0] + radius * math.cos(start + (end - start) * i / steps),
                    centre[1] - radius * math.sin(start + (end - start) * i / steps))
                   for i in range(steps + 1)], kind)

    def node(self, x, y):
        self.parts.append(f'<circle class="node" cx="{x:.1f}" cy="{y:.1f}" r="4"/>')

    def text(self, x, y, words, kind="", anchor="start"):
        self.parts.append(f'<text class="{kind}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{words}</text>')

    def save(self, name):
        Path(name).write_text("\n".join(self.parts + ["</svg>"]) + "\n", encoding="utf-8")


def ridge(picture, x, y, slope, title):
    """Two segments that fall away from (x, y) by `slope` on both sides (negative: a valley)."""
    length, high = 130, 105
    c, s = math.cos(slope), math.sin(slope)
    left, right, top = (x - length * c, y + length * s), (x + length * c, y + length * s), (x, y - high)
    up_left = (left[0] - high * s * 0.9, left[1] - high * c * 0.9)
    up_right = (right[0] + high * s * 0.9, right[1] - high * c * 0.9)
    picture.area([left, (x, y), top, up_left], "own")
    picture.area([(x, y), right, up_right, top], "other")
    picture.line([(x, y + 40), top], "plane")
    picture.line([left, (x, y), right], "shell")
    for sign in (-1, 1):
        foot = (x + sign * length * c / 2, y + length * s / 2)
        picture.line([foot, (foot[0] + sign * 46 * s, foot[1] - 46 * c)], "normal", "r")
    picture.line([(x, y), (x, y - 52)], "normal", "r")
    picture.text(x + 5, y - 56, "m")
    picture.text(x - 70, y - 74, "A owns", "", "middle")
    picture.text(x + 70, y - 74, "B owns", "", "middle")
    picture.text(x, 232, title, "title", "middle")


def partition():
    picture = Picture(720, 260)
    ridge(picture, 180, 140, 0.35, "convex ridge")
    ridge(picture, 540, 160, -0.35, "concave ridge (valley)")
    picture.text(180, 250, "between the two normals the edge is nearest: no gap", "small", "middle")
    picture.text(540, 250, "where both have a foot, the dividing plane chooses one", "small", "middle")
    picture.save("contact_partition.svg")


def free_edge(picture, x, y):
    h = 42
    picture.line([(x - 130, y), (x, y)], "shell")
    picture.line([(x - 130, y - h), (x, y - h)], "reach")
    picture.line([(x - 130, y + h), (x, y + h)], "reach")
    picture.arc((x, y), h, -math.pi / 2, math.pi / 2, "reach")
    for angle in (1.1, 0.2, -0.8):
        px, py = x + 30 * math.cos(angle), y - 30 * math.sin(angle)
        picture.node(px, py)
        picture.line([(px, py), (px + 30 * math.cos(angle), py - 30 * math.sin(angle))], "force", "k")
    picture.text(x - 60, y + 100, "free edge: round, no sides", "title", "middle")
    picture.text(x - 120, y - h - 6, "contact distance", "small")


def sharp_fold(picture, x, y):
    angle = math.radians(15)
    length = 170
    ends = [(x - length * math.cos(a), y - length * math.sin(a)) for a in (angle, -angle)]
    picture.line([ends[0], (x, y), ends[1]], "shell")
    picture.line([(x - length, y), (x + 60, y)], "plane")
    picture.line([(x, y), (x + 48, y)], "normal", "r")
    picture.text(x + 8, y - 8, "m")
    picture.node(x - 110, y)
    for sign in (-1, 1):
        picture.line([(x - 110, y), (x - 110 + 5, y + sign * 19)], "force", "k")
    picture.text(x - 60, y + 100, "sharp fold: both walls push", "title", "middle")
    picture.text(x - 60, y + 116, "m from the bisector, not from the vanishing sum", "small", "middle")


def junction(picture, x, y):
    picture.line([(x - 110, y), (x + 110, y)], "shell")
    picture.line([(x, y), (x, y + 80)], "shell")
    picture.node(x - 60, y - 22)
    picture.line([(x - 60, y - 22), (x - 60, y - 58)], "force", "k")
    picture.line([(x - 40, y - 30), (x + 60, y - 30)], "plane")
    picture.node(x + 22, y + 22)
    picture.line([(x + 22, y + 22), (x + 22, y + 58)], "force", "k")
    picture.line([(x + 22, y + 22), (x + 58, y + 22)], "force", "k")
    picture.text(x, y + 100, "T-junction: nearest places", "title", "middle")


def special():
    picture = Picture(760, 230)
    free_edge(picture, 160, 90)
    sharp_fold(picture, 440, 90)
    junction(picture, 640, 90)
    picture.save("contact_special_edges.svg")


def law():
    picture = Picture(520, 270)
    x0, y0, unit = 50, 220, 200
    picture.line([(x0, y0), (x0 + 340, y0)], "force", "k")
    picture.line([(x0, y0), (x0, 20)], "force", "k")

    def force(d, limit):
        k, half = 1.0, 0.5
        rate = 9 * k / half
        ramp = (limit - k) / rate
        if d <= half:
            return k * d
        on = min(d - half, ramp)
        return k * d + rate * on * (0.5 * on + (d - half - on))

    for limit, name, words in ((1e9, "normal", "slope grows, 10 k at h"), (3.0, "reach", "slope limited by stability")):
        points = [(x0 + unit * d / 100, y0 - 50 * force(d / 100, limit)) for d in range(0, 131)]
        picture.line([p for p in points if p[1] > 15], name)
        last = [p for p in points if p[1] > 15][-1]
        picture.text(last[0] + 6, last[1] + (12 if limit < 1e8 else 4), words, "small")
    picture.line([(x0, y0), (x0 + unit * 1.3, y0 - 50 * 1.3)], "plane")
    for d, words in ((0.5, "h/2"), (1.0, "h: mid-surface")):
        picture.line([(x0 + unit * d, y0 - 4), (x0 + unit * d, y0 + 4)], "force")
        picture.text(x0 + unit * d, y0 + 20, words, "small", "middle")
    picture.text(x0 + 300, y0 + 34, "penetration", "", "middle")
    picture.text(x0 + 8, 30, "force")
    picture.save("contact_law.svg")


partition()
special()
law()
