"""``warpsph list``."""

from rich.table import Table

from warpsph.cli.catalogue import all_scenarios
from warpsph.cli.consoles import output_console


def list_scenarios() -> None:
    """List the scenarios, one line each, with the source they reproduce."""
    table = Table(box=None, header_style="bold")
    table.add_column("scenario", style="cyan", no_wrap=True)
    table.add_column("what is simulated")
    table.add_column("source", style="dim")
    for name, scenario in all_scenarios().items():
        table.add_row(name, scenario.summary, scenario.source)
    output_console().print(table)
