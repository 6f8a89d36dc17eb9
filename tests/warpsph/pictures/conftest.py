"""A made-up casting run: quick to write, and with everything that a picture must show."""

import matplotlib
import numpy as np
import pytest

from warpsph.core.labels import Phase, Role
from warpsph.core.quantity import Quantity
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile

matplotlib.use("Agg")

LIQUIDUS = 1723.0
FIELDS = {
    "velocity": Quantity("velocity", "m/s"),
    "pressure": Quantity("pressure", "Pa", "cividis"),
    "temperature": Quantity("temperature", "K", "inferno"),
}
DIAGNOSTICS = {
    "level": Quantity("melt level", "m"),
    **{f"mass_{where}": Quantity(where, "kg/m", panel="mass") for where in ("inside", "in", "out")},
    **{f"enthalpy_{where}": Quantity(where, "J/m", panel="enthalpy") for where in ("inside", "in", "out")},
    "heat_mould": Quantity("to the mould", "J/m", panel="heat taken away"),
    "heat_spray": Quantity("to the spray", "J/m", panel="heat taken away"),
    "ledger_error": Quantity("relative error of the heat ledger"),
    "kinetic_energy": Quantity("kinetic energy", "J/m"),
    "highest_speed": Quantity("highest speed", "m/s"),
    "shell_thickness": Quantity("shell thickness", "m", over="height"),
    "shell_surface_temperature": Quantity("shell surface temperature", "K", "inferno", over="height"),
    "density_min": Quantity("lowest", "kg/m^3", panel="density"),
    "density_max": Quantity("highest", "kg/m^3", panel="density"),
    "casting_speed": Quantity("casting speed", "m/s"),
    "height": Quantity("height", "m"),
}


def lattice(left, bottom, right, top, spacing) -> np.ndarray:
    """Points (n, 3) of a square lattice in a rectangle, half a spacing from its edges [m]."""
    x = np.arange(left + spacing / 2, right, spacing)
    y = np.arange(bottom + spacing / 2, top, spacing)
    return np.stack([*(axis.ravel() for axis in np.meshgrid(x, y)), np.zeros(len(x) * len(y))], axis=1)


def strand(time: float, spacing: float) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """One frame: melt with a shell at the right that is withdrawn along a mould, rolls and sprays."""
    random = np.random.default_rng(1)
    level = 0.44 - 0.002 * time
    free = lattice(0.0, -0.02, 0.1, level, spacing)
    free = free[~((free[:, 0] > 0.016) & (free[:, 0] < 0.02) & (free[:, 1] > 0.36))]
    free[:, :2] += random.normal(0, 0.05 * spacing, (len(free), 2))
    x, y = free[:, 0], free[:, 1]
    depth = np.clip(level - y, 0.0, None)
    thickness = 0.03 * np.sqrt(depth / 0.46) * min(1.0, time / 6.0)
    inside = 0.1 - x
    solid = inside < thickness
    temperature = np.where(
        solid,
        LIQUIDUS - 500.0 * (1 - inside / np.maximum(thickness, 1e-9)) * np.sqrt(depth / 0.46),
        LIQUIDUS + 100.0 * np.exp(-2.5 * depth / 0.46) * np.clip((inside - thickness) / 0.1, 0, 1) ** 0.4,
    )
    velocity = np.stack([0.02 * np.sin(40 * y), -0.01 - 0.08 * np.exp(-((x / 0.03) ** 2)) * (~solid), 0 * x], axis=1)
    blocks = [(free, Role.FREE, temperature, np.where(solid, Phase.SOLID, Phase.LIQUID), velocity, depth * 7000 * 9.81)]

    def add(points, role, temperature):
        n = len(points)
        blocks.append((points, role, np.full(n, temperature), np.full(n, Phase.SOLID), np.zeros((n, 3)), np.zeros(n)))

    add(lattice(0.1, 0.24, 0.112, 0.5, spacing), Role.WALL, 400.0)
    add(lattice(-0.012, -0.02, 0.0, 0.54, spacing), Role.DUMMY, 300.0)
    add(lattice(0.016, 0.36, 0.02, 0.54, spacing), Role.DUMMY, 300.0)
    for roll in np.arange(0.01, 0.24, 0.04):
        add(lattice(0.1, roll, 0.112, roll + 0.008, spacing), Role.DUMMY, 300.0)
    if time > 0:
        sprays = np.stack([0.11 + 0.06 * random.random(60), 0.03 + 0.2 * random.random(60), np.zeros(60)], axis=1)
        add(sprays, Role.SPRAY, 300.0)
    points, roles, temperatures, phases, velocities, pressures = zip(*blocks, strict=True)
    counts = [len(block) for block in points]
    total = sum(counts)
    return np.concatenate(points).astype("f4"), {
        "id": np.arange(total, dtype="i4"),
        "role": np.repeat(np.array(roles, "i4"), counts),
        "material": np.repeat(np.array(roles, "i4") == Role.WALL, counts).astype("i4"),
        "phase": np.concatenate(phases).astype("i4"),
        "velocity": np.concatenate(velocities).astype("f4"),
        "pressure": np.concatenate(pressures).astype("f4"),
        "temperature": np.concatenate(temperatures).astype("f4"),
    }


def write_strand(path, spacing: float = 0.004, times=(0.0, 3.0, 6.0, 12.0)) -> ResultFile:
    """Write the made-up run with diagnostics like those of a casting run."""
    height = np.linspace(-0.02, 0.44, 24)
    provenance = {"spacing": spacing, "dimension": 2, "materials": ["steel", "copper"]}
    with ResultWriter(path, {"scenario": "casting", "spacing": spacing}, provenance, quantities=FIELDS) as writer:
        for time in times:
            writer.write_frame(time, *strand(time, spacing))
        for time in np.linspace(0, 12, 60):
            thickness = 0.03 * np.sqrt(np.clip(0.44 - height, 0, None) / 0.46) * min(1.0, time / 6.0)
            values = {
                "level": 0.44 - 0.002 * time + 0.001 * np.sin(9 * time),
                "mass_inside": 310 - time,
                "mass_in": 5 * time,
                "mass_out": 6 * time,
                "enthalpy_inside": 4e8 - 1e6 * time,
                "enthalpy_in": 6e6 * time,
                "enthalpy_out": 5e6 * time,
                "heat_mould": 1.4e6 * time,
                "heat_spray": 0.6e6 * time,
                "ledger_error": 1e-6 * np.sin(time),
                "kinetic_energy": 2e-3 * np.exp(-time),
                "highest_speed": 0.2 + 0.1 * np.exp(-time),
                "shell_thickness": thickness,
                "shell_surface_temperature": LIQUIDUS - 10e3 * thickness,
                "density_min": 6990 - time,
                "density_max": 7010 + time,
                "casting_speed": 0.01 * min(1.0, time / 3),
                "height": height,
                "something_else": time,
            }
            writer.write_diagnostics(time, values, DIAGNOSTICS)
        writer.write_event(9.0, "spray 2 failed")
        writer.finish(status="complete")
    return ResultFile(path)


@pytest.fixture(scope="session")
def result(tmp_path_factory) -> ResultFile:
    """The made-up run at 4 mm."""
    return write_strand(tmp_path_factory.mktemp("strand") / "strand.vtkhdf")
