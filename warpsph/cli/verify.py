"""``warpsph verify``."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter
from rich.text import Text

from warpsph.cases.check import Check
from warpsph.cases.report import check_table, check_writable, write_json
from warpsph.cases.scenario import Scenario
from warpsph.cli.catalogue import all_scenarios, find_scenario
from warpsph.cli.consoles import error_console, output_console
from warpsph.cli.progress import shown_progress
from warpsph.errors import DivergenceError
from warpsph.run.interrupt import Interrupted
from warpsph.run.result import Result
from warpsph.run.statistics import undefined_is_no_number


def verify(
    *names: str,
    slow: bool = False,
    json: Annotated[Path | None, Parameter(metavar="FILE")] = None,
) -> int:
    """Run the checks of scenarios: measured values beside published or exact ones. The exit code is 1 if one fails.

    Parameters
    ----------
    names
        Scenarios of `warpsph list`; all of them when not given.
    slow
        Run the checks of many minutes too.
    json
        Write the rows to this file as well.
    """
    scenarios = [find_scenario(name) for name in names] or list(all_scenarios().values())
    if json:
        check_writable(json)
    checks: list[Check] = []
    diverged = False
    for scenario in scenarios:
        try:
            with undefined_is_no_number():
                found = list(scenario.verify(_simulate, slow))
        except DivergenceError as error:
            diverged = True
            output_console().print(Text(f"{scenario.name}: diverged: {error}", style="bold red"))
            continue
        _show(scenario, found)
        checks += found
    if json:
        write_json(checks, json)
    failed = sum(not check.passed for check in checks)
    output_console().print(f"{len(checks) - failed} of {len(checks)} checks passed")
    return DivergenceError.exit_code if diverged else int(failed > 0)


def _simulate(scenario: Scenario) -> Result:
    with shown_progress(scenario.name, error_console()) as report:
        result = scenario.run(progress=report)
    if result.stopped_by:
        raise Interrupted(result.stopped_by)
    return result


def _show(scenario: type[Scenario], checks: list[Check]) -> None:
    if checks:
        output_console().print(check_table(f"{scenario.name}: {scenario.source}", checks))
    else:
        output_console().print(Text(f"{scenario.name}: no check without --slow"))
