"""Fluid between two plates that move along themselves."""

from warpsph.cases.scenario import parameter
from warpsph.scenarios.flow.channel import SOURCE, ParallelFlow


class Couette(ParallelFlow):
    """The upper plate starts to move along itself, the lower one at another speed, and they take the fluid along."""

    name = "couette"
    summary = "fluid between two plates that slide"
    source = f"{SOURCE}, equation 22"

    lower: float = parameter(0.0, "", "speed of the lower plate over U, which is that of the upper one", ge=-1, le=1)

    @property
    def plate_speeds(self) -> tuple[float, float]:
        return self.lower * self.speed, self.speed

    @property
    def label(self) -> str:
        return super().label + (f", lower plate at {self.lower:g} U" if self.lower else "")

    @classmethod
    def variations(cls) -> tuple[ParallelFlow, ...]:
        return cls(lower=-1.0), cls(slip="lower")
