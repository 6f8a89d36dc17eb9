"""Conduction as a linear system: how the heat that each particle gains depends on all temperatures, a row each."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.heat.conduction import ThermalTable, for_conducting, pair_conductivity, towards
from warpsph.kernels.heat.walls import HeatWalls, behind_walls, chain_of, height, how_many, passing_share, supply
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.struct
class HeatRows:
    """Rows of the heat [W] that unknown temperatures gain (per metre of depth in 2D).

    There are ``families`` times n unknowns, that of particle i in family f at f n + i: one family in a body that
    conducts; two where liquid and ice at the same place have temperatures of their own. Row u says
    ``sum_k beside[k] T_j + here[u] T_other - diagonal[u] T_u + source[u]``: ``beside`` [W/K], one block for each pair
    of families, addressed like the neighbour list; ``here`` [W/K] (2 n,), of the other family at the same place;
    ``diagonal`` [W/K] and ``source`` [W]. Of what particle i loses, wall p takes ``to_wall[p, i] T_i +
    wall_source[p, i]`` [W], (walls, n). All but ``beside`` in float64. Between walls that do not mirror what is before
    them to a colder image the rows are symmetric.
    """

    families: int
    beside: wp.array[float]
    here: wp.array[wp.float64]
    diagonal: wp.array[wp.float64]
    source: wp.array[wp.float64]
    to_wall: wp.array2d[wp.float64]
    wall_source: wp.array2d[wp.float64]


@wp.func
def heat_gained(rows: HeatRows, neighbours: NeighbourList, T: wp.array[wp.float64], u: int) -> wp.float64:
    """What unknown u gains without the source, for temperatures ``T`` [K] or changes of them."""
    n = neighbours.count.shape[0]
    family = u // n
    i = u - family * n
    total = -rows.diagonal[u] * T[u]
    if rows.families == 2:
        total += rows.here[u] * T[(1 - family) * n + i]
    block = family * rows.families * neighbours.entry.shape[0]
    for k in range(neighbours.count[i]):
        at = i * neighbours.row_stride + k * neighbours.entry_stride
        j = index_of(neighbours.entry[at])
        for other in range(rows.families):
            total += wp.float64(rows.beside[block + other * neighbours.entry.shape[0] + at]) * T[other * n + j]
    return total


def _find_rows(slope: wp.Function, sharp: bool) -> Callable[..., None]:
    def find_rows(
        first: int,
        table: ThermalTable,
        neighbours: NeighbourList,
        walls: HeatWalls,
        rows: HeatRows,
        position: wp.array[wp.vec3],
        role: wp.array[int],
        temperature: wp.array[float],
        conductivity: wp.array[float],
        solid_fraction: wp.array[float],
        thermal_volume: wp.array[float],
        material: wp.array[int],
    ):
        """Write the rows of what :data:`SUM_HEAT` and :data:`ADD_HEAT_OF_IMAGES` sum, for the present conductivities.

        Rook, Yildiz & Dost (2007), equation (16), times the volume, which makes it symmetric. What an image is colder
        than its particle depends on that alone: so a wall takes from each particle what all others see its images
        short of.
        """
        i = wp.tid() + first
        near, mirrors = int(0), int(0)
        for p in range(walls.offset.shape[0]):
            near = walls.near[i]
            mirrors = near & ~walls.behind[i]
            rows.to_wall[p, i] = wp.float64(0.0)
            rows.wall_source[p, i] = wp.float64(0.0)
        count = how_many(mirrors)
        chains = count * count * count
        x_i, T_i = position[i], temperature[i]
        diagonal, source = wp.float64(0.0), wp.float64(0.0)
        for k in range(neighbours.count[i] + wp.where(mirrors != 0, 1, 0)):
            j = int(i)  # last of all its own image
            if k < neighbours.count[i]:
                j = index_of(entry_of(neighbours, i, k))
            meets = role[i] != Role.RESERVOIR and role[j] != Role.RESERVOIR
            if near != 0:
                meets = meets and (walls.behind[i] ^ walls.behind[j]) & near == 0
            whole, beside, mirrored = wp.float64(0.0), wp.float64(0.0), wp.float64(0.0)
            d = difference(neighbours, x_i, position[j])
            factor = -2.0 * table.scale * (thermal_volume[i] * thermal_volume[j])
            if meets and k < neighbours.count[i]:
                r_squared = wp.dot(d, d)
                k_i, k_j = float(conductivity[i]), float(conductivity[j])
                if wp.static(sharp):
                    k_i = towards(table, material[i], k_i, solid_fraction[i], T_i - temperature[j])
                    k_j = towards(table, material[j], k_j, solid_fraction[j], temperature[j] - T_i)
                k_pair = pair_conductivity(table, material[i], material[j], k_i, k_j, r_squared)
                whole = wp.float64(factor * (k_pair * slope(r_squared, table.support)))
                beside = whole
                mirrored = whole
            for number in range(wp.where(meets, chains, 0)):
                chain = chain_of(walls, number, mirrors)
                d_i, d_j = wp.vec3(0.0, 0.0, 0.0), wp.vec3(0.0, 0.0, 0.0)
                for m in range(3):
                    if chain[m] >= 0:
                        d_i[m] = wp.max(height(walls, chain[m], x_i), 0.0)
                        d_j[m] = wp.max(height(walls, chain[m], position[j]), 0.0)
                r_squared = wp.dot(d, d) + 4.0 * wp.dot(d_i, d_j)
                if chain[0] >= 0 and r_squared < table.support * table.support:
                    k_i, k_j = float(conductivity[i]), float(conductivity[j])
                    k_pair = pair_conductivity(table, material[i], material[j], k_i, k_j, r_squared)
                    if k_pair > 0.0:
                        if wp.static(sharp):
                            colder = T_i - behind_walls(walls, chain, j, temperature[j], d_j, k_pair)
                            k_i = towards(table, material[i], k_i, solid_fraction[i], colder)
                            colder = temperature[j] - behind_walls(walls, chain, i, T_i, d_i, k_pair)
                            k_j = towards(table, material[j], k_j, solid_fraction[j], colder)
                            k_pair = pair_conductivity(table, material[i], material[j], k_i, k_j, r_squared)
                        weight = wp.float64(factor * (k_pair * slope(r_squared, table.support)))
                        # the image of j has the temperature passed T_j + rest, that of i mine T_i + mine_rest
                        passed, rest = wp.float64(1.0), wp.float64(0.0)
                        mine, mine_rest = wp.float64(1.0), wp.float64(0.0)
                        for m in range(3):
                            if chain[m] >= 0:
                                p = chain[m]
                                there = wp.float64(passing_share(walls, p, j, d_j[m], k_pair))
                                passed -= there * passed
                                rest -= there * rest - wp.float64(supply(walls, p, j, d_j[m], k_pair))
                                here = wp.float64(passing_share(walls, p, i, d_i[m], k_pair))
                                taken = here * mine_rest - wp.float64(supply(walls, p, i, d_i[m], k_pair))
                                rows.to_wall[p, i] += weight * here * mine
                                rows.wall_source[p, i] += weight * taken
                                mine -= here * mine
                                mine_rest -= taken
                        whole += weight
                        beside += weight * passed
                        mirrored += weight * mine
                        source += weight * rest
            if k < neighbours.count[i]:
                rows.beside[i * neighbours.row_stride + k * neighbours.entry_stride] = float(beside)
                diagonal += wp.float64(float(mirrored)) + (whole - mirrored)  # what the row of j rounds is not lost
            else:
                diagonal += whole - beside
        rows.diagonal[i] = diagonal
        rows.source[i] = source

    return find_rows


FIND_ROWS = {sharp: for_conducting(_find_rows, "slope", __name__, sharp) for sharp in (False, True)}
