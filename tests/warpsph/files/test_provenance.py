"""What made a result is stored with it."""

import json
from datetime import datetime

from warpsph.files.provenance import provenance


def test_names_what_is_needed_to_repeat_a_run():
    """If it failed, nobody could tell from a file which program and machine made it."""
    values = provenance("cpu", 2)
    assert values["device"] == "cpu"
    assert values["threads"] == 2
    assert all(values[name] for name in ("warpsph", "warp", "python", "numpy", "platform", "cpu"))
    assert datetime.fromisoformat(values["started"]).utcoffset().total_seconds() == 0
    assert json.loads(json.dumps(values)) == values


def test_an_installed_package_has_no_revision(tmp_path, monkeypatch):
    """If it failed, an installed program would report the revision of a repository that merely lies around it."""
    monkeypatch.setattr("warpsph.files.provenance.__file__", str(tmp_path / "warpsph" / "provenance.py"))
    assert "revision" not in provenance("cpu", 1)
