"""The errors that a user can cause or must know of; the command line turns each into its exit code."""


class WarpsphError(Exception):
    """Base of the errors that warpsph raises on purpose; its text is one line a user can act on."""

    exit_code = 1


class InputError(WarpsphError):
    """The input is wrong: which key or file, what was given, what is allowed. Nothing has been written."""

    exit_code = 2


class DivergenceError(WarpsphError):
    """The simulation left the physical range: which particle, where, which quantity, at what time."""

    exit_code = 3
