"""Plane walls of heat: what is given on a face of a body that conducts."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from warpsph.core.lattice import Lattice
from warpsph.errors import InputError, number, require, shown
from warpsph.terms.profile import Profile

PERPENDICULAR = 1.0e-3  # largest cosine between planes whose images are those of a corner
LARGEST = 1.0e30  # of numbers that single precision has to hold
SLACK = 0.25  # spacings by which a particle may be behind a wall and count as on it
NUMBERS = ("conductance", "outside", "flux")  # of a wall, that may be profiles


@dataclass(frozen=True, eq=False)
class HeatWall:
    """A plane with a body before it; ``q = conductance (T_surface - outside) + flux`` leaves the body there.

    Made by :meth:`at_temperature`, :meth:`film`, :meth:`given_flux` or :meth:`insulated`. The plane has no end. Rows of
    particles begin half a spacing before it, or with a row on it whose cells are cut (:func:`cut_cells`). A particle
    up to a quarter of a spacing behind it counts as on it; one further behind exchanges no heat across it and does not
    see the wall.

    What is given may change along the wall and with time: a :class:`warpsph.terms.profile.Profile` in the place of a
    number. A particle then sees the number at its own place, at the time of the integrator: the begin of an explicit
    step, the end of one of :class:`BackwardEuler`. A row on a wall whose temperature changes with time is not to be
    ``held``; it takes that temperature by itself. In a corner of two walls the profile of one is continued behind the
    other as by a mirror.

    Args:
        normal: unit vector (3,) that points into the body.
        offset: ``x . normal`` on the plane [m].
        conductance: [W/(m^2 K)]; infinite where the temperature of the surface is given, 0 where it does not matter.
        outside: temperature [K] behind the film, or of the surface where it is given.
        flux: heat that leaves the body [W/m^2], beside what passes the film.
        profiles: those of the three numbers that change, by their names; the numbers themselves are then means.
    """

    normal: Sequence[float]
    offset: float
    conductance: float
    outside: float
    flux: float
    profiles: Mapping[str, Profile] = field(default_factory=dict)

    def __post_init__(self) -> None:
        three = np.shape(self.normal) == (3,) and all(np.isfinite(number(n)) for n in self.normal)
        unit = three and abs(float(np.linalg.norm(self.normal)) - 1.0) < 1e-6
        require(self, "normal", unit, "a unit vector of three numbers")
        require(self, "offset", bool(np.isfinite(number(self.offset))), "a number [m]")
        for name, profile in self.profiles.items():
            known = name in NUMBERS and isinstance(profile, Profile)
            require(self, "profiles", known, f"Profile by name, one of {', '.join(NUMBERS)}")
            if self.conductance == np.inf and name != "outside":
                raise InputError(
                    f"HeatWall: {name} = {shown(profile)}: none where the temperature of the surface is given"
                )
            lowest = -LARGEST if name == "flux" else 0.0
            if profile.table.min() < lowest or profile.table.max() > LARGEST:
                raise InputError(
                    f"HeatWall: {name} = {shown(profile)}: its values must be from {lowest:g} to {LARGEST:g}"
                )
        conductance = number(self.conductance)
        allowed = f"zero, positive up to {LARGEST:g}, or infinite [W/(m^2 K)]"
        require(self, "conductance", 0.0 <= conductance <= LARGEST or conductance == np.inf, allowed)
        require(self, "outside", 0.0 <= number(self.outside) <= LARGEST, "a temperature [K], from 0 K up")
        require(self, "flux", abs(number(self.flux)) <= LARGEST, "a number [W/m^2]")
        given_twice = conductance == np.inf and self.flux != 0.0
        require(self, "flux", not given_twice, "zero where the temperature of the surface is given")

    @classmethod
    def at_temperature(cls, normal: Sequence[float], offset: float, temperature: float | Profile) -> "HeatWall":
        """A surface of given temperature [K]; a row that stands on it is to be ``held`` at that temperature."""
        return cls._given(normal, offset, np.inf, temperature, 0.0)

    @classmethod
    def film(
        cls, normal: Sequence[float], offset: float, conductance: float | Profile, outside: float | Profile
    ) -> "HeatWall":
        """A film of a conductance [W/(m^2 K)] before an outside of given temperature [K]."""
        return cls._given(normal, offset, conductance, outside, 0.0)

    @classmethod
    def given_flux(cls, normal: Sequence[float], offset: float, flux: float | Profile) -> "HeatWall":
        """A flux [W/m^2] that leaves the body, whatever its temperature."""
        return cls._given(normal, offset, 0.0, 0.0, flux)

    @classmethod
    def insulated(cls, normal: Sequence[float], offset: float) -> "HeatWall":
        """A surface through which no heat passes: a plane of symmetry, too."""
        return cls(normal, offset, 0.0, 0.0, 0.0)

    @classmethod
    def _given(cls, normal: Sequence[float], offset: float, *given: float | Profile) -> "HeatWall":
        profiles = {name: value for name, value in zip(NUMBERS, given, strict=True) if isinstance(value, Profile)}
        conductance, outside, flux = (float(v.table.mean()) if isinstance(v, Profile) else v for v in given)
        return cls(normal, offset, conductance, outside, flux, profiles)

    def height(self, points: np.ndarray) -> np.ndarray:
        """Distance (n,) [m] of ``points`` (n, 3) before the plane."""
        return np.asarray(points, float) @ np.asarray(self.normal, float) - self.offset


def cut_cells(points: np.ndarray, walls: Sequence[HeatWall], spacing: float, dimension: int) -> np.ndarray:
    """Volumes (n,) [m^3, or m^2 in 2D] of the cells around ``points`` (n, 3), as far as they are before the walls.

    For lattices along the walls: half a cell where a row stands on one of them, a quarter where on two.

    Raises:
        InputError: a cell is all behind a wall.
    """
    volume = np.full(len(points), spacing**dimension)
    for wall in walls:
        volume *= np.clip(0.5 + wall.height(points) / spacing, 0.0, 1.0)
    if outside := int(np.sum(volume <= 0.0)):
        raise InputError(f"cut_cells: {outside} of {len(points)} cells are all behind a wall; leave them out")
    return volume


def refuse_misfits(walls: Sequence[HeatWall], lattice: Lattice, points: np.ndarray) -> None:
    """Refuse walls whose images would be wrong for the particles at ``points`` (n, 3) [m].

    Raises:
        InputError: two walls are parallel and nearer to each other than the support, or neither parallel nor
            perpendicular and near the same particle; or one, or the direction of its profile, leans out of the plane.
    """
    for b, wall in enumerate(walls):
        if lattice.dimension == 2 and wall.normal[2] != 0.0:
            raise InputError(f"heat walls: the normal {tuple(wall.normal)} leans out of the plane, in two dimensions")
        for name, profile in wall.profiles.items():
            if lattice.dimension == 2 and profile.direction[2] != 0.0:
                raise InputError(f"heat wall {b}: the profile of {name} is along z, but there are two dimensions")
        for a, other in enumerate(walls[:b]):
            cosine = float(np.dot(wall.normal, other.normal))
            if abs(cosine) > 1.0 - PERPENDICULAR:
                _refuse_narrow(wall, other, cosine, lattice.support)
            elif abs(cosine) > PERPENDICULAR and np.any(_near(wall, points, lattice) & _near(other, points, lattice)):
                raise InputError(
                    f"heat walls {a} and {b} meet in the body, neither parallel nor at right angles: no images fit"
                )


def _refuse_narrow(wall: HeatWall, other: HeatWall, cosine: float, support: float) -> None:
    """Two faces of one body must be a support apart; walls of two bodies may stand back to back."""
    gap = abs(wall.offset - other.offset) if cosine > 0.0 else -(wall.offset + other.offset)
    if (cosine > 0.0 or gap > 0.0) and gap < support * (1.0 - 1e-6):
        raise InputError(
            f"heat walls: two parallel ones are {gap:.4g} m apart; they must be as far as the support, {support:.4g} m"
        )


def _near(wall: HeatWall, points: np.ndarray, lattice: Lattice) -> np.ndarray:
    """Which points (n,) see images behind a wall."""
    height = wall.height(points)
    return (height > -SLACK * lattice.spacing) & (height < lattice.support)
