"""Bonds between solid neighbours: made at freezing, cut at melting, each with the separation of that moment."""

import warp as wp

from warpsph.kernels.basics.labels import Phase
from warpsph.kernels.basics.smoothing import sine_slope, sine_value
from warpsph.kernels.neighbours.pairs import (
    NOT_NEGATIVE,
    NeighbourList,
    difference,
    entry_of,
    index_of,
    precise_difference,
)

wp.set_module_options({"enable_backward": False})


# What has become of the bonds of a particle
UNCHANGED = wp.constant(0)
CHANGED = wp.constant(1)
NEW = wp.constant(2)

SMALLEST_VOLUME = wp.constant(0.1)  # over the one at freezing, below which a deformation is not looked at


@wp.struct
class BondList:
    """Rows of bonds: ``count`` (n,), and for each bond (n * capacity,) its ``partner``, its ``separation`` x_i - x_j at
    freezing [m], there the normalised ``slope`` W'/r and ``value`` W of the smoothing kernel, and what it bears besides
    the elastic force, until that has faded: the ``borne`` force on the particle [N], in 2D [N/m], turned back like the
    separation. ``whole`` is the force of the bond while bonds come and go."""

    count: wp.array[int]
    partner: wp.array[int]
    separation: wp.array[wp.vec3]
    slope: wp.array[float]
    value: wp.array[float]
    borne: wp.array[wp.vec3]
    whole: wp.array[wp.vec3]
    capacity: int


@wp.func
def place_of(bonds: BondList, i: int, b: int) -> int:
    """Where bond b of particle i stands."""
    return (i * bonds.capacity + b) & NOT_NEGATIVE


@wp.func
def partner_of(bonds: BondList, place: int) -> int:
    return bonds.partner[place] & NOT_NEGATIVE


@wp.func
def turn_of(deformation: wp.mat33, planar: int) -> wp.mat33:
    """The rotation in a deformation gradient (polar decomposition); none in one that turns a body inside out.

    In the plane nothing may leave it, not even by rounding: no force would bring it back.
    """
    turn = wp.identity(n=3, dtype=float)
    if wp.determinant(deformation) > SMALLEST_VOLUME:
        if planar != 0:
            cosine = deformation[0, 0] + deformation[1, 1]
            sine = deformation[1, 0] - deformation[0, 1]
            length = wp.sqrt(cosine * cosine + sine * sine)
            turn[0, 0] = cosine / length
            turn[1, 1] = cosine / length
            turn[1, 0] = sine / length
            turn[0, 1] = -sine / length
        else:
            U, _, V = wp.svd3(deformation)
            turn = U * wp.transpose(V)
    return turn


@wp.func
def copy_bond(bonds: BondList, source: int, target: BondList, place: int):
    target.partner[place] = bonds.partner[source]
    target.separation[place] = bonds.separation[source]
    target.slope[place] = bonds.slope[source]
    target.value[place] = bonds.value[source]
    target.borne[place] = bonds.borne[source]
    target.whole[place] = bonds.whole[source]


@wp.kernel
def update_bonds(
    first: int,
    reach: float,
    scale: float,
    planar: int,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    body: wp.array[int],
    phase: wp.array[int],
    froze: wp.array[int],
    deformation: wp.array[wp.mat33],
    bonds: BondList,
    rebonded: wp.array[int],
    row_length: wp.array[int],
    longest_bond_row: wp.array[int],
):
    """Cut the bonds of molten particles and bond those that just ``froze`` to their solid neighbours within ``reach``,
    of the same ``body``.

    A particle that freezes later joins a body that has turned: its bonds keep the separation of that moment
    (Vijaykumar 2012, equation 4.6), turned back by the rotation in the ``deformation`` (n,) of both ends to where the
    other bonds count from. ``scale`` normalises the sine kernel, whose support is ``reach`` [m]. ``rebonded`` (n,)
    marks where bonds have come or gone, and where they are the first ones. A row that would overflow is cut;
    ``row_length`` (n,) has the full lengths, and ``longest_bond_row`` (1,) is not zero where one is cut.
    """
    i = wp.tid() + first
    n = int(0)
    kept = int(0)
    if phase[i] == Phase.SOLID:
        row = i * bonds.capacity
        if froze[i] == 0:
            for b in range(bonds.count[i]):
                j = bonds.partner[row + b]
                if phase[j] == Phase.SOLID and froze[j] == 0:
                    copy_bond(bonds, row + b, bonds, row + n)
                    n += 1
        kept = n
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if phase[j] == Phase.SOLID and body[j] == body[i] and (froze[i] != 0 or froze[j] != 0):
                d = precise_difference(neighbours, position, position_carry, i, j)
                if wp.dot(d, d) < reach * reach:
                    if n < bonds.capacity:
                        X = wp.transpose(turn_of(deformation[i] + deformation[j], planar)) * d
                        bonds.partner[row + n] = j
                        bonds.separation[row + n] = X
                        bonds.slope[row + n] = scale * sine_slope(wp.dot(X, X), reach)
                        bonds.value[row + n] = scale * sine_value(wp.dot(X, X), reach)
                        bonds.borne[row + n] = wp.vec3()
                        bonds.whole[row + n] = wp.vec3()
                    n += 1
        if n > bonds.capacity:
            wp.atomic_max(longest_bond_row, 0, n)
    rebonded[i] = UNCHANGED
    if kept == 0:
        rebonded[i] = NEW
    elif kept != n or kept != bonds.count[i]:
        rebonded[i] = CHANGED
    row_length[i] = n
    bonds.count[i] = wp.min(n, bonds.capacity)


@wp.kernel
def join_body(
    first: int,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    phase: wp.array[int],
    froze: wp.array[int],
    deformation: wp.array[wp.mat33],
    body: wp.array[int],
):
    """Let what just ``froze`` join the ``body`` (n,) of the nearest particle that was solid before, if there is one.

    It takes over the ``deformation`` (n,) of that particle: the body has turned where it joins it.
    """
    i = wp.tid() + first
    if froze[i] != 0:
        nearest = float(1.0e30)
        deformation[i] = wp.identity(n=3, dtype=float)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            d = difference(neighbours, position[i], position[j])
            if phase[j] == Phase.SOLID and froze[j] == 0 and wp.dot(d, d) < nearest:
                nearest = wp.dot(d, d)
                body[i] = body[j]
                deformation[i] = deformation[j]


@wp.kernel
def mark_bonded_neighbours(first: int, neighbours: NeighbourList, bonds: BondList):
    """Mark in the neighbour list which pairs are bonded."""
    i = wp.tid() + first
    for k in range(neighbours.count[i]):
        place = i * neighbours.row_stride + k * neighbours.entry_stride
        j = index_of(neighbours.entry[place])
        entry = j
        if bonds.count[i] > 0 and bonds.count[j] > 0:
            for b in range(bonds.count[i]):
                if partner_of(bonds, place_of(bonds, i, b)) == j:
                    entry = -1 - j
        neighbours.entry[place] = entry


@wp.kernel
def move_bonds(first: int, order: wp.array[int], place: wp.array[int], bonds: BondList, target: BondList):
    """Write into ``target`` the rows of bonds in their new ``order``, the partners by their new ``place``."""
    i = wp.tid() + first
    old = order[i]
    for b in range(bonds.count[old]):
        source, there = place_of(bonds, old, b), place_of(target, i, b)
        copy_bond(bonds, source, target, there)
        target.partner[there] = place[partner_of(bonds, source)]
    target.count[i] = bonds.count[old]


@wp.kernel
def copy_bonds(first: int, bonds: BondList, target: BondList):
    """Copy all rows of bonds."""
    i = wp.tid() + first
    target.count[i] = bonds.count[i]
    for b in range(bonds.count[i]):
        there = place_of(bonds, i, b)
        copy_bond(bonds, there, target, there)
