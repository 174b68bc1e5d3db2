# SPDX-License-Identifier: BSD-3-Clause
"""Draws frames of a ParaView collection with VTK, on a white ground."""

import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import vtkmodules.vtkRenderingFreeType  # noqa: F401  text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  drawing
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPlane
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeneral import vtkReflectionFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkDataSetMapper, vtkLightKit,
                                         vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor,
                                         vtkWindowToImageFilter)

AXES = "xyz"
MOST_PARTS = 30  # that a bar of colours can name
VIEWS = {"iso": (-1.0, -1.6, 0.9)}
# What is at rest is pale, so that shape and mesh can be seen; then blue over green and yellow to dark red.
PALETTE = [(0.00, "#dfe5ec"), (0.10, "#b5cfe6"), (0.22, "#74b3d8"), (0.36, "#5fc0ab"), (0.50, "#a5d36a"),
           (0.64, "#f2df53"), (0.78, "#f5a13a"), (0.90, "#dd4a2b"), (1.00, "#8f1020")]
PART_COLOURS = ["#7fa8d1", "#e3a857", "#8cc08a", "#d98880", "#b39cd0", "#9fb8ad", "#c9b07c", "#88b7c4"]
TITLES = {"plastic_strain": "plastic strain", "von_mises": "von Mises stress", "von_mises_mid": "von Mises stress (mid)",
          "contact_force": "contact force"}


def colour(text):
    return tuple(int(text[i:i + 2], 16) / 255 for i in (1, 3, 5))


def frames_of(collection):
    entries = xml.parse(collection).getroot().iter("DataSet")
    return [(float(entry.get("timestep")), collection.parent / entry.get("file")) for entry in entries
            if entry.get("part", "0") == "0"]


def nearest_frame(frames, time):
    return min(frames, key=lambda frame: abs(frame[0] - time))


def read_grid(file, mirrors):
    """The living elements of a frame, with their mirror images."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    last = vtkThreshold()
    last.SetInputConnection(reader.GetOutputPort())
    last.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "alive")
    last.SetLowerThreshold(0.5)
    last.SetUpperThreshold(1.5)
    for axis, place in mirrors:
        reflection = vtkReflectionFilter()
        reflection.SetInputConnection(last.GetOutputPort())
        # The enumeration counts planes at the box's faces first, then those at a given place.
        reflection.SetPlane(6 + axis)
        reflection.SetCenter(place)
        last = reflection
    last.Update()
    return last.GetOutput()


def numbers_of(text):
    """Numbers and ranges: 3,10-20."""
    found = set()
    for item in filter(None, text.split(",")):
        first, _, last = item.partition("-")
        found.update(range(int(first), int(last or first) + 1))
    return found


def without_parts(grid, numbers):
    """The grid without the elements of some parts."""
    array = field_of(grid, "part")[1]
    kept = [number for number in {int(array.GetValue(i)) for i in range(array.GetNumberOfValues())} if number not in numbers]
    alive = grid.GetCellData().GetArray("alive")
    for i in range(array.GetNumberOfValues()):
        alive.SetValue(i, 1 if int(array.GetValue(i)) in kept else 0)
    chosen = vtkThreshold()
    chosen.SetInputData(grid)
    chosen.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "alive")
    chosen.SetLowerThreshold(0.5)
    chosen.SetUpperThreshold(1.5)
    chosen.Update()
    return chosen.GetOutput()


def behind(grid, axis, place, direction):
    """What lies behind a plane across an axis, seen from a direction."""
    plane = vtkPlane()
    origin, normal = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    origin[axis] = place
    normal[axis] = 1.0 if direction[axis] >= 0 else -1.0
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    cut = vtkExtractGeometry()
    cut.SetInputData(grid)
    cut.SetImplicitFunction(plane)
    cut.ExtractInsideOn()
    cut.Update()
    return cut.GetOutput()


def axis_and_place(text):
    name, _, place = text.partition("=")
    if name not in AXES or len(name) != 1:
        sys.exit(f"tools/picture: '{text}' is no plane; write x, y or z, with =PLACE if it is not at zero")
    return AXES.index(name), float(place or 0)


def field_of(grid, name):
    """(on the cells, array) of a field."""
    for on_cells, data in ((True, grid.GetCellData()), (False, grid.GetPointData())):
        if data.HasArray(name):
            return on_cells, data.GetArray(name)
    known = [data.GetArrayName(i) for data in (grid.GetCellData(), grid.GetPointData())
             for i in range(data.GetNumberOfArrays())]
    return sys.exit(f"tools/picture: there is no field {name}; there are {', '.join(known)}")


def value_range(grids, name):
    ranges = []
    for grid in grids:
        array = field_of(grid, name)[1]
        ranges.append(array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0))
    low, high = min(r[0] for r in ranges), max(r[1] for r in ranges)
    return (low, high) if high > low else (low, low + 1)


def colour_table(low, high):
    function = vtkColorTransferFunction()
    for place, text in PALETTE:
        function.AddRGBPoint(place, *colour(text))
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *function.GetColor(i / 255), 1)
    table.SetRange(low, high)
    return table


def part_table(grids):
    """A colour for every part id that occurs."""
    ids = set()
    for grid in grids:
        array = field_of(grid, "part")[1]
        ids.update(int(array.GetValue(i)) for i in range(array.GetNumberOfValues()))
    table = vtkLookupTable()
    table.IndexedLookupOn()
    table.SetNumberOfTableValues(len(ids))
    for number, part in enumerate(sorted(ids)):
        table.SetTableValue(number, *colour(PART_COLOURS[number % len(PART_COLOURS)]), 1)
        table.SetAnnotation(part, str(part))
    return table


def mesh_actor(grid, name, table, edges):
    on_cells, array = field_of(grid, name)
    mapper = vtkDataSetMapper()
    mapper.SetInputData(grid)
    if array.GetNumberOfComponents() > 1:
        table.SetVectorModeToMagnitude()
    if on_cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.InterpolateScalarsBeforeMappingOn()
    mapper.SelectColorArray(name)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.22)
    look.SetDiffuse(0.9)
    look.SetSpecular(0.1)
    if edges:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(0.2, 0.2, 0.22)
        look.SetLineWidth(1.0)
    return actor


def wall_actor(bounds, axis, place):
    """A grey plate, half as large again as the model."""
    middle = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    others = [i for i in range(3) if i != axis]
    reach = 0.75 * max(bounds[2 * i + 1] - bounds[2 * i] for i in others)
    middle[axis] = place
    corners = []
    for first, second in ((-1, -1), (1, -1), (-1, 1)):
        corner = list(middle)
        corner[others[0]] += first * reach
        corner[others[1]] += second * reach
        corners.append(corner)
    plane = vtkPlaneSource()
    plane.SetOrigin(corners[0])
    plane.SetPoint1(corners[1])
    plane.SetPoint2(corners[2])
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.72, 0.72, 0.74)
    actor.GetProperty().SetOpacity(0.45)
    actor.GetProperty().LightingOff()
    return actor


def shaped_walls_actor(frame):
    """The rigid walls that are the second part of a frame; None if it has none."""
    name, _, number = frame.stem.rpartition("_")
    file = frame.with_name(f"{name}_walls_{number}{frame.suffix}")
    if not file.exists():
        return None
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.72, 0.72, 0.74)
    actor.GetProperty().SetOpacity(0.45)
    return actor


def colour_bar(table, height, parts):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetNumberOfLabels(6)
    if parts:
        bar.DrawTickLabelsOff()
        bar.SetAnnotationLeaderPadding(8)
    bar.SetLabelFormat("%-#.3g")
    bar.UnconstrainedFontSizeOn()
    style(bar.GetLabelTextProperty(), 0.021 * height)
    style(bar.GetAnnotationTextProperty(), 0.021 * height)
    bar.SetBarRatio(0.2)
    bar.SetPosition(0.885, 0.2)
    bar.SetWidth(0.1)
    bar.SetHeight(0.6)
    return bar


def style(text, size):
    text.SetColor(0.1, 0.1, 0.1)
    text.SetFontFamilyToArial()
    text.SetFontSize(max(9, int(size)))
    text.BoldOff()
    text.ItalicOff()
    text.ShadowOff()


def label(words, size, place, to_the_left=False):
    actor = vtkTextActor()
    actor.SetInput(words)
    style(actor.GetTextProperty(), size)
    if to_the_left:
        actor.GetTextProperty().SetJustificationToRight()
    actor.SetPosition(*place)
    return actor


def three_numbers(text, instead_of):
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != 3:
        sys.exit(f"tools/picture: '{text}' is no {instead_of} three numbers with commas between them")
    return numbers


def direction_of(view):
    if view in VIEWS:
        return VIEWS[view]
    if view.lstrip("-") in AXES and view.lstrip("-"):
        sign = -1.0 if view.startswith("-") else 1.0
        return tuple(sign if name == view.lstrip("-") else 0.0 for name in AXES)
    direction = three_numbers(view, "direction; write iso, x, -x, ..., or")
    if not any(direction):
        sys.exit("tools/picture: 0,0,0 is no direction")
    return direction


def place_camera(renderer, bounds, arguments):
    direction = direction_of(arguments.view)
    along_z = direction[0] == 0 and direction[1] == 0
    up = arguments.up or ("y" if along_z else "z")
    camera = renderer.GetActiveCamera()
    camera.SetViewAngle(20)
    middle = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    centre = three_numbers(arguments.centre, "place; write") if arguments.centre else middle
    camera.SetFocalPoint(middle)
    camera.SetPosition([m + d for m, d in zip(middle, direction)])
    camera.SetViewUp(*[1.0 if name == up else 0.0 for name in AXES])
    renderer.ResetCamera(bounds)
    camera.Zoom(fit_factor(renderer, bounds) * arguments.zoom)
    camera.SetPosition([p + c - m for p, c, m in zip(camera.GetPosition(), centre, middle)])
    camera.SetFocalPoint(centre)
    # The colour bar takes the right edge: the model moves a little to the left.
    camera.SetWindowCenter(0.06, 0.0)
    renderer.ResetCameraClippingRange(tuple(b + (-1, 1)[i % 2] * 0.5 * renderer_length(bounds)
                                            for i, b in enumerate(bounds)))


def renderer_length(bounds):
    return max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3))


def fit_factor(renderer, bounds):
    """How much closer the camera may come until the box fills the free part of the picture."""
    most = 0.0
    for x in bounds[0:2]:
        for y in bounds[2:4]:
            for z in bounds[4:6]:
                renderer.SetWorldPoint(x, y, z, 1)
                renderer.WorldToView()
                across, upwards, _ = renderer.GetViewPoint()
                most = max(most, abs(across) / 0.80, abs(upwards) / 0.86)
    return 1 / most if most > 0 else 1.0


def union(all_bounds):
    return [(min if i % 2 == 0 else max)(bounds[i] for bounds in all_bounds) for i in range(6)]


def draw(collection, arguments):
    frames = frames_of(collection)
    if not frames:
        sys.exit(f"tools/picture: {collection} lists no frames")
    chosen = [nearest_frame(frames, time) for time in arguments.time or [frames[-1][0]]]
    mirrors = [axis_and_place(text) for text in arguments.mirror]
    grids = [read_grid(file, mirrors) for _, file in chosen]
    if arguments.without:
        grids = [without_parts(grid, numbers_of(arguments.without)) for grid in grids]
    if arguments.cut:
        grids = [behind(grid, *axis_and_place(arguments.cut), direction_of(arguments.view)) for grid in grids]
    bounds = union([grid.GetBounds() for grid in grids])
    low, high = (map(float, arguments.range.split(",")) if arguments.range else value_range(grids, arguments.field))
    width, height = (int(number) for number in arguments.size.split("x"))
    for number, ((time, file), grid) in enumerate(zip(chosen, grids), 1):
        renderer = vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        parts = arguments.field == "part"
        table = part_table(grids) if parts else colour_table(low, high)
        renderer.AddActor(mesh_actor(grid, arguments.field, table, not arguments.no_edges))
        if arguments.wall:
            renderer.AddActor(wall_actor(bounds, *axis_and_place(arguments.wall)))
        if walls := shaped_walls_actor(file):
            renderer.AddActor(walls)
        if not parts or table.GetNumberOfTableValues() <= MOST_PARTS:
            renderer.AddActor2D(colour_bar(table, height, parts))
        title = TITLES.get(arguments.field, arguments.field.replace("_", " "))
        renderer.AddActor2D(label(title, 0.024 * height, (0.985 * width, 0.825 * height), to_the_left=True))
        renderer.AddActor2D(label(f"t = {time:.4g}", 0.028 * height, (0.03 * height, 0.03 * height)))
        lights = vtkLightKit()
        lights.AddLightsToRenderer(renderer)
        output = arguments.output or collection.with_name(f"{collection.stem}_{arguments.field}.png")
        if len(chosen) > 1:
            output = output.with_name(f"{output.stem}_{number}{output.suffix}")
        render(renderer, (width, height), bounds, arguments, output)
        print(output)


def render(renderer, size, bounds, arguments, output):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    place_camera(renderer, bounds, arguments)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(Path(output)))
    writer.Write()
