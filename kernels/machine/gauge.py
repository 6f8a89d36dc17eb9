"""The level of the melt, weighed in a column, and the casting and pouring speeds that follow from it."""

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False})

PARTS = 128  # partial sums; their order of summation does not depend on the number of threads


@wp.struct
class GaugeConstants:
    """Constants of the level gauge and of the flow control.

    ``low``, ``high`` corners of the weighed column [m]; ``mass_per_height`` of the full column [kg/m];
    ``response`` time of the gauge [s]; ``pressure_per_height`` rho g [Pa/m]; ``outflow_coefficient`` k of
    v = k p [m/(s Pa)]; ``area_ratio`` strand over nozzle; ``target_level`` [m]; ``gain`` of the level control.
    """

    low: wp.vec3
    high: wp.vec3
    mass_per_height: float
    response: float
    pressure_per_height: float
    outflow_coefficient: float
    area_ratio: float
    target_level: float
    gain: float


@wp.kernel
def weigh(
    first: int,
    gauge: GaugeConstants,
    role: wp.array[int],
    position: wp.array[wp.vec3],
    mass: wp.array[float],
    parts: wp.array[wp.float64],
):
    """Weigh the free particles of the column, in ``PARTS`` partial sums ``parts`` (PARTS,) [kg]."""
    part = wp.tid() + first
    n = role.shape[0]
    length = (n + wp.static(PARTS) - 1) / wp.static(PARTS)
    total = wp.float64(0.0)
    for i in range(part * length, wp.min((part + 1) * length, n)):
        if role[i] == Role.FREE:
            x = position[i]
            inside = bool(True)
            for axis in range(3):
                if x[axis] < gauge.low[axis] or x[axis] > gauge.high[axis]:
                    inside = False
            if inside:
                total += wp.float64(mass[i])
    parts[part] = total


@wp.kernel
def control(first: int, interval: float, gauge: GaugeConstants, parts: wp.array[wp.float64], speeds: wp.array[float]):
    """Update ``speeds`` (3,): level of the melt [m], casting speed [m/s], pouring speed [m/s]; one thread.

    The level is the height of a column at rest as heavy as the particles weighed in it, smoothed in time.
    The strand leaves with v = k p (Vijaykumar 2012, equation 6.2); the melt enters at the rate of the outflow, raised
    in proportion to the shortage of level.
    """
    total = wp.float64(0.0)
    for part in range(wp.static(PARTS)):
        total += parts[part]
    level = speeds[0]
    level += (float(total) / gauge.mass_per_height - level) * wp.min(interval / gauge.response, 1.0)
    speeds[0] = level
    speeds[1] = gauge.outflow_coefficient * gauge.pressure_per_height * level  # Vijaykumar (6.2)
    shortage = (gauge.target_level - level) / gauge.target_level
    speeds[2] = wp.max(speeds[1] * gauge.area_ratio * (1.0 + gauge.gain * shortage), 0.0)
