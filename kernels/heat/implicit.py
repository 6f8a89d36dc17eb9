"""Implicit steps of conduction: the equations that the end of a step fulfils, and Newton's method for them.

All in double precision: within a step that is much longer than the explicit one, the last digits of single precision
would flow back and forth many times. Indices are those of the unknowns of :class:`HeatRows`.
"""

import warp as wp

from warpsph.kernels.heat.rows import HeatRows, heat_gained
from warpsph.kernels.neighbours.pairs import NeighbourList

wp.set_module_options({"enable_backward": False, "fast_math": False})

STILL = wp.constant(wp.float64(-1.0))  # in the place of a heat capacity: a temperature that does not change


@wp.struct
class ImplicitStep:
    """What a step is solved with, an entry for each unknown, float64.

    ``heat`` [J], ``temperature`` [K], those of the begin of the step first and of its end when it is solved; ``begun``
    [J], the heat at the begin; ``supply`` [W], what sources bring; ``capacity`` [J/K], by how much heat changes with
    temperature, infinite where latent heat passes and :data:`STILL` where the temperature is held. ``known`` [J], the
    heat at the end as far as it does not depend on it; ``moved`` [J], what has come since the begin; ``rest`` [J], by
    how much the equations are not fulfilled; ``terms`` [J], how large what they are made of is, and ``content`` [J],
    what would leave down to 0 K. ``change`` [K] of the temperature solves a linear system with the ``right_side`` [J];
    ``added`` [J] is what came with it. ``bound`` (int) is 1 where there is no heat, but a row that says which
    temperature goes with those of the neighbours.
    """

    heat: wp.array[wp.float64]
    temperature: wp.array[wp.float64]
    capacity: wp.array[wp.float64]
    supply: wp.array[wp.float64]
    begun: wp.array[wp.float64]
    known: wp.array[wp.float64]
    moved: wp.array[wp.float64]
    terms: wp.array[wp.float64]
    content: wp.array[wp.float64]
    rest: wp.array[wp.float64]
    right_side: wp.array[wp.float64]
    change: wp.array[wp.float64]
    added: wp.array[wp.float64]
    bound: wp.array[int]


@wp.func
def stored(solution: ImplicitStep, u: int) -> wp.float64:
    """The heat capacity [J/K] of an unknown temperature that changes, as it stands in its row."""
    return wp.where(solution.bound[u] != 0, wp.float64(0.0), solution.capacity[u])


@wp.func
def changes(capacity: wp.float64) -> bool:
    """Whether a temperature changes: it is not held, nor at a melting point."""
    return capacity != STILL and capacity < wp.float64(wp.inf)


@wp.kernel
def find_known(
    first: int,
    begin: wp.float64,
    step: wp.float64,
    neighbours: NeighbourList,
    rows: HeatRows,
    solution: ImplicitStep,
):
    """Write ``solution.known``: the heat at the begin, and what comes in the ``step`` [s] that is known by then.

    What is conducted at the begin counts for ``begin`` [s], the supply for the whole step. ``solution.terms`` is what
    the terms of the equations amount to: their rounding is what no solution is free of.
    """
    u = wp.tid() + first
    solution.begun[u] = solution.heat[u]
    known = solution.heat[u] + step * solution.supply[u]
    solution.terms[u] = wp.abs(known) + step * rows.diagonal[u] * wp.abs(solution.temperature[u])
    solution.content[u] = wp.float64(0.0)
    if changes(solution.capacity[u]):
        solution.content[u] = stored(solution, u) * wp.abs(solution.temperature[u])
    if begin > wp.float64(0.0):
        known += begin * (heat_gained(rows, neighbours, solution.temperature, u) + rows.source[u])
    solution.known[u] = known


@wp.kernel
def find_rest(first: int, end: wp.float64, neighbours: NeighbourList, rows: HeatRows, solution: ImplicitStep):
    """Write ``solution.rest``: heat that the end of the step lacks, if what is conducted then counts for ``end`` [s].

    And what the next linear system begins with: its right side, the rest where the temperature changes, and no change.
    """
    u = wp.tid() + first
    rest, moved = wp.float64(0.0), wp.float64(0.0)
    if solution.capacity[u] != STILL:
        rest = end * (heat_gained(rows, neighbours, solution.temperature, u) + rows.source[u])
        if solution.bound[u] == 0:
            moved = solution.heat[u] - solution.begun[u]
            rest += solution.known[u] - solution.heat[u]
    solution.rest[u] = rest
    solution.moved[u] = moved
    solution.right_side[u] = wp.where(changes(solution.capacity[u]), rest, wp.float64(0.0))
    solution.change[u] = wp.float64(0.0)


@wp.kernel
def multiply_rows(
    first: int,
    end: wp.float64,
    alpha: wp.float64,
    beta: wp.float64,
    neighbours: NeighbourList,
    rows: HeatRows,
    solution: ImplicitStep,
    x: wp.array[wp.float64],
    y: wp.array[wp.float64],
    z: wp.array[wp.float64],
):
    """Write ``z = alpha A x + beta y``, A being the heat that the change x of temperatures takes [J].

    Rook, Yildiz & Dost (2007), left hand sides of (15) and (18), times the heat capacity. ``y`` is not read where beta
    is zero.
    """
    u = wp.tid() + first
    product = x[u]
    if changes(solution.capacity[u]):
        product = stored(solution, u) * x[u] - end * heat_gained(rows, neighbours, x, u)
    product = alpha * product
    if beta != wp.float64(0.0):
        product += beta * y[u]
    z[u] = product


@wp.kernel
def precondition(
    first: int,
    end: wp.float64,
    alpha: wp.float64,
    beta: wp.float64,
    rows: HeatRows,
    solution: ImplicitStep,
    x: wp.array[wp.float64],
    y: wp.array[wp.float64],
    z: wp.array[wp.float64],
):
    """Write ``z = alpha M x + beta y``, M being the inverse of the diagonal of A (Jacobi)."""
    u = wp.tid() + first
    product = alpha * x[u]
    if changes(solution.capacity[u]):
        product = product / (stored(solution, u) + end * rows.diagonal[u])
    if beta != wp.float64(0.0):
        product += beta * y[u]
    z[u] = product


@wp.kernel
def change_heat(first: int, end: wp.float64, neighbours: NeighbourList, rows: HeatRows, solution: ImplicitStep):
    """Add to the heat what comes with the change of temperatures.

    Where latent heat passes the temperature stays and the heat takes up all that comes. Elsewhere it does not take up
    what the linear solver has left: in a long step that would flow on many times.
    """
    u = wp.tid() + first
    added = wp.float64(0.0)
    if solution.capacity[u] != STILL:
        added = solution.capacity[u] * solution.change[u]
        if not changes(solution.capacity[u]):
            added = solution.rest[u] + end * heat_gained(rows, neighbours, solution.change, u)
    solution.added[u] = added
    solution.heat[u] += added


@wp.kernel
def retreat(first: int, share: wp.float64, solution: ImplicitStep):
    """Take back a ``share`` of the heat that was added last."""
    u = wp.tid() + first
    solution.heat[u] -= share * solution.added[u]


@wp.kernel
def settle_heat(first: int, solution: ImplicitStep):
    """Make up for the rest, so that what one particle gains another one loses, whatever the tolerance."""
    u = wp.tid() + first
    if solution.bound[u] == 0:
        solution.heat[u] += solution.rest[u]
