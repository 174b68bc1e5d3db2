# SPDX-License-Identifier: BSD-3-Clause
"""Decks for the tests of the Python packages."""
import pathlib

PLATE = """*KEYWORD
*TITLE
a plate falls on a wall
*PARAMETER
R speed      -10.0
R thick        1.0
*CONTROL_TERMINATION
      0.05
*PART
plate
         7         1         1
*SECTION_SHELL
         1         2  0.833333         3
&thick
*MAT_PLASTIC_KINEMATIC
         1   7.83E-6     207.0       0.3      0.25       1.0       1.0
*INITIAL_VELOCITY_GENERATION
7,2,0.0,0.0,0.0,&speed

*RIGIDWALL_PLANAR
         0
       0.0       0.0       0.0       0.0       0.0       1.0       0.0
*DATABASE_GLSTAT
    0.0005
*DATABASE_RWFORC
    0.0005
*DATABASE_NODOUT
    0.0005
*DATABASE_HISTORY_NODE
        11        13
*DATABASE_BINARY_D3PLOT
     0.005
*NODE
{nodes}
*ELEMENT_SHELL
{shells}
*END
"""


def plate_text(cells=4, height=0.1):
    """A plate of `cells` x `cells` elements of 5 mm, 0.1 mm above a wall, falls with &speed. Nodes from 11, elements from
    101. Units: kg, mm, ms."""
    nodes, shells = [], []
    for j in range(cells + 1):
        for i in range(cells + 1):
            nodes.append(f"{11 + j * (cells + 1) + i:8d}{5.0 * i:16.6f}{5.0 * j:16.6f}{height + 0.3 * i:16.6f}")
    for j in range(cells):
        for i in range(cells):
            first = 11 + j * (cells + 1) + i
            corners = (first, first + 1, first + cells + 2, first + cells + 1)
            shells.append(f"{101 + j * cells + i:8d}{7:8d}" + "".join(f"{node:8d}" for node in corners))
    return PLATE.replace("{nodes}", "\n".join(nodes)).replace("{shells}", "\n".join(shells))


def write_plate(folder, name="plate.k", cells=4, **replacements):
    """Writes the deck; `replacements` replace text of it. Returns its path."""
    text = plate_text(cells)
    for old, new in replacements.items():
        assert old in text, old
        text = text.replace(old, new)
    path = pathlib.Path(folder) / name
    path.write_text(text)
    return path
