"""Which colours particles get, and what the key says about them."""

import numpy as np
import pytest
from matplotlib.colors import to_rgb

from warpsph.core.labels import Phase, Role
from warpsph.core.quantity import Quantity
from warpsph.errors import InputError
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile
from warpsph.pictures.looks import CategoryLook, QuantityLook, StrandLook, choose_look
from warpsph.pictures.palette import MELT, ROLE_COLOURS, SHELL


@pytest.fixture
def frames(result):
    """Two frames of the made-up run."""
    return [result.frame(0), result.frame(-1)]


def of_role(fields, role):
    """Mask of one role."""
    return fields["role"] == role


def test_default_look_of_a_strand(result, frames):
    """If it failed, shell and melt could not be told apart, or the mould would look like steel."""
    look = choose_look(result, None, frames)
    assert isinstance(look, StrandLook)
    fields = frames[-1][1]
    colours = look.colours(fields)
    for role in (Role.WALL, Role.DUMMY, Role.SPRAY):
        np.testing.assert_allclose(
            colours[of_role(fields, role)], [to_rgb(ROLE_COLOURS[role])] * sum(of_role(fields, role))
        )
    free, solid = of_role(fields, Role.FREE), fields["phase"] == Phase.SOLID
    red, blue = colours[:, 0], colours[:, 2]
    assert np.all(blue[free & solid] > red[free & solid])
    assert np.all(red[free & ~solid] > blue[free & ~solid])
    hottest, coldest = (np.argmax(np.where(free, sign * fields["temperature"], -np.inf)) for sign in (1, -1))
    np.testing.assert_allclose(colours[hottest], to_rgb(MELT[-1]), atol=0.05)
    np.testing.assert_allclose(colours[coldest], to_rgb(SHELL[0]), atol=0.05)
    assert [name for name, _ in look.patches()] == ["copper", "dummy", "spray"]
    assert look.title == "temperature [K]"


def test_shell_stays_blue_at_the_temperature_of_melt(result, frames):
    """If it failed, a shell that is as hot as the melt beside it would vanish from the picture."""
    look = choose_look(result, None, frames)
    hot = np.full(2, 1800.0, "f4")
    colours = look.colours({"temperature": hot, "phase": np.array([0, 2]), "role": np.zeros(2, "i4")})
    assert colours[0, 0] > colours[0, 2]
    assert colours[1, 2] > colours[1, 0]


def made_up(tmp_path, quantities=None, **fields):
    """A file of one frame of ten free particles, and what is known of its fields."""
    n = 10
    plain = {
        "role": np.zeros(n, "i4"),
        "phase": np.zeros(n, "i4"),
        "temperature": np.full(n, 300, "f4"),
        "velocity": np.ones((n, 3), "f4"),
    }
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {"spacing": 0.1, "dimension": 2}, quantities=quantities) as writer:
        writer.write_frame(0.0, np.random.default_rng(1).random((n, 3)), plain | fields)
    result = ResultFile(path)
    return result, [result.frame(0)]


def test_default_look_of_runs_without_freezing(tmp_path):
    """If it failed, a dam break would be shown in one flat colour of a constant temperature."""
    result, frames = made_up(tmp_path)
    assert choose_look(result, None, frames).name == "speed"
    (tmp_path / "run.vtkhdf").unlink()
    result, frames = made_up(tmp_path, temperature=np.linspace(300, 400, 10, dtype="f4"))
    assert choose_look(result, None, frames).name == "temperature"


def test_temperature_spends_its_colours_on_the_steel(result, frames):
    """If it failed, a cold mould would leave one colour for the whole strand, and the shell could not be seen."""
    look = choose_look(result, "temperature", frames)
    steel = np.concatenate([fields["temperature"][of_role(fields, Role.FREE)] for _, fields in frames])
    assert look.mappable.get_clim() == (steel.min(), steel.max())
    assert [name for name, _ in look.patches()] == ["copper", "dummy", "spray"]
    assert look.edge


def test_walls_are_coloured_where_nothing_freezes(tmp_path):
    """If it failed, nobody could see how a wall warms up."""
    role = np.where(np.arange(10) < 5, Role.FREE, Role.WALL).astype("i4")
    result, frames = made_up(tmp_path, temperature=np.linspace(300, 400, 10, dtype="f4"), role=role)
    look = choose_look(result, "temperature", frames)
    assert look.mappable.get_clim() == (300.0, 400.0)
    assert not look.edge
    assert look.patches() == []


def test_speed_is_the_magnitude_of_velocity(result, frames):
    """If it failed, the colour bar of a speed would show one component, or the wrong range."""
    look = choose_look(result, "speed", frames)
    assert isinstance(look, QuantityLook)
    assert look.title == "speed [m/s]"
    velocity, role = frames[-1][1]["velocity"], frames[-1][1]["role"]
    fastest = np.linalg.norm(velocity[role == Role.FREE], axis=1).max()
    assert look.mappable.norm.vmax == pytest.approx(fastest, rel=0.05)
    np.testing.assert_allclose(choose_look(result, "velocity", frames).mappable.get_clim(), look.mappable.get_clim())


def test_a_declared_field_has_its_name_unit_and_colours(tmp_path):
    """If it failed, a scenario's own field could not be drawn, or would not be called what it was declared as."""
    quantities = {
        "dye": Quantity("concentration of the dye", "mol/m^3", "magma"),
        "pull": Quantity("pull of the wire", "N"),
        "speed": Quantity("speed of the reaction", "1/s"),
        "velocity": Quantity("velocity", "m/s"),
    }
    own = {
        "dye": np.linspace(0, 1, 10, dtype="f4"),
        "pull": np.full((10, 3), 2.0, "f4"),
        "speed": np.arange(10, dtype="i4"),
    }
    result, frames = made_up(tmp_path, quantities, **own)
    look = choose_look(result, "dye", frames)
    assert look.title == "concentration of the dye [mol/m³]"
    assert look.mappable.get_cmap().name == "magma"
    assert look.mappable.get_clim() == (0.0, 1.0)
    pull = choose_look(result, "pull", frames)
    assert pull.title == "pull of the wire [N]"
    assert np.mean(pull.mappable.get_clim()) == pytest.approx(np.sqrt(12.0))
    assert choose_look(result, "speed", frames).title == "speed of the reaction [1/s]"
    assert choose_look(result, "speed", frames).mappable.get_clim() == (0.0, 9.0)
    assert choose_look(result, "velocity", frames).title == "speed [m/s]"


def test_an_undeclared_field_is_called_by_its_name(tmp_path):
    """If it failed, the fields of an older file could not be drawn."""
    result, frames = made_up(tmp_path, solid_fraction=np.linspace(0, 1, 10, dtype="f4"))
    assert choose_look(result, "solid_fraction", frames).title == "solid fraction"
    assert choose_look(result, "velocity", frames).title == "speed"
    assert choose_look(result, None, frames).title == "speed"


def test_unknown_colours_are_viridis(tmp_path):
    """If it failed, a field whose declaration misspells a colour map could not be looked at."""
    result, frames = made_up(tmp_path, {"dye": Quantity("dye", colours="magmma")}, dye=np.zeros(10, "f4"))
    assert choose_look(result, "dye", frames).mappable.get_cmap().name == "viridis"


def test_outliers_do_not_take_the_colours(tmp_path):
    """If it failed, one wild particle would leave all others in a single colour, without a hint that it is there."""
    n = 1000
    values = np.linspace(0, 1, n, dtype="f4")
    values[7] = 1e6
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {"spacing": 0.1, "dimension": 2}) as writer:
        writer.write_frame(
            0.0, np.random.default_rng(1).random((n, 3)), {"role": np.zeros(n, "i4"), "pressure": values}
        )
    result = ResultFile(path)
    look = choose_look(result, "pressure", [result.frame(0)])
    assert look.mappable.norm.vmax < 1.1
    assert look.bar.extend == "max"


def test_temperatures_keep_all_their_colours(tmp_path):
    """If it failed, the few hottest particles, which matter most, would be cut off the scale."""
    values = np.linspace(300, 301, 10, dtype="f4")
    values[3] = 2000.0
    result, frames = made_up(tmp_path, temperature=values)
    look = choose_look(result, "temperature", frames)
    assert look.mappable.get_clim() == (300.0, 2000.0)
    assert look.bar.extend == "neither"


def test_categories_are_named(result, frames):
    """If it failed, a key would show numbers where the case has names."""
    assert choose_look(result, "role", frames).patches()[0] == ("free", ROLE_COLOURS[Role.FREE])
    assert [name for name, _ in choose_look(result, "phase", frames).patches()][:2] == ["liquid", "solid"]
    look = choose_look(result, "material", frames)
    assert isinstance(look, CategoryLook)
    assert [name for name, _ in look.patches()] == ["steel", "copper"]


def test_unknown_field_names_the_nearest(result, frames):
    """If it failed, a typo would end in a KeyError."""
    with pytest.raises(InputError, match=r"field = 'temprature'.*did you mean 'temperature'"):
        choose_look(result, "temprature", frames)
    with pytest.raises(InputError, match=r"field = 'xyz'.*allowed: id, .*speed"):
        choose_look(result, "xyz", frames)


@pytest.mark.parametrize("values", [np.full(10, np.nan), np.full(10, 5.0), np.zeros(10), np.full(10, -3e30)])
def test_fields_without_a_range(tmp_path, values):
    """If it failed, a constant or undefined field could not be drawn at all."""
    result, frames = made_up(tmp_path, pressure=values.astype("f4"))
    look = choose_look(result, "pressure", frames)
    low, high = look.mappable.get_clim()
    assert low < high
    assert look.colours(frames[0][1]).shape == (10, 3)
