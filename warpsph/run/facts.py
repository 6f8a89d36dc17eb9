"""What a result file says of the run that made it."""

from typing import Any
from uuid import uuid4

from warpsph.core.executor import Executor
from warpsph.core.model import Model
from warpsph.files.provenance import provenance


def facts_of_run(executor: Executor, model: Model) -> dict[str, Any]:
    """Versions, machine, device and moment, a name of its own, and what pictures must know of the case."""
    facts = provenance(executor.device_name, executor.threads) | {
        "run": uuid4().hex,
        "spacing": model.spacing,
        "dimension": model.dimension,
        "materials": [material.name for material in model.materials],
    }
    melting = {material.name: [material.solidus, material.liquidus] for material in model.materials if material.melts}
    if melting:
        facts["melting_ranges"] = melting
    if model.periodic is not None:
        facts |= model.periodic.facts()
    for term in model.terms:
        facts |= term.facts()
    return facts
