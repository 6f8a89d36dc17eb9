"""Implicit steps of conduction: the equations that the end of a step fulfils, and Newton's method for them.

All in double precision: within a step that is much longer than the explicit one, the last digits of single precision
would flow back and forth many times.
"""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.heat.conduction import ThermalTable
from warpsph.kernels.heat.rows import HeatRows, heat_gained
from warpsph.kernels.heat.walls import HeatWalls
from warpsph.kernels.neighbours.pairs import NeighbourList

wp.set_module_options({"enable_backward": False, "fast_math": False})

STILL = wp.constant(wp.float64(-1.0))  # in the place of a heat capacity: a temperature that does not change


@wp.struct
class ImplicitStep:
    """What a step is solved with, (n,), float64.

    ``enthalpy`` [J/kg], ``temperature`` [K], those of the begin of the step first and of its end when it is solved;
    ``begun`` [J/kg], the enthalpy at the begin; ``capacity`` [J/K], by how much heat changes with temperature, infinite
    where latent heat passes and :data:`STILL` where the temperature is held. ``known`` [J], the heat at the end as far
    as it does not depend on it; ``moved`` [J], what has come since the begin; ``rest`` [J], by how much the equations
    are not fulfilled; ``terms`` [J], how large what they are made of is. ``change`` [K] of the temperature solves a
    linear system; ``added`` [J/kg] is what the enthalpy gained with it. ``bound`` (n,) is 1 for a particle that has no
    heat of its own, but a row that says which temperature goes with those of its neighbours.
    """

    enthalpy: wp.array[wp.float64]
    temperature: wp.array[wp.float64]
    capacity: wp.array[wp.float64]
    begun: wp.array[wp.float64]
    known: wp.array[wp.float64]
    moved: wp.array[wp.float64]
    terms: wp.array[wp.float64]
    rest: wp.array[wp.float64]
    change: wp.array[wp.float64]
    added: wp.array[wp.float64]
    bound: wp.array[int]


@wp.kernel
def supply_no_heat(first: int, heat_rate: wp.array[float]):
    """Set ``heat_rate`` (n,) [W] to zero, before others add what they bring."""
    heat_rate[wp.tid() + first] = 0.0


@wp.kernel
def begin_implicit(first: int, solution: ImplicitStep, enthalpy: wp.array[float], enthalpy_carry: wp.array[float]):
    """Begin with the enthalpy (n,) [J/kg] of the particles, with what single precision has lost of it."""
    i = wp.tid() + first
    solution.enthalpy[i] = wp.float64(enthalpy[i]) - wp.float64(enthalpy_carry[i])


def _find_iterate(mixing: bool):
    def find_iterate(
        first: int,
        table: ThermalTable,
        solution: ImplicitStep,
        material: wp.array[int],
        mass: wp.array[float],
        role: wp.array[int],
        held: wp.array[int],
        temperature: wp.array[float],
        solid_fraction: wp.array[float],
        conductivity: wp.array[float],
    ):
        """Write what follows from the enthalpy of the solution: temperature and capacity, in double precision.

        And temperature [K], solid fraction and, where it is mixed from the two phases, conductivity [W/(m K)] (n,).
        """
        i = wp.tid() + first
        m = material[i]
        h = solution.enthalpy[i]
        segment = int(0)
        while segment < table.enthalpy.shape[1] - 2 and h > wp.float64(table.enthalpy[m, segment + 1]):
            segment += 1
        low, T_low = wp.float64(table.enthalpy[m, segment]), wp.float64(table.temperature[m, segment])
        rise = wp.float64(table.temperature[m, segment + 1]) - T_low
        slope = rise / (wp.float64(table.enthalpy[m, segment + 1]) - low)
        T = T_low + slope * (h - low)
        solution.temperature[i] = T
        solution.capacity[i] = wp.float64(mass[i]) / slope
        if role[i] == Role.RESERVOIR or (held[i] != 0 and solution.bound[i] == 0):
            solution.capacity[i] = STILL
        solid = float(0.0)
        if table.solidus[m] < table.liquidus[m]:
            solid = wp.clamp((table.liquidus[m] - float(T)) / (table.liquidus[m] - table.solidus[m]), 0.0, 1.0)
        else:
            latent_heat = table.enthalpy_liquid[m] - table.enthalpy_solid[m]
            solid = wp.clamp((table.enthalpy_liquid[m] - float(h)) / latent_heat, 0.0, 1.0)
        temperature[i] = float(T)
        solid_fraction[i] = solid
        if wp.static(mixing):
            conductivity[i] = solid * table.conductivity_solid[m] + (1.0 - solid) * table.conductivity_liquid[m]

    return find_iterate


FIND_ITERATE = {
    mixing: wp.Kernel(
        _find_iterate(mixing), key=f"find_iterate_{'mixed' if mixing else 'kept'}", module=wp.get_module(__name__)
    )
    for mixing in (False, True)
}


@wp.kernel
def find_known(
    first: int,
    begin: wp.float64,
    step: wp.float64,
    neighbours: NeighbourList,
    rows: HeatRows,
    solution: ImplicitStep,
    mass: wp.array[float],
    heat_rate: wp.array[float],
):
    """Write ``solution.known``: the heat at the begin, and what comes in the ``step`` [s] that is known by then.

    What is conducted at the begin counts for ``begin`` [s], that of sources, ``heat_rate``, for the whole step.
    ``solution.terms`` is what the terms of the equations amount to: their rounding is what no solution is free of.
    """
    i = wp.tid() + first
    solution.begun[i] = solution.enthalpy[i]
    known = wp.float64(mass[i]) * solution.enthalpy[i] + step * wp.float64(heat_rate[i])
    solution.terms[i] = wp.abs(known) + step * rows.diagonal[i] * wp.abs(solution.temperature[i])
    if begin > wp.float64(0.0):
        known += begin * (heat_gained(rows, neighbours, solution.temperature, i) + rows.source[i])
    solution.known[i] = known


@wp.kernel
def find_rest(
    first: int,
    end: wp.float64,
    neighbours: NeighbourList,
    rows: HeatRows,
    solution: ImplicitStep,
    mass: wp.array[float],
):
    """Write ``solution.rest``: heat that the end of the step lacks, if what is conducted then counts for ``end`` [s].

    And ``solution.moved``, what each particle has gained since the begin.
    """
    i = wp.tid() + first
    rest, moved = wp.float64(0.0), wp.float64(0.0)
    if solution.capacity[i] != STILL:
        rest = end * (heat_gained(rows, neighbours, solution.temperature, i) + rows.source[i])
        if solution.bound[i] == 0:
            moved = wp.float64(mass[i]) * (solution.enthalpy[i] - solution.begun[i])
            rest += solution.known[i] - wp.float64(mass[i]) * solution.enthalpy[i]
    solution.rest[i] = rest
    solution.moved[i] = moved
    solution.change[i] = wp.float64(0.0)


@wp.func
def stored(solution: ImplicitStep, i: int) -> wp.float64:
    """The heat capacity [J/K] of a particle whose temperature moves, as it stands in its row."""
    return wp.where(solution.bound[i] != 0, wp.float64(0.0), solution.capacity[i])


@wp.func
def moves(capacity: wp.float64) -> bool:
    """Whether the temperature of a particle changes: it is not held, nor at a melting point."""
    return capacity != STILL and capacity < wp.float64(wp.inf)


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
    """Write ``z = alpha A x + beta y`` (n,), A being the heat that the change x of temperatures takes [J].

    Rook, Yildiz & Dost (2007), left hand sides of (15) and (18), times the heat capacity. ``y`` is not read where beta
    is zero.
    """
    i = wp.tid() + first
    product = x[i]
    if moves(solution.capacity[i]):
        product = stored(solution, i) * x[i] - end * heat_gained(rows, neighbours, x, i)
    product = alpha * product
    if beta != wp.float64(0.0):
        product += beta * y[i]
    z[i] = product


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
    """Write ``z = alpha M x + beta y`` (n,), M being the inverse of the diagonal of A (Jacobi)."""
    i = wp.tid() + first
    product = alpha * x[i]
    if moves(solution.capacity[i]):
        product = product / (stored(solution, i) + end * rows.diagonal[i])
    if beta != wp.float64(0.0):
        product += beta * y[i]
    z[i] = product


@wp.kernel
def find_right_side(first: int, solution: ImplicitStep, right_side: wp.array[wp.float64]):
    """Write the right hand side (n,) [J] of the linear system: the rest, where the temperature changes."""
    i = wp.tid() + first
    right_side[i] = wp.where(moves(solution.capacity[i]), solution.rest[i], wp.float64(0.0))


@wp.kernel
def change_heat(
    first: int,
    end: wp.float64,
    neighbours: NeighbourList,
    rows: HeatRows,
    solution: ImplicitStep,
    mass: wp.array[float],
):
    """Add to the enthalpy what is lacking after the change of temperatures.

    Where latent heat passes the temperature stays and the enthalpy takes up all that comes.
    """
    i = wp.tid() + first
    added = wp.float64(0.0)
    if solution.capacity[i] != STILL:
        heat = solution.capacity[i] * solution.change[i]
        if solution.bound[i] == 0:
            heat = solution.rest[i] + end * heat_gained(rows, neighbours, solution.change, i)
        added = heat / wp.float64(mass[i])
    solution.added[i] = added
    solution.enthalpy[i] += added


@wp.kernel
def retreat(first: int, share: wp.float64, solution: ImplicitStep):
    """Take back a ``share`` of what was added last to the enthalpy."""
    i = wp.tid() + first
    solution.enthalpy[i] -= share * solution.added[i]


@wp.kernel
def count_implicit_heat(
    first: int,
    part: wp.float64,
    neighbours: NeighbourList,
    walls: HeatWalls,
    rows: HeatRows,
    solution: ImplicitStep,
    id: wp.array[int],
    held: wp.array[int],
    heat_held: wp.array[wp.float64],
):
    """Count what walls and held particles take in the time ``part`` [s], by ids: ``walls.taken``, ``heat_held``."""
    i = wp.tid() + first
    T = solution.temperature[i]
    for p in range(walls.offset.shape[0]):
        rate = rows.to_wall[p, i] * T + rows.wall_source[p, i]
        walls.rate[p, id[i]] = float(rate)
        walls.taken[p, id[i]] += part * rate
    if held[i] != 0:
        heat_held[i] += part * (heat_gained(rows, neighbours, solution.temperature, i) + rows.source[i])


@wp.kernel
def settle_heat(first: int, solution: ImplicitStep, mass: wp.array[float]):
    """Make up for the rest, so that what one particle gains another one loses, whatever the tolerance."""
    i = wp.tid() + first
    if solution.bound[i] == 0:
        solution.enthalpy[i] += solution.rest[i] / wp.float64(mass[i])


@wp.kernel
def end_implicit(
    first: int,
    solution: ImplicitStep,
    role: wp.array[int],
    held: wp.array[int],
    enthalpy: wp.array[float],
    enthalpy_carry: wp.array[float],
):
    """Write the enthalpy (n,) [J/kg] of the particles and what single precision loses of it."""
    i = wp.tid() + first
    if role[i] != Role.RESERVOIR and (held[i] == 0 or solution.bound[i] != 0):
        h = float(solution.enthalpy[i])
        enthalpy[i] = h
        enthalpy_carry[i] = float(wp.float64(h) - solution.enthalpy[i])
