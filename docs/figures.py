"""Draw the pictures of the manual anew: all of them, or those named on the command line (``make figures``).

A figure is a function here: its name with hyphens is the name of the picture under ``docs/figures``.
"""

import sys
from collections.abc import Callable
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from casting_figures import draw_breakout_shell, draw_inlets, draw_oscillation, event_times
from casting_flow_figures import draw_formulations
from conduction_figures import draw_cost, draw_steps
from convection_figures import draw_convection
from crystal_figures import draw_crystal_growth
from flow_figures import draw_impact, draw_scatter
from freezing_figures import draw_cavity, draw_sink, draw_sink_radius, draw_stefan
from matplotlib.colors import LogNorm
from particle_figures import draw_block, draw_ensemble
from plate_figures import draw_errors, draw_isotherms
from shear_figures import draw_cavity_flow, draw_channels
from vortex_figures import draw_patch, draw_vortices

from warpsph.cases.case import preset_layer, resolve, settings_layer
from warpsph.cli.catalogue import find_scenario
from warpsph.cli.consoles import error_console
from warpsph.cli.progress import shown_progress
from warpsph.core.labels import Role
from warpsph.core.model import GRAVITY
from warpsph.files.results import ResultFile
from warpsph.nearest import did_you_mean
from warpsph.pictures import plot_diagnostics, render_series, render_still
from warpsph.pictures.lines import Lines
from warpsph.scenarios.casting.experiments import INLETS
from warpsph.scenarios.casting.travelling_slice import shell_thickness
from warpsph.scenarios.elastic.cantilever import period, spectral_elements
from warpsph.scenarios.flow.dam_break import published_front
from warpsph.scenarios.flow.drop_shape import swing_of
from warpsph.scenarios.freezing.sodium_nitrate import EARLY, LATE

matplotlib.use("Agg")

ROOT = Path(__file__).parents[1]
PICTURES = ROOT / "docs" / "figures"
RUNS = ROOT / "build" / "figures"

EXPERIMENTS = {
    "KoshizukaOka1996": "Koshizuka & Oka (1996)",
    "MM1952_a2.25in_n2=2": "Martin & Moyce (1952), 57 mm",
    "MM1952_a1.125in_n2=2": "Martin & Moyce (1952), 29 mm",
}

Figure = Callable[[Path], None]
figures: dict[str, Figure] = {}


def figure(draw: Figure) -> Figure:
    """Register a function that draws one picture to the path it is given."""
    figures[draw.__name__.replace("_", "-")] = draw
    return draw


def simulated(name: str, preset: str | None = None, *settings: str) -> ResultFile:
    """The result of a preset with ``KEY=VALUE`` settings; figures that ask for the same one share the run."""
    path = RUNS / f"{'-'.join([name, preset or 'default', *settings])}.vtkhdf"
    if path not in _finished:
        scenario = find_scenario(name)
        layers = [preset_layer(scenario, preset)] if preset else []
        scenario = resolve(scenario, [*layers, settings_layer(settings)])
        with shown_progress(path.stem, error_console()) as progress:
            scenario.run(output=path, overwrite=True, progress=progress)
        _finished.add(path)
    return ResultFile(path)


_finished: set[Path] = set()


@figure
def casting_demo(picture: Path) -> None:
    """The strand of the demo at its end: the first picture of the README."""
    render_still(simulated("casting", "demo"), picture)


@figure
def casting_steady(picture: Path) -> None:
    """The strand at four times, until it is steady."""
    render_series(simulated("casting", "steady"), picture, [0.0, 15.0, 30.0, 60.0])


@figure
def casting_diagnostics(picture: Path) -> None:
    """All diagnostics of a strand that becomes steady."""
    plot_diagnostics(simulated("casting", "steady"), picture)


@figure
def casting_shell(picture: Path) -> None:
    """Thickness and surface temperature of the shell along the height, beside one-dimensional conduction."""
    result = simulated("casting", "steady")
    case = resolve(find_scenario("casting"), [preset_layer(find_scenario("casting"), "steady")])
    series = result.diagnostics
    heights, last_third = series["height"][0], series["time"] > 2.0 / 3.0 * series["time"][-1]
    profiles = case.slices(heights)
    exact = [shell_thickness(profile, case.steel, case.half_width, 0.5) for profile in profiles]
    drawing, (left, right) = plt.subplots(1, 2, figsize=(8, 5), sharey=True, layout="constrained")
    left.plot(1e3 * series["shell_thickness"][last_third].mean(axis=0), heights, "o-", label="warpsph")
    left.plot(1e3 * np.array(exact), heights, "k--", label="1-D, stagnant melt")
    left.set(xlabel="shell thickness [mm]", ylabel="height [m]")
    right.plot(np.nanmean(series["shell_surface_temperature"][last_third], axis=0), heights, "o-")
    right.plot(profiles[:, -1], heights, "k--")
    right.set(xlabel="surface temperature [K]")
    for axes in (left, right):
        axes.axhline(case.mould_bottom, color="0.7", lw=1)
        axes.axhline(case.nozzle_mouth, color="0.7", lw=1, ls=":")
    left.annotate("mould ends", (0.98, case.mould_bottom), xycoords=("axes fraction", "data"), ha="right", va="bottom")
    left.annotate("nozzle", (0.98, case.nozzle_mouth), xycoords=("axes fraction", "data"), ha="right", va="bottom")
    left.legend(frameon=False, loc="lower left")
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


@figure
def casting_formulations(picture: Path) -> None:
    """Pressure, speed and shell of the demo on two formulations of the flow."""
    names = ("published", "corrected")
    results = {name: simulated("casting", "demo", f"formulation={name}") for name in names}
    draw_formulations(
        resolve(find_scenario("casting"), [preset_layer(find_scenario("casting"), "demo")]), results, picture
    )


@figure
def casting_inlet_port(picture: Path) -> None:
    """The strand with side ports in the middle."""
    render_still(simulated("casting", "inlet_middle"), picture)


@figure
def casting_inlets(picture: Path) -> None:
    """The thickness of the shell with ports at three heights."""
    draw_inlets([simulated("casting", preset) for preset in INLETS], picture)


@figure
def casting_oscillation(picture: Path) -> None:
    """What follows the mould over two cycles."""
    draw_oscillation(simulated("casting", "oscillation"), picture)


@figure
def casting_billet(picture: Path) -> None:
    """The billet from outside."""
    render_still(simulated("casting", "billet"), picture)


@figure
def casting_billet_open(picture: Path) -> None:
    """The billet cut open."""
    render_still(simulated("casting", "billet"), picture, cut=(2, 0.03))


@figure
def breakout(picture: Path) -> None:
    """The strand when the sprays fail, when the program noted thinning and hole, and half a second and more later."""
    result = simulated("breakout", "coarse")
    thinning, hole, _ = event_times(result)
    render_series(result, picture, [result.parameters["spray_failure"], thinning, hole, hole + 0.5, hole + 2.5])


@figure
def breakout_shell(picture: Path) -> None:
    """The shell over height and time, with the sprays on and off."""
    case = resolve(find_scenario("breakout"), [preset_layer(find_scenario("breakout"), "coarse")])
    control = simulated("breakout", "coarse", "spray_failing=[]")
    draw_breakout_shell(simulated("breakout", "coarse"), control, case, picture)


@figure
def hydrostatic(picture: Path) -> None:
    """Pressure and density of every particle of the column at rest, beside the exact column."""
    case = find_scenario("hydrostatic")()
    position, fields = simulated("hydrostatic").frame(-1)
    melt = fields["role"] == Role.FREE
    y = np.linspace(0.0, case.height, 200)
    drawing, (left, right) = plt.subplots(1, 2, figsize=(8, 5), sharey=True, layout="constrained")
    left.plot(1e-3 * fields["pressure"][melt], position[melt, 1], ".", ms=2, label="particles")
    left.plot(1e-3 * case.exact_pressure(y), y, "k-", lw=1, label="exact column")
    left.plot(43.8, 0.0, "D", color="C3", clip_on=False, label="Vijaykumar (7.1)")
    left.set(xlabel="pressure [kPa]", ylabel="height [m]")
    left.legend(frameon=False)
    right.plot(fields["density"][melt], position[melt, 1], ".", ms=2)
    right.plot(case.exact_density(y), y, "k-", lw=1)
    right.set(xlabel="density [kg/m³]", xlim=(2050.0, 2200.0))
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


@figure
def heat_gaussian(picture: Path) -> None:
    """Temperature through the middle of the plate at four times, and the error against the spacing."""
    case = find_scenario("heat_gaussian")
    result = simulated("heat_gaussian")
    drawing, (left, right) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    for k, time in enumerate((0.0, 1.0, 2.5, 5.0)):
        position, fields = result.frame(result.nearest(time))
        row = np.abs(position[:, 1]) < 0.6 * case().spacing
        left.plot(position[row, 0], fields["temperature"][row], ".", ms=4, color=f"C{k}", label=f"{time:g} s")
        x = np.column_stack([np.linspace(-0.5, 0.5, 200), np.full((200, 2), [0.5 * case().spacing, 0.0])])
        left.plot(x[:, 0], case().exact(x, time), "k-", lw=0.8)
    left.set(xlabel="x [m]", ylabel="temperature [K]")
    left.legend(frameon=False)
    spacings = np.array([0.02, 0.01, 0.005])
    runs = [simulated("heat_gaussian", None, f"spacing={dx}", "output_interval=5.0") for dx in spacings]
    errors = [run.diagnostics["largest_error"][-1] for run in runs]
    right.loglog(1e3 * spacings, errors, "o-", label="largest error over the peak")
    right.loglog(1e3 * spacings, errors[1] * (spacings / spacings[1]) ** 2, "k--", lw=0.8, label="second order")
    right.set(xlabel="spacing [mm]", xticks=1e3 * spacings, xticklabels=["20", "10", "5"])
    right.minorticks_off()
    right.legend(frameon=False)
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


@figure
def heat_slab(picture: Path) -> None:
    """Temperature through a slab with two kinds of walls at some times, and the error against the number of rows."""
    kind = find_scenario("heat_slab")
    drawing, axes = plt.subplots(1, 3, figsize=(12, 4), layout="constrained")
    for panel, preset, title in zip(axes, ("flux", "film"), ("flux | temperature", "insulation | film"), strict=False):
        case = resolve(kind, [preset_layer(kind, preset)])
        result, x = simulated("heat_slab", preset), np.linspace(0.0, case.thickness, 200)
        for k, time in enumerate((20.0, 60.0, 200.0)):
            position, fields = result.frame(result.nearest(time))
            row = position[:, 1] < case.spacing
            panel.plot(
                1e3 * position[row, 0], fields["temperature"][row], "o", ms=4, color=f"C{k}", label=f"{time:g} s"
            )
            panel.plot(1e3 * x, case.exact.temperature(x, time), "k-", lw=0.8)
        panel.set(xlabel="x [mm]", ylabel="temperature [K]", title=title)
        panel.legend(frameon=False)
    rows = np.array([10, 20, 40])
    for label, settings in (("rows before the walls", ()), ("rows on the walls", ("row_on_wall=true",))):
        runs = [simulated("heat_slab", None, f"rows={n}", *settings) for n in rows]
        axes[2].loglog(rows, [run.diagnostics["largest_error"][-1] for run in runs], "o-", label=label)
    axes[2].loglog(rows, 0.3 * (10.0 / rows) ** 2, "k--", lw=0.8, label="second order")
    axes[2].set(xlabel="rows", ylabel="largest error at 200 s [K]", xticks=rows, xticklabels=["10", "20", "40"])
    axes[2].minorticks_off()
    axes[2].legend(frameon=False)
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


def _plate(name: str, preset: str | None = None, *settings: str):
    """A plate and its run."""
    layers = [preset_layer(find_scenario(name), preset)] if preset else []
    case = resolve(find_scenario(name), [*layers, settings_layer(settings)])
    return case, simulated(name, preset, *settings)


@figure
def plate_fixed(picture: Path) -> None:
    """Isotherms of the plate between cold edges at the times of the source."""
    runs = {"default": _plate("plate_fixed"), "published": _plate("plate_fixed", "paper")}
    draw_isotherms(runs, [0.25, 1.0, 4.0, 8.0], np.arange(10.0, 100.0, 10.0), picture)


@figure
def natural_convection(picture: Path) -> None:
    """Isotherms, arrows and Nusselt numbers of three boxes."""
    scenario = find_scenario("natural_convection")
    runs = {}
    for preset in ("weak", None, "strong"):
        case = resolve(scenario, [preset_layer(scenario, preset)] if preset else [])
        runs[case] = simulated("natural_convection", preset)
    draw_convection(runs, picture)


@figure
def plate_convective(picture: Path) -> None:
    """Isotherms of the plate behind films at the times of the source."""
    runs = {"default": _plate("plate_convective"), "published": _plate("plate_convective", "paper")}
    draw_isotherms(runs, [0.5, 1.0, 4.0, 8.0], np.arange(60.0, 100.0, 4.0), picture)


@figure
def plate_errors(picture: Path) -> None:
    """Errors of both plates over time, and against the number of particles."""
    runs = {
        "cold edges": simulated("plate_fixed"),
        "cold edges, published": simulated("plate_fixed", "paper"),
        "films": simulated("plate_convective"),
        "films, published": simulated("plate_convective", "paper"),
    }
    counts, orders = [20, 40, 80, 160], {}
    for label, name, settings in (
        ("cold edges", "plate_fixed", ()),
        ("films", "plate_convective", ()),
        ("films, gradient on one side", "plate_convective", ("boundary=gradient",)),
    ):
        short = ("duration=1.0", "output_interval=1.0", "step=1.0", *settings)
        orders[label] = [
            float(simulated(name, None, f"across={n}", *short).diagnostics["rms_error"][-1]) for n in counts
        ]
    draw_errors(runs, counts, orders, picture)


@figure
def conduction_steps(picture: Path) -> None:
    """Errors of the integrators over the step, as ``make study`` has measured them."""
    draw_steps(picture)


@figure
def conduction_cost(picture: Path) -> None:
    """Processor time over the number of particles, as ``make study`` has measured it."""
    draw_cost(picture)


@figure
def crystal_growth(picture: Path) -> None:
    """The crucible after half an hour, beside finite volumes."""
    draw_crystal_growth(simulated("crystal_growth"), picture)


@figure
def stefan_slab(picture: Path) -> None:
    """Temperature and heat lost through the slab that freezes, as published and by the default."""
    published = ("planes=false", "exact_on_lattice=false", "phases=stored")
    runs = {"published": simulated("stefan_slab", "paper"), "default": simulated("stefan_slab")}
    unequal = {
        "published": simulated("stefan_slab", "unequal", *published),
        "default": simulated("stefan_slab", "unequal"),
    }
    draw_stefan(runs, unequal, picture)


@figure
def point_sink(picture: Path) -> None:
    """Particles, heat lost and temperature around the sink."""
    strong = ("similarity=0.2", "duration=316666.666667", "output_interval=3166.66666667")
    runs = [
        ("published, λ = 0.15, 40 particles", simulated("point_sink", "paper")),
        ("published, λ = 0.15, 50 particles", simulated("point_sink", "paper", "particles=50")),
        ("published, λ = 0.20, 40 particles", simulated("point_sink", "paper", *strong)),
        ("default, λ = 0.15, 40 particles", simulated("point_sink")),
    ]
    draw_sink(runs, picture)


@figure
def point_sink_radius(picture: Path) -> None:
    """The radius of the ice over time, and its error against the spacing."""
    counts = (20, 30, 40, 50)
    published = {n: simulated("point_sink", "paper", f"particles={n}") for n in counts}
    draw_sink_radius(published, {n: simulated("point_sink", None, f"particles={n}") for n in counts}, picture)


@figure
def cavity(picture: Path) -> None:
    """The cavity at three times, and the share that has frozen."""
    result = simulated("cavity")
    shares = {
        "80 particles a metre": simulated("cavity", None, "across=80"),
        "40": result,
        "40, published conduction": simulated("cavity", "paper"),
    }
    draw_cavity(result, [120000.0, 360000.0, 600000.0], shares, picture)


@figure
def sodium_nitrate(picture: Path) -> None:
    """Temperature, ice and salt over the height beside the exact mush, and the thickness of the mush over time."""
    kind = find_scenario("sodium_nitrate")
    case, result = kind(), simulated("sodium_nitrate")
    narrow = {n: simulated("sodium_nitrate", None, f"rows={n}", "columns=4") for n in (60, 120)}
    printed = simulated("sodium_nitrate", None, "rows=60", "columns=4", "literal=true")
    drawing, axes = plt.subplots(2, 2, figsize=(10, 8), layout="constrained")
    temperature, ice, salt, thickness = axes.flat
    y = np.linspace(1e-4, 0.25, 500)
    for k, (time, label) in enumerate(((EARLY, "3 h 40 min"), (LATE, "25 h 30 min"))):
        for panel, name, exact in (
            (temperature, "temperature", case.exact.temperature(y, time) - 273.15),
            (ice, "ice", case.exact.ice(y, time)),
            (salt, "brine", case.exact.solute(y, time)),
        ):
            offset = 273.15 if name == "temperature" else 0.0
            for n, run, marker in ((30, result, "o"), (60, narrow[60], ".")):
                series = run.diagnostics
                frame = int(np.argmin(np.abs(series["time"] - time)))
                shown = f"{label}, {n} rows" if panel is temperature else None
                values = series[name][frame] - offset
                panel.plot(series["height"][frame], values, marker, mfc="none", ms=6, color=f"C{k}", label=shown)
            panel.plot(y, exact, "k-", lw=0.8)
    temperature.set(ylabel="temperature [°C]")
    temperature.legend(frameon=False, fontsize=8)
    ice.set(ylabel="volume fraction of ice")
    salt.set(ylabel="mass fraction of salt in the liquid")
    for panel in (temperature, ice, salt):
        panel.set(xlabel="height [m]", xlim=(0.0, 0.25 if panel is temperature else 0.15))
    hours = np.linspace(1e-3, LATE, 200) / 3600.0
    for run, label, style in (
        (result, "30 rows", "C0o"),
        (narrow[60], "60 rows", "C1."),
        (narrow[120], "120 rows", "C2-"),
        (printed, "60 rows, (4.2) as printed", "C3-"),
    ):
        thickness.plot(run.diagnostics["time"] / 3600.0, 1e2 * run.diagnostics["mush"], style, ms=3, label=label)
    thickness.plot(hours, [1e2 * case.exact.front(3600.0 * hour) for hour in hours], "k-", lw=0.8, label="exact")
    thickness.set(xlabel="time [h]", ylabel="thickness of the mush [cm]")
    thickness.legend(frameon=False, fontsize=8)
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


@figure
def sodium_nitrate_box(picture: Path) -> None:
    """The box at the two times of the source, coloured by the volume fraction of ice."""
    render_series(simulated("sodium_nitrate"), picture, [0.0, EARLY, LATE], field="solid_fraction")


@figure
def dam_break(picture: Path) -> None:
    """The collapse at four times, coloured by temperature."""
    render_series(simulated("dam_break"), picture, [0.0, 0.2, 0.4, 0.8], field="temperature")


@figure
def dam_break_front(picture: Path) -> None:
    """The front in the plane and in space beside the experiments."""
    drawing, axes = plt.subplots(figsize=(6, 4.5), layout="constrained")
    for preset, label in ((None, "warpsph, 2D"), ("space", "warpsph, 3D")):
        series = simulated("dam_break", preset).diagnostics
        time = series["time"] * np.sqrt(2.0 * GRAVITY / find_scenario("dam_break")().width)
        axes.plot(time, series["front"], label=label)
    for dataset, marker in (("KoshizukaOka1996", "o"), ("MM1952_a2.25in_n2=2", "^"), ("MM1952_a1.125in_n2=2", "v")):
        axes.plot(*np.transpose(published_front(dataset)), marker, mfc="none", label=EXPERIMENTS[dataset])
    axes.set(xlim=(0.0, 3.5), ylim=(0.9, 4.1), xlabel=r"$t\sqrt{2g/L}$", ylabel="front / L")
    axes.legend(frameon=False)
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


@figure
def dam_break_space(picture: Path) -> None:
    """The collapse in space."""
    render_still(simulated("dam_break", "space"), picture, field="temperature", time=0.4)


@figure
def poiseuille(picture: Path) -> None:
    """Profiles of the pushed fluid, between plates that rub and with one along which it slips, beside the series."""
    cases: dict[str, tuple[str, ...]] = {"plates that rub": (), "it slips along the upper one": ("slip=upper",)}
    draw_channels({title: simulated("poiseuille", None, *settings) for title, settings in cases.items()}, picture)


@figure
def couette(picture: Path) -> None:
    """Profiles between plates that slide, one of them or both, beside the series."""
    cases: dict[str, tuple[str, ...]] = {
        "the upper plate slides": (),
        "both slide": ("lower=-1.0",),
        "it slips along the lower one": ("slip=lower",),
    }
    draw_channels({title: simulated("couette", None, *settings) for title, settings in cases.items()}, picture)


@figure
def cavity_flow(picture: Path) -> None:
    """Vorticity and streamlines of the box under a lid."""
    render_still(simulated("cavity_flow"), picture, field="vorticity", lines=Lines(streamlines=True))


@figure
def cavity_flow_profiles(picture: Path) -> None:
    """Velocity on the centre lines of the box under a lid, at two Reynolds numbers, beside the published ones."""
    settings = {100: (), 400: ("reynolds=400.0", "duration=50.0")}
    draw_cavity_flow({re: simulated("cavity_flow", None, *given) for re, given in settings.items()}, picture)


@figure
def dam_impact(picture: Path) -> None:
    """The wave before, at and after the impact, and when it comes back, coloured by pressure."""
    render_series(simulated("dam_impact"), picture, [0.0, 0.35, 0.6, 1.2], field="pressure")


@figure
def dam_impact_pressure(picture: Path) -> None:
    """Pressures on the end wall and levels beside the experiment."""
    draw_impact(simulated("dam_impact"), find_scenario("dam_impact")().moment, picture)


@figure
def still_tank(picture: Path) -> None:
    """Pressure of every particle over its height, with both formulations at the same viscosity."""
    case = find_scenario("still_tank")()
    settings = f"viscosity={case.viscosity_of_cell(10.0):.4g}"
    names = ("published", "corrected")
    draw_scatter(
        case, {name: simulated("still_tank", None, settings, f"formulation={name}") for name in names}, picture
    )


@figure
def drop(picture: Path) -> None:
    """The square drop on its way to the circle."""
    render_series(simulated("drop"), picture, [0.0, 0.2, 0.4, 6.0], field="pressure")


@figure
def drop_swing(picture: Path) -> None:
    """The second mode of the elliptic drop, beside the swing that fits it and the one of Rayleigh's period."""
    case, series = find_scenario("drop")(shape="ellipse"), simulated("drop", None, "shape=ellipse").diagnostics
    time, exact = series["time"], case.period(2, float(series["radius"][0]))
    swing = swing_of(time, series["second_mode"], exact)
    omega = np.sqrt((2.0 * np.pi / exact) ** 2 - swing.damping**2)
    drawing, axes = plt.subplots(figsize=(6, 3.5), layout="constrained")
    axes.plot(time, series["second_mode"], label="measured")
    rayleigh = swing.amplitude * np.exp(-swing.damping * time) * np.cos(omega * time)
    axes.plot(time, rayleigh, "k--", lw=1, label="Rayleigh's period, damping and amplitude as measured")
    axes.axhline(0.0, color="0.8", lw=0.8, zorder=0)
    axes.set(xlabel="time [s]", ylabel="amplitude of the second mode, over R")
    axes.legend(frameon=False)
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


@figure
def taylor_green(picture: Path) -> None:
    """The vortices at the end, their decay by each formulation, and the error of its rate over the rows."""
    formulations = {name: simulated("taylor_green", None, f"formulation={name}") for name in ("corrected", "delta")}
    kinds = {"lattice": (), "disordered": ("start=disordered",), "lattice, sound twice as fast": ("sound_speed=20.0",)}
    refined = {
        kind: {n: simulated("taylor_green", None, f"rows={n}", *settings) for n in (25, 50, 100)}
        for kind, settings in kinds.items()
    }
    draw_vortices(formulations, refined, picture)


@figure
def free_patch(picture: Path) -> None:
    """The patch at three times, and what each formulation makes of its energy and its area."""
    names = ("corrected", "delta", "continuity")
    runs = {name: simulated("free_patch", None, "start=disordered", f"formulation={name}") for name in names}
    draw_patch(runs, (0.0, 0.5, 1.0), picture)


@figure
def rotated_disc(picture: Path) -> None:
    """Force on each particle of the turned disc, corrected and as published."""
    drawing, axes = plt.subplots(1, 2, figsize=(8, 4), layout="constrained")
    for panel, corrected, title in zip(axes, (True, False), ("corrected", "as published"), strict=True):
        case = find_scenario("rotated_disc")(corrected=corrected, duration=1e-4, output_interval=1e-4)
        result = case.run(device="cpu")
        mass = result.fields["mass"][:, None]
        force = np.linalg.norm(mass * result.fields["acceleration"], axis=1) / (case.youngs_modulus * case.spacing)
        x = 1e3 * result.positions
        dots = panel.scatter(x[:, 0], x[:, 1], s=9, c=np.maximum(force, 1e-8), norm=LogNorm(1e-8, 1.0), cmap="viridis")
        panel.set(title=title, xlabel="x [mm]", aspect="equal")
    axes[0].set_ylabel("y [mm]")
    drawing.colorbar(dots, ax=axes, label=r"force / ($E\,\Delta x$)")
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


@figure
def cantilever(picture: Path) -> None:
    """Shapes of the plate over a period, the deflection of its tip, and the error of the period over the spacing."""
    case = find_scenario("cantilever")()
    known_period, known_tip = spectral_elements()[case.speed]
    layers = np.array([6, 10, 20])
    runs = [simulated("cantilever", None, f"layers={n}") for n in layers]
    drawing, (shapes, tip, error) = plt.subplots(1, 3, figsize=(13, 4), layout="constrained")
    for k, quarter in enumerate((0.0, 0.25, 0.5, 0.75)):
        position, _ = runs[1].frame(runs[1].nearest(quarter * known_period))
        shapes.plot(1e3 * position[:, 0], 1e3 * position[:, 1], ".", ms=1.5, color=f"C{k}", label=f"{quarter:g} T")
    shapes.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal")
    shapes.legend(frameon=False, markerscale=6, loc="upper left")
    for run, n in zip(runs, layers, strict=True):
        tip.plot(run.diagnostics["time"], 1e3 * run.diagnostics["tip"], lw=1, label=f"{n} particles across")
    crests, troughs = (np.arange(3) + 0.25) * known_period, (np.arange(3) + 0.75) * known_period
    tip.plot(crests, np.full(3, 1e3 * known_tip), "k_", ms=12, label="spectral elements")
    tip.plot(troughs, np.full(3, -1e3 * known_tip), "k_", ms=12)
    tip.plot(np.arange(1, 4) * known_period, np.zeros(3), "k|", ms=12)
    tip.set(xlabel="time [s]", ylabel="deflection of the tip [mm]", ylim=(-130.0, 190.0))
    tip.legend(frameon=False, ncols=2, loc="upper center", fontsize=8)
    wide = [simulated("cantilever", None, f"layers={n}", "support_ratio=2.6", "duration=0.3") for n in layers]
    for found, label in ((wide, "support 2.6 spacings"), (runs, "support 1.5 spacings")):
        periods = np.array([period(run.diagnostics["time"], run.diagnostics["tip"]) for run in found])
        errors = 100.0 * (periods / known_period - 1.0)
        error.loglog(layers, errors, "o-", label=label)
    error.loglog(layers, errors[1] * (layers[1] / layers) ** 2, "k--", lw=0.8, label="second order")
    error.set(xlabel="particles across", ylabel="error of the period [%]", xticks=layers, xticklabels=layers)
    error.minorticks_off()
    error.legend(frameon=False)
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


@figure
def rubber_rings(picture: Path) -> None:
    """The rings at six times, coloured by speed."""
    render_series(simulated("rubber_rings"), picture, [0.0, 0.004, 0.008, 0.012, 0.018, 0.024], field="speed")


@figure
def melting_triangle(picture: Path) -> None:
    """Slow heating with the stronger last source at the times of figure 4.1."""
    times = [8.0, 8.2, 8.4, 8.6, 8.7, 8.8, 9.4, 10.0]
    render_series(simulated("melting_triangle", "adjusted"), picture, times)


@figure
def melting_triangle_fast(picture: Path) -> None:
    """Fast heating with the stronger source; of figure 4.2 the text tells the times 0.5 s (e) and 3.0 s (g)."""
    render_series(simulated("melting_triangle", "fast_adjusted"), picture, [0.1, 0.2, 0.3, 0.4, 0.5, 1.4, 3.0])


@figure
def melting_block(picture: Path) -> None:
    """The block from when the lamp is switched on until the end."""
    draw_block(simulated("melting_block"), [6.0, 8.0, 12.0, 20.0], picture)


@figure
def melting_rectangle(picture: Path) -> None:
    """The rectangle on the hot floor, table 2 as printed; of figure 5.2 the text tells the time 5.0 s only."""
    render_series(simulated("melting_rectangle", "printed"), picture, [0.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0])


@figure
def melting_rectangle_ensemble(picture: Path) -> None:
    """How many particles are fluid at the end, over starts that differ by 1e-12 ft, and over time."""
    runs = [simulated("melting_rectangle", "printed", "perturbation=1e-12", f"seed={seed}") for seed in range(40)]
    draw_ensemble(runs, picture)


def main(names: list[str]) -> str | None:
    """Draw the named figures, all of them if none is named; return what is wrong with the names."""
    for name in names:
        if name not in figures:
            return f"unknown figure '{name}'{did_you_mean(name, figures)}"
    for folder in (PICTURES, RUNS):
        folder.mkdir(parents=True, exist_ok=True)
    for name in names or figures:
        picture = PICTURES / f"{name}.png"
        figures[name](picture)
        print(f"drawn: {picture.relative_to(ROOT)}")
    return None


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
