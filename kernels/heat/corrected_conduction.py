"""Conduction between the disordered particles of a flow: sums over neighbours and images, mended by a moment matrix."""

import warp as wp

from warpsph.kernels.basics.compensation import compensated_sum
from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import wendland_c2_slope
from warpsph.kernels.heat.conduction import ThermalTable, pair_conductivity
from warpsph.kernels.heat.walls import HeatWalls, behind_walls, chain_of, drop_across, height, how_many
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})

SMALLEST_DETERMINANT = wp.constant(0.3)  # of a moment matrix that is inverted
SMALLEST_MEAN = wp.constant(0.3)  # of the mean of its diagonal, by which is divided
NEAREST = wp.constant(1.0e-6)  # distance squared over that of the support, so that nothing is divided by zero


@wp.struct
class HeatWeights:
    """How pairs are weighted: ``anisotropy`` k of the weight, and the ``dimension``."""

    anisotropy: float
    dimension: int


@wp.func
def walls_before(walls: HeatWalls, i: int) -> int:
    """The planes, a bit each, behind which particle i has an image."""
    if walls.offset.shape[0] == 0:
        return 0
    return walls.near[i] & ~walls.behind[i]


@wp.func
def same_side(walls: HeatWalls, i: int, j: int) -> bool:
    """Whether no wall near particle i stands between it and particle j."""
    if walls.offset.shape[0] == 0:
        return True
    return (walls.behind[i] ^ walls.behind[j]) & walls.near[i] == 0


@wp.func
def chain_number(walls: HeatWalls, number: int, mirrors: int) -> wp.vec3i:
    """The planes of the images of a ``number``: none for 0, for which the particles stand themselves."""
    if number == 0:
        return wp.vec3i(-1, -1, -1)
    return chain_of(walls, number - 1, mirrors)


@wp.func
def normals_of(walls: HeatWalls, chain: wp.vec3i) -> wp.mat33:
    """Unit normals of the planes of a ``chain`` as rows, zero where there is no plane."""
    normals = wp.mat33()
    for m in range(3):
        if chain[m] >= 0:
            for axis in range(3):
                normals[m, axis] = float(walls.normal[chain[m]][axis])
    return normals


@wp.func
def heights_of(walls: HeatWalls, chain: wp.vec3i, x: wp.vec3) -> wp.vec3:
    """Distances [m] of ``x`` before the planes of a ``chain``, not below zero."""
    heights = wp.vec3()
    for m in range(3):
        if chain[m] >= 0:
            heights[m] = wp.max(height(walls, chain[m], x), 0.0)
    return heights


@wp.func
def mean_of(weights: HeatWeights, M: wp.mat33) -> float:
    """Mean of the diagonal of a moment matrix, which is 1 on the lattice."""
    trace = M[0, 0] + M[1, 1]
    if weights.dimension == 3:
        trace += M[2, 2]
    return wp.max(trace / float(weights.dimension), SMALLEST_MEAN)


@wp.func
def weight_of(weights: HeatWeights, M: wp.mat33, d: wp.vec3, r_squared: float) -> float:
    """Weight of a pair at the distance ``d`` [m] that mends the second derivatives of a particle with the moments M.

    (1 - k n . dev(M) n) / mean(M), n the direction of the pair, exact to first order in what M differs from isotropy.
    """
    mean = mean_of(weights, M)
    return (1.0 - weights.anisotropy * (wp.dot(d, M * d) / r_squared - mean)) / mean


@wp.kernel
def find_temperature_gradient(
    first: int,
    table: ThermalTable,
    heat_weights: HeatWeights,
    neighbours: NeighbourList,
    walls: HeatWalls,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    temperature: wp.array[float],
    conductivity: wp.array[float],
    thermal_volume: wp.array[float],
    material: wp.array[int],
    heat_moment: wp.array[wp.mat33],
    temperature_gradient: wp.array[wp.vec3],
):
    """Write the moment matrix (n,) of the neighbours that conduct and of the images, and the gradient (n,) [K/m].

    M = -sum V x_ij x_ij W'/r; the gradient is corrected by its inverse (Bonet & Lok 1999).
    """
    i = wp.tid() + first
    k_i = conductivity[i]
    M = wp.mat33()
    rise = wp.vec3()
    if role[i] != Role.RESERVOIR and k_i > 0.0:
        x_i = position[i]
        mirrors = walls_before(walls, i)
        count = how_many(mirrors)
        for number in range(count * count * count + 1):
            chain = chain_number(walls, number, mirrors)
            images = chain[0] >= 0
            sweep = wp.where(number == 0 or images, neighbours.count[i], 0) + wp.where(images, 1, 0)
            normals, d_i = normals_of(walls, chain), heights_of(walls, chain, x_i)
            for k in range(sweep):
                j = int(i)  # last of all its own image
                if k < neighbours.count[i]:
                    j = index_of(entry_of(neighbours, i, k))
                d = difference(neighbours, x_i, position[j])
                d_j = wp.max(d_i - normals * d, wp.vec3())
                way = d + wp.transpose(normals) * d_j * 2.0
                r_squared = wp.dot(way, way)
                if r_squared < table.support * table.support and role[j] != Role.RESERVOIR and same_side(walls, i, j):
                    k_pair = pair_conductivity(table, material[i], material[j], k_i, conductivity[j], r_squared)
                    if k_pair > 0.0:
                        T = behind_walls(walls, chain, j, temperature[j], d_j, k_pair)
                        slope = wendland_c2_slope(r_squared, table.support)
                        V_grad_W = way * (table.scale * thermal_volume[j] * slope)
                        M -= wp.outer(way, V_grad_W)
                        rise += V_grad_W * (T - temperature[i])
    if heat_weights.dimension == 2:
        M[2, 2] = 1.0
    if wp.determinant(M) > SMALLEST_DETERMINANT:
        rise = wp.inverse(M) * rise
    heat_moment[i] = M
    temperature_gradient[i] = rise


@wp.kernel
def sum_corrected_heat(
    first: int,
    table: ThermalTable,
    heat_weights: HeatWeights,
    neighbours: NeighbourList,
    walls: HeatWalls,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    temperature: wp.array[float],
    conductivity: wp.array[float],
    thermal_volume: wp.array[float],
    material: wp.array[int],
    id: wp.array[int],
    heat_moment: wp.array[wp.mat33],
    heat_rate: wp.array[float],
):
    """Write the heat that flows into each particle, ``heat_rate`` (n,) [W] (per metre of depth in 2D).

    Vijaykumar (2012), equation (3.2), each pair weighted by the mean of what its two particles ask for, so that what
    one gains the other loses. Images behind walls, and what walls take, as in
    :data:`warpsph.kernels.heat.walls.ADD_HEAT_OF_IMAGES`.
    """
    i = wp.tid() + first
    k_i = conductivity[i]
    M_i = heat_moment[i]
    total = float(0.0)
    factor = 2.0 * table.scale * thermal_volume[i]
    if role[i] != Role.RESERVOIR and k_i > 0.0:
        x_i = position[i]
        mirrors = walls_before(walls, i)
        count = how_many(mirrors)
        for number in range(count * count * count + 1):
            chain = chain_number(walls, number, mirrors)
            images = chain[0] >= 0
            sweep = wp.where(number == 0 or images, neighbours.count[i], 0) + wp.where(images, 1, 0)
            normals, d_i = normals_of(walls, chain), heights_of(walls, chain, x_i)
            taken = wp.vec3()
            for k in range(sweep):
                j = int(i)
                if k < neighbours.count[i]:
                    j = index_of(entry_of(neighbours, i, k))
                d = difference(neighbours, x_i, position[j])
                d_j = wp.max(d_i - normals * d, wp.vec3())
                way = d + wp.transpose(normals) * d_j * 2.0
                r_squared = wp.dot(way, way)
                if r_squared < table.support * table.support and role[j] != Role.RESERVOIR and same_side(walls, i, j):
                    k_pair = pair_conductivity(table, material[i], material[j], k_i, conductivity[j], r_squared)
                    if k_pair > 0.0:
                        r_squared = wp.max(r_squared, NEAREST * table.support * table.support)
                        mirrored = way - wp.transpose(normals) * (normals * way) * 2.0  # as the image sees it
                        w = weight_of(heat_weights, M_i, way, r_squared)
                        w = 0.5 * (w + weight_of(heat_weights, heat_moment[j], mirrored, r_squared))
                        weight = w * k_pair * thermal_volume[j] * wendland_c2_slope(r_squared, table.support)
                        T = float(temperature[j])
                        for m in range(3):
                            if chain[m] >= 0:
                                drop = drop_across(walls, chain[m], j, T, d_j[m], k_pair)
                                taken[m] = taken[m] - weight * drop
                                T -= drop
                        total += weight * (temperature[i] - T)  # Vijaykumar (3.2)
            for m in range(3):
                if chain[m] >= 0:
                    walls.rate[chain[m], id[i]] += factor * taken[m]
    heat_rate[i] = factor * total


@wp.func
def heat_capacity(table: ThermalTable, material: int, enthalpy: float) -> float:
    """Slope [J/(kg K)] of the enthalpy curve; 0 where latent heat passes at one temperature."""
    segment = int(0)
    last = table.enthalpy.shape[1] - 2
    while segment < last and enthalpy > table.enthalpy[material, segment + 1]:
        segment += 1
    rise = table.temperature[material, segment + 1] - table.temperature[material, segment]
    if rise <= 0.0:
        return 0.0
    return (table.enthalpy[material, segment + 1] - table.enthalpy[material, segment]) / rise


@wp.kernel
def carry_heat(
    first: int,
    dt: float,
    table: ThermalTable,
    role: wp.array[int],
    held: wp.array[int],
    material: wp.array[int],
    shift_velocity: wp.array[wp.vec3],
    temperature_gradient: wp.array[wp.vec3],
    enthalpy: wp.array[float],
    enthalpy_carry: wp.array[float],
):
    """Add to the enthalpy (n,) [J/kg] of free particles what it is more at the place to which they are shifted."""
    i = wp.tid() + first
    if role[i] == Role.FREE and held[i] == 0:
        warmer = wp.dot(shift_velocity[i], temperature_gradient[i]) * dt
        h, carry = compensated_sum(
            enthalpy[i], warmer * heat_capacity(table, material[i], enthalpy[i]), enthalpy_carry[i]
        )
        enthalpy[i] = h
        enthalpy_carry[i] = carry
