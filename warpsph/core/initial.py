"""The state at the start: the fields that the terms declare, filled with what the particles were given."""

import numpy as np
import warp as wp

from warpsph.core.field import Field, Value, declared
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.errors import InputError
from warpsph.nearest import did_you_mean


def initial_state(model: Model, particles: Particles, device: wp.Device) -> State:
    """The fields and values of all terms of a composed model.

    Raises:
        InputError: a material is unknown, two terms declare one name differently, or the particles were given values
            that no term of the case knows.
    """
    if len(particles) == 0:
        raise InputError("particles: there is none; add some before the simulation is built")
    fields = _declared_fields(model)
    for name in particles.given:
        if name not in fields:
            raise InputError(f"particles: no term of this case has a field '{name}'{did_you_mean(name, fields)}")
    starts = {name: particles.column(name, field.shape, field.start_value(model)) for name, field in fields.items()}
    starts |= _identity(model, particles)
    for term in model.terms:
        starts |= term.start(model, particles, starts)
    state = State(len(particles), device)
    for name, field in fields.items():
        state.add(field, starts[name])
    _hold_values(model, state)
    return state


def _declared_fields(model: Model) -> dict[str, Field]:
    fields: dict[str, Field] = {}
    for term in model.terms:
        for field in declared(type(term), Field):
            if fields.setdefault(field.name, field) is not field:
                raise InputError(f"{type(term).__name__}: another term has a field '{field.name}' of its own")
    return fields


def _identity(model: Model, particles: Particles) -> dict[str, np.ndarray]:
    """Who each particle is and what it weighs."""
    sizes = [len(block.position) for block in particles.blocks]
    material = np.repeat([model.index_of(block.material) for block in particles.blocks], sizes)
    densities = np.array([material.density for material in model.materials])
    volume = np.where(particles.volume > 0.0, particles.volume, model.cell_volume)
    return {
        "id": np.arange(len(particles)),
        "role": particles.role,
        "material": material,
        "position": particles.position,
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
