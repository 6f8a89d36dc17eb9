"""Buoyancy: the force, the walls under it, and what is refused."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.faces import way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Buoyancy, Conduction, CorrectedFluid, Fluid, Solute, SummedDensity

G = (0.0, -10.0, 0.0)
SOUND = 10.0
FLOWS = {"corrected": (CorrectedFluid(1.0, SOUND),), "published": (Fluid(1.0, SOUND, tension=True), SummedDensity())}


def layer(device, terms, dx=0.05, gravity=(0.0, 0.0, 0.0), **start):
    fluid = fluid_material("fluid", 1.0, 0.01, conductivity=1e-6, heat_capacity=1.0)
    model = Model(
        dimension=2,
        spacing=dx,
        materials=(fluid, solid_material("wall", 1.0, 0.01)),
        terms=terms,
        gravity=gravity,
        periodic=PeriodicBox((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
    )
    x, outside = lattice((0.0, 0.0), (1.0, 1.0), dx), lattice((0.0, -3.0 * dx), (1.0, 1.0 + 3.0 * dx), dx)
    way = way_to_box(outside, (-np.inf, 0.0, 0.0), (np.inf, 1.0, 0.0))
    walls = np.linalg.norm(way, axis=1) > 0.0
    particles = Particles()
    particles.add(x, Role.FREE, "fluid", **{name: value(x) for name, value in start.items()})
    corrected = any(isinstance(term, CorrectedFluid) for term in terms)
    particles.add(outside[walls], Role.DUMMY, "wall", **({"to_surface": way[walls]} if corrected else {}))
    return Simulation(Executor(device), model, particles)


@pytest.mark.parametrize("flow", FLOWS.values(), ids=FLOWS.keys())
@pytest.mark.parametrize("carrier", ["temperature", "solute"])
def test_what_is_lighter_rises(flow, carrier, device):
    """Otherwise warm liquid, or liquid that has given off its heavy solute, would stay or sink."""
    if carrier == "temperature":
        terms = (*flow, Conduction(), Buoyancy(0.1, 300.0, gravity=G))
        start = {"temperature": lambda x: np.full(len(x), 302.0)}
    else:
        terms = (*flow, Solute(), Buoyancy(solutal_expansion=0.5, reference_solute=0.1, gravity=G))
        start = {"solute": lambda x: np.full(len(x), 0.5)}
    simulation = layer(device, terms, **start)
    simulation.run(1e-3, 1e-3)
    state = simulation.snapshot()
    inside = np.abs(state["position"][:, 1] - 0.5) < 0.2
    # 0.1 / K times 2 K, and 0.5 times 0.4: a fifth of gravity, upward; pressure has not come from the walls yet
    np.testing.assert_allclose(state["velocity"][inside, 1], 2e-3, rtol=1e-3)


def test_a_layered_fluid_stays_at_rest(device):
    """Otherwise a wall would not know what rests on it, and push what is warmer than the reference off."""
    terms = (CorrectedFluid(1.0, SOUND), Conduction(), Buoyancy(0.1, 299.0, gravity=G))
    pressure = lambda x: x[:, 1] + 0.5 * x[:, 1] ** 2 - 2.0 / 3.0  # noqa: E731
    simulation = layer(
        device,
        terms,
        temperature=lambda x: 300.0 + x[:, 1],
        pressure=pressure,
        compression=lambda x: pressure(x) / SOUND**2,
    )
    simulation.run(1.0, 1.0)
    state = simulation.snapshot()
    fluid = state["role"] == Role.FREE
    error = state["pressure"][fluid] - pressure(state["position"][fluid].astype(float))
    assert np.std(error) < 0.01  # of 1.5 Pa from floor to ceiling: half a per cent, by rows that settle
    assert np.linalg.norm(state["velocity"][fluid], axis=1).max() < 0.02  # sound of the start; free rise makes 1 m/s


@pytest.mark.parametrize(
    ("terms", "message"),
    [
        ((Buoyancy(0.1, 300.0, gravity=G),), "needs fluid in the same case"),
        ((*FLOWS["corrected"], Buoyancy(0.1, 300.0, gravity=G)), "expansion needs a temperature.*add Conduction"),
        ((*FLOWS["corrected"], Buoyancy(solutal_expansion=1.0, gravity=G)), "needs a solute.*add Solute"),
        ((*FLOWS["corrected"], Conduction(), Buoyancy(0.1, 300.0)), "the model has no gravity"),
    ],
)
def test_buoyancy_without_what_is_buoyant_is_refused(terms, message):
    """Otherwise a case without heat, solute or gravity would run as if nothing were buoyant."""
    with pytest.raises(InputError, match=message):
        layer("cpu", terms)


def test_buoyancy_of_nothing_is_refused():
    """Otherwise forgetting the coefficient would give a case that does not turn over."""
    with pytest.raises(InputError, match="nothing is buoyant"):
        Buoyancy(reference=300.0)
