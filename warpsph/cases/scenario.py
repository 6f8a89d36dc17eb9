"""What a scenario is: a class whose fields are its parameters, and the registry through which the program finds it."""

from collections.abc import Callable, Iterable
from enum import Enum
from importlib.metadata import version
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError
from pydantic.fields import FieldInfo

from warpsph.cases.check import Check
from warpsph.cases.resuming import refuse_other_case
from warpsph.errors import LONGEST_VALUE, InputError, cut, shown
from warpsph.files.checkpoint import Checkpoint
from warpsph.nearest import did_you_mean

if TYPE_CHECKING:  # not at run time: Warp takes long to import, and help must appear at once
    from warpsph.core.executor import Executor
    from warpsph.run.result import Result
    from warpsph.run.simulation import Simulation

_registry: dict[str, type["Scenario"]] = {}


def parameter(default: Any, unit: str, meaning: str, *, changeable: bool = False, **bounds: Any) -> Any:
    """Declare a field of a scenario.

    Args:
        default: its value where the case says nothing.
        unit: SI unit, "" where it has none.
        meaning: one phrase for ``warpsph describe``.
        changeable: whether a run that is resumed may have another value than before.
        bounds: ``gt``, ``ge``, ``lt``, ``le`` as in pydantic.
    """
    by_name = False if isinstance(default, Enum) else None  # strict reading would refuse its name
    extra: dict[str, Any] = {"unit": unit, "changeable": changeable}
    return Field(default, strict=by_name, description=meaning, json_schema_extra=extra, **bounds)


def unit_of(field: FieldInfo) -> str:
    """The unit of a field that was declared by :func:`parameter`."""
    return str(_declared(field, "unit") or "")


def is_changeable(field: FieldInfo) -> bool:
    """Whether a field was declared by :func:`parameter` as one that may change in a run."""
    return bool(_declared(field, "changeable"))


def _declared(field: FieldInfo, what: str) -> Any:
    extra = field.json_schema_extra
    return extra.get(what) if isinstance(extra, dict) else None


class Scenario(BaseModel):
    """A case to simulate; subclasses add their parameters as fields and are registered under ``name``.

    Class attributes of a subclass: ``name`` (on the command line), ``summary`` (one line), ``source`` (paper and
    section) and ``presets`` (names of the TOML files under ``presets/<name>/`` beside its module).
    """

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, allow_inf_nan=False, validate_default=True)

    name: ClassVar[str]
    summary: ClassVar[str]
    source: ClassVar[str]
    presets: ClassVar[tuple[str, ...]] = ()
    default_preset: ClassVar[str | None] = None

    duration: float = parameter(1.0, "s", "physical time to simulate", changeable=True, gt=0, le=1e6)
    output_interval: float = parameter(
        0.1, "s", "physical time between two frames and diagnostics", changeable=True, gt=0, le=1e6
    )

    def __init_subclass__(cls, **kwargs: Any) -> None:
        super().__init_subclass__(**kwargs)
        if "name" in cls.__dict__:
            _registry[cls.name] = cls

    def __init__(self, /, **values: Any) -> None:
        unknown = next((key for key in values if key not in type(self).model_fields), None)
        if unknown is not None:
            key = cut(unknown, LONGEST_VALUE)
            raise InputError(f"{self.name}: unknown parameter '{key}'{did_you_mean(unknown, type(self).model_fields)}")
        try:
            with np.errstate(divide="raise", over="raise", invalid="raise"):
                super().__init__(**{key: _plain(value) for key, value in values.items()})
        except ValidationError as error:
            raise InputError(_one_line(type(self), error)) from None
        except ArithmeticError as error:
            given = cut(", ".join(values), LONGEST_VALUE)
            reason = f"nothing can be reckoned with these values ({error}); give {given} nearer to the default"
            raise InputError(f"{self.name}: {reason}") from None

    def build(self, executor: "Executor") -> "Simulation":
        """Place the particles and choose terms and parts."""
        raise NotImplementedError

    def run(self, device: str = "auto", threads: int | None = None, **options: Any) -> "Result":
        """Simulate to ``duration`` and return the final state and the diagnostics as NumPy arrays.

        ``options`` go to :meth:`warpsph.run.simulation.Simulation.run`.
        """
        from warpsph.core.executor import Executor

        executor = Executor(device, threads)
        simulation = self.build(executor)
        own: dict[str, Any] = {
            "duration": self.duration,
            "output_interval": self.output_interval,
            "parameters": self.as_dict(),
        }
        if (begun := options.get("resume")) is not None:
            options["resume"] = begun = begun if isinstance(begun, Checkpoint) else Checkpoint.read(begun)
            self.refuse_other_case(begun)
        return simulation.run(**own | options)

    def checks(self, result: "Result") -> list[Check]:
        """Compare one finished run with the sources."""
        return []

    def refuse_other_case(self, checkpoint: Checkpoint) -> None:
        """Refuse to go on from a checkpoint of another case.

        Raises:
            InputError: a parameter differs that cannot change in a run.
        """
        refuse_other_case(checkpoint, self.name, self.as_dict(), self.changeable())

    @classmethod
    def changeable(cls) -> set[str]:
        """Names of the parameters that may have another value when a run is resumed."""
        bases = [base for base in cls.__mro__ if issubclass(base, Scenario)]
        return {key for base in bases for key, field in base.model_fields.items() if is_changeable(field)}

    @classmethod
    def verify(cls, simulate: "Callable[[Scenario], Result]", slow: bool) -> Iterable[Check]:
        """Yield the rows of ``warpsph verify``; scenarios that need several runs override it.

        Args:
            simulate: runs a scenario and returns its result.
            slow: whether runs of many minutes are allowed.
        """
        scenario = cls()
        yield from scenario.checks(simulate(scenario))

    def as_dict(self) -> dict[str, Any]:
        """The resolved parameters, as they are stored with the result."""
        return {"scenario": self.name, "version": version("warpsph")} | self.model_dump(mode="json")


def registered_scenarios() -> dict[str, type[Scenario]]:
    """All scenarios that have been imported, by name, in the order of their registration."""
    return dict(_registry)


def _one_line(scenario: type[Scenario], error: ValidationError) -> str:
    first = error.errors()[0]
    reason = first["msg"].removeprefix("Value error, ")
    key = ".".join(str(part) for part in first["loc"])
    if not key:
        return f"{scenario.name}: {reason}"
    field = scenario.model_fields.get(key)
    unit = unit_of(field) if field else ""
    return f"{scenario.name}: {key} = {shown(first.get('input'))}: {reason}" + (f" [{unit}]" if unit else "")


def _plain(value: Any) -> Any:
    """A value of a case: tuples for the arrays of TOML and of NumPy, Python's numbers for NumPy's."""
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    return tuple(_plain(item) for item in value) if isinstance(value, list | tuple) else value
