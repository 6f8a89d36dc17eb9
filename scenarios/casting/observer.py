"""What is measured of a casting run: level, ledgers of mass and heat, and the shell along the height."""

from typing import Any

import numpy as np

from warpsph.core.labels import Phase, Role
from warpsph.core.materials import WATER
from warpsph.core.model import Model
from warpsph.core.state import Snapshot
from warpsph.run.diagnostics import enthalpy_by_material
from warpsph.run.events import Events
from warpsph.run.measured import Measured, Values
from warpsph.scenarios.casting.machine import MOULD, CastingMachine
from warpsph.scenarios.casting.parameters import CastingParameters
from warpsph.scenarios.casting.watch import ShellWatch

BINS = 22


class CastingObserver:
    """Gives the diagnostics of a casting run, in the plane per metre of depth; ledgers count from the start of the run.

    Args:
        case: the scenario.
        machine: its parts.
    """

    def __init__(self, case: CastingParameters, machine: CastingMachine):
        self.case, self.gauge, self.inlet, self.spray = case, machine.gauge, machine.inlet, machine.spray
        self.noted: set[str] = set()
        self.edges = np.linspace(0.0, case.level, BINS + 1)
        self.heights = 0.5 * (self.edges[1:] + self.edges[:-1])

    def begin(self, model: Model, snapshot: Snapshot, events: Events) -> None:
        """Remember the initial contents, and where events are noted."""
        self.materials = len(model.materials)
        names = (self.case.steel.name, MOULD, WATER.name)
        self.steel, self.mould, self.water = (model.index_of(name) for name in names)
        self.start = enthalpy_by_material(snapshot, self.materials)
        self._note = events.note
        self.watch = ShellWatch(self.case, self.steel, events.note)

    def __call__(self, state: Snapshot, time: float) -> Values:
        self._note_shortages(time)
        self._note_passage(time)
        thickness, surface = self._shell(state)
        shell: Values = {
            "shell_thickness": Measured(thickness, "m", "shell thickness", over="height"),
            "shell_surface_temperature": Measured(
                surface, "K", "shell surface temperature", over="height", colours="inferno"
            ),
        }
        watched = self.watch(state, time, self.heights, thickness)
        flow = self._flow(state) | self._stroke(state)
        height: Values = {"height": Measured(self.heights, "m", "height")}
        return flow | self._mass(state) | self._heat(state) | shell | watched | height

    def describe(self, values: dict[str, Any]) -> str:
        """One line for the progress bar."""
        exit_bin = int(np.argmin(np.abs(self.heights - self.case.mould_bottom)))
        shell = 1e3 * values["shell_thickness"][exit_bin]
        early = values["time"] < self.case.passage - 1e-9
        unsteady = f", not yet steady (the start's strand is gone at {self.case.passage:.3g} s)" if early else ""
        return f"level {values['level']:.3f} m, shell at mould exit {shell:.1f} mm{unsteady}"

    def memory(self) -> dict[str, Any]:
        return {"noted": sorted(self.noted), "watch": self.watch.memory()}

    def restore(self, memory: dict[str, Any]) -> None:
        self.noted = set(memory["noted"])
        self.watch.restore(memory["watch"])

    def _note_passage(self, time: float) -> None:
        if time >= self.case.passage - 1e-9 and "passage" not in self.noted:
            self.noted.add("passage")
            self._note(time, "the strand has passed through once: nothing is left of that of the start")

    def _note_shortages(self, time: float) -> None:
        for part, substance in ((self.inlet, "melt"), (self.spray, "water")):
            if part.missing.numpy()[0] > 0 and substance not in self.noted:
                self.noted.add(substance)
                self._note(time, f"the reservoir has run out of {substance}")

    def _flow(self, state: Snapshot) -> Values:
        level, casting_speed, pouring_speed = (float(v) for v in self.gauge.speeds.numpy())
        x, y = state["position"][:, 0], state["position"][:, 1]
        column = (state["material"] == self.steel) & (state["role"] == Role.FREE)
        column &= (x > self.gauge.low[0]) & (x < self.gauge.high[0])
        meniscus = float(np.percentile(y[column], 99.5)) if np.any(column) else np.nan
        melt, water = (float(part.missing.numpy()[0]) for part in (self.inlet, self.spray))
        return {
            "level": Measured(level, "m", "melt level, by weight"),
            "meniscus": Measured(meniscus, "m", "meniscus"),
            "casting_speed": Measured(casting_speed, "m/s", "casting speed"),
            "pouring_speed": Measured(pouring_speed, "m/s", "pouring speed"),
            "missing_melt": Measured(melt, "", "melt missing in the reservoir"),
            "missing_water": Measured(water, "", "water missing in the reservoir"),
        }

    def _stroke(self, state: Snapshot) -> Values:
        """Velocities along y of the mould and of the skin of the shell in it."""
        case, velocity = self.case, state["velocity"][:, 1]
        x, y, _ = state["position"].T
        skin = (state["material"] == self.steel) & (state["role"] == Role.FREE) & (state["phase"] == Phase.SOLID)
        skin &= (x > case.half_width - 1.5 * case.spacing) & (y > case.mould_bottom) & (y < case.level)
        of_mould = float(np.mean(velocity[state["role"] == Role.WALL]))
        of_skin = float(np.mean(velocity[skin])) if np.any(skin) else np.nan
        return {
            "mould_velocity": Measured(of_mould, "m/s", "velocity of the mould"),
            "shell_velocity": Measured(of_skin, "m/s", "velocity of the shell's skin in the mould"),
        }

    def _mass(self, state: Snapshot) -> Values:
        steel = state["material"] == self.steel
        inside = steel & (state["role"] != Role.RESERVOIR)
        mass = state["mass"].astype(float)
        masses = {
            "inside": float(np.sum(mass[inside])),
            "in": float(np.sum((mass * state["entries"])[steel])),
            "out": float(np.sum((mass * state["exits"])[steel])),
        }
        numbers = {
            "inside": float(np.sum(inside)),
            "in": float(np.sum(state["entries"][steel])),
            "out": float(np.sum(state["exits"][steel])),
        }
        values: Values = {}
        for where, mass_there in masses.items():
            values[f"mass_{where}"] = Measured(mass_there, "kg", where, per_depth=True, panel="mass")
        for where, number in numbers.items():
            values[f"particles_{where}"] = Measured(number, "", where, panel="particles")
        return values

    def _heat(self, state: Snapshot) -> Values:
        now = enthalpy_by_material(state, self.materials)
        entered = np.bincount(state["material"], state["heat_entered"], self.materials)
        left = np.bincount(state["material"], state["heat_left"], self.materials)
        steel, mould, water = self.steel, self.mould, self.water
        to_mould = float(np.sum(state["heat_held"])) + now[mould] - self.start[mould]
        to_spray = now[water] - self.start[water] + left[water] - entered[water]
        change = now[steel] - self.start[steel]
        expected = entered[steel] - left[steel] - to_mould - to_spray
        turnover = entered[steel] + left[steel] + abs(to_mould) + abs(to_spray)
        error = (change - expected) / turnover if turnover > 0.0 else 0.0
        contents = {"inside": now[steel], "in": entered[steel], "out": left[steel]}
        taken = {"mould": to_mould, "spray": to_spray}
        return {
            **{
                f"enthalpy_{where}": Measured(float(heat), "J", where, per_depth=True, panel="enthalpy")
                for where, heat in contents.items()
            },
            **{
                f"heat_{where}": Measured(float(heat), "J", f"to the {where}", per_depth=True, panel="heat taken away")
                for where, heat in taken.items()
            },
            "ledger_error": Measured(float(error), "", "relative error of the heat ledger"),
        }

    def _shell(self, state: Snapshot) -> tuple[np.ndarray, np.ndarray]:
        """Thickness [m] and surface temperature [K] of the shell (heights,) at the face at x = half width.

        In 3D of the half of the face next to the axis.
        """
        case = self.case
        inside = (state["material"] == self.steel) & (state["role"] == Role.FREE)
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
        return volume / (breadth * np.diff(self.edges)), surface
