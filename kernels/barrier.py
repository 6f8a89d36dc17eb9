"""A meeting point for the threads that replay the slices of one step on a CPU."""

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.func_native(
    """
#if !defined(__CUDA_ARCH__)
    int yield_processor(void) __asm__("sched_yield");
    int* arrived = (int*)meeting.data;
    int* generation = (int*)meeting.data + 32;
    const int now = __atomic_load_n(generation, __ATOMIC_ACQUIRE);
    if (__atomic_add_fetch(arrived, 1, __ATOMIC_ACQ_REL) == threads) {
        __atomic_store_n(arrived, 0, __ATOMIC_RELAXED);
        __atomic_store_n(generation, now + 1, __ATOMIC_RELEASE);
    } else {
        int spins = 0;
        while (__atomic_load_n(generation, __ATOMIC_ACQUIRE) == now) {
            if (++spins > 4096) yield_processor();
        }
    }
#endif
"""
)
def _wait_for_all(meeting: wp.array[int], threads: int): ...


@wp.kernel
def barrier(meeting: wp.array[int], threads: int):
    """Return once ``threads`` threads have arrived; ``meeting`` holds 64 zeros at first (two cache lines)."""
    _wait_for_all(meeting, threads)
