"""The same particles drawn by matplotlib, for machines on which VTK cannot draw."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import EllipseCollection
from matplotlib.figure import Figure

from warpsph.pictures.view import GROUND, GROUND_BRIGHTNESS, View

DOTS_PER_INCH = 100
RIM_BRIGHTNESS, FACE = 0.85, 0.8  # brightness of the rim; diameter of what it surrounds


def paint(
    points: np.ndarray, colours: np.ndarray, diameters: np.ndarray, view: View, size: tuple[int, int]
) -> np.ndarray:
    """Draw particles on white; arguments and result as in :func:`warpsph.pictures.paint_vtk.paint`."""
    figure = Figure(figsize=(size[0] / DOTS_PER_INCH, size[1] / DOTS_PER_INCH), dpi=DOTS_PER_INCH)
    canvas = FigureCanvasAgg(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    axes.set(xlim=(view.left, view.right), ylim=(view.bottom, view.top))
    seen = view.project(points)
    if view.camera:
        diameters = diameters / seen[:, 2]
    far_first = np.argsort(-seen[:, 2], kind="stable")
    seen, diameters, colours = seen[far_first], diameters[far_first], colours[far_first]
    if not view.camera:
        _add_discs(axes, seen, GROUND_BRIGHTNESS * colours, GROUND * diameters)
    # rim and face of each particle in turn, so that a near one hides the whole of a far one
    rim_and_face = np.stack([RIM_BRIGHTNESS * colours, colours], axis=1).reshape(-1, 3)
    _add_discs(axes, np.repeat(seen, 2, axis=0), rim_and_face, np.outer(diameters, (1.0, FACE)).ravel())
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[:, :, :3].copy()


def _add_discs(axes: Axes, seen: np.ndarray, colours: np.ndarray, diameters: np.ndarray) -> None:
    angles, offsets = np.zeros(len(seen)), seen[:, :2]
    discs = EllipseCollection(
        diameters, diameters, angles, units="xy", offsets=offsets, transOffset=axes.transData, facecolors=colours
    )
    discs.set_linewidth(0)
    axes.add_collection(discs)
