"""Viscosity that follows the temperature."""

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.kernel
def find_viscosity(
    first: int,
    curve_nodes: wp.array[int],
    curve_temperature: wp.array2d[float],
    curve_viscosity: wp.array2d[float],
    temperature: wp.array[float],
    material: wp.array[int],
    viscosity: wp.array[float],
):
    """Write the ``viscosity`` (n,) [Pa s] of materials that have a curve: linear between its nodes, constant beyond.

    ``curve_nodes`` (materials,) says how many nodes each has, 0 without a curve; ``curve_temperature`` [K] and
    ``curve_viscosity`` [Pa s] (materials, most nodes) hold them, rising in temperature.
    """
    i = wp.tid() + first
    m = material[i]
    count = curve_nodes[m]
    if count > 0:
        T = temperature[i]
        mu = curve_viscosity[m, 0]
        for k in range(1, count):
            before = curve_temperature[m, k - 1]
            if before < T:
                share = wp.min((T - before) / (curve_temperature[m, k] - before), 1.0)
                mu = wp.lerp(curve_viscosity[m, k - 1], curve_viscosity[m, k], share)
        viscosity[i] = mu
