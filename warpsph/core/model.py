"""What does not change in a run: dimension, spacing, materials, and one slot for each kind of physics."""

from dataclasses import dataclass, field

import numpy as np

from warpsph.core.materials import Material
from warpsph.kernels.basics.smoothing import normalisation


@dataclass(frozen=True)
class Fluid:
    """Weakly compressible flow (Vijaykumar 2012, chapters 1 and 2).

    Args:
        reference_density: rho_0 [kg/m^3].
        sound_speed: c_s [m/s].
        tension: whether pressure may fall below zero; forbid it where there is a free surface.
        continuity: advance the density by the equation of continuity in place of (2.1), which finds too little of it
            at a free surface: the outermost rows fall onto each other before they bear any pressure.
    """

    reference_density: float
    sound_speed: float
    tension: bool = False
    continuity: bool = False


@dataclass(frozen=True)
class Conduction:
    """Heat conduction by enthalpy (Vijaykumar 2012, chapter 3).

    Args:
        contact: conductivity [W/(m K)] of pairs of two materials, by their indices (the smaller first), in place of
            the harmonic mean.
        longest_interval: largest time between two conduction steps [s], beside the stability limit.
    """

    contact: dict[tuple[int, int], float] = field(default_factory=dict)
    longest_interval: float = 1.0e-3


@dataclass(frozen=True)
class PhaseChange:
    """Switch between fluid and solid (Vijaykumar 2012, chapter 4).

    Args:
        freeze_above: solid fraction above which a particle turns solid.
        melt_below: solid fraction below which a solid particle melts.
    """

    freeze_above: float = 0.55
    melt_below: float = 0.45


@dataclass(frozen=True)
class Elasticity:
    """Elastic solid of bonded particles (Vijaykumar 2012, chapter 4).

    Args:
        youngs_modulus: E [Pa].
        poisson_ratio: nu.
        corrected: correct the displacement gradient by the moment matrix; False is the published form.
        hourglass: strength of the control of zero-energy modes (Ganzenmueller 2015), 0 for none.
        contact: different bodies press on each other; not needed with a fluid, whose pressure does so.
    """

    youngs_modulus: float
    poisson_ratio: float
    corrected: bool = True
    hourglass: float = 0.1
    contact: bool = False

    @property
    def lame(self) -> tuple[float, float]:
        """lambda and mu [Pa] of Hooke's law (4.5)."""
        E, nu = self.youngs_modulus, self.poisson_ratio
        return E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), E / (2.0 * (1.0 + nu))

    def wave_speed(self, density: float) -> float:
        """Speed of the elastic compression wave [m/s]."""
        lame_lambda, lame_mu = self.lame
        return float(np.sqrt((lame_lambda + 2.0 * lame_mu) / density))


@dataclass(frozen=True)
class SurfaceTension:
    """Surface tension by the colour field; needs a fluid whose density follows the equation of continuity.

    Args:
        coefficient: sigma [N/m].
        threshold: gradient of the colour field, in units of 1/H, above which there is a surface.
        published: the force of Vijaykumar (2012), section 2.3.2, which pulls on flat surfaces too.
    """

    coefficient: float
    threshold: float = 0.15
    published: bool = False


@dataclass(frozen=True)
class Model:
    """All that stays the same. A slot that is None costs nothing: no array, no launch.

    Args:
        dimension: 2 or 3.
        spacing: particle spacing dx [m].
        materials: what the ``material`` index of a particle points to.
        support_ratio: support radius of the smoothing kernels over the spacing, H / dx.
        gravity: [m/s^2].
        fluid, conduction, phase_change, elasticity, surface_tension: the slots.
    """

    dimension: int
    spacing: float
    materials: tuple[Material, ...]
    support_ratio: float = 2.6
    gravity: tuple[float, float, float] = (0.0, -9.81, 0.0)
    fluid: Fluid | None = None
    conduction: Conduction | None = None
    phase_change: PhaseChange | None = None
    elasticity: Elasticity | None = None
    surface_tension: SurfaceTension | None = None

    @property
    def support(self) -> float:
        """Support radius H [m]."""
        return self.support_ratio * self.spacing

    @property
    def cell_volume(self) -> float:
        """Volume of one particle of the lattice [m^3], or area [m^2] in 2D."""
        return self.spacing**self.dimension

    def lattice_offsets(self) -> np.ndarray:
        """Neighbours (n, 3) [m] of a particle of the infinite lattice, inside the support."""
        reach = int(np.ceil(self.support_ratio))
        steps = np.arange(-reach, reach + 1)
        depth = steps if self.dimension == 3 else np.zeros(1)
        points = np.stack(np.meshgrid(steps, steps, depth, indexing="ij"), -1).reshape(-1, 3) * self.spacing
        distance = np.linalg.norm(points, axis=1)
        return points[(distance > 0.0) & (distance < self.support)]

    def lattice_density(self) -> float:
        """Number density times cell volume that the summation (2.1) finds on the lattice; 1 for a perfect kernel."""
        r_squared = np.append(np.sum(self.lattice_offsets() ** 2, axis=1), 0.0)
        return self._lattice_sum("poly6", (self.support**2 - r_squared) ** 3)

    def lattice_gradient(self) -> float:
        """Gradient that the pressure sum (2.3) finds on the lattice for a field of gradient 1."""
        d = self.lattice_offsets()
        r = np.linalg.norm(d, axis=1)
        slope = 3.0 * (self.support - r) ** 2 / r
        return self._lattice_sum("spiky", d[:, 0] ** 2 * slope) / self.lattice_density()

    def lattice_viscosity(self) -> float:
        """Viscosity that the sum (2.5) has on the lattice, over the true one."""
        d = self.lattice_offsets()
        laplacian = self.support - np.linalg.norm(d, axis=1)
        return self._lattice_sum("viscosity", 0.5 * d[:, 0] ** 2 * laplacian) / self.lattice_density()

    def lattice_conduction(self) -> float:
        """Diffusivity that conduction by the poly6 kernel has on the lattice, over the true one."""
        d = self.lattice_offsets()
        slope = 6.0 * (self.support**2 - np.sum(d**2, axis=1)) ** 2
        return self._lattice_sum("poly6", d[:, 0] ** 2 * slope)

    def lattice_surface(self, threshold: float) -> tuple[float, float]:
        """Sum of V (|grad c| - threshold), where positive, over the particles under a unit of a face of the lattice.

        And their mean depth [m], so weighted. ``threshold`` [1/m]; without one the sum is half the lattice factor of
        conduction, close to 1/2.
        """
        d = self.lattice_offsets()
        slope = 6.0 * (self.support**2 - np.sum(d**2, axis=1)) ** 2
        total = moment = 0.0
        for layer in range(int(np.ceil(self.support_ratio))):
            missing = d[:, 0] > (layer + 0.5) * self.spacing
            steepness = self._lattice_sum("poly6", (d[:, 0] * slope)[missing])
            weight = self.spacing * max(steepness - threshold, 0.0)
            total += weight
            moment += weight * (layer + 0.5) * self.spacing
        return float(total), float(moment / total)

    def contact_conductivity(self, conductance: float) -> float:
        """Pair conductivity [W/(m K)] that gives a flat interface between two lattices this conductance [W/(m^2 K)].

        Sum of all pairs of the lattice that cross a plane: a pair m layers apart crosses m positions of the plane.
        """
        d = self.lattice_offsets()
        crossing = d[d[:, 0] > 0.0]
        slope = 6.0 * (self.support**2 - np.sum(crossing**2, axis=1)) ** 2
        layers = crossing[:, 0] / self.spacing
        area = self.cell_volume / self.spacing
        scale = normalisation("poly6", self.dimension, self.support) / self.lattice_conduction()
        return float(conductance * area / (2.0 * scale * self.cell_volume**2 * np.sum(layers * slope)))

    def _lattice_sum(self, smoothing_kernel: str, terms: np.ndarray) -> float:
        return float(normalisation(smoothing_kernel, self.dimension, self.support) * self.cell_volume * np.sum(terms))
