"""Where kernels run: one CUDA graph on a GPU, one graph a thread on a CPU. The only place that decides."""

import os
import time as wall_clock
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import warp as wp

from warpsph.core.driver import cuda_versions, driver_complaint, driver_is_here
from warpsph.core.kernel_cache import start_warp
from warpsph.core.turns import in_turn
from warpsph.errors import InputError
from warpsph.kernels.basics.barrier import barrier

# Threads take turns along the particles, because these are sorted by place and places differ in work.
SLICES_PER_THREAD = 8
WORTH_THREADS = 20_000  # indices, above which a launch from the host is done faster by several threads than by one


@dataclass
class Recording:
    """A piece of work recorded once and replayed many times without the interpreter.

    Attributes:
        stages: graphs, one a thread, and between them what the host does.
    """

    stages: list[list[wp.Graph] | Callable[[], None]]


class Executor:
    """Launches kernels on one device.

    Every kernel takes the first index of its range as its first argument, so that a launch can be cut into slices: on
    a CPU each thread replays a graph of its own slices, and the threads meet after each launch. The results have the
    same bits for any number of threads, because every kernel writes its own particle only.

    Args:
        device: "auto" (a CUDA device where there is one; where there should be one, a warning), "cpu" or "cuda:N".
        threads: CPU threads, all cores by default; ignored on a GPU.

    Raises:
        InputError: the device does not exist here or the number of threads makes no sense.
    """

    @in_turn
    def __init__(self, device: str = "auto", threads: int | None = None):
        wp.config.log_level = wp.LOG_ERROR
        start_warp()
        self.device = _find_device(device)
        self.threads = 1 if self.device.is_cuda else _thread_count(threads)
        self._slice: int | None = None
        self._in_section = False
        self._capture: wp.ScopedCapture | None = None
        self._graphs: list[wp.Graph] = []
        self._work_of_host: list[Callable[[], None]] = []
        self._meeting = wp.zeros(64, dtype=int, device=self.device)
        self._pool = ThreadPoolExecutor(self.threads, "warpsph")

    @property
    def device_name(self) -> str:
        """Name of the device, for people."""
        return self.device.name if self.device.is_cuda else "cpu"

    @property
    def description(self) -> str:
        """Device and threads, for people."""
        if self.device.is_cuda:
            return f"{self.device.name} ({self.device.alias})"
        return f"cpu, {self.threads} thread{'s' if self.threads > 1 else ''}"

    @property
    def on_cuda(self) -> bool:
        return self.device.is_cuda

    def __call__(self, kernel: wp.Kernel, dim: int, inputs: Sequence) -> None:
        """Launch ``kernel`` over ``dim`` threads, cut into slices while a step is recorded for a CPU."""
        if self._slice is None:
            wp.launch(kernel, dim=dim, inputs=[0, *inputs], device=self.device)
            return
        slices = self.threads * SLICES_PER_THREAD
        for index in range(self._slice, slices, self.threads):
            first, last = (dim * (index + k) // slices for k in (0, 1))
            if last > first:
                wp.launch(kernel, dim=last - first, inputs=[first, *inputs], device=self.device)
        self._meet()

    def prepared(self, kernel: wp.Kernel, dim: int, inputs: Sequence) -> Callable[[], None]:
        """A launch that is made many times from the host, with what the interpreter has to do done once."""
        if self.threads == 1 or dim < WORTH_THREADS:
            return wp.launch(kernel, dim=dim, inputs=[0, *inputs], device=self.device, record_cmd=True).launch
        recording = self.record(lambda: self(kernel, dim, inputs))
        return lambda: self.replay([(recording, 1)])

    def whole(self, kernel: wp.Kernel, dim: int, inputs: Sequence) -> None:
        """Launch ``kernel`` without cutting it: for counters that several indices share, and for single-thread work."""
        if self._slice is None or self._slice == 0:
            wp.launch(kernel, dim=dim, inputs=[0, *inputs], device=self.device)
        self._meet()

    @contextmanager
    def section(self) -> Iterator[None]:
        """Launches inside do not wait for each other; threads meet once, at the end.

        Allowed where no launch inside reads another particle's data that a launch inside writes, and all launches are
        over the same range.
        """
        self._in_section = True
        try:
            yield
        finally:
            self._in_section = False
        self._meet()

    def when(self, flag: wp.array, body: Callable[[], None]) -> None:
        """Do ``body`` if ``flag[0]`` is not zero; decided on the device."""
        wp.capture_if(flag, on_true=body)

    def on_host(self, work: Callable[[], None]) -> None:
        """Do ``work`` on the host, between what is launched before and after; not inside a section or a condition."""
        if self._capture is None:
            work()
            return
        self._end_stage()
        self._work_of_host.append(work)
        self._begin_stage()

    def record(self, work: Callable[[], None]) -> Recording:
        """Record the launches of ``work`` for :meth:`replay`."""
        threads = []
        for index in range(self.threads):
            self._slice = None if self.on_cuda else index
            self._graphs, self._work_of_host = [], []
            self._begin_stage()
            try:
                work()
            finally:
                self._end_stage()
                self._slice = None
            threads.append(self._graphs)
        first, *others = (list(graphs) for graphs in zip(*threads, strict=True))
        stages: list[list[wp.Graph] | Callable[[], None]] = [first]
        for host, graphs in zip(self._work_of_host, others, strict=True):
            stages += [host, graphs]
        return Recording(stages)

    def _begin_stage(self) -> None:
        self._capture = wp.ScopedCapture(self.device)
        self._capture.__enter__()

    def _end_stage(self) -> None:
        capture: Any = self._capture
        self._capture = None
        capture.__exit__(None, None, None)
        self._graphs.append(capture.graph)

    def replay(self, schedule: Sequence[tuple[Recording, int]]) -> None:
        """Replay recordings in order, each the given number of times, and wait for the end."""
        waiting: list[tuple[list[wp.Graph], int]] = []
        for recording, count in schedule:
            alone = len(recording.stages) == 1
            for stage in recording.stages * (1 if alone else count):
                if isinstance(stage, list):
                    waiting.append((stage, count if alone else 1))
                else:
                    self._replay(waiting)
                    waiting = []
                    stage()
        self._replay(waiting)

    def seconds(self, recording: Recording, least: float = 0.3) -> float:
        """Wall time [s] of one replay, measured over ``least`` [s], after one that warms up."""
        self.replay([(recording, 1)])
        count, taken, per_replay = 1, 0.0, 0.0
        while taken < least:
            started = wall_clock.perf_counter()
            self.replay([(recording, count)])
            taken = wall_clock.perf_counter() - started
            per_replay = taken / count
            count *= 4
        return per_replay

    def _replay(self, graphs: Sequence[tuple[list[wp.Graph], int]]) -> None:
        jobs = [self._pool.submit(_launch_graphs, graphs, index) for index in range(self.threads)]
        try:
            wait(jobs)
        finally:
            wait(jobs)
            if self.on_cuda:
                wp.synchronize_device(self.device)
        for job in jobs:
            job.result()

    def meet(self) -> None:
        """Let what follows wait for what came before, inside a section too."""
        if self._slice is not None and self.threads > 1:
            wp.launch(barrier, dim=1, inputs=[self._meeting, self.threads], device=self.device)

    def _meet(self) -> None:
        if not self._in_section:
            self.meet()


def _launch_graphs(graphs: Sequence[tuple[list[wp.Graph], int]], index: int) -> None:
    for of_threads, count in graphs:
        for _ in range(count):
            wp.capture_launch(of_threads[index])


def available_cores() -> int:
    """CPU cores that this process may use: its affinity, and the quota of its container (Linux)."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    try:
        quota, period = Path("/sys/fs/cgroup/cpu.max").read_text().split()
        return max(min(cores, int(quota) // int(period)), 1)
    except (OSError, ValueError):
        return cores


def _find_device(name: str) -> wp.Device:
    available = ["cpu"] + [device.alias for device in wp.get_cuda_devices()]
    complaint = driver_complaint(driver_is_here(), *cuda_versions()) if len(available) == 1 else None
    if name == "auto":
        name = available[1] if len(available) > 1 else "cpu"
        if complaint:
            warnings.warn(f"{complaint}; this run computes on the CPU", stacklevel=3)
    if name == "cuda":
        name = "cuda:0"
    if name not in available:
        reason = complaint or f"available: auto, {', '.join(available)}"
        raise InputError(f"device '{name}' is not here; {reason}")
    return wp.get_device(name)


def _thread_count(threads: int | None) -> int:
    cores = available_cores()
    if threads is None:
        return cores
    if not (isinstance(threads, int) and 1 <= threads <= cores):
        raise InputError(f"threads = {threads!r}: this machine has {cores} core(s); give 1 to {cores}")
    return threads
