"""Devices for the tests: the CPU always, a CUDA device where there is one."""

import pytest
import warp as wp

wp.config.log_level = wp.LOG_ERROR


@pytest.fixture(params=["cpu", "cuda:0"])
def device(request: pytest.FixtureRequest) -> str:
    """Name of a Warp device; a test that asks for it runs once on each."""
    wp.init()
    if request.param.startswith("cuda") and not wp.is_cuda_available():
        pytest.skip("this machine has no CUDA device, so the CUDA half of this test cannot run")
    return request.param
