"""What is measured of a casting run: level, ledgers of mass and heat, and the shell along the height."""

from typing import TYPE_CHECKING

import numpy as np

from warpsph.core.labels import Phase, Role
from warpsph.run.diagnostics import Snapshot, enthalpy_by_material
from warpsph.scenarios.casting.watch import ShellWatch

if TYPE_CHECKING:
    from warpsph.run.simulation import Simulation
    from warpsph.scenarios.casting.casting import Casting
    from warpsph.scenarios.casting.machine import CastingMachine

BINS = 22
Values = dict[str, float | np.ndarray]


class CastingObserver:
    """Gives the diagnostics of a casting run, in the plane per metre of depth; ledgers count from the start of the run.

    Args:
        case: the scenario.
        machine: its devices.
    """

    def __init__(self, case: "Casting", machine: "CastingMachine"):
        self.case, self.gauge, self.inlet, self.spray = case, machine.gauge, machine.inlet, machine.spray
        self.noted: set[str] = set()
        self.watch = ShellWatch(case, self._note)
        self.edges = np.linspace(0.0, case.level, BINS + 1)
        self.heights = 0.5 * (self.edges[1:] + self.edges[:-1])

    def begin(self, simulation: "Simulation") -> None:
        """Remember the initial contents."""
        self.simulation = simulation
        self.materials = len(simulation.model.materials)
        self.start = enthalpy_by_material(simulation.snapshot(), self.materials)

    def __call__(self, state: Snapshot, time: float) -> Values:
        self._note_shortages(time)
        shell = self._shell(state)
        watched = self.watch(state, time, self.heights, shell["shell_thickness"])
        flow = self._flow(state) | self._stroke(state)
        return flow | self._mass(state) | self._heat(state) | shell | watched | {"height": self.heights}

    def describe(self, values: Values) -> str:
        """One line for the progress bar."""
        exit_bin = int(np.argmin(np.abs(self.heights - self.case.mould_bottom)))
        return f"level {values['level']:.3f} m, shell at mould exit {1e3 * values['shell_thickness'][exit_bin]:.1f} mm"

    def _note(self, time: float, text: str) -> None:
        self.simulation.note_event(time, text)

    def _note_shortages(self, time: float) -> None:
        for device, substance in ((self.inlet, "melt"), (self.spray, "water")):
            if device.missing.numpy()[0] > 0 and substance not in self.noted:
                self.noted.add(substance)
                self._note(time, f"the reservoir has run out of {substance}")

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

    def _stroke(self, state: Snapshot) -> Values:
        """Velocities along y of the mould and of the skin of the shell in it."""
        case, velocity = self.case, state["velocity"][:, 1]
        x, y, _ = state["position"].T
        skin = (state["material"] == 0) & (state["role"] == Role.FREE) & (state["phase"] == Phase.SOLID)
        skin &= (x > case.half_width - 1.5 * case.spacing) & (y > case.mould_bottom) & (y < case.level)
        return {
            "mould_velocity": float(np.mean(velocity[state["role"] == Role.WALL])),
            "shell_velocity": float(np.mean(velocity[skin])) if np.any(skin) else np.nan,
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
        """The shell of the face at x = half width; in 3D of its half next to the axis."""
        case = self.case
        inside = (state["material"] == 0) & (state["role"] == Role.FREE)
        inside &= state["position"][:, 0] > 0.5 * case.half_width
        breadth = 1.0
        if case.dimension == 3:
            breadth = 0.5 * case.half_width
            inside &= state["position"][:, 2] < breadth
        x, y = state["position"][inside, 0], state["position"][inside, 1]
        solid = state["phase"][inside] == Phase.SOLID
        temperature = state["temperature"][inside]
        place = np.digitize(y, self.edges) - 1
        strand = (place >= 0) & (place < BINS)
        volume = np.bincount(place[strand & solid], minlength=BINS) * case.spacing**case.dimension
        surface = np.full(BINS, np.nan)
        for k in range(BINS):
            here = strand & (place == k)
            if np.any(here):
                outermost = x[here] > np.max(x[here]) - 0.6 * case.spacing
                surface[k] = np.mean(temperature[here][outermost])
        return {
            "shell_thickness": volume / (breadth * np.diff(self.edges)),
            "shell_surface_temperature": surface,
        }
