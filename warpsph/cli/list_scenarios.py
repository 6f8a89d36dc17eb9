"""``warpsph list``."""

from rich.text import Text

from warpsph.cli.catalogue import all_scenarios
from warpsph.cli.consoles import output_console


def list_scenarios() -> None:
    """List the scenarios, one line each, with the source they reproduce."""
    scenarios = all_scenarios()
    console = output_console()
    width = max(map(len, scenarios), default=0)
    for name, scenario in scenarios.items():
        line = Text.assemble((f"{name:{width}}", "cyan"), f"  {scenario.summary}  ", (f"[{scenario.source}]", "dim"))
        console.print(line, soft_wrap=True)
