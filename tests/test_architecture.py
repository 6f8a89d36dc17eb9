"""The house: imports point from scenarios to warpsph to kernels, and files stay small."""

import ast
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
FLOORS = {"kernels": "warpsph.kernels", "scenarios": "warpsph.scenarios", "warpsph": "warpsph"}
FILES = sorted(path for floor in FLOORS for path in (ROOT / floor).rglob("*.py"))
SYNTAX = ("collections.abc", "enum", "functools", "typing")  # of the language, not of the machine
LONGEST = 400  # lines


def on_floor(floor: str) -> list[Path]:
    return [path for path in FILES if path.is_relative_to(ROOT / floor)]


def module_name(path: Path) -> str:
    """The dotted name under which a source file is installed."""
    floor, *parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join([FLOORS[floor], *(part for part in parts if part != "__init__")])


def imported_modules(path: Path) -> Iterator[str]:
    """Every module that a source file imports, wherever in the file the import stands."""
    for node in ast.walk(ast.parse(path.read_text(), str(path))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def is_inside(module: str, package: str) -> bool:
    return module == package or module.startswith(f"{package}.")


def test_every_floor_is_looked_at():
    """If it failed, the tests below would pass because they look at nothing."""
    assert all(on_floor(floor) for floor in FLOORS)


@pytest.mark.parametrize("path", on_floor("kernels"), ids=module_name)
def test_kernels_know_arrays_and_numbers_only(path: Path):
    """If it failed, a kernel would depend on something above it, such as a scenario, a file or a plot."""
    allowed = ("warpsph.kernels", "warp", "numpy", "math", *SYNTAX)
    for module in imported_modules(path):
        assert any(is_inside(module, package) for package in allowed), f"{module_name(path)} imports {module}"


@pytest.mark.parametrize("path", on_floor("warpsph"), ids=module_name)
def test_warpsph_names_no_scenario(path: Path):
    """If it failed, a new scenario could not be added without touching the engine."""
    for module in imported_modules(path):
        assert not is_inside(module, "warpsph.scenarios"), f"{module_name(path)} imports {module}"


@pytest.mark.parametrize("path", FILES, ids=module_name)
def test_imports_are_absolute(path: Path):
    """If it failed, a file moved to another floor would silently import another module."""
    imports = (node for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.ImportFrom))
    assert all(node.level == 0 for node in imports)


@pytest.mark.parametrize("path", FILES, ids=module_name)
def test_files_stay_small(path: Path):
    """If it failed, a file would have grown beyond one concept."""
    assert len(path.read_text().splitlines()) <= LONGEST


def test_every_package_is_listed_for_installation():
    """If it failed, a folder would work in the checkout and be missing from the wheel."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    packages = {module_name(path) for path in FILES if path.name == "__init__.py"}
    assert set(project["tool"]["setuptools"]["packages"]) == packages
