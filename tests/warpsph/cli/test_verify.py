"""``warpsph verify``: the table, the JSON report and the exit code."""

import json
from pathlib import Path

KEYS = {"case", "quantity", "unit", "measured", "reference", "error", "tolerance", "source", "passed"}


def test_passing_checks_exit_0(warpsph_command):
    """If it failed, a good scenario would be reported as bad, or its numbers would not be shown."""
    outcome = warpsph_command("verify", "ingot")
    assert outcome.code == 0
    row = next(line for line in outcome.output.splitlines() if "front" in line)
    for cell in ("1.02", "1", "m", "2.00%", "5.00%", "Nobody (1)", "yes"):
        assert cell in row
    assert "1 of 1 checks passed" in outcome.output


def test_a_failed_check_exits_1_and_a_nan_is_a_failure(warpsph_command):
    """If it failed, a value out of tolerance, or no number at all, would pass."""
    outcome = warpsph_command("verify", "crooked")
    assert outcome.code == 1
    verdicts = dict.fromkeys(("bend", "twist"), "NO") | {"front": "yes"}
    for quantity, verdict in verdicts.items():
        assert any(quantity in line and verdict in line for line in outcome.output.splitlines())
    assert "1 of 3 checks passed" in outcome.output


def test_json_report(warpsph_command, tmp_path: Path):
    """If it failed, a script could not read the report: keys missing, NumPy values, or NaN that JSON does not know."""
    assert warpsph_command("verify", "ingot", "crooked", "--json", "rows.json").code == 1

    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} is not JSON")

    rows = json.loads((tmp_path / "rows.json").read_text(), parse_constant=refuse)
    assert [row["case"] for row in rows] == ["ingot", "crooked", "crooked", "crooked"]
    assert all(row.keys() >= KEYS for row in rows)
    assert [row["passed"] for row in rows] == [True, True, False, False]
    assert rows[3]["measured"] is None
    assert rows[2]["reference"] is None


def test_divergence_exits_3_and_does_not_hide_the_others(warpsph_command, tmp_path: Path):
    """If it failed, one diverging scenario would hide the rows of all the others."""
    outcome = warpsph_command("verify", "diverging", "ingot", "--json", "rows.json")
    assert outcome.code == 3
    assert "particle 7" in outcome.output
    assert len(json.loads((tmp_path / "rows.json").read_text())) == 1


def test_interruption_exits_130(warpsph_command):
    """If it failed, Ctrl-C would only skip to the next scenario, or count as a failed check."""
    outcome = warpsph_command("verify", "interrupted", "ingot")
    assert outcome.code == 130
    assert outcome.error == "warpsph: interrupted\n"
    assert "ingot" not in outcome.output


def test_slow_checks_are_left_out_unless_asked_for(warpsph_command):
    """If it failed, a quick verification would take hours, or --slow would do nothing."""
    assert "no check without --slow" in warpsph_command("verify", "patient").output
    assert "1 of 1 checks passed" in warpsph_command("verify", "patient", "--slow").output


def test_all_scenarios_by_default(warpsph_command):
    """If it failed, plain verify would skip scenarios."""
    output = warpsph_command("verify").output
    for name in ("ingot", "crooked", "diverging", "patient"):
        assert f"{name}:" in output
