"""Arguments without meaning are refused where they are given, in one line that names them."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.errors import InputError
from warpsph.machine import Inlet, LevelGauge, OscillatingMould, Outflow, Settling, Spray, SprayZone, SymmetryPlane
from warpsph.terms import (
    ColourFieldTension,
    Conduction,
    Elasticity,
    Fluid,
    HeatWall,
    PhaseChange,
    SurfaceTension,
)

WATER = (fluid_material("water", 1000.0),)
NAN, INFINITE = float("nan"), float("inf")
SQUARE = lattice((0.0, 0.0), (0.1, 0.1), 0.02)
GAUGE = LevelGauge((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), 0.1, 0.01, 1.0)
INLET = {"gauge": GAUGE, "row": np.zeros((2, 3)), "direction": (1.0, 0.0, 0.0), "length": 0.1, "temperature": 300.0}
OUTFLOW = {"gauge": GAUGE, "begin": 0.2, "end": 0.1, "width": 1.0}
ZONE = {"low": 0.1, "high": 0.2, "rate": 10.0}
SPRAY = {
    "zones": [SprayZone(**ZONE)], "nozzle": 1.0, "speed": 1.0, "near": 0.01, "lost": 2.0, "temperature": 300.0,
    "boiled": 373.0, "material": "water",
}  # fmt: skip
UNIT = ((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))


def add(position: Any = SQUARE, role: Any = Role.FREE, **values: Any) -> None:
    Particles().add(position, role, **values)


REFUSED: list[tuple[Callable[[], Any], str]] = [
    *((lambda nu=nu: Elasticity(1e5, nu), "Elasticity: poisson_ratio") for nu in (0.5, 0.7, -1.0, NAN, "soft")),
    *((lambda E=E: Elasticity(E, 0.3), "Elasticity: youngs_modulus") for E in (0.0, -1.0, NAN, INFINITE, "a", None)),
    *((lambda h=h: Elasticity(1e5, 0.3, hourglass=h), "Elasticity: hourglass") for h in (-1.0, "strong")),
    (lambda: Elasticity(1e5, 0.3, support_ratio="wide"), "Elasticity: support_ratio"),
    *((lambda rho=rho: Fluid(rho, 10.0), "Fluid: reference_density") for rho in (0.0, -1.0, NAN, "heavy")),
    *((lambda c=c: Fluid(1000.0, c), "Fluid: sound_speed") for c in (0.0, -1.0, NAN, [10.0])),
    (lambda: PhaseChange(0.4, 0.5), "PhaseChange: melt_below"),
    (lambda: PhaseChange(0.5, "low"), "PhaseChange: melt_below"),
    *((lambda f=f: PhaseChange(f), "PhaseChange: freeze_above") for f in (1.5, "high")),
    *((lambda t=t: Conduction(longest_interval=t), "Conduction: longest_interval") for t in (0.0, NAN, "long")),
    *(
        (lambda films=films: Conduction(films), "Conduction: films")
        for films in ({("water", "water"): -1.0}, {("water", "water"): "good"}, {"water": 1.0}, {(0, 1): 1.0}, [1.0])
    ),
    *((lambda c=c: SurfaceTension(c), "SurfaceTension: coefficient") for c in (-1.0, "strong")),
    (lambda: SurfaceTension(0.07, "low"), "SurfaceTension: threshold"),
    (lambda: Conduction(walls=((1.0, 0.0, 0.0),)), "Conduction: walls"),
    *(
        (lambda n=n: HeatWall.insulated(n, 0.0), "HeatWall: normal")
        for n in ((1.0, 1.0, 0.0), (0.0, 0.0, 0.0), (1.0, 0.0), (NAN, 0.0, 0.0))
    ),
    *((lambda x=x: HeatWall.insulated((1.0, 0.0, 0.0), x), "HeatWall: offset") for x in (NAN, INFINITE)),
    *((lambda h=h: HeatWall.film((1.0, 0.0, 0.0), 0.0, h, 300.0), "HeatWall: conductance") for h in (-1.0, NAN)),
    *(
        (lambda T=T: HeatWall.at_temperature((1.0, 0.0, 0.0), 0.0, T), "HeatWall: outside")
        for T in (NAN, INFINITE, -1.0)
    ),
    *((lambda q=q: HeatWall.given_flux((1.0, 0.0, 0.0), 0.0, q), "HeatWall: flux") for q in (NAN, INFINITE)),
    (lambda: ColourFieldTension(NAN), "ColourFieldTension: coefficient"),
    *((lambda d=d: Model(d, 0.1, WATER), "Model: dimension") for d in (4, "2", [2], None)),
    *((lambda dx=dx: Model(2, dx, WATER), "Model: spacing") for dx in (0.0, -0.1, NAN, "fine")),
    *((lambda h=h: Model(2, 0.1, WATER, support_ratio=h), "Model: support_ratio") for h in (1.0, 0.0, NAN, 50.0, "2")),
    *((lambda m=m: Model(2, 0.1, m), "Model: materials") for m in ((), None, WATER[0], ("water",))),
    *(
        (lambda g=g: Model(2, 0.1, WATER, gravity=g), "Model: gravity")
        for g in ((0.0, NAN, 0.0), (0.0, -9.81), 9.81, "abc", ("a", "b", "c"))
    ),
    (lambda: Model(2, 0.1, WATER, Conduction()), "Model: terms"),
    *((lambda v=v: Settling(v, 1.0), "Settling: rate") for v in (-1.0, NAN, "slow")),
    *((lambda v=v: Settling(1.0, v), "Settling: until") for v in (NAN, "late")),
    *((lambda v=v: OscillatingMould(v, 1.0), "OscillatingMould: stroke") for v in (NAN, "far")),
    *((lambda v=v: OscillatingMould(0.01, v), "OscillatingMould: frequency") for v in (-1.0, "fast")),
    *((lambda n=n: SymmetryPlane(n, 0.0), "SymmetryPlane: normal") for n in ((1.0, 1.0, 0.0), (1.0, 0.0), "abc", 1.0)),
    *((lambda v=v: SymmetryPlane((1.0, 0.0, 0.0), v), "SymmetryPlane: offset") for v in (NAN, "left")),
    (lambda: LevelGauge((0.0, 0.0), (1.0, 1.0), 0.1, 0.01, 1.0), "LevelGauge: high"),
    (lambda: LevelGauge(*UNIT, "high", 0.01, 1.0), "LevelGauge: target_level"),
    *((lambda v=v: LevelGauge(*UNIT, 0.1, v, 1.0), "LevelGauge: casting_speed") for v in (NAN, "fast")),
    *(
        (lambda kind=kind, given=given | {name: value}: kind(**given), f"{kind.__name__}: {name} = ")
        for kind, given, wrong in (
            (
                Inlet,
                INLET,
                {"gauge": None, "row": [0.0], "direction": (1.0, 1.0, 0.0), "length": NAN, "temperature": -1},
            ),
            (Outflow, OUTFLOW, {"gauge": 3, "begin": "low", "end": 0.3, "width": 0.0}),
            (SprayZone, ZONE, {"low": NAN, "high": 0.0, "rate": -1.0, "off": "never"}),
            (Spray, SPRAY, {"zones": [1], "nozzle": NAN, "speed": 0.0, "near": "close", "lost": None, "breadth": -1.0}),
        )
        for name, value in wrong.items()
    ),
    (lambda: add(np.array([[NAN, 0.0, 0.0]])), "particles: position: 1 of 1 are not finite"),
    (lambda: add(np.zeros((3, 2))), r"particles: position has the shape \(3, 2\)"),
    *((lambda x=x: add(x), "particles: position") for x in ("abc", None, [[1], [1, 2]], np.zeros((3, 3), complex))),
    *((lambda r=r: add(role=r), "particles: role") for r in ("free", 9, None, [0, 0], [[0], [0, 0]])),
    *(
        (lambda m=m: add(material=m), "particles: material")
        for m in (0, -1, WATER[0], ["water"] * 3, [1] * len(SQUARE))
    ),
    *((lambda v=v: add(volume=v), "particles: volume") for v in (-1.0, NAN, "large")),
    (lambda: add(flows="yes"), "particles: flows"),
    (lambda: add(temperature=[[1.0], [1.0, 2.0]]), "particles: temperature"),
    (lambda: Particles().add_table({"role": Role.FREE}), "particles: the table has no position"),
    (lambda: Particles().add_table({"position": SQUARE}), "particles: the table has no role: give one"),
    *((lambda dx=dx: lattice((0.0, 0.0), (1.0, 1.0), dx), "lattice: spacing") for dx in (0, -0.1, NAN, "fine")),
    *(
        (lambda box=box: lattice(*box, 0.1), "lattice: lower, upper")
        for box in (((0, 0), (1, 1, 1)), ("ab", (1, 1)), ((0, 0), (NAN, 1)), (0, 1), ((0,), (1,)))
    ),
    (lambda: tank((0.0, 0.0), (1.0, 1.0), 0), "tank: spacing"),
    *((lambda n=n: tank((0.0, 0.0), (1.0, 1.0), 0.1, n), "tank: layers") for n in (0, -1, "three")),
    *((lambda d=d: Executor(d), "device '") for d in ("gpu", 3)),
    *((lambda n=n: Executor("cpu", n), "threads = ") for n in (0, -1, 1.5, "two")),
]


@pytest.mark.parametrize(("make", "words"), REFUSED, ids=[f"{k}-{words}" for k, (_, words) in enumerate(REFUSED)])
def test_nonsense_is_refused(make, words):
    """If it failed, a wrong number would end in a raw error, or in a run that means nothing."""
    with pytest.raises(InputError, match=words) as caught:
        make()
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 250
