"""What a run leaves."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from warpsph.core.quantity import Quantity
from warpsph.errors import InputError
from warpsph.files.tables import Diagnosed, optional
from warpsph.nearest import did_you_mean
from warpsph.run.ledgers import Ledger

if TYPE_CHECKING:
    import pandas


@dataclass
class Result(Diagnosed):
    """The final state as NumPy arrays and the diagnostics as time series.

    ``positions`` (n, 3) [m] and ``fields`` (n, ...) hold every particle in the order of its id, those in the reservoir
    too; ``quantities`` says what the diagnostics are called and in which unit; ``status`` is "complete",
    "interrupted", or what has become of the run, for example "strand lost"; ``materials`` are their names, by index;
    ``summary`` pairs a label with a text for people; ``stopped_by`` is the number of the signal that has interrupted
    the run, or 0; ``ledgers`` say of each conserved quantity whether it was.
    """

    positions: np.ndarray
    fields: dict[str, np.ndarray]
    diagnostics: dict[str, np.ndarray]
    quantities: dict[str, Quantity]
    events: list[tuple[float, str]]
    time: float
    steps: int
    status: str
    wall_time: float
    materials: tuple[str, ...] = ()
    summary: dict[str, str] = field(default_factory=dict)
    stopped_by: int = 0
    ledgers: list[Ledger] = field(default_factory=list)

    def made_of(self, material: str) -> np.ndarray:
        """Which particles (n,) are made of a material.

        Raises:
            InputError: there is no such material.
        """
        if material not in self.materials:
            raise InputError(f"unknown material '{material}'{did_you_mean(material, self.materials)}")
        return self.fields["material"] == self.materials.index(material)

    def particles_to_pandas(self) -> "pandas.DataFrame":
        """The final state, a row a particle and a column a number: x, y, z [m], then the fields in their units.

        Velocities stand in vx, vy, vz, other vectors in <name>_x, ...; materials by their names; tensors are left out.
        What ``to_csv(path, index=False)`` writes of it, :func:`warpsph.files.particles.read_particles` reads.

        Raises:
            InputError: pandas is not installed.
        """
        columns = dict(zip("xyz", self.positions.T, strict=True))
        for name, values in self.fields.items():
            if name == "material":
                columns[name] = np.array(self.materials, object)[values]
            elif values.ndim == 1:
                columns[name] = values
            elif values.ndim == 2:
                prefix = "v" if name == "velocity" else f"{name}_"
                columns |= {f"{prefix}{axis}": values[:, k] for k, axis in enumerate("xyz")}
        return optional("pandas").DataFrame(columns)
