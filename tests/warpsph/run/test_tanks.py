"""Tanks keep what is in them, in every scenario that has one."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.state import Snapshot
from warpsph.run.simulation import Simulation
from warpsph.terms import CorrectedFluid

# the scenarios with a tank or walls around their fluid, each with the time [s] in which it would leak
TANKS = {
    "breakout": 0.06,
    "casting": 0.06,
    "cavity_flow": 2.0,
    "couette": 1.0,
    "dam_break": 0.8,
    "dam_impact": 1.2,
    "hydrostatic": 0.3,
    "natural_convection": 1.0,
    "poiseuille": 1.0,
    "still_tank": 2.0,
}
LOOKS = 20


def parts(state: Snapshot) -> tuple[np.ndarray, np.ndarray]:
    """Which particles (n,) are free liquid, and which are walls that it feels."""
    counts = state["fluid_mass"] > 0.0 if "fluid_mass" in state else np.zeros(len(state["role"]), bool)
    liquid = counts & (state["role"] == Role.FREE) & (state["phase"] != Phase.SOLID)
    return liquid, counts & np.isin(state["role"], (Role.WALL, Role.DUMMY))


def faces(simulation: Simulation) -> list[tuple[int, int, float]]:
    """Axis, outward direction and place [m] of each side of the box that walls make around the liquid of the start."""
    state, dx = simulation.snapshot(), simulation.model.spacing
    liquid, wall = parts(state)
    if not (np.any(liquid) and np.any(wall)):
        return []
    x, walls = state["position"][liquid].astype(float), state["position"][wall].astype(float)
    low, high = x.min(axis=0), x.max(axis=0)
    found = []
    for axis in range(simulation.model.dimension):
        beside = np.delete((walls >= low) & (walls <= high), axis, axis=1).all(axis=1)
        for side, end in ((-1, low[axis]), (1, high[axis])):
            outside = beside & (side * (walls[:, axis] - end) > 0.0)
            if np.any(outside):
                found.append((axis, side, float(np.min(side * walls[outside, axis])) - 0.5 * dx))
    return found


@pytest.mark.filterwarnings("ignore:the ledger")  # short runs are no matter of ledgers
def test_no_liquid_leaves_its_tank(case):
    """Particle after particle that leaks lowers the level of a long run, and its pressure, with nobody told."""
    simulation = case.build(Executor("cpu", 1))
    box = faces(simulation)
    assert bool(box) == (case.name in TANKS)
    if not box:
        return
    # walls of the published flow begin where their particles are
    allowed = 1.0e-5 if simulation.model.find(CorrectedFluid) else 0.5
    step = TANKS[case.name] / LOOKS
    for _ in range(LOOKS):
        simulation.run(step, step)
        state = simulation.snapshot()
        liquid, _ = parts(state)
        x = state["position"][liquid].astype(float)
        out = [np.sum(side * x[:, axis] - face > allowed * simulation.model.spacing) for axis, side, face in box]
        assert sum(out) == 0, f"{case.name} at {simulation.time:.3g} s: {out} particles beyond {box}"
