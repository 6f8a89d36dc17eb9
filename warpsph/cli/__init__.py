"""The ``warpsph`` command: one file a subcommand, errors as one line and an exit code."""

from collections.abc import Sequence

from warpsph.cli.ending import end_at_once_when_asked
from warpsph.cli.streams import mend_streams, written_out


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code.

    Args:
        arguments: the words after ``warpsph``; those of this process by default, whose standard streams and signals
            are seen to then.
    """
    if arguments is not None:
        return _application(arguments)
    end_at_once_when_asked()
    mend_streams()
    return written_out(_application(None))


def _application(arguments: Sequence[str] | None) -> int:
    from warpsph.cli.application import main  # here, so that a signal during the long imports leaves one line

    return main(arguments)


__all__ = ["main"]
