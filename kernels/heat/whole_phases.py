"""Phases that change when all latent heat has passed, and conductivities that change with them."""

import warp as wp

from warpsph.kernels.basics.labels import Phase
from warpsph.kernels.basics.roles import is_fluid
from warpsph.kernels.heat.conduction import ThermalTable

wp.set_module_options({"enable_backward": False})


@wp.kernel
def switch_whole_phase(
    first: int,
    table: ThermalTable,
    role: wp.array[int],
    material: wp.array[int],
    solid_fraction: wp.array[float],
    conductivity: wp.array[float],
    phase: wp.array[int],
    froze: wp.array[int],
    phase_changed: wp.array[int],
):
    """Write ``phase`` (n,) and the ``conductivity`` (n,) [W/(m K)] of the whole phase that it stands for.

    Liquid turns solid when it has lost all its latent heat, solid turns liquid when it has all of it back; liquid that
    has lost a part is mushy and conducts like liquid. ``froze`` (n,) marks the particles that turned solid now;
    ``phase_changed`` (1,) is raised where any one turned. Monaghan, Huppert & Worster (2005), section 3.
    """
    i = wp.tid() + first
    froze[i] = 0
    if is_fluid(role[i]):
        was_solid = phase[i] == Phase.SOLID
        f = solid_fraction[i]
        if f >= 1.0 or (was_solid and f > 0.0):
            phase[i] = Phase.SOLID
            conductivity[i] = table.conductivity_solid[material[i]]
            if not was_solid:
                froze[i] = 1
                phase_changed[0] = 1
        else:
            phase[i] = wp.where(f > 0.0, Phase.MUSHY, Phase.LIQUID)
            conductivity[i] = table.conductivity_liquid[material[i]]
            if was_solid:
                phase_changed[0] = 1
