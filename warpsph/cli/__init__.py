"""The ``warpsph`` command: one file a subcommand, errors as one line and an exit code."""

from warpsph.cli.application import main

__all__ = ["main"]
