"""Elastic forces of bonded particles: Green-Saint-Venant strain, Hooke's law, and hourglass control."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.neighbours.pairs import precise_difference
from warpsph.kernels.solid.bonds import CHANGED, SMALLEST_VOLUME, UNCHANGED, BondList

wp.set_module_options({"enable_backward": False})

# Of the eigenvalues of a moment matrix, which are 1 inside a body: the smallest over the largest, 0.3 in a corner of a
# cube, 0 in a row or a pair; and the smallest, because its inverse is how much stiffer a particle of few bonds is made.
WORST_CONDITION = wp.constant(0.1)
SMALLEST_MOMENT = wp.constant(0.06)


@wp.struct
class ElasticConstants:
    """Constants of the elastic solid.

    ``lame_lambda``, ``lame_mu``, ``youngs_modulus`` [Pa]; ``hourglass`` strength of the hourglass control, and
    ``shortest_squared`` [m^2] the square of the length below which a bond gets no stiffer by it;
    ``corrected`` 1 where gradients are corrected by the moment matrix, 0 for the form as published; ``planar`` 1 in
    2D, where the moment matrix has no third row.
    """

    lame_lambda: float
    lame_mu: float
    youngs_modulus: float
    hourglass: float
    shortest_squared: float
    corrected: int
    planar: int


@wp.kernel
def settle_volume(
    first: int, froze: wp.array[int], mass: wp.array[float], density: wp.array[float], body_volume: wp.array[float]
):
    """Fix the body volume (n,) [m^3, or m^2 in 2D] of particles that just ``froze`` (Vijaykumar 2012, section 4.2)."""
    i = wp.tid() + first
    if froze[i] != 0:
        body_volume[i] = mass[i] / density[i]


@wp.kernel
def invert_moments(
    first: int,
    elastic: ElasticConstants,
    bonds: BondList,
    body_volume: wp.array[float],
    correction: wp.array[wp.mat33],
):
    """Renew every moment matrix after bonds have changed.

    ``correction`` (n,) is the inverse of the moment matrix of each particle's bonds, the identity where these do not
    span the space.
    """
    i = wp.tid() + first
    if bonds.count[i] > 0:
        moment = wp.mat33()
        for b in range(bonds.count[i]):
            place = i * bonds.capacity + b
            X = bonds.separation[place]
            moment -= wp.outer(X, X) * (body_volume[bonds.partner[place]] * bonds.slope[place])
        if elastic.planar != 0:
            moment[2, 2] = 0.5 * (moment[0, 0] + moment[1, 1])  # between the other two, so that it decides nothing
        _, spread = wp.eig3(moment)
        correction[i] = wp.identity(n=3, dtype=float)
        smallest = wp.min(spread)
        if elastic.corrected != 0 and smallest > wp.max(SMALLEST_MOMENT, WORST_CONDITION * wp.max(spread)):
            correction[i] = wp.inverse(moment)


@wp.func
def deformation_of_bonds(
    bonds: BondList,
    i: int,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    body_volume: wp.array[float],
    correction: wp.array[wp.mat33],
) -> wp.mat33:
    """Deformation gradient of a particle since its bonds were made.

    Vijaykumar (2012), equations (4.6), (4.9), with the displacement gradient corrected by the moment matrix so that a
    turned body feels no force.
    """
    gradient = wp.mat33()
    for b in range(bonds.count[i]):
        place = i * bonds.capacity + b
        j = bonds.partner[place]
        X = bonds.separation[place]
        u_ij = X - precise_difference(position, position_carry, i, j)  # Vijaykumar (4.6)
        gradient += wp.outer(u_ij, X * (body_volume[j] * bonds.slope[place]))  # Vijaykumar (4.9), transposed
    return wp.identity(n=3, dtype=float) + gradient * correction[i]


@wp.kernel
def find_stress(
    first: int,
    elastic: ElasticConstants,
    bonds: BondList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    body_volume: wp.array[float],
    correction: wp.array[wp.mat33],
    settled: wp.array[wp.mat33],
    deformation: wp.array[wp.mat33],
    stress: wp.array[wp.mat33],
):
    """Write the deformation gradient of the bonds and the stress of bonded particles, each (n,).

    Vijaykumar (2012), equations (4.3), (4.5). ``stress`` is the first Piola-Kirchhoff stress [Pa] times the correction,
    as the forces need it.
    """
    i = wp.tid() + first
    if bonds.count[i] > 0:
        of_bonds = deformation_of_bonds(bonds, i, position, position_carry, body_volume, correction)
        F = of_bonds * settled[i]
        identity = wp.identity(n=3, dtype=float)
        strain = 0.5 * (wp.transpose(F) * F - identity)  # Vijaykumar (4.3)
        sigma = 2.0 * elastic.lame_mu * strain + elastic.lame_lambda * wp.trace(strain) * identity  # (4.5)
        deformation[i] = of_bonds
        stress[i] = F * sigma * wp.transpose(settled[i]) * correction[i]


@wp.kernel
def keep_strain(
    first: int,
    bonds: BondList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    body_volume: wp.array[float],
    correction: wp.array[wp.mat33],
    rebonded: wp.array[int],
    deformation: wp.array[wp.mat33],
    settled: wp.array[wp.mat33],
):
    """Let every particle keep its strain where bonds come and go, and what is new be without any.

    ``settled`` (n,) leads from the shape without stress to the one that the bonds count from. Where bonds change, so
    does the gradient over them; the stress must not. It would most of all where a particle has had so few bonds that
    its moment matrix could not be inverted, and now can.
    """
    i = wp.tid() + first
    if rebonded[i] != UNCHANGED:
        now = deformation_of_bonds(bonds, i, position, position_carry, body_volume, correction)
        before = wp.identity(n=3, dtype=float)
        if rebonded[i] == CHANGED:
            before = deformation[i] * settled[i]
        if wp.determinant(now) > SMALLEST_VOLUME:
            settled[i] = wp.inverse(now) * before


@wp.kernel
def add_elastic_forces(
    first: int,
    elastic: ElasticConstants,
    bonds: BondList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    role: wp.array[int],
    mass: wp.array[float],
    body_volume: wp.array[float],
    deformation: wp.array[wp.mat33],
    stress: wp.array[wp.mat33],
    acceleration: wp.array[wp.vec3],
):
    """Add the elastic acceleration of bonded particles to ``acceleration`` (n,) [m/s^2].

    Vijaykumar (2012), equations (4.13), (4.14); zero-energy modes are held down as by Ganzenmueller (2015). Bonds that
    froze under pressure go on bearing it, along their separation as it is deformed on average: along the distance of
    the particles it would feed the zero-energy modes.
    """
    i = wp.tid() + first
    if bonds.count[i] > 0 and role[i] == Role.FREE:
        F_i = deformation[i]
        P_i = stress[i]
        force = wp.vec3()
        pressed = wp.vec3()
        for b in range(bonds.count[i]):
            place = i * bonds.capacity + b
            j = bonds.partner[place]
            X = bonds.separation[place]
            v_j = body_volume[j]
            F_X = (F_i + deformation[j]) * X
            pressed += F_X * (0.5 * bonds.prestress[place])
            # Vijaykumar (4.13), (4.14) as in his pseudo-code 4.4, gathered over both ends of the bond
            force += (P_i + stress[j]) * (X * (v_j * bonds.slope[place]))
            if elastic.hourglass > 0.0:
                # Ganzenmueller (2015), equations 17-20
                x = precise_difference(position, position_carry, i, j)
                miss = wp.dot(F_X - 2.0 * x, x) / (wp.dot(x, x) + 1.0e-20)
                weight = v_j * bonds.value[place] / wp.max(wp.dot(X, X), elastic.shortest_squared)
                force += x * (0.5 * elastic.hourglass * elastic.youngs_modulus * weight * miss)
        acceleration[i] += (force * body_volume[i] + pressed) / mass[i]
