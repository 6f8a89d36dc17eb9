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
from warpsph.scenarios.casting.alarms import Alarms
from warpsph.scenarios.casting.machine import MOULD, CastingMachine
from warpsph.scenarios.casting.parameters import CastingParameters
from warpsph.scenarios.casting.shell import profile_heights, shell_profile
from warpsph.scenarios.casting.watch import ShellWatch

EXIT_MEAN = 1.0 / 3.0  # last part of a run over which the shell at the mould's exit is averaged


class CastingObserver:
    """Gives the diagnostics of a casting run, in the plane per metre of depth; ledgers count from the start of the run.

    Args:
        case: the scenario.
        machine: its parts.
    """

    def __init__(self, case: CastingParameters, machine: CastingMachine):
        self.case, self.machine, self.gauge, self.spray = case, machine, machine.gauge, machine.spray
        self.heights = profile_heights(case)
        self._exit: dict[float, float] = {}  # thickness of the shell at the mould's exit, by time

    def begin(self, model: Model, snapshot: Snapshot, events: Events) -> None:
        """Remember the initial contents, and where events are noted."""
        self.materials = len(model.materials)
        names = (self.case.steel.name, MOULD, WATER.name)
        self.steel, self.mould, self.water = (model.index_of(name) for name in names)
        self.start = enthalpy_by_material(snapshot, self.materials)
        self.watch = ShellWatch(self.case, self.steel, events.note)
        self.alarms = Alarms(self.case, self.machine, events)

    def __call__(self, state: Snapshot, time: float) -> Values:
        free = (state["material"] == self.steel) & (state["role"] == Role.FREE)
        of_free = (state[name][free] for name in ("position", "solid_fraction", "temperature"))
        thickness, surface = shell_profile(self.case, self.heights, *of_free)
        self._exit[time] = float(np.interp(self.case.mould_bottom, self.heights, thickness))
        speed, grain_speed = self.machine.speedometer.read()
        self.alarms(time, float(self.gauge.speeds.numpy()[0]), speed)
        shell: Values = {
            "height": Measured(self.heights, "m", "height"),
            "shell_thickness": Measured(thickness, "m", "shell thickness", over="height"),
            "shell_surface_temperature": Measured(
                surface, "K", "shell surface temperature", over="height", colours="inferno"
            ),
            "shell_speed": Measured(speed, "m/s", "highest speed of the shell"),
            "grain_speed": Measured(grain_speed, "m/s", "highest speed of grains in the melt"),
        }
        watched = self.watch(state, time, self.heights, thickness)
        flow = self._flow(state) | self._stroke(state) | self._water(state)
        return flow | self._mass(state) | self._heat(state) | shell | watched

    def describe(self, values: dict[str, Any]) -> str:
        """One line for the progress bar and the summary."""
        times, thickness = np.array(list(self._exit.items())).T
        late = 1e3 * thickness[times >= (1.0 - EXIT_MEAN) * times[-1]]
        early = values["time"] < self.case.passage - 1e-9
        unsteady = f", not yet steady (the start's strand is gone at {self.case.passage:.3g} s)" if early else ""
        shell = "no shell at mould exit"
        if np.all(np.isfinite(late)):
            now = f"{1e3 * thickness[-1]:.1f} mm"
            shell = f"shell at mould exit {now} (last third {late.mean():.1f} ± {late.std():.1f} mm)"
        return f"level {values['level']:.3f} m, {shell}{unsteady}"

    def memory(self) -> dict[str, Any]:
        return {"exit": dict(self._exit), "watch": self.watch.memory(), "alarms": self.alarms.memory()}

    def restore(self, memory: dict[str, Any]) -> None:
        self._exit = {float(time): float(shell) for time, shell in memory["exit"].items()}
        self.watch.restore(memory["watch"])
        self.alarms.restore(memory["alarms"])

    def _flow(self, state: Snapshot) -> Values:
        level, casting_speed, pouring_speed = (float(v) for v in self.gauge.speeds.numpy())
        x, y = state["position"][:, 0], state["position"][:, 1]
        column = (state["material"] == self.steel) & (state["role"] == Role.FREE)
        column &= (x > self.gauge.low[0]) & (x < self.gauge.high[0])
        top = float(np.percentile(y[column], 99.5)) + 0.5 * self.case.spacing if np.any(column) else np.nan
        melt, water = (float(part.missing.numpy()[0]) for part in (self.machine.inlet, self.spray))
        return {
            "level": Measured(level, "m", "melt level, by weight"),
            "meniscus": Measured(top, "m", "meniscus"),
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

    def _water(self, state: Snapshot) -> Values:
        """Water that the strand has closed over: still there, and taken out."""
        x, y, z = state["position"].T
        away = np.maximum(x, z) if self.case.dimension == 3 else x
        steel = (state["material"] == self.steel) & (state["role"] == Role.FREE)
        inside = 0
        for drop in np.flatnonzero(state["role"] == Role.SPRAY):
            beside = steel & (np.abs(y - y[drop]) < 0.5 * self.case.spacing)
            if self.case.dimension == 3:
                across = np.where(x > z, z, x)
                beside &= (np.abs(across - across[drop]) < 0.5 * self.case.spacing) & ((x > z) == (x[drop] > z[drop]))
            inside += bool(np.any(away[beside] > away[drop] + 0.5 * self.case.spacing))
        return {
            "water_inside": Measured(float(inside), "", "in the steel", panel="particles of water"),
            "water_caught": Measured(
                float(self.spray.caught.numpy()[0]), "", "closed over and taken out", panel="particles of water"
            ),
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
