"""Arguments without meaning are refused where they are given, in one line that names them."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from warpsph.core.labels import Role
from warpsph.core.materials import inert
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.errors import InputError
from warpsph.terms import (
    ColourFieldTension,
    Conduction,
    Elasticity,
    Fluid,
    HeatWall,
    PhaseChange,
    SurfaceTension,
)

WATER = (inert("water", 1000.0),)
NAN, INFINITE = float("nan"), float("inf")

REFUSED: list[tuple[Callable[[], Any], str]] = [
    *((lambda nu=nu: Elasticity(1e5, nu), "Elasticity: poisson_ratio") for nu in (0.5, 0.7, -1.0, NAN)),
    *((lambda E=E: Elasticity(E, 0.3), "Elasticity: youngs_modulus") for E in (0.0, -1.0, NAN, INFINITE)),
    (lambda: Elasticity(1e5, 0.3, hourglass=-1.0), "Elasticity: hourglass"),
    *((lambda rho=rho: Fluid(rho, 10.0), "Fluid: reference_density") for rho in (0.0, -1.0, NAN)),
    *((lambda c=c: Fluid(1000.0, c), "Fluid: sound_speed") for c in (0.0, -1.0, NAN)),
    (lambda: PhaseChange(0.4, 0.5), "PhaseChange: melt_below"),
    (lambda: PhaseChange(1.5), "PhaseChange: freeze_above"),
    (lambda: Conduction(longest_interval=0.0), "Conduction: longest_interval"),
    (lambda: Conduction({("water", "water"): -1.0}), "Conduction: films"),
    (lambda: Conduction(walls=((1.0, 0.0, 0.0),)), "Conduction: walls"),
    *(
        (lambda n=n: HeatWall.insulated(n, 0.0), "HeatWall: normal")
        for n in ((1.0, 1.0, 0.0), (0.0, 0.0, 0.0), (1.0, 0.0), (NAN, 0.0, 0.0))
    ),
    *((lambda x=x: HeatWall.insulated((1.0, 0.0, 0.0), x), "HeatWall: offset") for x in (NAN, INFINITE)),
    *((lambda h=h: HeatWall.film((1.0, 0.0, 0.0), 0.0, h, 300.0), "HeatWall: conductance") for h in (-1.0, NAN)),
    *((lambda T=T: HeatWall.at_temperature((1.0, 0.0, 0.0), 0.0, T), "HeatWall: outside") for T in (NAN, INFINITE)),
    *((lambda q=q: HeatWall.given_flux((1.0, 0.0, 0.0), 0.0, q), "HeatWall: flux") for q in (NAN, INFINITE)),
    (lambda: SurfaceTension(-1.0), "SurfaceTension: coefficient"),
    (lambda: ColourFieldTension(NAN), "ColourFieldTension: coefficient"),
    (lambda: Model(4, 0.1, WATER), "Model: dimension"),
    *((lambda dx=dx: Model(2, dx, WATER), "Model: spacing") for dx in (0.0, -0.1, NAN)),
    *((lambda h=h: Model(2, 0.1, WATER, support_ratio=h), "Model: support_ratio") for h in (1.0, 0.0, NAN, 50.0)),
    (lambda: Model(2, 0.1, ()), "Model: materials"),
    (lambda: Model(2, 0.1, WATER, gravity=(0.0, NAN, 0.0)), "Model: gravity"),
    (lambda: Particles().add(np.array([[NAN, 0.0, 0.0]]), Role.FREE), "particles: position: 1 of 1 are not finite"),
    (lambda: Particles().add(np.zeros((3, 2)), Role.FREE), r"particles: position has the shape \(3, 2\)"),
]


@pytest.mark.parametrize(("make", "words"), REFUSED, ids=[f"{k}-{words}" for k, (_, words) in enumerate(REFUSED)])
def test_nonsense_is_refused(make, words):
    """If it failed, a wrong number would end in a raw error, or in a run that means nothing."""
    with pytest.raises(InputError, match=words) as caught:
        make()
    assert "\n" not in str(caught.value)
