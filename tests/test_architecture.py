"""The house: imports point from scenarios to warpsph to kernels, and files stay small."""

import ast
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
FLOORS = {"kernels": "warpsph.kernels", "scenarios": "warpsph.scenarios", "warpsph": "warpsph"}
FILES = sorted(path for floor in FLOORS for path in (ROOT / floor).rglob("*.py"))
SYNTAX = ("collections.abc", "enum", "functools", "types", "typing")  # of the language, not of the machine
LONGEST = 400  # lines
ROOMS = (
    "errors",
    "nearest",
    "core",
    "terms",
    "machine",
    "files",
    "run",
    "cases",
    "pictures",
    "cli",
)  # the lowest first


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


def imports_among(modules: set[str]) -> dict[str, set[str]]:
    """Which modules each module imports, those for annotations only among them."""
    found: dict[str, set[str]] = {}
    for path in FILES:
        own = module_name(path)
        for imported in imported_modules(path):
            while imported and imported not in modules:
                imported = imported.rpartition(".")[0]
            if imported != own:
                found.setdefault(own, set()).add(imported)
    return found


def circles(imports: dict[str, set[str]]) -> list[str]:
    """A circle of names that import each other, as a list that ends where it begins; empty if there is none."""
    done: set[str] = set()

    def walk(name: str, way: list[str]) -> list[str]:
        if name in way:
            return [*way[way.index(name) :], name]
        if name in done:
            return []
        for other in sorted(imports.get(name, ())):
            if circle := walk(other, [*way, name]):
                return circle
        done.add(name)
        return []

    return next((circle for name in sorted(imports) if (circle := walk(name, []))), [])


def test_no_module_imports_itself_in_a_circle():
    """If it failed, two files could not be understood, or moved, one without the other."""
    assert circles(imports_among({module_name(path) for path in FILES})) == []
    assert circles({"a": {"b"}, "b": {"c"}, "c": {"a"}}) == ["a", "b", "c", "a"]


@pytest.mark.parametrize("floor", FLOORS)
def test_no_room_imports_itself_in_a_circle(floor: str):
    """If it failed, the rooms of a floor would have no order."""

    def room(module: str) -> str:
        return ".".join(module.split(".")[: FLOORS[floor].count(".") + 2])

    between: dict[str, set[str]] = {}
    for module, imported in imports_among({module_name(path) for path in FILES}).items():
        if module_name_is_on(module, floor):
            others = {room(other) for other in imported if module_name_is_on(other, floor)} - {room(module)}
            between.setdefault(room(module), set()).update(others)
    between.pop(FLOORS[floor], None)
    assert circles(between) == []


def module_name_is_on(module: str, floor: str) -> bool:
    """Whether a module is on a floor; kernels and scenarios are not on that of warpsph."""
    others = [name for name in FLOORS.values() if name != "warpsph"]
    if floor == "warpsph":
        return not any(is_inside(module, other) for other in others)
    return is_inside(module, FLOORS[floor])


@pytest.mark.parametrize("path", on_floor("warpsph"), ids=module_name)
def test_rooms_import_downwards(path: Path):
    """If it failed, a step would know of files, or a file of the command line."""
    parts = path.relative_to(ROOT / "warpsph").with_suffix("").parts
    if parts[0] not in ROOMS:
        return
    above = [f"warpsph.{room}" for room in ROOMS[ROOMS.index(parts[0]) + 1 :]]
    for module in imported_modules(path):
        assert not any(is_inside(module, room) for room in above), f"{module_name(path)} imports {module}"


@pytest.mark.parametrize("path", on_floor("scenarios"), ids=module_name)
def test_scenarios_use_public_names_only(path: Path):
    """If it failed, the engine could not change its insides without breaking scenarios."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Attribute) and node.attr.startswith("_") and not node.attr.startswith("__"):
            owner = node.value.id if isinstance(node.value, ast.Name) else ""
            assert owner in ("self", "cls", "scenario", "case"), f"{ast.unparse(node)} in line {node.lineno}"
        if isinstance(node, ast.ImportFrom):
            assert not any(alias.name.startswith("_") for alias in node.names), ast.unparse(node)


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
