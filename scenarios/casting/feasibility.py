"""What is known before a run: whether the numbers of a case can hold a strand together."""

import numpy as np

from warpsph.core.capacity import refuse_too_many
from warpsph.core.model import GRAVITY
from warpsph.errors import InputError
from warpsph.scenarios.casting.parameters import WALL_LAYERS, CastingParameters
from warpsph.scenarios.casting.travelling_slice import shell_thickness

COMPRESSION = 0.10  # of the melt at the lower end, above which the pressure no longer is that of a fluid
SHARPEST_SOUND = 24.0  # speed of sound times density and spacing over the viscosity; at 28 the melt boiled
BOILING_TIME = 0.6  # of water on the shell [s]
MOST_DROPS = 3.0  # of water on one spacing of the shell
LAYERS = 2.0  # layers of particles that the shell needs where it leaves the mould
SLOWER = 5  # times slower casting, up to which a speed that would do is looked for
COARSE = 0.004  # spacing [m] that suffices for the reckoning
CHANNEL = 2.0  # spacings of melt that the shell needs to pass by the nozzle's mouth
BULGE = 0.05  # of a shell between two rolls, over their distance


def refuse_what_cannot_hold(case: CastingParameters) -> None:
    """Refuse a nozzle in the shell or the mould, a speed of sound too low for the depth or too high for the viscosity,
    more particles or water than there is room for, a shell too thin for the spacing, or too soft for the pressure.

    Raises:
        InputError: which parameter, and the value that would do.
    """
    strand = case.half_width ** (case.dimension - 1) * case.level / case.spacing**case.dimension
    refuse_too_many(f"spacing = {case.spacing:g}: a strand", strand)  # before the reckoning, which takes seconds
    _refuse_wide_nozzle(case)
    lowest = float(np.sqrt(GRAVITY * case.level / COMPRESSION))
    if case.sound_speed < lowest:
        raise InputError(
            f"sound_speed = {case.sound_speed:g}: melt {case.level:g} m deep would be compressed by more than "
            f"{COMPRESSION:.0%}; at least {_at_least(lowest)} m/s would do"
        )
    calm = SHARPEST_SOUND * case.viscosity / (case.density * case.spacing)
    if case.sound_speed > calm:
        raise InputError(
            f"sound_speed = {case.sound_speed:g}: a melt of {case.viscosity:g} Pa s does not calm such sound at a "
            f"spacing of {1e3 * case.spacing:g} mm; at most {_at_most(calm)} m/s would do, or a viscosity of "
            f"{_at_least(case.viscosity * case.sound_speed / calm)} Pa s"
        )
    drops = case.spray_flux / case.spray_particle * BOILING_TIME * case.spacing ** (case.dimension - 1)
    if drops > MOST_DROPS:
        raise InputError(
            f"spray_flux = {case.spray_flux:g}: some {drops:.0f} particles of water would stand on each one of steel; "
            f"a spray_particle of {_at_least(case.spray_particle * drops / MOST_DROPS)} kg would do"
        )
    _refuse_thin_shell(case)


def _refuse_wide_nozzle(case: CastingParameters) -> None:
    low, high = case.beside_nozzle
    if low < high:
        _refuse_nozzle_in_shell(case)
        return
    side = case.nozzle_port == "side"
    widest = (high - 1 - (0 if side else WALL_LAYERS)) * case.spacing
    remedy = f"at most {widest:.4g} m would do, or " if widest >= case.spacing else ""
    key = "nozzle_reach" if side else "nozzle_width"
    raise InputError(
        f"{key} = {getattr(case, key):g}: its outer side, {case.nozzle_side:.4g} m from the axis, leaves no melt "
        f"before the shell and the mould at half_width {case.half_width:g} m; {remedy}a wider strand or a finer spacing"
    )


def _refuse_nozzle_in_shell(case: CastingParameters) -> None:
    """A shell that has grown onto the nozzle squeezes the melt between the two, and jumps."""
    shell = _shells(case, np.array([case.nozzle_mouth]))[0]
    if case.half_width - shell - case.nozzle_side < CHANNEL * case.spacing:
        raise InputError(
            f"nozzle_mouth = {case.nozzle_mouth:g}: the shell is {1e3 * shell:.1f} mm thick there and leaves less than "
            f"{CHANNEL:g} spacings of {1e3 * case.spacing:g} mm to the nozzle's side, {case.nozzle_side:.4g} m of "
            f"half_width {case.half_width:g} m from the axis; a higher mouth, faster casting or a wider strand would do"
        )


def _refuse_thin_shell(case: CastingParameters) -> None:
    shell, needed = _shells(case, np.array([case.mould_bottom]))[0], LAYERS * case.spacing
    if shell < needed:
        slowest = case.model_copy(update={"casting_speed": case.casting_speed / SLOWER})
        speeds = np.linspace(case.casting_speed, slowest.casting_speed, 4 * SLOWER)
        depth = case.level - case.mould_bottom
        good = speeds[_shells(slowest, case.level - depth * slowest.casting_speed / speeds) >= needed]
        remedy = f"{_at_most(good[0])} m/s would do, or a" if len(good) else "take a"
        raise InputError(
            f"casting_speed = {case.casting_speed:g}: the shell leaves the mould {1e3 * shell:.1f} mm thick, less than "
            f"{LAYERS:g} spacings of {1e3 * case.spacing:g} mm; {remedy} longer mould or a finer spacing"
        )
    span = max(case.roll_pitch, case.mould_bottom - case.roll_first)
    pressure = case.density * GRAVITY * (case.level - case.roll_first)
    stiffness = pressure * span**3 / (32.0 * shell**3 * BULGE)  # bulge p l^4/(32 E s^3) of a plate held at both ends
    if case.youngs_modulus < stiffness:
        nearer = "roll_pitch" if span == case.roll_pitch else f"roll_first nearer mould_bottom {case.mould_bottom:g} m"
        raise InputError(
            f"youngs_modulus = {case.youngs_modulus:g}: a shell of {1e3 * shell:.1f} mm under {1e-3 * pressure:.1f} "
            f"kPa would bulge by more than {BULGE:.0%} of the {span:.3g} m between its supports; at least "
            f"{_at_least(stiffness)} Pa would do, or rolls nearer together ({nearer})"
        )


def _shells(case: CastingParameters, heights: np.ndarray) -> np.ndarray:
    """Thickness (heights,) [m] of the shell in the mould, by one-dimensional conduction."""
    profiles = case.model_copy(update={"spacing": max(case.spacing, COARSE)}).slices(heights)
    return np.array([shell_thickness(profile, case.steel, case.half_width, 0.5) for profile in profiles])


def _at_least(value: float) -> str:
    """A number of three digits, rounded up."""
    step = 10.0 ** (np.floor(np.log10(value)) - 2)
    return f"{np.ceil(value / step) * step:.3g}"


def _at_most(value: float) -> str:
    """A number of three digits, rounded down."""
    step = 10.0 ** (np.floor(np.log10(value)) - 2)
    return f"{np.floor(value / step) * step:.3g}"
