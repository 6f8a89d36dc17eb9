"""A lamp in the plane whose rays heat the first particle that they meet; what stands behind lies in its shadow."""

import warp as wp

wp.set_module_options({"enable_backward": False, "fast_math": False})

NOTHING = wp.constant(wp.float64(1.0e300))  # distance [m] at which a ray has met nothing
NOBODY = wp.constant(2**31 - 1)
SLACK = wp.constant(wp.float64(1.0 + 1.0e-12))  # a compiler may round a distance differently in two kernels
TURN = wp.constant(wp.float64(6.283185307179586))


@wp.struct
class LampConstants:
    """A lamp at ``place`` [m] that sends ``rays`` evenly to all sides; a particle has a ``radius`` [m].

    Each ray carries ``power`` [W] (per metre of depth), from the time ``begin`` [s] on.
    """

    place: wp.vec3d
    rays: int
    radius: wp.float64
    power: wp.float64
    begin: wp.float64


@wp.func
def distance_of(lamp: LampConstants, x: wp.vec3d) -> wp.float64:
    """Distance [m] of a particle from the lamp, at least its radius."""
    return wp.max(wp.length(x - lamp.place), lamp.radius)


@wp.func
def rays_on(lamp: LampConstants, x: wp.vec3d) -> wp.vec2i:
    """First and last number of the rays that meet a particle if nothing is before it; whole turns may be on top."""
    d = x - lamp.place
    angle = wp.atan2(d[1], d[0])
    half = wp.asin(lamp.radius / distance_of(lamp, x))
    per_turn = wp.float64(lamp.rays) / TURN
    return wp.vec2i(int(wp.ceil((angle - half) * per_turn)), int(wp.floor((angle + half) * per_turn)))


@wp.func
def number_of(lamp: LampConstants, ray: int) -> int:
    """A ray's number within one turn."""
    return (ray + lamp.rays) % lamp.rays


@wp.kernel
def clear_rays(first: int, met: wp.array[wp.float64], owner: wp.array[int]):
    """Let the rays (m,) meet nothing."""
    ray = wp.tid() + first
    met[ray] = NOTHING
    owner[ray] = NOBODY


@wp.kernel
def meet_particles(first: int, lamp: LampConstants, precise_position: wp.array[wp.vec3d], met: wp.array[wp.float64]):
    """Find the distance ``met`` (m,) [m] at which each ray meets its first particle: the least, in any order."""
    i = wp.tid() + first
    x = precise_position[i]
    rays = rays_on(lamp, x)
    for ray in range(rays[0], rays[1] + 1):
        wp.atomic_min(met, number_of(lamp, ray), distance_of(lamp, x))


@wp.kernel
def own_rays(
    first: int,
    lamp: LampConstants,
    id: wp.array[int],
    precise_position: wp.array[wp.vec3d],
    met: wp.array[wp.float64],
    owner: wp.array[int],
):
    """Find the ``id`` (n,) of the particle that each ray (m,) meets first; the smallest of those equally far."""
    i = wp.tid() + first
    x = precise_position[i]
    rays = rays_on(lamp, x)
    for ray in range(rays[0], rays[1] + 1):
        if distance_of(lamp, x) <= SLACK * met[number_of(lamp, ray)]:
            wp.atomic_min(owner, number_of(lamp, ray), id[i])


@wp.kernel
def take_light(
    first: int,
    lamp: LampConstants,
    time: wp.array[wp.float64],
    id: wp.array[int],
    precise_position: wp.array[wp.vec3d],
    owner: wp.array[int],
    light: wp.array[float],
):
    """Write the power (n,) [W] that each particle takes: that of the rays that meet no other one before."""
    i = wp.tid() + first
    count = int(0)
    if time[0] >= lamp.begin:
        rays = rays_on(lamp, precise_position[i])
        for ray in range(rays[0], rays[1] + 1):
            if owner[number_of(lamp, ray)] == id[i]:
                count += 1
    light[i] = float(wp.float64(count) * lamp.power)


@wp.kernel
def warm_up(
    first: int,
    dt: wp.float64,
    lamp: LampConstants,
    mass: wp.array[float],
    light: wp.array[float],
    precise_position: wp.array[wp.vec3d],
    precise_velocity: wp.array[wp.vec3d],
):
    """Add the heat of ``dt`` [s] to the kinetic energy: faster along the velocity (n,), at rest away from the lamp."""
    i = wp.tid() + first
    if light[i] > 0.0:
        u = precise_velocity[i]
        before = wp.dot(u, u)
        after = before + wp.float64(2.0) * dt * wp.float64(light[i]) / wp.float64(mass[i])
        if before > wp.float64(0.0):
            precise_velocity[i] = wp.sqrt(after / before) * u
        else:
            precise_velocity[i] = wp.sqrt(after) * wp.normalize(precise_position[i] - lamp.place)
