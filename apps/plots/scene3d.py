"""Stones, steel and forces as things that VTK can draw, and the stage they are drawn on.

VTK of Debian 12 draws through X; where there is no screen, through a virtual one
(on_some_screen)."""
import os
import shutil
import sys
import xml.etree.ElementTree

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from .errors import InputError, reading

STEEL, PAPER, INK = (0.72, 0.75, 0.79), (1, 1, 1), (0.13, 0.13, 0.13)


def on_some_screen():
    """Starts this program again on a virtual screen where there is none."""
    if os.environ.get("DISPLAY"):
        return
    if not shutil.which("xvfb-run"):
        raise InputError("DISPLAY: expected a screen, found none; install xvfb and xauth "
                         "(apps/setup.sh does)")
    os.execvp("xvfb-run", ["xvfb-run", "-a", sys.executable, *sys.argv])


def pictures(folder, name):
    """Times [s] and files of a ParaView series of a run."""
    path = folder / f"{name}.pvd"
    with reading(path, "the pictures of a run", "run it again"):
        sets = xml.etree.ElementTree.parse(path).iter("DataSet")
        return [(float(entry.get("timestep")), folder / entry.get("file")) for entry in sets]


def read(path):
    kind = vtk.vtkXMLPolyDataReader if path.suffix == ".vtp" else vtk.vtkXMLUnstructuredGridReader
    reader = kind()
    reader.SetFileName(str(path))
    vtk.vtkObject.GlobalWarningDisplayOff()  # one line instead of them
    reader.Update()
    if reader.GetErrorCode() or not reader.GetOutput().GetNumberOfPoints():
        raise InputError(f"{path}: expected a picture of a run, found none or a damaged one; "
                         "run it again")
    return reader.GetOutput()


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def points(places, **columns):
    """A cloud of points that carries columns of numbers."""
    cloud = vtk.vtkPolyData()
    at = vtk.vtkPoints()
    at.SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=True))
    cloud.SetPoints(at)
    for name, values in columns.items():
        data = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=True)
        data.SetName(name)
        cloud.GetPointData().AddArray(data)
    return cloud


def colours(low, high, steps):
    """A scale of colours through `steps`, each (r, g, b)."""
    ramp = vtk.vtkColorTransferFunction()
    for share, colour in zip(np.linspace(0, 1, len(steps)), steps):
        ramp.AddRGBPoint(low + share * (high - low), *colour)
    return ramp


WARM = [(0.99, 0.91, 0.66), (0.96, 0.60, 0.26), (0.74, 0.15, 0.15), (0.30, 0.02, 0.10)]
COOL = [(0.86, 0.89, 0.92), (0.35, 0.55, 0.75), (0.10, 0.20, 0.42)]


def spheres(cloud, diameter, colour_by=None, scale=None, colour=None, opacity=1):
    """A sphere at each point; coloured by a column along a scale, or all alike."""
    ball = vtk.vtkSphereSource()
    ball.SetThetaResolution(20)
    ball.SetPhiResolution(14)
    mapper = vtk.vtkGlyph3DMapper()
    mapper.SetInputData(cloud)
    mapper.SetSourceConnection(ball.GetOutputPort())
    mapper.SetScaleArray(diameter)
    mapper.SetScaleModeToScaleByMagnitude()
    if colour_by:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(colour_by)
        mapper.SetLookupTable(scale)
    else:
        mapper.ScalarVisibilityOff()
    return actor(mapper, colour or INK, opacity)


def actor(mapper, colour, opacity=1):
    made = vtk.vtkActor()
    made.SetMapper(mapper)
    look = made.GetProperty()
    look.SetColor(*colour)
    look.SetOpacity(opacity)
    look.SetAmbient(0.18)
    look.SetDiffuse(0.85)
    look.SetSpecular(0.15)
    look.SetSpecularPower(20)
    return made


def cut_steel(data, middle, top, opacity=1):
    """The half of a body, or of a surface, that lies behind y = middle, up to the height `top`."""
    for origin, normal in (((0, middle, 0), (0, 1, 0)), ((0, 0, top), (0, 0, -1))):
        plane = vtk.vtkPlane()
        plane.SetOrigin(*origin)
        plane.SetNormal(*normal)
        cut = vtk.vtkClipDataSet()
        cut.SetInputData(data)
        cut.SetClipFunction(plane)
        cut.Update()
        data = cut.GetOutput()
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(data)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SetFeatureAngle(40)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    return actor(mapper, STEEL, opacity)


def rods(begin, end, radius, values, scale):
    """A rod for each pair of ends [m], with its radius [m] and the value that colours it."""
    count = len(begin)
    lines = points(np.stack([begin, end], axis=1).reshape(-1, 3), radius=np.repeat(radius, 2),
                   value=np.repeat(values, 2))
    cells = vtk.vtkCellArray()
    for k in range(count):
        cells.InsertNextCell(2)
        cells.InsertCellPoint(2 * k)
        cells.InsertCellPoint(2 * k + 1)
    lines.SetLines(cells)
    lines.GetPointData().SetActiveScalars("radius")
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputData(lines)
    tubes.SetVaryRadiusToVaryRadiusByAbsoluteScalar()
    tubes.SetNumberOfSides(8)
    tubes.CappingOn()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(tubes.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("value")
    mapper.SetLookupTable(scale)
    return actor(mapper, INK)


class Stage:
    """Things seen from the side that is cut away, a little from above."""

    def __init__(self, size, title, height, width):
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(*PAPER)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)
        self.renderer.UseFXAAOn()
        self.window.AlphaBitPlanesOn()  # what shines through is drawn in its order
        self.renderer.UseDepthPeelingOn()
        self.renderer.SetMaximumNumberOfPeels(20)
        self.size = size
        self.write(title, 0.03, 0.955, 22)
        camera = self.renderer.GetActiveCamera()
        aside, up = 0.13 * width, 0.66 * height  # room for the scale of colours, and for words
        camera.SetFocalPoint(aside, 0, up)
        camera.SetPosition(aside, -1, up + 0.36)
        camera.SetViewUp(0, 0, 1)
        camera.ParallelProjectionOn()
        camera.SetParallelScale(max(0.78 * height + 0.2 * width, 0.72 * width * size[1] / size[0]))

    def add(self, *things):
        for thing in things:
            self.renderer.AddActor(thing)

    def write(self, words, x, y, size):
        text = vtk.vtkTextActor()
        text.SetInput(words)
        text.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        text.GetPositionCoordinate().SetValue(x, y)
        style = text.GetTextProperty()
        style.SetFontSize(max(13, int(size * self.size[1] / 900)))
        style.SetColor(*INK)
        self.renderer.AddActor2D(text)
        return text

    def explain(self, scale, title):
        bar = vtk.vtkScalarBarActor()
        bar.SetLookupTable(scale)
        bar.SetTitle(title)
        bar.SetNumberOfLabels(5)
        bar.SetLabelFormat("%.3g")
        bar.SetUnconstrainedFontSize(True)
        bar.SetVerticalTitleSeparation(8)
        for style in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
            style.SetColor(*INK)
            style.SetFontSize(max(11, int(18 * self.size[1] / 900)))
            style.BoldOff()
            style.ItalicOff()
            style.ShadowOff()
        bar.SetPosition(0.88, 0.28)
        bar.SetWidth(0.10)
        bar.SetHeight(0.45)
        self.renderer.AddActor2D(bar)

    def image(self):
        """What is seen, as (rows, columns, 3)."""
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        grab = vtk.vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        seen = grab.GetOutput()
        columns, rows, _ = seen.GetDimensions()
        return vtk_to_numpy(seen.GetPointData().GetScalars()).reshape(rows, columns, 3)[::-1]
