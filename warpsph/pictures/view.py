"""From where a run is looked at: straight on in two dimensions, in perspective from outside in three."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from warpsph.core.labels import Role
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError
from warpsph.files.results import ResultFile
from warpsph.pictures.fit import FARTHEST
from warpsph.pictures.parts import Frames

DIRECTION = np.array([0.75, 0.5, 1.0]) / np.linalg.norm([0.75, 0.5, 1.0])
UP = np.array([0.0, 1.0, 0.0])
GROUND, GROUND_BRIGHTNESS = 1.55, 0.8  # larger, darker discs behind those in 2-D, so that no paper glitters through
AROUND = (Role.WALL, Role.DUMMY)
LAYERS = np.array([0.2, 0.1, 0.0, 0.4, 0.0, 0.3, 0.3])  # by role, in spacings
AXES_CORNERS = np.array([[0, 0, 1], [1, 0, 1], [1, 0, 0], [0, 1, 1]])  # corners of the box at which axes are drawn
MOST_CELLS = 2000  # along a side, more than there are pixels
SMALLEST = 1.0e-9  # spacing that is believed [m]
DISTANCE = 4.0  # of the eye from the centre, in diagonals of the domain


@dataclass(frozen=True)
class Camera:
    """An eye, the three directions of its picture, and the corners of the box that it looks at, all (3,)."""

    eye: np.ndarray
    right: np.ndarray
    up: np.ndarray
    forward: np.ndarray
    low: np.ndarray
    high: np.ndarray


@dataclass(frozen=True)
class View:
    """A rectangle of the picture plane: the x-y plane [m], or with a camera the plane at distance 1 from its eye."""

    left: float
    right: float
    bottom: float
    top: float
    spacing: float
    camera: Camera | None = None
    periodic: PeriodicBox | None = None

    @property
    def aspect(self) -> float:
        """Width over height."""
        return (self.right - self.left) / (self.top - self.bottom)

    @property
    def finest(self) -> float:
        """Edge [m] of the smallest cells into which the picture is divided, however small the particles."""
        return max(self.right - self.left, self.top - self.bottom) / MOST_CELLS

    def project(self, points: np.ndarray) -> np.ndarray:
        """(n, 3): place in the picture plane and distance from it."""
        return _project(points, self.camera) if self.camera else points * (1.0, 1.0, -1.0)

    def layered(self, points: np.ndarray, role: np.ndarray) -> np.ndarray:
        """Points (n, 3), in two dimensions lifted so that dummies lie at the back and sprays in front."""
        if self.camera:
            return points
        return np.column_stack([points[:, :2], LAYERS[role] * self.spacing])

    def diameters(self, role: np.ndarray) -> np.ndarray:
        """Diameters (n,) [m]: area or volume is the particle's; walls in 3-D are dots that one can see through."""
        if self.camera is None:
            return np.full(len(role), np.sqrt(4.0 / np.pi) * self.spacing)
        return np.where(np.isin(role, AROUND), 0.25, np.cbrt(6.0 / np.pi)) * self.spacing

    def uncovered(self, points: np.ndarray, role: np.ndarray) -> np.ndarray:
        """Which particles (n,) are drawn: in 3-D no dots of walls and dummies where they would lie over the rest."""
        drawn = np.ones(len(points), bool)
        dots = np.isin(role, AROUND)
        if self.camera and np.any(dots) and not np.all(dots):
            seen = self.project(points)
            radius = 0.5 * np.max(self.diameters(role)) / np.min(seen[:, 2])
            distance, _ = cKDTree(seen[~dots, :2]).query(seen[dots, :2], distance_upper_bound=radius)
            drawn[dots] = np.isinf(distance)
        return drawn


def make_view(result: ResultFile, frames: Frames) -> View:
    """The tightest view of all particles of ``frames``, except for a few that have flown far away.

    A periodic box is seen whole.
    """
    points = np.concatenate([points for points, _ in frames]).astype(float)
    spacing = _spacing(result, points)
    if len(points) == 0:
        return View(0.0, 1.0, 0.0, 1.0, spacing)
    periodic = PeriodicBox.of_facts(result.provenance)
    if periodic is not None and max(map(abs, (*periodic.lower, *periodic.edges))) > FARTHEST:
        raise InputError(f"{result.path}: its periodic box is larger than {FARTHEST:g} m")
    if result.provenance.get("dimension") == 3 or np.ptp(points[:, 2]) > spacing:
        low, high = _box(points, periodic)
        eye = (low + high) / 2 + DISTANCE * (np.linalg.norm(high - low) + spacing) * DIRECTION
        right = np.cross(UP, DIRECTION)
        right /= np.linalg.norm(right)
        camera = Camera(eye, right, np.cross(DIRECTION, right), -DIRECTION, low, high)
        box = np.where(AXES_CORNERS, high, low)
        corners = _project(np.concatenate([np.clip(points, low, high), box]), camera)[:, :2]
        (left, bottom), (right, top) = corners.min(axis=0), corners.max(axis=0)
        margin = spacing / float(np.linalg.norm(eye - (low + high) / 2))
    else:
        camera = None
        (left, bottom, _), (right, top, _) = _box(points, periodic)
        # so that there is a picture of a few particles far from the origin
        margin = max(spacing, 1e-6 * max(map(abs, (left, bottom, right, top))))
    return View(left - margin, right + margin, bottom - margin, top + margin, spacing, camera, periodic)


def _project(points: np.ndarray, camera: Camera) -> np.ndarray:
    seen = points - camera.eye
    depth = seen @ camera.forward
    return np.stack([seen @ camera.right / depth, seen @ camera.up / depth, depth], axis=1)


def _box(points: np.ndarray, periodic: PeriodicBox | None) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper corner (3,), without those of the outermost half percent that are far from all others."""
    low, high = np.quantile(points, (0.005, 0.995), axis=0)
    reach = 0.5 * (high - low)
    near = points[np.all((points >= low - reach) & (points <= high + reach), axis=1)]
    low, high = near.min(axis=0), near.max(axis=0)
    if periodic is not None:
        lower, edges = np.asarray(periodic.lower), periodic.edges
        low = np.where(edges > 0.0, np.minimum(low, lower), low)
        high = np.where(edges > 0.0, np.maximum(high, lower + edges), high)
    return low, high


def _spacing(result: ResultFile, points: np.ndarray) -> float:
    """The stored particle spacing [m], or else a guess from the volume that the particles fill."""
    stored = result.provenance.get("spacing")
    if isinstance(stored, int | float) and SMALLEST <= stored <= FARTHEST:
        return float(stored)
    if len(points) < 2:
        return 1.0
    extent = np.ptp(points, axis=0)
    extent = extent[extent > 1e-6 * extent.max()]
    return max(float((np.prod(extent) / len(points)) ** (1 / len(extent))), SMALLEST) if len(extent) else 1.0
