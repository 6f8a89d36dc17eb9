"""The breakout of Vijaykumar (2012), section 7.4: the lower sprays fail, the shell melts through, melt runs out."""

from collections.abc import Callable, Iterable
from typing import ClassVar

import numpy as np

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.run.events import Event
from warpsph.run.result import Result
from warpsph.scenarios.breakout.reckoning import LAYERS, remelting_delay, thinnest_shell
from warpsph.scenarios.casting.casting import Casting
from warpsph.scenarios.casting.checks import ledger_checks

THINS, HOLE, OUTFLOW = EVENTS = ("the shell thins", "hole in the shell", "melt runs out")
PUBLISHED_HOLE = 13.0  # figure 7.5 (b) [s]


class Breakout(Casting):
    """Casting with a melt that brings more heat than the shell can bear without water.

    The water below the mould fails at ``spray_failure``; with no failing zone it is the control run.
    """

    name: ClassVar[str] = "breakout"
    summary: ClassVar[str] = "the lower sprays of the casting machine fail: the shell melts through, melt runs out"
    source: ClassVar[str] = "Vijaykumar (2012), section 7.4, figures 7.3 to 7.7"
    presets: ClassVar[tuple[str, ...]] = ("coarse", "fine")
    default_preset: ClassVar[str | None] = "coarse"

    mould_conductance: float = parameter(1700.0, "W/(m^2 K)", "conductance between steel and mould", gt=0, le=1e5)
    pouring_temperature: float = parameter(2043.15, "K", "temperature of the melt in the nozzle", gt=1000, le=2500)
    melt_conductivity: float = parameter(
        300.0, "W/(m K)", "conductivity of the melt, raised for its turbulence", ge=1, le=1e4
    )
    spray_flux: float = parameter(0.3, "kg/(m^2 s)", "water sprayed on the shell below the mould", ge=0, le=50)
    spray_zones: int = parameter(
        6, "", "number of zones between mould and outflow, the first under the mould", ge=1, le=20
    )
    spray_failure: float | None = parameter(2.5, "s", "time at which the failing zones go off; none: never", ge=0)
    spray_failing: tuple[int, ...] = parameter(
        (1, 2, 3, 4, 5, 6), "", "zones that fail, counted from the mould; [] for the control run"
    )
    roll_pitch: float = parameter(0.03, "m", "distance of the support rolls", gt=0, le=1)
    roll_first: float = parameter(0.226, "m", "height of the middle of the first roll", gt=0, le=5)

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The reckoning in one dimension; and, where there is time, the control run and the one that is calibrated."""
        yield from cls().reckoning()
        if slow:
            failed = resolve(cls, [preset_layer(cls, "coarse")])
            for case in (failed.model_copy(update={"spray_failing": ()}), failed):
                yield from case.checks(simulate(case))

    def reckoning(self) -> list[Check]:
        """Whether the heat of the melt suffices, by one-dimensional conduction."""
        return [
            Check(
                self.name, f"lack of shell below the mould, all sprays on, of {LAYERS:g} layers", "m",
                max(LAYERS * self.spacing - thinnest_shell(self), 0.0), None, 0.0,
                "one-dimensional enthalpy conduction of a stagnant slice",
                reason="two bonded layers at least must bear the melt between two rolls",
            ),
            Check(
                self.name, "time from the failure until the shell has remelted, one-dimensional", "s",
                remelting_delay(self), 10.0, 5.0, "figures 7.5 (a) and (b): within the 18 s of the run",
                relative=False, reason="what moves and what bulges is not in the reckoning",
            ),
        ]  # fmt: skip

    def checks(self, result: Result) -> list[Check]:
        control = not self.spray_failing
        return ledger_checks(self, result) + ([self._no_hole(result)] if control else self._events(result))

    def _no_hole(self, result: Result) -> Check:
        return Check(
            self.name, f"control at {1e3 * self.spacing:g} mm, all sprays on: openings of the shell", "",
            float(len(openings(result))), None, 0.0, "Vijaykumar (2012), figure 6.3 (a)", reason="the shell holds",
        )  # fmt: skip

    def _events(self, result: Result) -> list[Check]:
        """Thinning, hole and outflow come at the published times; the shell opens in a zone that has failed."""
        times = {kind: next((time for time, text in result.events if kind in text), np.inf) for kind in EVENTS}
        at, figures = f"at {1e3 * self.spacing:g} mm", "Vijaykumar (2012), figures 7.5 and 7.6"
        opened = [text for _, text in openings(result)]
        return [
            Check(
                self.name, f"{THINS}, {at}", "s", times[THINS], 12.0, 4.0, figures, relative=False,
                reason="noted as soon as three tenths are gone, drawn in the thesis a second before the hole",
            ),
            Check(
                self.name, f"{HOLE}, {at}", "s", times[HOLE], PUBLISHED_HOLE, 2.0, figures, relative=False,
                reason="the failure is set to this time; chance in a shell of few layers, and heights of the profile",
            ),
            Check(
                self.name, f"{OUTFLOW} after the hole, {at}", "s", times[OUTFLOW] - times[HOLE], 1.0, 1.0, figures,
                relative=False, reason="drawn two seconds after the hole, when it has been flowing",
            ),
            Check(
                self.name, f"openings outside the zones that failed, {at}", "",
                float(sum("(failed)" not in text for text in opened)), None, 0.0, "Vijaykumar (2012), section 7.4",
                reason="the shell melts where there is no spray",
            ),
        ]  # fmt: skip


def openings(result: Result) -> list[Event]:
    """When and where the shell has opened."""
    return [(time, text) for time, text in result.events if HOLE in text or OUTFLOW in text]
