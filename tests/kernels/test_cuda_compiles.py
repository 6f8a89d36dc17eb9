"""Every kernel is compiled for a GPU, on machines without one too."""

import importlib
import pkgutil
from pathlib import Path

import pytest
import warp as wp

import warpsph.kernels


def modules_with_kernels() -> list[str]:
    """Modules of warpsph.kernels with Warp kernels; device functions alone are compiled where they are called."""
    names = [module.name for module in pkgutil.walk_packages(warpsph.kernels.__path__, "warpsph.kernels.")]
    return [name for name in names if kernels_of(name)]


def kernels_of(name: str) -> list[wp.Kernel]:
    values = vars(importlib.import_module(name)).values()
    return [value for value in values if isinstance(value, wp.Kernel) and value.module.name == name]


@pytest.mark.parametrize("name", modules_with_kernels())
def test_compiles_for_cuda(name: str, tmp_path: Path):
    """Otherwise a kernel that works on the CPU would fail on the first GPU it meets."""
    wp.init()
    module = wp.get_module(name)
    wp.compile_aot_module(importlib.import_module(name), arch=90, module_dir=tmp_path, use_ptx=True)
    ptx = "".join(path.read_text() for path in tmp_path.glob("*.ptx"))
    assert ptx.count(".visible .entry") == len(module.kernels)
