"""The state at the start: the fields that the terms declare, filled with what the particles were given."""

import numpy as np
import warp as wp

from warpsph.core.field import Field, Value, declared
from warpsph.core.labels import Phase
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.placement import refuse_misplaced
from warpsph.core.state import State
from warpsph.errors import InputError
from warpsph.nearest import did_you_mean

SMALLEST_NORMAL = float(np.finfo(np.float32).tiny)


def initial_state(model: Model, particles: Particles, device: wp.Device) -> State:
    """The fields and values of all terms of a composed model.

    Raises:
        InputError: a material is unknown, single precision or the periodic box does not suit the places, two terms
            declare one name differently, or the particles were given values that no term of the case knows.
    """
    fields = _declared_fields(model)
    refuse_misplaced(model, particles)
    for name in particles.given:
        if name in ("id", "role", "material", "position"):
            raise InputError(
                f"particles: '{name}' is not given as a field; ids are numbered, the rest has its argument"
            )
        if name not in fields:
            raise InputError(f"particles: no term of this case has a field '{name}'{did_you_mean(name, fields)}")
    starts = {name: particles.column(name, field.shape, field.start_value(model)) for name, field in fields.items()}
    for name in particles.given:
        _refuse_misfits(fields[name], starts[name])
    given = {name: particles.was_given(name) for name in particles.given}

    def take(found: dict[str, np.ndarray], finder: str) -> None:
        for name, values in found.items():
            if name not in fields:
                raise InputError(f"{finder}.start: there is no field '{name}'{did_you_mean(name, fields)}")
            starts[name] = _where_not_given(given.get(name), starts[name], values)

    take(_identity(model, particles), "particles")
    for term in model.terms:
        take(term.start(model, particles, starts), type(term).__name__)
    _refuse_depth(model, starts)
    if np.min(starts["mass"]) < SMALLEST_NORMAL:
        raise InputError(
            f"particles: a mass of {np.min(starts['mass']):g}: too small for single precision; use SI units"
        )
    state = State(len(particles), device)
    for name, field in fields.items():
        state.add(field, starts[name])
    _hold_values(model, state)
    return state


def _where_not_given(given: np.ndarray | None, own: np.ndarray, found: np.ndarray) -> np.ndarray:
    """Start values that were found (n, ...), but what particles were ``given`` stays their own."""
    if given is None or np.shape(found) != np.shape(own):
        return found
    return np.where(given.reshape(-1, *[1] * (own.ndim - 1)), own, found)


def _refuse_misfits(field: Field, values: np.ndarray) -> None:
    """Numbers that were given to particles must be finite, and whole where the field is of integers."""
    if not np.issubdtype(values.dtype, np.number) and values.dtype != bool:
        raise InputError(f"particles: '{field.name}' was given {values.dtype} values; numbers are needed")
    if not np.all(np.isfinite(values)):
        raise InputError(f"particles: '{field.name}' was given values that are not finite numbers")
    if field.dtype is int and (np.any(values != np.round(values)) or np.any(np.abs(values) > 2**31 - 1)):
        raise InputError(f"particles: '{field.name}' was given values that are not integers of 32 bits")
    if np.any(values < field.least):
        unit = f" {field.unit}" if field.unit else ""
        raise InputError(
            f"particles: '{field.name}' was given {np.min(values):g}{unit}: must not be below {field.least:g}{unit}"
        )
    if field.name == "mass" and np.any(values <= 0.0):
        raise InputError("particles: 'mass' was given values that are not positive [kg, or kg/m in 2D]")
    if field.name == "phase" and not np.all(np.isin(values, list(Phase))):
        raise InputError(f"particles: 'phase' must be one of {', '.join(f'Phase.{phase.name}' for phase in Phase)}")


def _refuse_depth(model: Model, starts: dict[str, np.ndarray]) -> None:
    """In the plane nothing has a third coordinate."""
    if model.dimension == 2:
        for name in ("position", "velocity"):
            if np.any(starts[name][:, 2] != 0.0):
                raise InputError(f"particles: a {name} has a third coordinate that is not 0, in two dimensions")


def _declared_fields(model: Model) -> dict[str, Field]:
    fields: dict[str, Field] = {}
    for term in model.terms:
        for field in declared(type(term), Field):
            if fields.setdefault(field.name, field) is not field:
                other = next(o for o in model.terms if field.name in {f.name for f in declared(type(o), Field)})
                raise InputError(
                    f"{type(other).__name__} and {type(term).__name__} both declare a field '{field.name}'; share one "
                    f"declaration ({field.name} = {type(other).__name__}.{field.name}) or choose another name"
                )
    return fields


def _identity(model: Model, particles: Particles) -> dict[str, np.ndarray]:
    """Who each particle is and what it weighs."""
    names = particles.material
    indices = {name: model.index_of(name) for name in dict.fromkeys(names)}
    material = np.array([indices[name] for name in names])
    densities = np.array([material.density for material in model.materials])
    volume = np.where(particles.volume > 0.0, particles.volume, model.cell_volume)
    return {
        "id": np.arange(len(particles)),
        "role": particles.role,
        "material": material,
        "position": particles.position if model.periodic is None else model.periodic.wrapped(particles.position),
        "mass": densities[material] * volume,
    }


def _hold_values(model: Model, state: State) -> None:
    numbers: dict[str, int] = {}
    for term in model.terms:
        name = _snake(type(term).__name__)
        numbers[name] = numbers.get(name, 0) + 1
        if values := declared(type(term), Value):
            owner = name if numbers[name] == 1 else f"{name}_{numbers[name]}"
            state.hold_values(owner, term, values)


def _snake(name: str) -> str:
    return "".join(f"_{letter.lower()}" if letter.isupper() else letter for letter in name).lstrip("_")
