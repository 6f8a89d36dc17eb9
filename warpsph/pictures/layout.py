"""Where panels and key lie on a sheet that is read at the width of a page; all lengths are in inches."""

from dataclasses import dataclass

PAGE = (9.0, 11.0)
LEFT, RIGHT, BOTTOM, TOP, GAP = 0.62, 0.12, 0.5, 0.38, 0.22
KEY = 1.45  # width of the key

Place = tuple[float, float, float, float]  # left, bottom, width, height


@dataclass(frozen=True)
class Layout:
    """Places from the lower left corner of the sheet.

    Attributes:
        total: width and height of the sheet.
        panels: the place of each panel.
        rows, columns: numbers of panels on top of each other and in a row.
        key: left and upper end of the key.
        room: height that there is for the key.
    """

    total: tuple[float, float]
    panels: tuple[Place, ...]
    rows: int
    columns: int
    key: tuple[float, float]
    room: float


def arrange(aspect: float, panels: int, long_side: float, key: float) -> Layout:
    """The grid in which the panels are largest, with the fewest rows and columns of those.

    The key lies in a cell of it that is left over, or beside it.

    Args:
        aspect: width over height of a panel.
        panels: their number.
        long_side: that a panel has at most.
        key: height of the key.
    """
    candidates = [
        _grid(aspect, panels, long_side, key, columns, inside)
        for columns in range(1, panels + 1)
        for inside in (True, False)
    ]
    grids = [grid for grid in candidates if grid]
    widest = max(grid.panels[0][2] for grid in grids)
    return min(
        (grid for grid in grids if grid.panels[0][2] > 0.99 * widest), key=lambda grid: (grid.rows, grid.columns)
    )


def _grid(aspect: float, panels: int, long_side: float, key: float, columns: int, inside: bool) -> Layout | None:
    """The sheet with a number of columns; None where the key does not fit in the grid."""
    rows = -(-panels // columns)
    beside = 0.0 if inside else KEY
    width = min(
        long_side * min(1.0, aspect),
        max((PAGE[0] - LEFT - beside) / columns - GAP, 0.1),
        max(PAGE[1] / rows - TOP - BOTTOM, 0.1) * aspect,
    )
    height = width / aspect
    across, down = width + GAP, height + TOP + BOTTOM
    if inside and (columns * rows == panels or across < KEY or down < key):
        return None
    body = max(rows * down, key)
    total = LEFT + columns * across + beside, body
    places = tuple(
        (LEFT + k % columns * across, body - TOP - k // columns * down - height, width, height) for k in range(panels)
    )
    if inside:
        corner, room = (LEFT + (columns - 1) * across + 0.1, body - TOP - (rows - 1) * down), down
    else:
        corner, room = (LEFT + columns * across + 0.1, body - TOP), body
    return Layout(total, places, rows, columns, corner, room - TOP - BOTTOM)
