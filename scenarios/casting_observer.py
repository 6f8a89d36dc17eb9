"""What is measured of a casting run: level, ledgers of mass and heat, and the shell along the height."""

from typing import TYPE_CHECKING

import numpy as np

from warpsph.diagnostics import Snapshot, enthalpy_by_material
from warpsph.labels import Phase, Role

if TYPE_CHECKING:
    from warpsph.scenarios.casting import Casting
    from warpsph.scenarios.casting_machine import CastingMachine
    from warpsph.simulation import Simulation

BINS = 22
Values = dict[str, float | np.ndarray]


class CastingObserver:
    """Gives the diagnostics of a casting run, per metre of depth; all ledgers count from the start of the run.

    Args:
        case: the scenario.
        machine: its devices.
    """

    def __init__(self, case: "Casting", machine: "CastingMachine"):
        self.case, self.gauge, self.inlet, self.spray = case, machine.gauge, machine.inlet, machine.spray
        self.noted: set[str] = set()
        self.edges = np.linspace(0.0, case.level, BINS + 1)
        self.heights = 0.5 * (self.edges[1:] + self.edges[:-1])

    def begin(self, simulation: "Simulation") -> None:
        """Remember the initial contents."""
        self.simulation = simulation
        self.materials = len(simulation.model.materials)
        self.start = enthalpy_by_material(simulation.snapshot(), self.materials)

    def __call__(self, state: Snapshot, time: float) -> Values:
        self._note_events(time)
        return self._flow(state) | self._mass(state) | self._heat(state) | self._shell(state) | {"height": self.heights}

    def describe(self, values: Values) -> str:
        """One line for the progress bar."""
        exit_bin = int(np.argmin(np.abs(self.heights - self.case.mould_bottom)))
        return f"level {values['level']:.3f} m, shell at mould exit {1e3 * values['shell_thickness'][exit_bin]:.1f} mm"

    def _note_events(self, time: float) -> None:
        failure = self.case.spray_failure
        if failure is not None and time >= failure:
            zones = ", ".join(str(zone) for zone in self.case.spray_failing)
            self._note_once(failure, f"sprays fail in zone {zones}")
        for device, substance in ((self.inlet, "melt"), (self.spray, "water")):
            if device.missing.numpy()[0] > 0:
                self._note_once(time, f"the reservoir has run out of {substance}")

    def _note_once(self, time: float, text: str) -> None:
        if text not in self.noted:
            self.noted.add(text)
            self.simulation.note_event(time, text)

    def _flow(self, state: Snapshot) -> Values:
        level, casting_speed, pouring_speed = (float(v) for v in self.gauge.speeds.numpy())
        x, y = state["position"][:, 0], state["position"][:, 1]
        column = (state["material"] == 0) & (state["role"] == Role.FREE)
        column &= (x > self.gauge.low[0]) & (x < self.gauge.high[0])
        return {
            "level": level,
            "meniscus": float(np.percentile(y[column], 99.5)) if np.any(column) else np.nan,
            "casting_speed": casting_speed,
            "pouring_speed": pouring_speed,
            "missing_melt": float(self.inlet.missing.numpy()[0]),
            "missing_water": float(self.spray.missing.numpy()[0]),
        }

    def _mass(self, state: Snapshot) -> Values:
        steel = state["material"] == 0
        inside = steel & (state["role"] != Role.RESERVOIR)
        mass = state["mass"].astype(float)
        return {
            "mass_inside": float(np.sum(mass[inside])),
            "mass_in": float(np.sum((mass * state["entries"])[steel])),
            "mass_out": float(np.sum((mass * state["exits"])[steel])),
            "particles_inside": float(np.sum(inside)),
            "particles_in": float(np.sum(state["entries"][steel])),
            "particles_out": float(np.sum(state["exits"][steel])),
        }

    def _heat(self, state: Snapshot) -> Values:
        now = enthalpy_by_material(state, self.materials)
        entered = np.bincount(state["material"], state["heat_entered"], self.materials)
        left = np.bincount(state["material"], state["heat_left"], self.materials)
        steel, mould, _, water = range(4)
        to_mould = float(np.sum(state["heat_held"])) + now[mould] - self.start[mould]
        to_spray = now[water] - self.start[water] + left[water] - entered[water]
        change = now[steel] - self.start[steel]
        expected = entered[steel] - left[steel] - to_mould - to_spray
        turnover = entered[steel] + left[steel] + abs(to_mould) + abs(to_spray)
        return {
            "enthalpy_inside": now[steel],
            "enthalpy_in": entered[steel],
            "enthalpy_out": left[steel],
            "heat_mould": to_mould,
            "heat_spray": to_spray,
            "ledger_error": (change - expected) / turnover if turnover > 0.0 else 0.0,
        }

    def _shell(self, state: Snapshot) -> Values:
        inside = (state["material"] == 0) & (state["role"] == Role.FREE)
        x, y = state["position"][inside, 0], state["position"][inside, 1]
        solid = state["phase"][inside] == Phase.SOLID
        cell = self.case.spacing**2
        place = np.digitize(y, self.edges) - 1
        strand = (place >= 0) & (place < BINS) & (x > 0.5 * self.case.half_width)
        area = np.bincount(place[strand & solid], minlength=BINS)[:BINS] * cell
        surface = np.full(BINS, np.nan)
        for k in range(BINS):
            here = strand & (place == k)
            if np.any(here):
                outermost = x[here] > np.max(x[here]) - 0.6 * self.case.spacing
                surface[k] = np.mean(state["temperature"][inside][here][outermost])
        escaped = (x > self.case.half_width + 5.0 * self.case.spacing) & ~solid
        return {
            "shell_thickness": area / np.diff(self.edges),
            "shell_surface_temperature": surface,
            "escaped_melt": float(np.sum(escaped)),
        }
