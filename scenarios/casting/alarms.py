"""What somebody at the machine would be told: once, when it happens."""

from typing import Any

from warpsph.run.events import Events
from warpsph.scenarios.casting.machine import CastingMachine
from warpsph.scenarios.casting.parameters import CastingParameters

WARNING = "warning: "
SETTLED = 1.0  # time in which a shell that was at rest comes to bear the melt [s]


class Alarms:
    """Notes that the strand has passed through, that reservoirs are empty, that the shell jumps, that it is lost.

    Args:
        case: the scenario.
        machine: its parts.
        events: where they are noted.
    """

    def __init__(self, case: CastingParameters, machine: CastingMachine, events: Events):
        self.case, self.inlet, self.spray, self._events = case, machine.inlet, machine.spray, events
        self._noted: set[str] = set()

    def __call__(self, time: float, level: float, shell_speed: float) -> None:
        """Look at the level [m] and at the highest speed of the shell [m/s] at a time [s]."""
        case = self.case
        if time >= case.passage - 1e-9:
            self._once(time, "passage", "the strand has passed through once: nothing is left of that of the start")
        for part, substance in ((self.inlet, "melt"), (self.spray, "water")):
            if part.missing.numpy()[0] > 0:
                self._once(time, substance, f"{WARNING}the reservoir has run out of {substance}")
        if shell_speed > case.fastest_shell and time > SETTLED:
            text = f"the shell jumps at {shell_speed:.2g} m/s, and should not exceed {case.fastest_shell:.2g} m/s"
            self._once(time, "jump", f"{WARNING}{text}")
        if level < case.mould_bottom:
            text = f"the strand is lost: its level has fallen to {level:.3f} m, out of the mould"
            self._once(time, "lost", f"{WARNING}{text}")
            self._events.outcome = "strand lost"

    def memory(self) -> dict[str, Any]:
        return {"noted": sorted(self._noted)}

    def restore(self, memory: dict[str, Any]) -> None:
        self._noted = set(memory["noted"])

    def _once(self, time: float, kind: str, text: str) -> None:
        if kind not in self._noted:
            self._noted.add(kind)
            self._events.note(time, text)
