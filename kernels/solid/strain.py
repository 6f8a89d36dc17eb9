"""The deformation that bonds measure, and the strain that is kept where they come and go."""

import warp as wp

from warpsph.kernels.neighbours.pairs import NeighbourList, precise_difference
from warpsph.kernels.solid.bonds import CHANGED, SMALLEST_VOLUME, UNCHANGED, BondList, partner_of, place_of

wp.set_module_options({"enable_backward": False})

# Of the eigenvalues of a moment matrix, which are 1 inside a body: the smallest over the largest, 0.3 in a corner of a
# cube, 0 in a row or a pair.
WORST_CONDITION = wp.constant(0.1)


@wp.struct
class ElasticConstants:
    """Constants of the elastic solid.

    ``lame_lambda``, ``lame_mu``, ``youngs_modulus`` [Pa]; ``hourglass`` strength of the hourglass control, and
    ``shortest_squared`` [m^2] the square of the length below which a bond gets no stiffer by it;
    ``highest_frequency_squared`` [1/s^2] the square of the angular frequency at which the strain of one particle may
    swing; ``corrected`` 1 where gradients are corrected by the moment matrix, 0 for the form as published; ``planar`` 1
    in 2D, where the moment matrix has no third row.
    """

    lame_lambda: float
    lame_mu: float
    youngs_modulus: float
    hourglass: float
    shortest_squared: float
    highest_frequency_squared: float
    corrected: int
    planar: int


@wp.func
def moment_of_bonds(bonds: BondList, i: int, planar: int, body_volume: wp.array[float]) -> wp.mat33:
    """Moment matrix of a particle's bonds; in the plane its third row is of no weight."""
    moment = wp.mat33()
    for b in range(bonds.count[i]):
        place = place_of(bonds, i, b)
        X = bonds.separation[place]
        moment -= wp.outer(X, X) * (body_volume[partner_of(bonds, place)] * bonds.slope[place])
    if planar != 0:
        moment[2, 2] = 0.5 * (moment[0, 0] + moment[1, 1])  # between the other two, so that it decides nothing
    return moment


@wp.func
def inverse_of_moment(moment: wp.mat33) -> wp.mat33:
    """The correction by a moment matrix: its inverse, the identity where the bonds do not span the space."""
    _, spread = wp.eig3(moment)
    correction = wp.identity(n=3, dtype=float)
    if wp.min(spread) > WORST_CONDITION * wp.max(spread):
        correction = wp.inverse(moment)
    return correction


@wp.func
def gradient_of_bonds(
    bonds: BondList,
    i: int,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    body_volume: wp.array[float],
) -> wp.mat33:
    """Displacement gradient of a particle since its bonds were made, not corrected by the moment matrix.

    Vijaykumar (2012), equations (4.6), (4.9), transposed.
    """
    gradient = wp.mat33()
    for b in range(bonds.count[i]):
        place = place_of(bonds, i, b)
        j = partner_of(bonds, place)
        X = bonds.separation[place]
        u_ij = X - precise_difference(neighbours, position, position_carry, i, j)  # Vijaykumar (4.6)
        gradient += wp.outer(u_ij, X * (body_volume[j] * bonds.slope[place]))  # Vijaykumar (4.9), transposed
    return gradient


@wp.func
def can_bear(
    bonds: BondList,
    i: int,
    body_volume: wp.array[float],
    stiffest: float,
    correction: wp.mat33,
    now: wp.mat33,
    before: wp.mat33,
) -> bool:
    """Whether a particle is not too stiff when it keeps the deformation ``before`` where the bonds show ``now``.

    Its stiffness [1/m^2], to be below ``stiffest``, is the largest eigenvalue of what joins the velocity of its bonds'
    ends, and of itself, to the growth of its deformation. Bonds that were not in a row when they were made may be so
    in the shape without stress, to which ``before`` and ``now`` lead.
    """
    if wp.determinant(now) <= SMALLEST_VOLUME:
        return False
    to_gradient = wp.transpose(correction * wp.inverse(now) * before)
    whole = wp.vec3()
    square = wp.mat33()
    for b in range(bonds.count[i]):
        place = place_of(bonds, i, b)
        d = to_gradient * bonds.separation[place] * (body_volume[partner_of(bonds, place)] * bonds.slope[place])
        whole += d
        square += wp.outer(d, d)
    _, stiffness = wp.eig3(square + wp.outer(whole, whole))
    return wp.max(stiffness) < stiffest


@wp.kernel
def keep_strain(
    first: int,
    elastic: ElasticConstants,
    bonds: BondList,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    mass: wp.array[float],
    body_volume: wp.array[float],
    rebonded: wp.array[int],
    deformation: wp.array[wp.mat33],
    correction: wp.array[wp.mat33],
    settled: wp.array[wp.mat33],
):
    """Let every particle keep its strain where bonds come and go, and what is new be without any.

    ``correction`` (n,) is the inverse of the moment matrix of each particle's bonds, the identity where these do not
    span the space. ``settled`` (n,) leads from the shape without stress to the one that the bonds count from. Where
    bonds change, so does the gradient over them; the stress must not. It would most of all where a particle has had so
    few bonds that its moment matrix could not be inverted, and now can.

    A particle that the inverse would make swing faster than the time step bears has the identity too; where it would
    with that, the ``correction`` is zero: it forgets its strain and bears no stress until its bonds change again.
    """
    i = wp.tid() + first
    if rebonded[i] != UNCHANGED and bonds.count[i] > 0:
        identity = wp.identity(n=3, dtype=float)
        before = wp.identity(n=3, dtype=float)
        if rebonded[i] == CHANGED:
            before = deformation[i] * settled[i]
        gradient = gradient_of_bonds(bonds, i, neighbours, position, position_carry, body_volume)
        modulus = elastic.lame_lambda + 2.0 * elastic.lame_mu
        stiffest = elastic.highest_frequency_squared * mass[i] / (modulus * body_volume[i])
        C = wp.identity(n=3, dtype=float)
        if elastic.corrected != 0:
            C = inverse_of_moment(moment_of_bonds(bonds, i, elastic.planar, body_volume))
        if not can_bear(bonds, i, body_volume, stiffest, C, identity + gradient * C, before):
            C = wp.identity(n=3, dtype=float)
            if not can_bear(bonds, i, body_volume, stiffest, C, identity + gradient, before):
                C = wp.mat33()
                before = wp.identity(n=3, dtype=float)
        correction[i] = C
        settled[i] = wp.inverse(identity + gradient * C) * before
