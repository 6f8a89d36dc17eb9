"""Heat conduction between particles and their mirror images behind plane walls."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.heat.conduction import ThermalTable, for_conducting, pair_conductivity, towards
from warpsph.kernels.heat.profiles import Profiles, profile_at
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.struct
class HeatWalls:
    """Planes ``x . normal = offset`` [m] with the body before them, where ``normal`` points.

    ``normal``, ``offset`` (walls,); ``conductance`` [W/(m^2 K)], infinite where the temperature is given, and
    ``outside`` [K], ``flux`` [W/m^2] out of the body, (walls,); ``slack`` [m], by how much a particle may be behind a
    plane and still be taken to stand on it. ``conductance_at``, ``outside_at`` and ``flux_at`` (walls, n), what the
    three are at the place of each particle; the same memory for all particles where no wall has a profile. ``profile``
    (walls, 3), the tables of the three, -1 where there is none; of no length where no wall has any. ``rate`` (walls, n)
    [W] and ``taken`` (walls, n) [J], by the ids of the particles: what each wall takes from each of them, in unit time
    and so far. ``near`` and ``behind`` (n,), a bit for each plane: which stand within the support of a particle, and
    which ones it is behind.
    """

    normal: wp.array[wp.vec3d]
    offset: wp.array[wp.float64]
    conductance: wp.array[float]
    outside: wp.array[float]
    flux: wp.array[float]
    slack: float
    conductance_at: wp.array2d[float]
    outside_at: wp.array2d[float]
    flux_at: wp.array2d[float]
    profile: wp.array2d[int]
    rate: wp.array2d[float]
    taken: wp.array2d[wp.float64]
    near: wp.array[int]
    behind: wp.array[int]


@wp.func
def height(walls: HeatWalls, p: int, x: wp.vec3) -> float:
    """Distance [m] of ``x`` before plane p, in double precision: far from the origin it is a small difference."""
    n = walls.normal[p]
    along = n[0] * wp.float64(x[0]) + n[1] * wp.float64(x[1]) + n[2] * wp.float64(x[2])
    return float(along - walls.offset[p])


@wp.func
def how_many(planes: int) -> int:
    """Number of bits in ``planes``."""
    count = int(0)
    while planes != 0:
        planes = planes & (planes - 1)
        count += 1
    return count


@wp.func
def plane_of(planes: int, rank: int) -> int:
    """The plane whose bit in ``planes`` has ``rank`` others below it."""
    p = int(0)
    while (planes >> p) & 1 == 0 or rank > 0:
        rank -= (planes >> p) & 1
        p += 1
    return p


@wp.func
def with_plane(walls: HeatWalls, chain: wp.vec3i, p: int) -> wp.vec3i:
    """The ``chain`` with plane p before those of a higher conductance and before what stands for none (-1)."""
    longer = wp.vec3i(chain[0], chain[1], chain[2])
    place = int(2)
    while place > 0 and (longer[place - 1] < 0 or walls.conductance[p] < walls.conductance[longer[place - 1]]):
        longer[place] = longer[place - 1]
        place -= 1
    longer[place] = p
    return longer


@wp.func
def chain_of(walls: HeatWalls, number: int, mirrors: int) -> wp.vec3i:
    """One, two or three of the planes ``mirrors`` (bits), in rising order of their conductance; -1 stands for none.

    The order is one for all particles, so it goes by the one conductance of each plane, not by that at their places.
    ``number`` has three digits in the system whose base is the count of planes: ranks a < b < c of planes. Digits aaa
    are the plane a, abb are two planes, abc three; all others give no plane, so that each set comes once.
    """
    count = how_many(mirrors)
    a, b, c = number // (count * count), (number // count) % count, number % count
    chain = wp.vec3i(-1, -1, -1)
    alone, two, three = a == b and b == c, a < b and b == c, a < b and b < c
    if alone or two or three:
        chain = with_plane(walls, chain, plane_of(mirrors, a))
    if two or three:
        chain = with_plane(walls, chain, plane_of(mirrors, b))
    if three:
        chain = with_plane(walls, chain, plane_of(mirrors, c))
    return chain


@wp.func
def passing_share(walls: HeatWalls, p: int, j: int, d: float, k: float) -> float:
    """By which share of what it is warmer than the outside of plane p particle j has an image that is colder than it.

    It has the conductivity ``k`` and stands at the distance ``d`` [m]: 2 where the temperature of the plane is given,
    none where it is insulated.
    """
    h = walls.conductance_at[p, j]
    if h < wp.inf:
        return 2.0 * d * h / (d * h + k)
    return 2.0


@wp.func
def supply(walls: HeatWalls, p: int, j: int, d: float, k: float) -> float:
    """How much warmer [K] the image of particle j behind plane p is for the outside and the flux that are given."""
    return passing_share(walls, p, j, d, k) * walls.outside_at[p, j] - 2.0 * d * walls.flux_at[p, j] / k


@wp.func
def drop_across(walls: HeatWalls, p: int, j: int, T: float, d: float, k: float) -> float:
    """How much colder [K] the image of particle j behind plane p is than what it is an image of: 2 d q / k.

    q is the flux that leaves a body of the temperature ``T`` at the distance ``d`` [m] and of the conductivity ``k``.
    """
    return passing_share(walls, p, j, d, k) * (T - walls.outside_at[p, j]) + 2.0 * d * walls.flux_at[p, j] / k


@wp.func
def behind_walls(walls: HeatWalls, chain: wp.vec3i, j: int, T: float, d: wp.vec3, k: float) -> float:
    """Temperature [K] of the image of particle j in all planes of the ``chain``, at the distances ``d`` [m] from it."""
    image = float(T)
    for m in range(3):
        if chain[m] >= 0:
            image -= drop_across(walls, chain[m], j, image, wp.max(d[m], 0.0), k)
    return image


@wp.func
def number_at(profiles: Profiles, table: int, x: wp.vec3, time: wp.float64, number: float) -> float:
    """The number of a ``table`` at the place ``x`` and the ``time``; the ``number`` itself where there is no table."""
    if table < 0:
        return number
    return profile_at(profiles, table, x, time)


@wp.kernel
def find_walls_near(
    first: int,
    walls: HeatWalls,
    profiles: Profiles,
    table: ThermalTable,
    ago: float,
    time: wp.array[wp.float64],
    position: wp.array[wp.vec3],
    id: wp.array[int],
):
    """Write ``walls.near`` and ``walls.behind`` (n,), and set ``walls.rate`` (walls, n) to zero.

    Where walls have profiles, write the numbers at the place of each particle, too: those of ``ago`` [s] before the
    present ``time`` (1,) [s].
    """
    i = wp.tid() + first
    near, behind = int(0), int(0)
    then = time[0] - wp.float64(ago)
    for p in range(walls.offset.shape[0]):
        h = height(walls, p, position[i])
        if wp.abs(h) < table.support:
            near |= 1 << p
        if h < -walls.slack:
            behind |= 1 << p
        walls.rate[p, id[i]] = 0.0
    for p in range(walls.profile.shape[0]):
        x = position[i]
        walls.conductance_at[p, i] = number_at(profiles, walls.profile[p, 0], x, then, walls.conductance[p])
        walls.outside_at[p, i] = number_at(profiles, walls.profile[p, 1], x, then, walls.outside[p])
        walls.flux_at[p, i] = number_at(profiles, walls.profile[p, 2], x, then, walls.flux[p])
    walls.near[i] = near
    walls.behind[i] = behind


def _add_heat_of_images(slope: wp.Function, sharp: bool) -> Callable[..., None]:
    def add_heat_of_images(
        first: int,
        table: ThermalTable,
        neighbours: NeighbourList,
        walls: HeatWalls,
        position: wp.array[wp.vec3],
        role: wp.array[int],
        temperature: wp.array[float],
        conductivity: wp.array[float],
        solid_fraction: wp.array[float],
        thermal_volume: wp.array[float],
        material: wp.array[int],
        id: wp.array[int],
        heat_rate: wp.array[float],
    ):
        """Add to ``heat_rate`` (n,) [W] what the images behind walls give, and take away what came across a wall.

        The sum of :data:`warpsph.kernels.heat.conduction.SUM_HEAT` goes over the images of the particles, their own
        among them, in one plane, in two and in three at right angles (method of images). The distance to an image is
        r'^2 = r^2 + 4 d_i d_j for each plane, d the distances from it; no image is nearer than the particle itself, so
        the list of neighbours has all. What a particle would give to the other one's image is antisymmetric in the
        pair; the walls take what the image is colder. An image in several planes is that of an image: softest planes
        first, because a wall of given temperature turns the sign of a flux behind it.
        """
        i = wp.tid() + first
        near = walls.near[i]
        if near == 0 or role[i] == Role.RESERVOIR:
            return
        x_i = position[i]
        T_i = temperature[i]
        total = float(0.0)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if role[j] != Role.RESERVOIR and (walls.behind[i] ^ walls.behind[j]) & near != 0:
                d = difference(neighbours, x_i, position[j])
                r_squared = wp.dot(d, d)
                k_i, k_j = float(conductivity[i]), float(conductivity[j])
                if wp.static(sharp):
                    k_i = towards(table, material[i], k_i, solid_fraction[i], T_i - temperature[j])
                    k_j = towards(table, material[j], k_j, solid_fraction[j], temperature[j] - T_i)
                k_pair = pair_conductivity(table, material[i], material[j], k_i, k_j, r_squared)
                weight = k_pair * thermal_volume[j] * slope(r_squared, table.support)
                total -= weight * (T_i - temperature[j])
        factor = 2.0 * table.scale * thermal_volume[i]
        mirrors = near & ~walls.behind[i]
        count = how_many(mirrors)
        chains = count * count * count
        for number in range(chains):
            chain = chain_of(walls, number, mirrors)
            sweep = wp.where(chain[0] >= 0, neighbours.count[i] + 1, 0)
            d_i, normals = wp.vec3(0.0, 0.0, 0.0), wp.mat33(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
            for m in range(3):
                if chain[m] >= 0:
                    d_i[m] = height(walls, chain[m], x_i)
                    for axis in range(3):
                        normals[m, axis] = float(walls.normal[chain[m]][axis])
            taken = wp.vec3(0.0, 0.0, 0.0)
            for k in range(sweep):
                j = int(i)  # last of all its own image
                if k < neighbours.count[i]:
                    j = index_of(entry_of(neighbours, i, k))
                d = difference(neighbours, x_i, position[j])
                d_j = wp.max(d_i - normals * d, wp.vec3(0.0, 0.0, 0.0))
                r_squared = wp.dot(d, d) + 4.0 * wp.dot(wp.max(d_i, wp.vec3(0.0, 0.0, 0.0)), d_j)
                if r_squared < table.support * table.support and (walls.behind[i] ^ walls.behind[j]) & near == 0:
                    k_pair = pair_conductivity(
                        table, material[i], material[j], conductivity[i], conductivity[j], r_squared
                    )
                    if k_pair > 0.0 and role[j] != Role.RESERVOIR:
                        if wp.static(sharp):  # each of the two sees the image of the other
                            colder = T_i - behind_walls(walls, chain, j, temperature[j], d_j, k_pair)
                            k_i = towards(table, material[i], conductivity[i], solid_fraction[i], colder)
                            colder = temperature[j] - behind_walls(walls, chain, i, T_i, d_i, k_pair)
                            k_j = towards(table, material[j], conductivity[j], solid_fraction[j], colder)
                            k_pair = pair_conductivity(table, material[i], material[j], k_i, k_j, r_squared)
                        weight = k_pair * thermal_volume[j] * slope(r_squared, table.support)
                        T = float(temperature[j])
                        for m in range(3):
                            if chain[m] >= 0:
                                drop = drop_across(walls, chain[m], j, T, d_j[m], k_pair)
                                taken[m] = taken[m] - weight * drop
                                T -= drop
                        total += weight * (T_i - T)  # Vijaykumar (3.2)
            for m in range(3):
                if chain[m] >= 0:
                    walls.rate[chain[m], id[i]] += factor * taken[m]
        heat_rate[i] += factor * total

    return add_heat_of_images


ADD_HEAT_OF_IMAGES = {sharp: for_conducting(_add_heat_of_images, "slope", __name__, sharp) for sharp in (False, True)}


@wp.kernel
def count_heat(first: int, interval: float, walls: HeatWalls):
    """Add what walls take in ``interval`` [s] to ``walls.taken``."""
    me = wp.tid() + first
    for p in range(walls.offset.shape[0]):
        if walls.rate[p, me] != 0.0:
            walls.taken[p, me] += wp.float64(walls.rate[p, me] * interval)
