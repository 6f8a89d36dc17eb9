"""Fluid between two plates at rest that is pushed along them."""

from warpsph.scenarios.flow.channel import SOURCE, ParallelFlow


class Poiseuille(ParallelFlow):
    """A push sets fluid between two plates at rest in motion, until the friction at the plates balances it."""

    name = "poiseuille"
    summary = "fluid pushed along between two plates"
    source = f"{SOURCE}, equation 21"

    @property
    def push(self) -> float:
        # a plate along which the fluid slips is the middle of a channel twice as high
        share = 8.0 if self.slip == "none" else 2.0
        return share * self.kinematic_viscosity * self.speed / self.height**2
