# SPDX-License-Identifier: BSD-3-Clause
"""Cards of a keyword deck that every generator of an example writes. Numbers of nodes and elements begin at 1."""


def node_cards(points):
    """*NODE of points (x, y, z) in their order."""
    for number, (x, y, z) in enumerate(points, 1):
        yield f"{number:8d}{x:16.9g}{y:16.9g}{z:16.9g}"


def shell_cards(shells):
    """*ELEMENT_SHELL of (part, node, node, node, node) in their order."""
    for number, shell in enumerate(shells, 1):
        yield f"{number:8d}" + "".join(f"{value:8d}" for value in shell)


def mass_cards(masses):
    """*ELEMENT_MASS of (node, mass) in their order."""
    for number, (node, mass) in enumerate(masses, 1):
        yield f"{number:8d}{node:8d}{mass:16.9g}"


def id_cards(numbers):
    """Eight ids a line, as the sets have them."""
    for at in range(0, len(numbers), 8):
        yield "".join(f"{number:10d}" for number in numbers[at:at + 8])


def search_lines(low, high, cell, expansion):
    """$crumple lines of the paper's search: cells of about this edge, never smaller, over a box, territory expansion c
    [length]."""
    counts = [max(1, int((b - a) / cell + 1e-9)) for a, b in zip(low, high)]
    yield "$crumple method=linked-cell"
    yield "$crumple cells=" + ",".join(map(str, counts))
    yield "$crumple domain=" + ",".join(f"{a:g},{b:g}" for a, b in zip(low, high))
    yield f"$crumple expansion={expansion:g}"
