"""Elastic forces of bonded particles: Green-Saint-Venant strain, Hooke's law, and hourglass control."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.neighbours.pairs import NeighbourList, precise_difference
from warpsph.kernels.solid.bonds import BondList, partner_of, place_of, turn_of
from warpsph.kernels.solid.strain import ElasticConstants, gradient_of_bonds

wp.set_module_options({"enable_backward": False})


@wp.kernel
def settle_volume(
    first: int,
    reference_density: float,
    froze: wp.array[int],
    mass: wp.array[float],
    density: wp.array[float],
    body_volume: wp.array[float],
):
    """Fix the body volume (n,) [m^3, or m^2 in 2D] of particles that just ``froze`` (Vijaykumar 2012, section 4.2).

    The melt is never thinner than its ``reference_density`` [kg/m^3]: what its density lacks at a free surface are the
    neighbours that are not there. A volume as large as that, up to eightfold, would make the particle
    as much stiffer.
    """
    i = wp.tid() + first
    if froze[i] != 0:
        body_volume[i] = mass[i] / wp.max(density[i], reference_density)


@wp.kernel
def find_stress(
    first: int,
    elastic: ElasticConstants,
    bonds: BondList,
    neighbours: NeighbourList,
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
        gradient = gradient_of_bonds(bonds, i, neighbours, position, position_carry, body_volume)
        identity = wp.identity(n=3, dtype=float)
        of_bonds = identity + gradient * correction[i]
        F = of_bonds * settled[i]
        strain = 0.5 * (wp.transpose(F) * F - identity)  # Vijaykumar (4.3)
        sigma = 2.0 * elastic.lame_mu * strain + elastic.lame_lambda * wp.trace(strain) * identity  # (4.5)
        deformation[i] = of_bonds
        stress[i] = F * sigma * wp.transpose(settled[i]) * correction[i]


@wp.func
def force_of_bond(
    elastic: ElasticConstants,
    bonds: BondList,
    place: int,
    x: wp.vec3,
    v_j: float,
    F_X: wp.vec3,
    P_ij: wp.mat33,
) -> wp.vec3:
    """Force of a bond that is ``x`` long [m] over the volume of particle i [N/m^3].

    Args:
        F_X: the separation, deformed by both ends and added.
        P_ij: stresses of both ends, added [Pa].
    """
    X = bonds.separation[place]
    # Vijaykumar (4.13), (4.14) as in his pseudo-code 4.4, gathered over both ends of the bond
    force = P_ij * (X * (v_j * bonds.slope[place]))
    if elastic.hourglass > 0.0:
        # Ganzenmueller (2015), equations 17-20
        miss = wp.dot(F_X - 2.0 * x, x) / (wp.dot(x, x) + 1.0e-20)
        weight = v_j * bonds.value[place] / wp.max(wp.dot(X, X), elastic.shortest_squared)
        force += x * (0.5 * elastic.hourglass * elastic.youngs_modulus * weight * miss)
    return force


@wp.func
def borne_force(bonds: BondList, place: int, F: wp.mat33, planar: int) -> wp.vec3:
    """What a bond bears besides its elastic force [N], turned as the deformations of both ends, added, have turned."""
    force = bonds.borne[place]
    if wp.length_sq(force) > 0.0:
        force = turn_of(F, planar) * force
    return force


@wp.kernel
def add_elastic_forces(
    first: int,
    elastic: ElasticConstants,
    bonds: BondList,
    neighbours: NeighbourList,
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

    Vijaykumar (2012), equations (4.13), (4.14); zero-energy modes are held down as by Ganzenmueller (2015). What bonds
    bear besides turns with them: along the distance of the particles it would feed the zero-energy modes.
    """
    i = wp.tid() + first
    if bonds.count[i] > 0 and role[i] == Role.FREE:
        F_i = deformation[i]
        P_i = stress[i]
        force = wp.vec3()
        borne = wp.vec3()
        for b in range(bonds.count[i]):
            place = place_of(bonds, i, b)
            j = partner_of(bonds, place)
            F = F_i + deformation[j]
            x = precise_difference(neighbours, position, position_carry, i, j)
            force += force_of_bond(
                elastic, bonds, place, x, body_volume[j], F * bonds.separation[place], P_i + stress[j]
            )
            borne += borne_force(bonds, place, F, elastic.planar)
        acceleration[i] += (force * body_volume[i] + borne) / mass[i]
