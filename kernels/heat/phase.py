"""The switch between fluid and solid."""

import warp as wp

from warpsph.kernels.basics.labels import Phase, Role

wp.set_module_options({"enable_backward": False})


@wp.kernel
def _switch_phase(
    first: int,
    freeze_above: float,
    melt_below: float,
    role: wp.array[int],
    solid_fraction: wp.array[float],
    phase: wp.array[int],
    froze: wp.array[int],
    changed: wp.array[int],
):
    i = wp.tid() + first
    froze[i] = 0
    if role[i] == Role.FREE or role[i] == Role.OUTFLOW or role[i] == Role.INFLOW:
        was_solid = phase[i] == Phase.SOLID
        f = solid_fraction[i]
        if f > freeze_above or (was_solid and f >= melt_below):
            phase[i] = Phase.SOLID
            if not was_solid:
                froze[i] = 1
                changed[0] = 1
        else:
            phase[i] = wp.where(f > 0.0, Phase.MUSHY, Phase.LIQUID)
            if was_solid:
                changed[0] = 1


def switch_phase(launch, freeze_above, melt_below, role, solid_fraction, phase, froze, changed) -> None:
    """Write ``phase`` (n,) from the solid fraction, with hysteresis between ``melt_below`` and ``freeze_above``.

    ``froze`` (n,) marks the particles that turned solid now; ``changed`` (1,) is raised where any particle turned.
    Vijaykumar (2012), chapter 4.
    """
    launch(
        _switch_phase,
        role.shape[0],
        [freeze_above, melt_below, role, solid_fraction, phase, froze, changed],
    )
