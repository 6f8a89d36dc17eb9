"""Second sweep of the corrected flow: pressure, viscosity, artificial viscosity, and shifting."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.dimensions import Space, for_each_dimension
from warpsph.kernels.basics.labels import Role
from warpsph.kernels.flow.corrected.faces import STOP_RANGE, stop_at_faces
from warpsph.kernels.flow.corrected.scheme import (
    FLUID,
    INTERIOR,
    NOTHING,
    SOLID,
    SPRAY_BELOW,
    SURFACE,
    WALL,
    FlowConstants,
    all_eigenvalues_above,
    correction_of,
    share_of_difference,
    slope_and_weight,
)
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})

CLUMPING = wp.constant(0.2)  # by which shifting pushes the closest neighbours harder (Monaghan 2000)
LARGEST_SHIFT = wp.constant(0.25)  # over the highest shifting speed
VELOCITY_SPREAD = wp.constant(4.0)  # supports' halves over which a gradient makes the speed of shifting
GUARD = wp.constant(0.1)  # of the particles of a wall on a fluid particle that comes close [c^2 / dx]
GUARD_RANGE = wp.constant(0.75)  # [dx]
LEAST_MEAN = wp.constant(1.0e-6)  # of a moment matrix; that of a particle without neighbours is 0


def _add_flow_forces(space: Space) -> Callable[..., None]:
    vector, narrow, widen, times = space.vector, space.narrow, space.widen, space.times

    def add_flow_forces(
        first: int,
        dt: float,
        flow: FlowConstants,
        neighbours: NeighbourList,
        position: wp.array[wp.vec3],
        velocity: wp.array[wp.vec3],
        ghost_velocity: wp.array[wp.vec3],
        to_surface: wp.array[wp.vec3],
        pressure: wp.array[float],
        viscosity: wp.array[float],
        mass: wp.array[float],
        role: wp.array[int],
        part: wp.array[int],
        material: wp.array[int],
        surface: wp.array[int],
        moment: wp.array[wp.mat33],
        velocity_gradient: wp.array[wp.mat33],
        is_near: wp.array[int],
        shift_velocity: wp.array[wp.vec3],
        acceleration: wp.array[wp.vec3],
    ):
        """Add the acceleration (n,) [m/s^2] of free particles by pressure and viscosity; write ``shift_velocity`` (n,)
        [m/s], by which they move besides, and ``is_near`` (n,), whether a neighbour is at the surface.
        """
        i = wp.tid() + first
        if role[i] == Role.FREE and part[i] == FLUID:
            x_i = position[i]
            u_i = narrow(velocity[i])
            p_i = pressure[i]
            mu_i = viscosity[i]
            G_i = velocity_gradient[i]
            M = moment[i]
            inside = surface[i] == INTERIOR
            trace = wp.trace(M)
            if flow.dimension == 2:
                trace -= M[2, 2]
            mean = trace / float(flow.dimension)
            c_squared = flow.bulk_modulus * flow.volume / mass[i]
            sound_speed = wp.sqrt(c_squared)
            pressed = vector()
            sheared = vector()
            rubbed = vector()
            damped = vector()
            crowding = vector()
            to_solids = vector()
            gathered = vector()
            guarded = vector()
            near = int(0)
            slips = bool(False)
            bends = bool(False)
            lean = vector()
            nearest_squared = 1.0e-6 * flow.spacing * flow.spacing
            at_wall = int(0)
            for k in range(neighbours.count[i]):
                j = index_of(entry_of(neighbours, i, k))
                d = narrow(difference(neighbours, x_i, position[j]))
                r_squared = wp.dot(d, d)
                what = part[j]
                if r_squared < flow.support * flow.support and what != NOTHING:
                    F, V_W = slope_and_weight(flow, r_squared)
                    V_grad_W = d * F
                    inverse = 1.0 / wp.max(r_squared, nearest_squared)
                    ratio = V_W * flow.inverse_nearest
                    ratio *= ratio
                    crowding += V_grad_W
                    gathered += V_grad_W * (1.0 + CLUMPING * ratio * ratio)
                    G_d = times(G_i, d)
                    p_j = pressure[j]
                    mu_j = viscosity[j]
                    mu = mu_i
                    share = float(1.0)
                    u_ij = u_i - narrow(velocity[j])
                    if what == WALL:
                        if mu_j == 0.0:
                            mu = 0.0
                            slips = True
                        r = wp.sqrt(wp.max(r_squared, nearest_squared)) / flow.spacing
                        if r < GUARD_RANGE:
                            guarded += d * (GUARD * c_squared * (1.0 / r - 1.0 / GUARD_RANGE))
                        depth = wp.length(to_surface[j])
                        if wp.dot(d, narrow(to_surface[j])) < depth * (depth + STOP_RANGE * flow.spacing):
                            at_wall = 1
                        u_ij = u_i - narrow(ghost_velocity[j])
                    elif what == SOLID:
                        to_solids += V_grad_W
                    elif what == FLUID:
                        if material[j] != material[i]:
                            share = share_of_difference(mass[i], mass[j])
                            bends = bends or mu_j != mu_i
                        if mu_j != mu_i:
                            mu = 2.0 * mu_i * mu_j / (mu_i + mu_j)
                        if surface[j] == SURFACE:
                            near = 1
                        of_gradient = 0.5 * wp.dot(d, G_d + times(velocity_gradient[j], d))
                        q = (wp.dot(u_ij, d) - of_gradient) * inverse
                        artificial = flow.artificial
                        if not inside or surface[j] != INTERIOR:
                            artificial = flow.artificial_at_surface
                        damped += V_grad_W * (q * (artificial * sound_speed - flow.quadratic * wp.min(q, 0.0)))
                    rubbed += u_ij * (mu * F)
                    if inside:
                        pressed += V_grad_W * (share * (p_j - p_i))
                        w = 1.0 - flow.anisotropy * (wp.dot(d, times(M, d)) * inverse - mean)
                        sheared += u_ij * (mu * w * F)
                        lean += d * (mu_i * w * F)
                    else:
                        pressed += V_grad_W * (share * p_j + (2.0 - share) * p_i)
            L = correction_of(M)
            normal = wp.normalize(times(L, crowding))
            rate = wp.sqrt(wp.ddot(G_i, G_i))
            fastest = wp.min(VELOCITY_SPREAD * 0.5 * flow.support * rate, flow.highest_shift_speed)
            shift = gathered * (-flow.shifting * fastest)
            if not inside:
                shift -= normal * wp.dot(shift, normal)
            # shifted towards a solid the fluid would have to flow off it, as if its volume came out of the face
            towards = wp.normalize(to_solids)
            shift -= towards * wp.max(wp.dot(shift, towards), 0.0)
            if not all_eigenvalues_above(M, SPRAY_BELOW):
                shift = vector()
            length = wp.length(shift)
            if length > LARGEST_SHIFT * fastest:
                shift *= LARGEST_SHIFT * fastest / length
            if inside:
                pressed = times(L, pressed)
                # what pairs of one viscosity make of a linear velocity is an error, beyond it is the viscosity's slope;
                # where a wall does not rub, the sum of pairs has no friction at its face, the corrected one has;
                # between two viscosities the gradient is that of neither side, and the stress is one
                if not slips:
                    if not bends:
                        sheared -= times(G_i, lean)
                    rubbed = sheared / wp.max(mean, LEAST_MEAN)
            force = rubbed * 2.0 - pressed
            change = force * (flow.volume / mass[i]) + damped + guarded / (flow.spacing * flow.spacing)
            if inside:
                change += times(G_i, shift)
            total = acceleration[i] + widen(change)
            if at_wall != 0 and dt > 0.0:
                motion = widen(u_i + shift) + total * dt
                total += stop_at_faces(flow, dt, i, motion, neighbours, position, velocity, to_surface, part)
            acceleration[i] = total
            shift_velocity[i] = widen(shift)
            is_near[i] = near

    return add_flow_forces


ADD_FLOW_FORCES = for_each_dimension(_add_flow_forces, __name__)
