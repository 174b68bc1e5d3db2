#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a run's d3plot files with VTK's LS-DYNA reader and compares them with the run's frames for ParaView. Says how
much it compared.

  read_d3plot_with_vtk.py DIR NAME    the folder of the results, the name of its .pvd

The title of each part must end with its number in brackets, since VTK tells the titles only.
"""

import struct
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkIOLSDyna import vtkLSDynaReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

SINGLE = 2e-6  # two roundings to single precision, relative


def rows(data, name):
    array = data.GetArray(name)
    assert array is not None, f"no array {name}; there are {[data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]}"
    return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]


def close(a, b, size):
    return all(abs(x - y) <= SINGLE * size for x, y in zip(a, b))


def von_mises(s):
    return (((s[0] - s[1]) ** 2 + (s[1] - s[2]) ** 2 + (s[2] - s[0]) ** 2) / 2
            + 3 * (s[3] ** 2 + s[4] ** 2 + s[5] ** 2)) ** 0.5


def frame_of(path):
    """Nodes and elements of a frame by their numbers."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    node_id = [int(row[0]) for row in rows(grid.GetPointData(), "node_id")]
    velocity = rows(grid.GetPointData(), "velocity")
    nodes = {number: (grid.GetPoint(i), velocity[i]) for i, number in enumerate(node_id)}
    names = ("part", "element_id", "von_mises", "von_mises_mid", "plastic_strain", "thickness", "axial_force", "alive")
    columns = {name: [row[0] for row in rows(grid.GetCellData(), name)] for name in names
               if grid.GetCellData().HasArray(name)}
    cells = {}
    for i in range(grid.GetNumberOfCells()):
        cell = {name: column[i] for name, column in columns.items()}
        cell["points"] = {grid.GetPoint(grid.GetCell(i).GetPointId(k)) for k in range(grid.GetCell(i).GetNumberOfPoints())}
        cells[int(cell["part"]), int(cell["element_id"])] = cell
    return nodes, cells


def open_database(file):
    reader = vtkLSDynaReader()
    reader.SetDatabaseDirectory(str(file.parent))
    reader.SetFileName(str(file))
    reader.SetDeformedMesh(1)
    # Both together keep the deleted elements, marked.
    reader.SetRemoveDeletedCells(1)
    reader.SetDeletedCellsAsGhostArray(1)
    reader.UpdateInformation()
    for kind in ("Point", "Solid", "Shell", "Beam"):
        for i in range(getattr(reader, f"GetNumberOf{kind}Arrays")()):
            name = getattr(reader, f"Get{kind}ArrayName")(i)
            getattr(reader, f"Set{kind}ArrayStatus")(name, 1)
    return reader


def node_numbers(points, nodes):
    """VTK 9.1 hands out two numbers of 32 bits as one of 64, and something else for the second half."""
    numbers = [int(row[0]) for row in rows(points, "UserID")]
    if set(numbers) <= set(nodes):
        return numbers
    halves = struct.unpack(f"={2 * len(numbers)}i", struct.pack(f"={len(numbers)}q", *numbers))
    return list(halves[:len(numbers)])


def check_nodes(block, nodes):
    size = max(abs(x) for position, _ in nodes.values() for x in position)
    speed = max(abs(x) for _, velocity in nodes.values() for x in velocity)
    points = block.GetPointData()
    velocities = rows(points, "Velocity")
    for i, number in enumerate(node_numbers(points, nodes)):
        position, velocity = nodes[number]
        assert close(block.GetPoint(i), position, size), (number, block.GetPoint(i), position)
        assert close(velocities[i], velocity, speed), (number, velocities[i], velocity)
    assert any(any(row) for row in rows(points, "Acceleration"))


def check_cells(block, part, cells, largest):
    data = block.GetCellData()
    numbers = [int(row[0]) for row in rows(data, "UserIds")]
    ghosts = rows(data, "vtkGhostType")
    for i, number in enumerate(numbers):
        cell = cells[part, number]
        assert (ghosts[i][0] != 0) == (cell["alive"] == 0), (part, number, ghosts[i], cell)
        shape = block.GetCell(i)
        points = {block.GetPoint(shape.GetPointId(k)) for k in range(shape.GetNumberOfPoints())}
        assert len(points) == len(cell["points"]), (part, number, points, cell)
        if data.HasArray("Thickness"):
            assert close(rows(data, "Thickness")[i], (cell["thickness"],), cell["thickness"])
        if data.HasArray("Stress"):
            middle = von_mises(rows(data, "Stress")[i])
            assert abs(middle - cell["von_mises_mid"]) <= SINGLE * largest, (part, number, middle, cell)
            strain = rows(data, "EffPlastStrn")[i][0]
            assert strain <= cell["plastic_strain"] * (1 + SINGLE), (part, number, strain, cell)
        if data.HasArray("AxialForce"):
            assert close(rows(data, "AxialForce")[i], (cell["axial_force"],), abs(cell["axial_force"]))
    return len(numbers)


def main():
    folder, name = Path(sys.argv[1]), sys.argv[2]
    frames = [(float(entry.get("timestep")), folder / entry.get("file"))
              for entry in xml.parse(folder / f"{name}.pvd").iter("DataSet") if entry.get("part") == "0"]
    reader = open_database(folder / "d3plot")
    assert reader.GetNumberOfTimeSteps() == len(frames), (reader.GetNumberOfTimeSteps(), len(frames))
    largest = 0
    for step, (time, path) in enumerate(frames):
        assert close((reader.GetTimeValue(step),), (time,), time), (step, time)
        reader.SetTimeStep(step)
        reader.Update()
        output = reader.GetOutput()
        nodes, cells = frame_of(path)
        largest = max([largest] + [cell["von_mises"] for cell in cells.values()])
        found = 0
        for b in range(output.GetNumberOfBlocks()):
            block = output.GetBlock(b)
            if block is None or block.GetNumberOfCells() == 0:
                continue
            title = output.GetMetaData(b).Get(vtkCompositeDataSet.NAME())
            if step > 0:
                check_nodes(block, nodes)
            found += check_cells(block, int(title.strip().rstrip(")").split("(")[-1]), cells, largest)
        assert found == len(cells), (found, len(cells))
    deleted = sum(cell["alive"] == 0 for cell in cells.values())
    print(f"{len(frames)} states, {len(cells)} elements, {deleted} deleted")


main()
