"""The term: its parameters, its arrays, its constants, its time step, and when it acts."""

from dataclasses import dataclass

from dye.kernels import add_dye, sum_dye
from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.kernels.basics.smoothing import normalisation


@dataclass(frozen=True, eq=False)
class Dye(Term):
    """A passive dye that diffuses.

    Args:
        diffusivity: D [m^2/s].
    """

    diffusivity: float

    provides = ("dye",)

    dye = Field(float, "", "concentration of the dye", written=True, renewed=True, colours="magma")
    dye_rate = Field(float, "1/s", "change of the dye in unit time", kept=False)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        W = normalisation("wendland_c2", model.dimension, model.support) / model.lattice.slope("wendland_c2")
        return {"support": model.support, "scale": self.diffusivity * model.cell_volume * W}

    def reach(self, model: Model) -> float:
        return model.support

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        return {"diffusion of the dye": 0.1 * model.spacing**2 / self.diffusivity}

    def sum_forces(self, launch: Launch) -> None:
        launch(sum_dye)

    def move(self, launch: Launch) -> None:
        launch(add_dye)
