#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of a result as numpy arrays with meshio: the largest plastic strain and displacement of each.

    ./frames.py ../../square_tube.out

With pyvista, which draws as well, it is `pyvista.PVDReader("square_tube.pvd")`, then set_active_time_point(i) and
read() for each frame, and mesh[0].warp_by_vector("displacement").plot(scalars="plastic_strain").
"""
import pathlib
import sys
import xml.etree.ElementTree as xml

import meshio
import numpy


def main():
    collection = next(pathlib.Path(sys.argv[1]).glob("*.pvd"))
    print(f"{'time':>12} {'plastic strain':>15} {'displacement':>15}")
    for frame in xml.parse(collection).getroot().iter("DataSet"):
        if frame.get("part", "0") != "0":
            continue  # the second part are rigid walls
        mesh = meshio.read(collection.parent / frame.get("file"))
        strain = max(block.max() for block in mesh.cell_data["plastic_strain"])
        moved = numpy.linalg.norm(mesh.point_data["displacement"], axis=1).max()
        print(f"{float(frame.get('timestep')):12.5g} {strain:15.5g} {moved:15.5g}")


main()
