#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless a picture shows something: coloured pixels in the part where the model is drawn."""

import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

reader = vtkPNGReader()
reader.SetFileName(sys.argv[1])
reader.Update()
image = reader.GetOutput()
width, height, _ = image.GetDimensions()
assert (width, height) == (400, 300), (width, height)
pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)
# Right of 0.8 lies the colour bar, the lowest tenth holds the time.
model = pixels[height // 10:, :int(0.8 * width)]
drawn = (model.min(axis=2) < 245).mean()
assert drawn > 0.05, f"{100 * drawn:.1f} % of the picture is drawn"
assert (pixels[-5:] == 255).all(), "the ground is not white"
