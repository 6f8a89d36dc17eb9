"""A result file of a periodic case says so."""

import pytest

from warpsph.cli import main
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.files.results import ResultFile
from warpsph.run.simulation import Simulation


@pytest.mark.parametrize("periodic", [PeriodicBox((0.2, 0.0, 0.0), (1.25, 0.0, 0.0)), None])
def test_the_box_is_written_and_told(tmp_path, capsys: pytest.CaptureFixture[str], periodic):
    """Whoever looks at the file would take the border for a surface."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (1.0, 0.3), 0.1), Role.FREE)
    model = Model(2, 0.1, (fluid_material("water", 1000.0),), periodic=periodic)
    path = tmp_path / "run.vtkhdf"
    Simulation(Executor("cpu"), model, particles, dt=0.01).run(0.02, 0.02, output=path)
    assert PeriodicBox.of_facts(ResultFile(path).provenance) == periodic
    assert main(["info", str(path)]) == 0
    rows = [line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines() if "periodic" in line]
    told = {name: " ".join(text.split()) for name, text in rows}
    assert told == ({"periodic_lower": "[0.2, 0, 0]", "periodic_lengths": "[1.25, 0, 0]"} if periodic else {})
