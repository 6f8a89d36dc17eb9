"""The wheel and the editable install: everything is in, and imports come from where they should."""

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
FLOORS = {"kernels": "warpsph/kernels", "scenarios": "warpsph/scenarios", "warpsph": "warpsph"}


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built from a copy of the sources so that the checkout stays clean."""
    folder = tmp_path_factory.mktemp("wheel")
    source = folder / "source"
    source.mkdir()
    for name in FLOORS:
        shutil.copytree(ROOT / name, source / name, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", str(folder), str(source)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return next(folder.glob("*.whl"))


def test_wheel_holds_every_source_file_and_all_data(wheel: Path):
    """If it failed, an installed program would miss a module, a preset or the licence."""
    names = set(zipfile.ZipFile(wheel).namelist())
    expected = {
        f"{target}/{path.relative_to(ROOT / floor).as_posix()}"
        for floor, target in FLOORS.items()
        for suffix in ("py", "toml", "csv")
        for path in (ROOT / floor).rglob(f"*.{suffix}")
    }
    assert expected <= names
    assert any(name.endswith("licenses/LICENSE") for name in names)


def test_wheel_works_away_from_the_checkout(wheel: Path, tmp_path: Path):
    """If it failed, the program would run in its own checkout only."""
    install = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index", "--target", "there", wheel]
    subprocess.run(install, cwd=tmp_path, check=True, capture_output=True)
    program = (
        "import sys; sys.path.insert(0, 'there');"
        "import warpsph, warpsph.kernels, warpsph.scenarios, warpsph.cli as cli;"
        "from warpsph.cases.scenario import registered_scenarios as scenarios;"
        "modules = [warpsph, warpsph.kernels, warpsph.scenarios, cli];"
        "print(*(module.__file__ for module in modules), sep='\\n');"
        "codes = [cli.main(['describe', name]) for name in scenarios()];"
        "sys.exit(any(codes))"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    files = [Path(line) for line in done.stdout.splitlines()[:4]]
    assert all(file.resolve().is_relative_to(tmp_path.resolve()) for file in files)


def test_this_installation_is_the_checkout():
    """If it failed, the tests would test another copy of the program than the one that is being changed."""
    import warpsph
    import warpsph.kernels
    import warpsph.scenarios

    modules = {"warpsph": warpsph, "kernels": warpsph.kernels, "scenarios": warpsph.scenarios}
    for floor, module in modules.items():
        assert Path(module.__file__).resolve() == (ROOT / floor / "__init__.py").resolve()
