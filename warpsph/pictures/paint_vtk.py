"""Particles as softly shaded discs or spheres, drawn off-screen by VTK."""

import numpy as np
import pyvista
from vtkmodules.vtkRenderingCore import vtkCamera

from warpsph.pictures.view import GROUND, GROUND_BRIGHTNESS, View

SUPERSAMPLING = 2
SHADE_2D, SHADE_3D = 0.25, 0.55

# darker towards the rim, so that neighbours of one colour can be told apart
DISC = """//VTK::Color::Impl
float rim = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);
if (rim > 1.0) {{ discard; }}
float shade = 1.0 - {shade} * rim * rim;
ambientColor *= shade;
diffuseColor *= shade;
"""


def paint(
    points: np.ndarray, colours: np.ndarray, diameters: np.ndarray, view: View, size: tuple[int, int]
) -> np.ndarray:
    """Draw particles on white.

    Args:
        points: (n, 3) [m].
        colours: (n, 3) from 0 to 1.
        diameters: (n,) [m].
        view: what is seen.
        size: width and height in pixels.

    Returns:
        (height, width, 3) uint8.
    """
    width, height = size
    plotter = pyvista.Plotter(off_screen=True, window_size=[SUPERSAMPLING * width, SUPERSAMPLING * height])
    plotter.renderer.SetBackground(1.0, 1.0, 1.0)
    if len(points):
        if view.camera:
            _add_discs(plotter, points, colours, diameters, SHADE_3D)
        else:
            _add_discs(plotter, points, colours, diameters, SHADE_2D)
            _add_discs(plotter, points - (0.0, 0.0, view.spacing), GROUND_BRIGHTNESS * colours, GROUND * diameters, 0.0)
    _aim(plotter.camera, view)
    plotter.renderer.ResetCameraClippingRange()
    image = np.asarray(plotter.screenshot(return_img=True))
    plotter.close()
    blocks = image.reshape(height, SUPERSAMPLING, width, SUPERSAMPLING, 3)
    return blocks.mean(axis=(1, 3)).round().astype("u1")


def _add_discs(
    plotter: pyvista.Plotter, points: np.ndarray, colours: np.ndarray, diameters: np.ndarray, shade: float
) -> None:
    cloud = pyvista.PolyData(np.asarray(points, "f4"))
    cloud["colour"] = np.round(255 * colours).astype("u1")
    cloud["radius"] = np.asarray(diameters / 2, "f4")
    actor = plotter.add_mesh(cloud, scalars="colour", rgb=True, style="points_gaussian", emissive=False, lighting=False)
    actor.ForceOpaqueOn()  # otherwise what is drawn last covers what is nearer
    actor.mapper.SetScaleArray("radius")
    actor.mapper.SetScaleFactor(1.0)
    actor.mapper.SetBoundScale(1.0)
    actor.mapper.SetSplatShaderCode(DISC.format(shade=shade))


def _aim(camera: vtkCamera, view: View) -> None:
    """Let the camera see the rectangle of the view and no more."""
    half_width, half_height = (view.right - view.left) / 2, (view.top - view.bottom) / 2
    x, y = (view.left + view.right) / 2, (view.bottom + view.top) / 2
    if view.camera:
        camera.SetPosition(*view.camera.eye)
        camera.SetFocalPoint(*(view.camera.eye + view.camera.forward))
        camera.SetViewUp(*view.camera.up)
        camera.SetViewAngle(np.degrees(2 * np.arctan(half_height)))
        camera.SetWindowCenter(x / half_width, y / half_height)
    else:
        camera.SetPosition(x, y, 1.0)
        camera.SetFocalPoint(x, y, 0.0)
        camera.SetViewUp(0.0, 1.0, 0.0)
        camera.SetParallelProjection(True)
        camera.SetParallelScale(half_height)
