"""Numbers given along a direction and over time, and piecewise linear in between."""

import warp as wp

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.struct
class Profiles:
    """Tables of numbers over places along a direction and over times, one after the other.

    ``along`` (tables,), unit vectors; ``places`` [m], ``times`` [s] and ``values`` of all tables, those of table m from
    ``first_place[m]``, ``first_time[m]`` and ``first_value[m]`` up to those of table m + 1 (tables + 1,). A table has a
    value for each of its times and, within these, for each of its places; one place or one time says that it does not
    change with it.
    """

    along: wp.array[wp.vec3d]
    first_place: wp.array[int]
    first_time: wp.array[int]
    first_value: wp.array[int]
    places: wp.array[wp.float64]
    times: wp.array[wp.float64]
    values: wp.array[float]


@wp.func
def interval_of(nodes: wp.array[wp.float64], first: int, end: int, x: wp.float64) -> int:
    """The one of the rising ``nodes`` from ``first`` up to ``end`` after which ``x`` is, not the last of several."""
    low = int(first)
    high = wp.max(end - 1, first + 1)
    while high - low > 1:
        middle = (low + high) // 2
        if nodes[middle] <= x:
            low = middle
        else:
            high = middle
    return low


@wp.func
def share_after(nodes: wp.array[wp.float64], node: int, end: int, x: wp.float64) -> float:
    """How far ``x`` is on the way from ``node`` to the next one, from 0 to 1; 0 where there is no next one."""
    if node + 1 >= end:
        return 0.0
    share = (x - nodes[node]) / (nodes[node + 1] - nodes[node])
    return float(wp.clamp(share, wp.float64(0.0), wp.float64(1.0)))


@wp.func
def profile_at(profiles: Profiles, table: int, x: wp.vec3, time: wp.float64) -> float:
    """The number of a ``table`` at the place ``x`` [m] and the ``time`` [s]; constant beyond the ends."""
    n = profiles.along[table]
    place = n[0] * wp.float64(x[0]) + n[1] * wp.float64(x[1]) + n[2] * wp.float64(x[2])
    first_place, end_place = profiles.first_place[table], profiles.first_place[table + 1]
    first_time, end_time = profiles.first_time[table], profiles.first_time[table + 1]
    s = interval_of(profiles.places, first_place, end_place, place)
    t = interval_of(profiles.times, first_time, end_time, time)
    to_next_place = share_after(profiles.places, s, end_place, place)
    to_next_time = share_after(profiles.times, t, end_time, time)
    width = end_place - first_place
    at = profiles.first_value[table] + (t - first_time) * width + s - first_place
    beside, later = wp.where(to_next_place > 0.0, 1, 0), wp.where(to_next_time > 0.0, width, 0)
    now = wp.lerp(profiles.values[at], profiles.values[at + beside], to_next_place)
    then = wp.lerp(profiles.values[at + later], profiles.values[at + later + beside], to_next_place)
    return wp.lerp(now, then, to_next_time)
