"""The same bits, whichever instructions of the processor the compiler may use."""

import platform
import subprocess
import sys

import pytest

PROGRAM = """
import hashlib, sys
import warp as wp
wp.config.cpu_compiler_flags = sys.argv[1]
from warpsph.scenarios import Casting, Drop, HeatSlab, RubberRings
for case in (
    Casting(spacing=0.006, duration=0.05, output_interval=0.05, spray_flux=0.8),
    Drop(rows=8, duration=0.2, output_interval=0.2),
    HeatSlab(rows=10, duration=40.0, output_interval=40.0),
    RubberRings(layers=4, duration=0.01, output_interval=0.01),
):
    result = case.run("cpu")
    bits = b"".join([result.positions.tobytes(), *(field.tobytes() for field in result.fields.values())])
    print(case.name, hashlib.sha256(bits).hexdigest())
"""


def bits(flags: str) -> list[str]:
    ended = subprocess.run([sys.executable, "-c", PROGRAM, flags], capture_output=True, text=True, check=True)
    return ended.stdout.splitlines()


@pytest.mark.slow  # compiles every kernel anew
@pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="the flags are those of x86 processors")
def test_instructions_do_not_change_the_bits():
    """If it failed, a run could not be repeated, or resumed, on another processor."""
    native = bits("-march=native")
    assert len(native) == 4
    # no more than every x86 processor has; AVX2; and what this one has, but one number at a time
    for flags in ("", "-target-cpu x86-64-v3", "-march=native -fno-vectorize -fno-slp-vectorize"):
        assert bits(flags) == native
