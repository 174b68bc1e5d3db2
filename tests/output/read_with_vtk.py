#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the frame that paraview_series_test writes with VTK's own reader; fails if anything differs."""

import sys

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(f"{sys.argv[1]}/vtu/run_000000.vtu")
reader.Update()
grid = reader.GetOutput()


def column(data, name):
    array = data.GetArray(name)
    return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]


assert grid.GetNumberOfPoints() == 6 and grid.GetNumberOfCells() == 3
assert [grid.GetCellType(i) for i in range(3)] == [9, 9, 5]
assert grid.GetPoint(4) == (1.25, 1.5, -1.0)
assert grid.GetCell(2).GetPointIds().GetId(2) == 4
assert column(grid.GetPointData(), "node_id") == [(60,), (50,), (40,), (30,), (20,), (10,)]
assert column(grid.GetPointData(), "displacement")[4] == (0.25, 0.5, -1.0)
assert column(grid.GetCellData(), "element_id") == [(99,), (11,), (5,)]
assert column(grid.GetCellData(), "thickness") == [(0.5,)] * 3
assert grid.GetFieldData().GetArray("TimeValue").GetValue(0) == 0.125
