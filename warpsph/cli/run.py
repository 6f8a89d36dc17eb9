"""``warpsph run``."""

import shlex
from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter, Token
from cyclopts.validators import Number
from rich.table import Table
from rich.text import Text

from warpsph.cases.case import Layer, file_layer, preset_layer, resolve, settings_layer
from warpsph.cases.resuming import parameters_of
from warpsph.cases.scenario import Scenario
from warpsph.cli.catalogue import find_scenario
from warpsph.cli.consoles import error_console, output_console
from warpsph.cli.progress import shown_progress
from warpsph.cli.rehearsal import rehearse
from warpsph.cli.target import check_free, check_target
from warpsph.errors import DivergenceError, InputError
from warpsph.files.checkpoint import Checkpoint, beside, result_of
from warpsph.run.result import Result

RESULTS = Path("results")


def _whole_number(kind: type, tokens: Sequence[Token]) -> int:
    """An integer as written: the parser itself would round 1.5 to 2."""
    return int(tokens[0].value)


Seconds = Annotated[float | None, Parameter(metavar="SECONDS", validator=Number(gt=0))]
Threads = Annotated[int | None, Parameter(metavar="N", validator=Number(gte=1), converter=_whole_number)]
Settings = Annotated[list[str] | None, Parameter(name="--set", metavar="KEY=VALUE", consume_multiple=(1, None))]


def run(
    name: str,
    case: Path | None = None,
    /,
    *,
    preset: Annotated[str | None, Parameter(metavar="NAME")] = None,
    settings: Settings = None,
    until: Seconds = None,
    device: Annotated[str, Parameter(metavar="NAME")] = "auto",
    threads: Threads = None,
    output: Annotated[Path | None, Parameter(metavar="FILE.vtkhdf")] = None,
    every: Seconds = None,
    checkpoint_every: Seconds = None,
    resume: Annotated[Path | None, Parameter(metavar="FILE.checkpoint")] = None,
    overwrite: bool = False,
    quiet: bool = False,
    dry_run: Annotated[bool, Parameter(negative=())] = False,
) -> int:
    """Run a scenario and write its frames and diagnostics to one VTKHDF file.

    A parameter takes its value from the last of these that names it: the scenario's default, the preset, the case
    file, `--set`. Ctrl-C, SIGTERM and SIGHUP stop the run and keep what has been simulated, and a checkpoint beside it
    from which `--resume` goes on to the same bits.

    Parameters
    ----------
    name
        A scenario of `warpsph list`.
    case
        A TOML file of parameters, `key = value` each; it may name any parameter of `warpsph describe NAME`.
    preset
        One of the scenario's ready-made cases; see `warpsph describe NAME`.
    settings
        Set one parameter, as in `--set duration=2.5`; may be repeated. A value is TOML, a bare word is text.
    until
        Physical time to simulate: the parameter `duration`.
    device
        Where to compute: auto (a CUDA device where there is one, and the default), cpu or cuda:0.
    threads
        CPU threads; all cores by default.
    output
        The VTKHDF file to write; results/NAME-PRESET.vtkhdf by default (or NAME-CASE, or NAME).
    every
        Physical time between two frames: the parameter `output_interval`.
    checkpoint_every
        Physical time between two checkpoints; FILE.checkpoint beside the output is the newest, the one before it is
        FILE.checkpoint.previous.
    resume
        Go on from a checkpoint: its parameters, and its result file, which is continued. Only what may change in a run
        may be set anew, such as `--until`.
    overwrite
        Replace the output file if it exists.
    quiet
        Show neither progress nor summary.
    dry_run
        Do not run: say what the run would take, in particles, memory, steps, time and disk, and draw its start beside
        the output.
    """
    kind = find_scenario(name)
    begun = Checkpoint.read(resume) if resume else None
    if begun is None:
        preset = preset or (None if case else kind.default_preset)
    layers = _layers(kind, preset, case, settings, until, every)
    if begun:
        layers.insert(0, Layer(str(resume), parameters_of(begun, kind.name)))
    scenario = resolve(kind, layers)
    if begun and resume:
        scenario.refuse_other_case(begun)
        path = _continued(resume, output)
    else:
        path = _target(output or default_path(kind, preset, case), overwrite)
    if dry_run:
        if begun:
            raise InputError("--dry-run: a resumed run has no start to show; give one of --dry-run and --resume")
        rehearse(scenario, device, threads, path, overwrite)
        return 0
    result = _simulate(scenario, device, threads, path, overwrite, quiet, checkpoint_every, begun)
    if not quiet:
        _conclude(kind.name, result, path)
    return 128 + result.stopped_by if result.stopped_by else 0


def _continued(checkpoint: Path, output: Path | None) -> Path:
    """The result file that a resumed run goes on with; one that is named and not there yet begins at the checkpoint."""
    if output is not None:
        check_target(output, ".vtkhdf")
        return output
    path = result_of(checkpoint)
    if not path.exists():
        raise InputError(f"{path}, which this checkpoint goes on with, is not there; give --output for a new file")
    return path


def _layers(
    kind: type[Scenario],
    preset: str | None,
    case: Path | None,
    settings: list[str] | None,
    until: float | None,
    every: float | None,
) -> list[Layer]:
    options = {"duration": until, "output_interval": every}
    layers = [preset_layer(kind, preset)] if preset else []
    layers += [file_layer(case)] if case else []
    layers.append(settings_layer(settings or []))
    layers.append(Layer("--until, --every", {key: value for key, value in options.items() if value is not None}))
    return layers


def default_path(kind: type[Scenario], preset: str | None, case: Path | None) -> Path:
    """Where the result of a case goes for which no file is named."""
    which = case.stem if case else preset or kind.default_preset
    return RESULTS / f"{'-'.join(filter(None, [kind.name, which]))}.vtkhdf"


def _target(path: Path, overwrite: bool) -> Path:
    check_target(path, ".vtkhdf", made_by_us=path.parent == RESULTS)
    check_free(path, overwrite)
    return path


def _simulate(
    scenario: Scenario,
    device: str,
    threads: int | None,
    path: Path,
    overwrite: bool,
    quiet: bool,
    checkpoint_every: float | None,
    begun: Checkpoint | None,
) -> Result:
    from warpsph.core.executor import Executor

    console = error_console()
    executor = Executor(device, threads)
    with nullcontext() if quiet else shown_progress(scenario.name, console) as report:
        simulation = scenario.build(executor)
        if path.parent == RESULTS:
            make_results_folder()
        if not quiet:
            console.print(f"{scenario.name}: computing on {executor.description}", markup=False, soft_wrap=True)
        try:
            return simulation.run(
                scenario.duration,
                scenario.output_interval,
                output=path,
                overwrite=overwrite,
                progress=report,
                parameters=scenario.as_dict(),
                checkpoint_every=checkpoint_every,
                resume=begun,
            )
        except DivergenceError as error:
            error.facts.setdefault("last good frame", f"the last one of {path}")
            raise


def make_results_folder() -> None:
    try:
        RESULTS.mkdir(exist_ok=True)
    except OSError as error:
        raise InputError(f"the folder {RESULTS} cannot be made: {error.strerror}; give --output") from None


def _conclude(name: str, result: Result, path: Path) -> None:
    console = output_console()
    table = Table.grid(padding=(0, 2))
    for quantity, value in result.summary.items():
        table.add_row(Text(quantity, style="bold"), Text(value))
    for time, event in result.events:
        table.add_row(Text(f"at {time:.4g} s", style="bold"), Text(event))
    console.print(table)
    if result.status == "interrupted":
        console.print(f"interrupted at {result.time:.4g} s; the frames until then are kept")
        if result.steps:
            go_on = ["warpsph", "run", name, "--resume", str(beside(path))]
            if result_of(beside(path)) != path:  # its ending is in capitals
                go_on += ["--output", str(path)]
            console.print(Text(f"go on:   {shlex.join(go_on)}"), soft_wrap=True)
    console.print(Text(f"written: {path}"), soft_wrap=True)
    console.print(Text(f"next:    {shlex.join(['warpsph', 'render', str(path)])}"), soft_wrap=True)
