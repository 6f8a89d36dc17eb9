"""What still pictures, series and movies share: the frames to look at, the view, the look and the painter."""

import sys
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from warpsph.errors import InputError
from warpsph.files.results import ResultFile
from warpsph.pictures import graphics, vorticity
from warpsph.pictures.bonds import SHRUNK, bonds_of, draw_bonds
from warpsph.pictures.fit import fit_to_draw
from warpsph.pictures.lines import NO_LINES, Lines, draw_lines
from warpsph.pictures.looks import choose_look
from warpsph.pictures.parts import Fields
from warpsph.pictures.sheet import Sheet
from warpsph.pictures.shell_edge import draw_edge
from warpsph.pictures.shown_field import values_of
from warpsph.pictures.view import make_view

SURVEYED_FRAMES = 9

Cut = tuple[int, float]


class Drawing:
    """Draws frames of one result on one sheet, in colours that hold for the whole run.

    Args:
        result: the run.
        drawn: numbers of the frames that the view must hold.
        field: what the colours show; None for the default look.
        panels: number of panels of the sheet.
        long_side: of one panel [inch].
        dots_per_inch: resolution of the sheet.
        cut: axis (0, 1, 2) and place [m] of a plane, beyond which nothing is drawn; None for no cut.
        lines: what is drawn over the particles, in the plane.

    Raises:
        InputError: there is no frame, no such field, nothing on this side of the cut, no depth to cut in, or no plane
            or no velocity for the lines.
    """

    def __init__(
        self,
        result: ResultFile,
        drawn: list[int],
        field: str | None,
        panels: int,
        long_side: float,
        dots_per_inch: int,
        cut: Cut | None = None,
        lines: Lines = NO_LINES,
    ) -> None:
        if len(result.times) == 0:
            raise InputError(f"{result.path}: holds no frame to draw")
        self.result, self.cut, self.lines = result, cut, lines
        self._finds_vorticity = vorticity.NAME in (field, lines.field)
        survey = np.linspace(0, len(result.times) - 1, SURVEYED_FRAMES).round().astype(int).tolist()
        frames = {k: self._frame(k) for k in {*drawn, *survey}}
        if cut is not None and cut[0] == 2 and not any(np.any(points[:, 2]) for points, _ in frames.values()):
            raise InputError(f"cut = z={cut[1]:g}: this run is two-dimensional and has no depth; cut along x or y")
        if cut is not None and not any(len(points) for points, _ in frames.values()):
            raise InputError(f"cut = {'xyz'[cut[0]]}={cut[1]:g}: all particles lie beyond it")
        self.look = choose_look(result, field, list(frames.values()))
        self.field = field if field is not None else getattr(self.look, "name", "temperature")
        self.view = make_view(result, [frames[k] for k in drawn])
        if lines:
            self._refuse_lines(next(iter(frames.values()))[1])
        self.sheet = Sheet(self.view, self.look, panels, long_side, dots_per_inch, float(result.times[-1]))
        most = max(len(points) for points, _ in frames.values())
        self.bonds = bonds_of(result, most, self.sheet.scale)

    def draw(self, panel: int, k: int) -> None:
        """Draw frame ``k`` into a panel."""
        points, fields = self._frame(k)
        drawn = self.view.uncovered(points, fields["role"])
        points, fields = points[drawn], {name: values[drawn] for name, values in fields.items()}
        diameters = self.view.diameters(fields["role"]) * (SHRUNK if self.bonds else 1.0)
        layered = self.view.layered(points, fields["role"])
        image = painter()(layered, self.look.colours(fields), diameters, self.view, self.sheet.size)
        self.sheet.show(panel, image, self.result.times[k])
        self.sheet.overlay(panel, lambda axes: self._draw_lines(axes, points, fields))

    def _draw_lines(self, axes: Axes, points: np.ndarray, fields: Fields) -> list[Any]:
        """Draw what lies over the particles; return what can be removed again."""
        if self.view.camera is not None:
            return []
        drawn = draw_edge(axes, points, fields, self.view) if self.look.edge else []
        if self.bonds is not None and not self.look.edge:
            drawn += draw_bonds(axes, points, fields, self.bonds)
        return drawn + (draw_lines(axes, points, fields, self.view, self.lines, self.field) if self.lines else [])

    def _refuse_lines(self, fields: Fields) -> None:
        if self.view.camera is not None:
            raise InputError("arrows, streamlines and levels are drawn in the plane; this run is three-dimensional")
        if (self.lines.arrows or self.lines.streamlines) and "velocity" not in fields:
            raise InputError(f"{self.result.path}: holds no velocity for arrows and streamlines")
        if self.lines.levels:
            values_of(fields, self.lines.field or self.field)

    def _frame(self, k: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        points, fields = fit_to_draw(self.result.path, *self.result.frame(k))
        if self._finds_vorticity and vorticity.NAME not in fields and "velocity" in fields:
            fields[vorticity.NAME] = vorticity.vorticity(points, fields)
        if self.cut is None:
            return points, fields
        axis, place = self.cut
        kept = points[:, axis] <= place
        return points[kept], {name: values[kept] for name, values in fields.items()}


def painter():
    """The function that paints particles here: VTK's, or where VTK cannot draw matplotlib's."""
    if graphics.graphics_available():
        from warpsph.pictures.paint_vtk import paint
    else:
        from warpsph.pictures.paint_matplotlib import paint

        _tell_once()
    return paint


@cache
def _tell_once() -> None:
    print(graphics.MESSAGE, file=sys.stderr)


def check_output(output: Path, suffixes: tuple[str, ...]) -> None:
    """Refuse, before anything is drawn, a picture that could not be saved.

    Raises:
        InputError: the format is unknown or the folder is missing.
    """
    if output.suffix.lower() not in suffixes:
        raise InputError(f"{output}: pictures of this kind end in {', '.join(suffixes)}")
    if not output.parent.is_dir():
        raise InputError(f"{output}: there is no folder {output.parent}; make it first")
