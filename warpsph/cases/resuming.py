"""Going on with a case: what may change in it meanwhile, and what not."""

from typing import Any

from warpsph.errors import InputError, shown
from warpsph.files.checkpoint import Checkpoint

NOT_PARAMETERS = ("scenario", "version")


def parameters_of(checkpoint: Checkpoint, scenario: str) -> dict[str, Any]:
    """The parameters of the run that wrote a checkpoint.

    Raises:
        InputError: it is of another scenario.
    """
    parameters: dict[str, Any] = checkpoint.facts["parameters"]
    if parameters.get("scenario") != scenario:
        there = parameters.get("scenario") or "a run from Python without parameters"
        raise InputError(f"the checkpoint is of {there}, not of {scenario}")
    return {key: value for key, value in parameters.items() if key not in NOT_PARAMETERS}


def refuse_other_case(checkpoint: Checkpoint, scenario: str, now: dict[str, Any], changeable: set[str]) -> None:
    """Refuse a checkpoint of another case; only parameters that are declared ``changeable`` may differ.

    Args:
        checkpoint: from which a run shall go on.
        scenario: name of its scenario.
        now: its parameters, as they are stored with results.
        changeable: names of those that may differ.

    Raises:
        InputError: it names the first parameter that differs.
    """
    before = parameters_of(checkpoint, scenario)
    for key, value in now.items():
        if key not in changeable and key not in NOT_PARAMETERS and before.get(key) != value:
            raise InputError(
                f"{scenario}: {key} = {shown(value)}: was {shown(before.get(key))} when the checkpoint was "
                f"written, and cannot change in a run; what can: {', '.join(sorted(changeable))}"
            )
