"""The switch between fluid and solid."""

import warp as wp

from warpsph.kernels.basics.labels import Phase
from warpsph.kernels.basics.roles import is_fluid

wp.set_module_options({"enable_backward": False})


@wp.kernel
def switch_phase(
    first: int,
    freeze_above: float,
    melt_below: float,
    role: wp.array[int],
    solid_fraction: wp.array[float],
    phase: wp.array[int],
    froze: wp.array[int],
    phase_changed: wp.array[int],
):
    """Write ``phase`` (n,) from the solid fraction, with hysteresis between ``melt_below`` and ``freeze_above``.

    ``froze`` (n,) marks the particles that turned solid now; ``phase_changed`` (1,) is raised where any one turned.
    Vijaykumar (2012), chapter 4.
    """
    i = wp.tid() + first
    froze[i] = 0
    if is_fluid(role[i]):
        was_solid = phase[i] == Phase.SOLID
        f = solid_fraction[i]
        if f > freeze_above or (was_solid and f >= melt_below):
            phase[i] = Phase.SOLID
            if not was_solid:
                froze[i] = 1
                phase_changed[0] = 1
        else:
            phase[i] = wp.where(f > 0.0, Phase.MUSHY, Phase.LIQUID)
            if was_solid:
                phase_changed[0] = 1
