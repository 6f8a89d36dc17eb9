"""What all parts have in common that bring particles in from the reservoir or take them out."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State, members_of
from warpsph.core.term import Term
from warpsph.kernels.machine.exchange import Exchange
from warpsph.kernels.machine.renewal import START_ANEW, forget_entries


@dataclass(frozen=True, eq=False)
class ExchangePart(Term):
    """A part with the ledger of what passes; particles that enter start anew in all fields that are renewed."""

    needs = ("fluid", "conduction")

    entered = Field(int, "", "whether it has just come in")
    entries = Field(int, "", "how often it has come in")
    exits = Field(int, "", "how often it has left")
    heat_entered = Field(wp.float64, "J", "enthalpy it has brought in (per metre of depth in 2D)")
    heat_left = Field(wp.float64, "J", "enthalpy it has taken out (per metre of depth in 2D)")

    def constants(self, model: Model, state: State) -> dict[str, object]:
        exchange = Exchange()
        for name in members_of(exchange):
            setattr(exchange, name, getattr(state, name))
        return {"exchange": exchange, "renewed": _renewed(model, state)}

    def gains(self, state: State) -> dict[str, dict[str, float | np.ndarray]]:
        """Of all parts together: the particles keep the ledger."""
        mass = (state.numpy("entries") - state.numpy("exits")) * state.numpy("mass").astype(float)
        heat = float(np.sum(state.numpy("heat_entered") - state.numpy("heat_left")))
        way = "inlets, sprays and outflows"
        return {"mass": {way: mass[np.argsort(state.numpy("id"))]}, "heat": {way: heat}}

    def start_anew(self, launch: Launch) -> None:
        """Give what has just come in the start values of the renewed fields."""
        for kernel, start, array in launch.find("renewed"):
            launch(kernel, start=start, field=array)
        launch(forget_entries)


def _renewed(model: Model, state: State) -> list[tuple[wp.Kernel, wp.array, wp.array]]:
    """What sets each renewed field and its carry, start value (1,) and array (n,)."""
    renewed = []
    for name, field in state.fields.items():
        if field.renewed:
            start = field.array(np.full((1, *field.shape), field.start_value(model)), state.device)
            renewed.append((START_ANEW[field.dtype], start, state.arrays[name]))
            if field.compensated:
                carry = state.arrays[field.carry_name]
                renewed.append((START_ANEW[field.dtype], wp.zeros_like(start), carry))
    return renewed
