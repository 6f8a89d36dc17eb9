"""One thread at a time computes: Warp records launches for the whole process, those of other threads among them."""

import threading
from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, TypeVar

Arguments = ParamSpec("Arguments")
Given = TypeVar("Given")

_turn = threading.RLock()  # a run within a run, as from an observer, has its turn already


def in_turn(work: Callable[Arguments, Given]) -> Callable[Arguments, Given]:
    """Decorate what launches or allocates on a device: a second thread waits until the first one is done."""

    @wraps(work)
    def waiting(*arguments: Arguments.args, **options: Arguments.kwargs) -> Given:
        with _turn:
            return work(*arguments, **options)

    return waiting
