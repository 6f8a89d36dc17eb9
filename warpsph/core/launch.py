"""Launching kernels by the names of their arguments."""

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from typing import Any

import warp as wp

from warpsph.core.executor import Executor
from warpsph.nearest import did_you_mean


class Launch:
    """Launches a kernel with what its arguments are called: a field, a value, a list or a constant of that name.

    Args:
        executor: where to run.
        count: number of particles, over which kernels run unless another number is given.
        scopes: where names are looked up, the first one first.
    """

    def __init__(self, executor: Executor, count: int, *scopes: Mapping[str, Any]):
        self.executor, self.count, self.scopes = executor, count, scopes

    def within(self, *scopes: Mapping[str, Any]) -> "Launch":
        """A launch that looks into ``scopes`` before it looks into those of this one."""
        return Launch(self.executor, self.count, *scopes, *self.scopes)

    def __call__(self, kernel: wp.Kernel, dim: int | None = None, **given: Any) -> None:
        """Launch ``kernel`` over ``dim`` indices, by default the particles; ``given`` arguments come first of all.

        Raises:
            TypeError: an argument is known under no such name, or one was given that the kernel does not take.
        """
        self.executor(kernel, self.count if dim is None else dim, self.arguments(kernel, given))

    def prepared(self, kernel: wp.Kernel, dim: int, **given: Any) -> Callable[[], None]:
        """A launch over ``dim`` indices that is made many times from the host."""
        return self.executor.prepared(kernel, dim, self.arguments(kernel, given))

    def whole(self, kernel: wp.Kernel, dim: int = 1, **given: Any) -> None:
        """Launch ``kernel`` uncut, by default over one index: for counters that several indices share."""
        self.executor.whole(kernel, dim, self.arguments(kernel, given))

    def when(self, flag: str, body: Callable[[], None]) -> None:
        """Do ``body`` if the value called ``flag`` is not zero; decided on the device."""
        self.executor.when(self.find(flag), body)

    def on_host(self, work: Callable[[], None]) -> None:
        """Do ``work`` on the host, between what is launched before and after it; see :meth:`Executor.on_host`."""
        self.executor.on_host(work)

    def section(self) -> AbstractContextManager[None]:
        """Launches inside do not wait for each other; see :meth:`Executor.section`."""
        return self.executor.section()

    def meet(self) -> None:
        """Let what follows wait for what came before, inside a section too."""
        self.executor.meet()

    def __contains__(self, name: str) -> bool:
        """Whether something is called ``name``."""
        return any(name in scope for scope in self.scopes)

    def find(self, name: str) -> Any:
        """What is called ``name``.

        Raises:
            KeyError: nothing is.
        """
        for scope in self.scopes:
            if name in scope:
                return scope[name]
        raise KeyError(name)

    def arguments(self, kernel: wp.Kernel, given: Mapping[str, Any]) -> list[Any]:
        """The values of a kernel's arguments after the first, which is the first index of its range."""
        names = [argument.label for argument in kernel.adj.args[1:]]
        for name in given:
            if name not in names:
                raise TypeError(f"kernel {kernel.key} takes no argument '{name}'{did_you_mean(name, names)}")
        scopes: list[Mapping[str, Any]] = [given, *self.scopes]
        for name in names:
            if not any(name in scope for scope in scopes):
                known = sorted({known for scope in scopes for known in scope if "." not in known})
                raise TypeError(
                    f"kernel {kernel.key} asks for '{name}', but no field, value, list or constant is called so"
                    f"{did_you_mean(name, known)}"
                )
        return [next(scope[name] for scope in scopes if name in scope) for name in names]
