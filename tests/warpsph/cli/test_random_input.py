"""Random settings and random case files never end in a traceback."""

import contextlib
import io
import os
from pathlib import Path

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from warpsph.cli import main

CAMPAIGN = int(os.environ.get("WARPSPH_CAMPAIGN", 0))  # examples a test, as in CONTRIBUTING.md
calm = settings(
    max_examples=CAMPAIGN or 150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)

keys = st.sampled_from(["count", "spacing", "wall", "oscillates", "zones", "duration"])
texts = st.text(st.characters(exclude_categories=()), max_size=12)  # surrogates too: words that are not UTF-8
values = (
    texts
    | st.integers().map(str)
    | st.floats().map(repr)
    | st.lists(st.floats().map(repr)).map(lambda items: f"[{', '.join(items)}]")
    | st.sampled_from(["[[", "{a=1}", "[" * 5000, "1\nx=2", "1979-05-27", "0x" + "f" * 6000, "9" * 5000, "1e999"])
)


def refused(*words: str) -> str:
    """The one line with which a command that cannot succeed ends."""
    error = io.StringIO()
    with contextlib.redirect_stderr(error):
        code = main(words)
    assert code == 2
    assert error.getvalue().startswith("warpsph: ")
    assert error.getvalue().count("\n") == 1
    assert error.getvalue().rstrip("\n").isprintable()
    assert len(error.getvalue()) < 4000
    return error.getvalue()


@pytest.fixture
def impossible(shop: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[str, ...]:
    """A run that ends, at the latest, because the folder of its output is missing."""
    monkeypatch.chdir(tmp_path)
    return ("run", "ingot", "--quiet", "--output", "absent/out.vtkhdf")


@calm
@given(key=keys | texts, value=values)
@example(key="self", value="1")
@example(key="model_config", value="1")
def test_random_settings(impossible: tuple[str, ...], key: str, value: str):
    """If it failed, some text after --set would end in a traceback or in several lines."""
    refused(*impossible, f"--set={key}={value}")


@calm
@given(
    content=st.binary(max_size=40)
    | st.lists(st.tuples(keys, values)).map(
        lambda rows: "\n".join(f"{k} = {v}" for k, v in rows).encode(errors="surrogatepass")
    )
)
def test_random_case_files(impossible: tuple[str, ...], content: bytes):
    """If it failed, some content of a case file would end in a traceback or in several lines."""
    Path("case.toml").write_bytes(content)
    refused(*impossible, "case.toml")


@calm
@given(words=st.lists(texts | st.sampled_from(["run", "ingot", "--until", "--set", "-1", "--"]), max_size=5))
def test_random_words(impossible: tuple[str, ...], words: list[str]):
    """If it failed, some command line would end in a traceback."""
    error = io.StringIO()
    with contextlib.redirect_stderr(error), contextlib.redirect_stdout(io.StringIO()):
        code = main(words)
    assert code in (0, 2)
    assert error.getvalue().count("\n") <= 1 or code == 0
