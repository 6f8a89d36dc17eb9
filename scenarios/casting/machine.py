"""The parts of the casting machine, placed: strand, mould, rolls, nozzle, dummies, water."""

from itertools import pairwise

import numpy as np

from warpsph.core.faces import way_out_of_boxes, way_to_box
from warpsph.core.hydrostatics import column_pressure, row_heights
from warpsph.core.labels import Role
from warpsph.core.materials import WATER
from warpsph.core.model import GRAVITY
from warpsph.core.particles import Particles, lattice, parked
from warpsph.errors import InputError
from warpsph.machine import Inlet, LevelGauge, Outflow, Rolls, ShellSpeedometer, Spray, SprayZone, SymmetryPlane
from warpsph.scenarios.casting.nozzle import Nozzle, side_port, straight_tube
from warpsph.scenarios.casting.parameters import (
    COOLING_WATER,
    SPRAY_BOILED,
    SPRAY_TEMPERATURE,
    CastingParameters,
)

MOULD, PLANE, NOZZLE, ROLLS = "mould", "symmetry plane", "nozzle", "rolls"  # materials, by which pictures name them
MOULD_LAYERS = 4
DUMMY_LAYERS = 3
OUTFLOW_ROWS = 4
SPRAY_DISTANCE = 0.04  # from the nozzles to the strand [m]
LONGEST_RIDE = 10.0  # time on the strand for which water is in reserve [s]


class CastingMachine:
    """Puts the particles of a case in their places and makes the parts that move them.

    Args:
        case: the scenario.
    """

    def __init__(self, case: CastingParameters):
        self.case = case
        self.corrected = case.formulation == "corrected"
        self.particles = Particles()
        self.rim = case.mould_top + 0.02
        self.heights = self._row_heights()
        side = case.nozzle_port == "side"
        nozzle = side_port(case, self.rim) if side else straight_tube(case, self.heights, self.rim)
        planes = [SymmetryPlane((1.0, 0.0, 0.0), 0.0)]
        if case.dimension == 3:
            planes.append(SymmetryPlane((0.0, 0.0, 1.0), 0.0))
        self.gauge = self._gauge(nozzle)
        self.rolls = Rolls(
            case.half_width, np.arange(case.roll_first, -case.roll_radius, -case.roll_pitch), case.roll_radius
        )
        self._add_strand(nozzle)
        self._add_walls(nozzle)
        self._add_dummies(planes)
        self.inlet = Inlet(
            self.gauge, nozzle.row, nozzle.direction, nozzle.length, case.pouring_temperature, case.steel.name
        )
        self.outflow = Outflow(self.gauge, 0.0, -OUTFLOW_ROWS * case.spacing, case.half_width + 2.0 * case.spacing)
        self.planes = planes
        self.spray = self._add_spray()
        self.speedometer = ShellSpeedometer()

    @property
    def box(self) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Corners of the box that holds everything [m]."""
        case, outside = self.case, self.case.half_width + 0.1
        low, flat = -4 * case.spacing, case.dimension == 2
        return (low, -8 * case.spacing, 0.0 if flat else low), (
            outside,
            case.mould_top + 0.05,
            0.0 if flat else outside,
        )

    def _row_heights(self) -> np.ndarray:
        """Heights [m] of the rows of the strand and of the zone in which it is withdrawn."""
        case, floor = self.case, -OUTFLOW_ROWS * self.case.spacing
        depth = case.level - floor
        if case.start == "hydrostatic" and not self.corrected:
            weight = column_pressure(depth, 1.0, GRAVITY, case.sound_speed)
            rows = round(float(weight) / (GRAVITY * case.spacing))
            return floor + row_heights(rows, case.spacing, GRAVITY, case.sound_speed)
        return floor + (np.arange(round(depth / case.spacing)) + 0.5) * case.spacing

    def _gauge(self, nozzle: Nozzle) -> LevelGauge:
        """Weighs a column of whole cells beside the nozzle."""
        case = self.case
        low, high = (cell * case.spacing for cell in case.beside_nozzle)
        depth = (-1.0, 1.0) if case.dimension == 2 else (0.0, high)
        return LevelGauge(
            low=(low, 0.0, depth[0]),
            high=(high, 2.0 * case.mould_top, depth[1]),
            target_level=case.level,
            casting_speed=case.casting_speed,
            area_ratio=nozzle.area_ratio,
            gain=case.level_gain,
        )

    def _fill(self, x: tuple[float, float], y: tuple[float, float], z: tuple[float, float]) -> np.ndarray:
        """Lattice (n, 3) [m] of a box, in the plane without z."""
        lower, upper = (corner[: self.case.dimension] for corner in zip(x, y, z, strict=True))
        return lattice(lower, upper, self.case.spacing)

    def _outside(self, points: np.ndarray, depth: float) -> np.ndarray:
        """Which points lie more than ``depth`` [m] outside the cold faces."""
        return np.max(points[:, [0, 2]], axis=1) > self.case.half_width + depth

    def _add_strand(self, nozzle: Nozzle) -> None:
        """Melt and shell at rest under their weight, the moving zones at both ends, and a reserve."""
        case, particles, dx, W = self.case, self.particles, self.case.spacing, self.case.half_width
        section = self._fill((0.0, W), (0.0, dx), (0.0, W))
        points = np.tile(section, (len(self.heights), 1))
        points[:, 1] = np.repeat(self.heights, len(section))
        profiles = case.slices(self.heights)
        if (coldest := float(np.min(profiles))) < 0.0:
            raise InputError(
                f"spray_flux = {case.spray_flux:g}: the strand of the start would fall to {coldest:.4g} K; less water, "
                "or faster casting, keeps it above 0 K"
            )
        cells = (np.arange(profiles.shape[1]) + 0.5) * W / profiles.shape[1]
        from_axis = np.max(section[:, [0, 2]], axis=1)
        temperature = np.concatenate([np.interp(from_axis, cells, profile) for profile in profiles])

        outside_nozzle, withdrawn = ~nozzle.keeps_out(points), points[:, 1] <= 0.0
        strand = outside_nozzle & ~withdrawn
        down = (0.0, -case.casting_speed, 0.0)
        steel = case.steel.name
        for role, chosen in ((Role.FREE, strand), (Role.OUTFLOW, withdrawn)):
            there = points[chosen]
            particles.add(
                there, role, steel, temperature=temperature[chosen], velocity=down, **self._at_rest(there[:, 1])
            )
        filling = nozzle.filling(dx)
        particles.add(filling, Role.INFLOW, steel, temperature=case.pouring_temperature, **self._at_rest(filling[:, 1]))
        reserve = parked((0.0, case.level, 0.0), len(points) // 5)
        particles.add(reserve, Role.RESERVOIR, steel, temperature=case.pouring_temperature)

    def _at_rest(self, heights: np.ndarray) -> dict[str, np.ndarray]:
        """What the corrected flow has at rest at some heights (n,) [m]; the published one has it from its rows."""
        if not self.corrected:
            return {}
        load = GRAVITY * np.maximum(self.case.level - heights, 0.0)
        return {"compression": load / self.case.sound_speed**2, "pressure": self.case.density * load}

    def _face(self, way: np.ndarray) -> dict[str, np.ndarray]:
        """The ways (n, 3) [m] of wall particles to their face, which the corrected flow must know."""
        return {"to_surface": way} if self.corrected else {}

    def _add_walls(self, nozzle: Nozzle) -> None:
        """The mould and the rolls at every cold face, and the nozzle's walls."""
        case, particles, dx, W = self.case, self.particles, self.case.spacing, self.case.half_width
        x = (0.0 if case.dimension == 3 else W, W + MOULD_LAYERS * dx)
        mould = self._fill(x, (case.mould_bottom, case.mould_top), x)
        mould = mould[self._outside(mould, 0.0)]
        outermost = self._outside(mould, (MOULD_LAYERS - 1) * dx)
        face = ~self._outside(mould, dx)
        way = way_to_box(mould, (-np.inf,) * 3, (W, np.inf, W if case.dimension == 3 else np.inf))
        particles.add(
            mould[~face], Role.WALL, MOULD, temperature=COOLING_WATER, held=outermost[~face], **self._face(way[~face])
        )
        # published, rows as near as this make a face that a shell slides over smoothly
        for half in (0.0,) if self.corrected else (-0.25 * dx, 0.25 * dx):
            rows = mould[face] + np.array([0.0, half, 0.0])
            volume = dx**case.dimension * (1.0 if self.corrected else 0.5)
            particles.add(rows, Role.WALL, MOULD, temperature=COOLING_WATER, volume=volume, **self._face(way[face]))
        tube = nozzle.wall_points(dx, case.dimension)
        particles.add(tube, Role.DUMMY, NOZZLE, **self._face(way_out_of_boxes(tube, (*nozzle.walls, nozzle.bore))))
        breadth = W if case.dimension == 3 else 0.0
        rolls = self.rolls.surface(dx, breadth)
        if case.dimension == 3:
            rolls = np.concatenate([rolls, rolls[:, ::-1]])
        particles.add(rolls, Role.DUMMY, ROLLS, flows=False)

    def _add_dummies(self, planes: list[SymmetryPlane]) -> None:
        """Dummies behind the planes of symmetry, in 3D also behind mould and rolls, or melt leaks at their ends."""
        dx = self.case.spacing
        behind, height = (-DUMMY_LAYERS * dx, 0.0), (-7 * dx, self.rim)
        outside = self.case.half_width + MOULD_LAYERS * dx
        places = [self._fill(behind, height, (behind[0], outside)), self._fill((0.0, outside), height, behind)]
        lower, upper = (0.0, -np.inf, 0.0 if self.case.dimension == 3 else -np.inf), (np.inf,) * 3
        for plane, points in zip(planes, places, strict=False):
            plane.add_dummies(self.particles, points, PLANE, **self._face(way_to_box(points, lower, upper)))

    def _add_spray(self) -> Spray:
        case = self.case
        flow = case.spray_flux * case.mould_bottom * (2.0 * case.half_width if case.dimension == 3 else 1.0)
        nozzle = case.half_width + SPRAY_DISTANCE
        under_way = SPRAY_DISTANCE / case.spray_speed + LONGEST_RIDE
        reserve = parked((nozzle, 0.0, 0.0), flow / case.spray_particle * under_way + 10.0)
        volume = case.spray_particle / WATER.density
        self.particles.add(
            reserve, Role.RESERVOIR, WATER.name, temperature=SPRAY_TEMPERATURE, flows=False, volume=volume
        )
        return Spray(
            self._spray_zones(flow / case.spray_particle),
            nozzle,
            case.spray_speed,
            near=1.2 * case.spacing,
            lost=0.5 * case.half_width,
            temperature=SPRAY_TEMPERATURE,
            boiled=SPRAY_BOILED,
            material=WATER.name,
            end=-OUTFLOW_ROWS * case.spacing,
            rolls=self.rolls,
            breadth=case.half_width if case.dimension == 3 else 0.0,
        )

    def _spray_zones(self, rate: float) -> list[SprayZone]:
        """The gaps between the rolls in each zone, through which ``rate`` [particles/s] is sprayed evenly."""
        case = self.case
        edges = np.linspace(case.mould_bottom, 0.0, case.spray_zones + 1)
        gaps = [(k + 1, *gap) for k, (high, low) in enumerate(pairwise(edges)) for gap in self._gaps(low, high)]
        length = sum(high - low for _, low, high in gaps)
        failure = case.spray_failure if case.spray_failure is not None else 1.0e9
        return [
            SprayZone(low, high, rate * (high - low) / length, off=failure if zone in case.spray_failing else 1.0e9)
            for zone, low, high in gaps
        ]

    def _gaps(self, low: float, high: float) -> list[tuple[float, float]]:
        """Stretches [m] between ``low`` and ``high`` that no roll stands before."""
        gaps, top = [], high
        for roll in [*self.rolls.heights, -np.inf]:
            lower, upper = max(roll + self.rolls.radius, low), min(top, high)
            if upper - lower > 0.0:
                gaps.append((lower, upper))
            top = min(top, roll - self.rolls.radius)
        return gaps
