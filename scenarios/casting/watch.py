"""The watch over the shell: when and where it thins after its sprays have failed, opens, and lets melt out."""

from collections.abc import Callable
from typing import Any

import numpy as np

from warpsph.core.labels import Phase, Role
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.scenarios.casting.parameters import CastingParameters

THIN = 0.7  # of the thickness before the sprays failed
HOLE_ROWS = 2  # rows of particles without any shell
THROUGH = 1.5  # spacings from the cold face at which melt has come through the shell
OUTSIDE = 5.0  # spacings from the cold face at which melt has left the strand
SETTLED = 1.0  # time after which the thickness counts as the one before the failure [s]


class ShellWatch:
    """Notes the moments of a breakout, each once, with its height.

    Thinning: where sprays have failed the shell, over three heights of its profile, has less than ``THIN`` of the mean
    thickness that it had there before. Hole: ``HOLE_ROWS`` rows of particles below the mould hold no solid, or melt has
    come ``THROUGH`` the shell. Outflow: melt is ``OUTSIDE`` spacings outside the cold face. Melt that is outside above
    the lower end of the mould has spilled over its rim.

    Args:
        case: the scenario.
        steel: index of its material.
        note: called with time [s] and text.
    """

    def __init__(self, case: CastingParameters, steel: int, note: Callable[[float, str], None]):
        self.case, self.steel, self._note = case, steel, note
        self._noted: set[str] = set()
        self._before: list[np.ndarray] = []
        rows = int(case.mould_bottom / (HOLE_ROWS * case.spacing))
        self._edges = np.arange(1, rows + 1) * HOLE_ROWS * case.spacing

    def __call__(self, state: Snapshot, time: float, heights: np.ndarray, thickness: np.ndarray) -> Values:
        """Note what has happened by ``time`` [s].

        Args:
            state: all particles.
            time: [s].
            heights, thickness: (m,) of the shell [m].

        Returns:
            ``hole_height``: height of strand below the mould that is without shell [m]; ``escaped_melt``: particles.
        """
        self._watch_thickness(time, heights, thickness)
        steel = (state["material"] == self.steel) & (state["role"] == Role.FREE)
        solid = steel & (state["phase"] == Phase.SOLID)
        x, y, z = state["position"].T
        shell, _ = np.histogram(y[solid & (x > 0.5 * self.case.half_width)], self._edges)
        open_rows = np.flatnonzero(shell == 0)
        outside = np.where(steel & ~solid, np.maximum(x, z) - self.case.half_width, -np.inf) / self.case.spacing
        below = y < self.case.mould_bottom
        through, escaped = below & (outside > THROUGH), below & (outside > OUTSIDE)
        if len(open_rows):
            self._note_at(time, "hole in the shell", self._edges[open_rows].mean() + HOLE_ROWS * self.case.spacing / 2)
        elif np.any(through):
            self._note_at(time, "hole in the shell", float(np.max(y[through])))
        if np.any(escaped):
            self._note_at(time, "melt runs out", float(np.max(y[escaped])))
        spilled = ~below & (outside > OUTSIDE)
        if np.any(spilled):
            self._once(time, "spill", f"melt spills over the mould: it is at {np.max(y[spilled]):.3f} m outside of it")
        hole = float(len(open_rows) * HOLE_ROWS * self.case.spacing)
        return {
            "hole_height": Measured(hole, "m", "height without shell"),
            "escaped_melt": Measured(float(np.sum(escaped)), "", "particles of escaped melt"),
        }

    def memory(self) -> dict[str, Any]:
        return {"noted": sorted(self._noted), "before": list(self._before)}

    def restore(self, memory: dict[str, Any]) -> None:
        self._noted, self._before = set(memory["noted"]), list(memory["before"])

    def zone_text(self, height: float, time: float) -> str:
        """Where a height [m] is at a time [s], in words."""
        zone = self.case.zone_at(height)
        if zone is None:
            return "in the mould"
        failure = self.case.spray_failure
        failed = failure is not None and time >= failure and zone in self.case.spray_failing
        return f"zone {zone} ({'failed' if failed else 'sprayed'})"

    def _note_at(self, time: float, kind: str, height: float) -> None:
        self._once(time, kind, f"{kind} at {height:.3f} m, {self.zone_text(height, time)}")

    def _watch_thickness(self, time: float, heights: np.ndarray, thickness: np.ndarray) -> None:
        failure = self.case.spray_failure
        if failure is None or not self.case.spray_failing:
            return
        if time < failure:
            if time >= min(SETTLED, 0.5 * failure):
                self._before.append(thickness)
            return
        zones = ", ".join(str(zone) for zone in self.case.spray_failing)
        self._once(failure, "failure", f"sprays fail in zone {zones}")
        failed = np.array([self.case.zone_at(height) in self.case.spray_failing for height in heights])
        if self._before and np.any(failed):
            before = np.mean(self._before, axis=0)
            share = _over_three(thickness) / np.maximum(_over_three(before), self.case.spacing)
            share[~failed] = np.inf
            place = int(np.argmin(share))
            if share[place] < THIN:
                text = f"the shell thins: {1e3 * thickness[place]:.1f} mm at {heights[place]:.3f} m"
                self._once(time, "thinning", f"{text}, {self.zone_text(heights[place], time)}")

    def _once(self, time: float, kind: str, text: str) -> None:
        if kind not in self._noted:
            self._noted.add(kind)
            self._note(time, text)


def _over_three(values: np.ndarray) -> np.ndarray:
    """Mean of every value and its two neighbours, at the ends of one."""
    padded = np.pad(values, 1, mode="edge")
    return (padded[:-2] + padded[1:-1] + padded[2:]) / 3.0
