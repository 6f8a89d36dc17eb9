"""A meeting point for the threads that replay the slices of one step on a CPU."""

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.func_native(
    """
#if !defined(__CUDA_ARCH__)
    int* arrived = (int*)meeting.data;
    int* generation = (int*)meeting.data + 16;
    int* sleepers = (int*)meeting.data + 32;
    const int now = __atomic_load_n(generation, __ATOMIC_SEQ_CST);
#if defined(__linux__)
    long system_call(long, ...) __asm__("syscall");
#if defined(__x86_64__)
    const long futex = 202;
#else
    const long futex = 98;
#endif
    const int wait_private = 128, wake_private = 129;
#endif
    if (__atomic_add_fetch(arrived, 1, __ATOMIC_SEQ_CST) == threads) {
        __atomic_store_n(arrived, 0, __ATOMIC_SEQ_CST);
        __atomic_store_n(generation, now + 1, __ATOMIC_SEQ_CST);
#if defined(__linux__)
        if (__atomic_load_n(sleepers, __ATOMIC_SEQ_CST) > 0)
            system_call(futex, generation, wake_private, threads, 0, 0, 0);
#endif
    } else {
        int spins = 0;
        while (__atomic_load_n(generation, __ATOMIC_SEQ_CST) == now) {
#if defined(__linux__)
            if (++spins > 20000) {
                __atomic_add_fetch(sleepers, 1, __ATOMIC_SEQ_CST);
                system_call(futex, generation, wait_private, now, 0, 0, 0);
                __atomic_add_fetch(sleepers, -1, __ATOMIC_SEQ_CST);
            }
#endif
        }
    }
#endif
"""
)
def _wait_for_all(meeting: wp.array[int], threads: int): ...


@wp.kernel
def barrier(meeting: wp.array[int], threads: int):
    """Return once ``threads`` threads have arrived; ``meeting`` (64,) holds zeros at first.

    A thread that waits long goes to sleep (on Linux), so that a busy machine can run the one it waits for.
    """
    _wait_for_all(meeting, threads)
