"""What is recorded for a device must not allocate: CUDA forbids it in a conditional body."""

import ast
from pathlib import Path

import pytest
import warp as wp

import warpsph
import warpsph.kernels
import warpsph.scenarios
from warpsph.core.executor import Executor
from warpsph.scenarios import DamBreak, Drop, RubberRings
from warpsph.scenarios.casting.casting import Casting

SOURCES = [path for package in (warpsph, warpsph.kernels) for path in Path(package.__file__).parent.rglob("*.py")]
CASES = [Casting(), DamBreak(columns=8), Drop(rows=6), RubberRings(layers=4)]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_nothing_that_is_recorded_allocates(case, device, monkeypatch):
    """If it failed, recording the first graph on a GPU would fail, or every step would wait for memory."""
    simulation = case.build(Executor(device))
    simulation.solver.set_steps(1e-5, 1e-5)
    simulation.prepare()
    sizes: list[int] = []
    allocator = wp.get_device(device).get_allocator()
    allocate = allocator.allocate
    monkeypatch.setattr(allocator, "allocate", lambda size: sizes.append(size) or allocate(size))
    step = simulation.solver.step_with_heat if simulation.plan.with_heat else simulation.solver.step
    simulation.executor.record(step)
    assert sizes == []


def test_nothing_uses_the_helpers_of_warp_that_allocate_by_themselves():
    """If it failed, scratch memory would be taken where no allocator of ours sees it (NVIDIA/warp#866)."""
    for path in SOURCES:
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                assert (node.value.id, node.attr) != ("wp", "utils"), path
