"""Heat conduction between particles and their mirror images behind plane walls."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import poly6_slope
from warpsph.kernels.heat.conduction import ThermalTable, pair_conductivity
from warpsph.kernels.neighbours.pairs import NeighbourList, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.struct
class HeatWalls:
    """Planes ``x . normal = offset`` [m] with the body before them, where ``normal`` points.

    ``normal``, ``offset`` (walls,); ``conductance`` [W/(m^2 K)], infinite where the temperature is given, and
    ``outside`` [K], ``flux`` [W/m^2] out of the body, (walls,); ``slack`` [m], by how much a particle may be behind a
    plane and still be taken to stand on it. ``rate`` (walls, n) [W] and ``taken`` (walls, n) [J], by the ids of the
    particles: what each wall takes from each of them, in unit time and so far.
    """

    normal: wp.array[wp.vec3d]
    offset: wp.array[wp.float64]
    conductance: wp.array[float]
    outside: wp.array[float]
    flux: wp.array[float]
    slack: float
    rate: wp.array2d[float]
    taken: wp.array2d[wp.float64]


@wp.func
def height(walls: HeatWalls, p: int, x: wp.vec3) -> float:
    """Distance [m] of ``x`` before plane p, in double precision: far from the origin it is a small difference."""
    n = walls.normal[p]
    along = n[0] * wp.float64(x[0]) + n[1] * wp.float64(x[1]) + n[2] * wp.float64(x[2])
    return float(along - walls.offset[p])


@wp.func
def near_a_plane(walls: HeatWalls, x: wp.vec3, support: float) -> bool:
    """Whether a plane stands within the support of ``x``, before or behind it."""
    near = bool(False)
    for p in range(walls.offset.shape[0]):
        near = near or wp.abs(height(walls, p, x)) < support
    return near


@wp.func
def same_side(walls: HeatWalls, x: wp.vec3, y: wp.vec3) -> bool:
    """Whether no plane stands between ``x`` and ``y``."""
    same = bool(True)
    for p in range(walls.offset.shape[0]):
        same = same and (height(walls, p, x) < -walls.slack) == (height(walls, p, y) < -walls.slack)
    return same


@wp.func
def mirrors(walls: HeatWalls, p: int, x: wp.vec3, support: float) -> bool:
    """Whether plane p shows ``x`` an image of its neighbours."""
    h = height(walls, p, x)
    return h >= -walls.slack and h < support


@wp.func
def chain_of(walls: HeatWalls, number: int, x: wp.vec3, support: float) -> wp.vec3i:
    """One, two or three planes that show ``x`` images, in rising order of their conductance; -1 stands for none.

    Every set of planes has one ``number`` below the cube of their count; other numbers give no plane at all.
    """
    count = walls.offset.shape[0]
    p = number // (count * count)
    q = (number // count) % count
    r = number % count
    if q < p or r < q or (q == p and r > q) or not mirrors(walls, p, x, support):
        return wp.vec3i(-1, -1, -1)
    if (q > p and not mirrors(walls, q, x, support)) or (r > q and not mirrors(walls, r, x, support)):
        return wp.vec3i(-1, -1, -1)
    if q > p and walls.conductance[q] < walls.conductance[p]:
        softer, stiffer = q, p
    else:
        softer, stiffer = p, q
    if q == p:
        return wp.vec3i(p, -1, -1)
    if r == q:
        return wp.vec3i(softer, stiffer, -1)
    if walls.conductance[r] < walls.conductance[softer]:
        return wp.vec3i(r, softer, stiffer)
    if walls.conductance[r] < walls.conductance[stiffer]:
        return wp.vec3i(softer, r, stiffer)
    return wp.vec3i(softer, stiffer, r)


@wp.func
def drop_across(walls: HeatWalls, p: int, T: float, d: float, k: float) -> float:
    """How much colder [K] the image behind plane p is than what it is an image of: 2 d q / k.

    q is the flux that leaves a body of the temperature ``T`` at the distance ``d`` [m] and of the conductivity ``k``.
    """
    h = walls.conductance[p]
    share = float(2.0)
    if not wp.isinf(h):
        share = 2.0 * d * h / (d * h + k)
    return share * (T - walls.outside[p]) + 2.0 * d * walls.flux[p] / k


@wp.kernel
def sum_heat_between_walls(
    first: int,
    table: ThermalTable,
    neighbours: NeighbourList,
    walls: HeatWalls,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    temperature: wp.array[float],
    conductivity: wp.array[float],
    thermal_volume: wp.array[float],
    material: wp.array[int],
    id: wp.array[int],
    heat_rate: wp.array[float],
):
    """Write the heat that flows into each particle, ``heat_rate`` (n,) [W], and what each wall takes of it.

    As :func:`warpsph.kernels.heat.conduction.sum_heat`, and the same sum over the images of the particles, their own
    among them, in one plane, in two and in three at right angles (method of images). The distance to an image is
    r'^2 = r^2 + 4 d_i d_j for each plane, d the distances from it; no image is nearer than the particle itself, so the
    list of neighbours has all. What a particle would give to the other one's image is antisymmetric in the pair; the
    walls take what the image is colder. An image in several planes is that of an image: softest planes first, because
    a wall of given temperature turns the sign of a flux behind it.
    """
    i = wp.tid() + first
    x_i = position[i]
    T_i = temperature[i]
    me = id[i]
    count = walls.offset.shape[0]
    for p in range(count):
        walls.rate[p, me] = 0.0
    total = float(0.0)
    near = near_a_plane(walls, x_i, table.support)
    for k in range(neighbours.count[i]):
        j = index_of(entry_of(neighbours, i, k))
        if role[j] != Role.RESERVOIR and (not near or same_side(walls, x_i, position[j])):
            d = x_i - position[j]
            r_squared = wp.dot(d, d)
            k_pair = pair_conductivity(table, material[i], material[j], conductivity[i], conductivity[j], r_squared)
            weight = k_pair * thermal_volume[j] * poly6_slope(r_squared, table.support)
            total += weight * (T_i - temperature[j])  # Vijaykumar (3.2)
    factor = 2.0 * table.scale * thermal_volume[i]
    chains = wp.where(near and role[i] != Role.RESERVOIR, count * count * count, 0)
    for number in range(chains):
        chain = chain_of(walls, number, x_i, table.support)
        sweep = wp.where(chain[0] >= 0, neighbours.count[i] + 1, 0)
        taken = wp.vec3(0.0, 0.0, 0.0)
        for k in range(sweep):
            j = int(i)  # last of all its own image
            if k < neighbours.count[i]:
                j = index_of(entry_of(neighbours, i, k))
            if role[j] != Role.RESERVOIR and same_side(walls, x_i, position[j]):
                d = x_i - position[j]
                r_squared = wp.dot(d, d)
                d_j = wp.vec3(0.0, 0.0, 0.0)
                for m in range(3):
                    if chain[m] >= 0:
                        d_j[m] = wp.max(height(walls, chain[m], position[j]), 0.0)
                        r_squared += 4.0 * wp.max(height(walls, chain[m], x_i), 0.0) * d_j[m]
                k_pair = pair_conductivity(table, material[i], material[j], conductivity[i], conductivity[j], r_squared)
                if k_pair > 0.0:
                    T = float(temperature[j])
                    drops = wp.vec3(0.0, 0.0, 0.0)
                    for m in range(3):
                        if chain[m] >= 0:
                            drops[m] = drop_across(walls, chain[m], T, d_j[m], k_pair)
                            T -= drops[m]
                    weight = k_pair * thermal_volume[j] * poly6_slope(r_squared, table.support)
                    total += weight * (T_i - T)
                    taken -= weight * drops
        for m in range(3):
            if chain[m] >= 0:
                walls.rate[chain[m], me] += factor * taken[m]
    heat_rate[i] = factor * total


@wp.kernel
def count_heat(first: int, interval: float, walls: HeatWalls, id: wp.array[int]):
    """Add what each wall takes of each particle in ``interval`` [s] to ``walls.taken``."""
    me = id[wp.tid() + first]
    for p in range(walls.offset.shape[0]):
        if walls.rate[p, me] != 0.0:
            walls.taken[p, me] += wp.float64(walls.rate[p, me] * interval)
